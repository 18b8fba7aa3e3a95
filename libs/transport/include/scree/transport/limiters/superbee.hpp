#pragma once

#include <scree/transport/concepts.hpp>

#include <algorithm>
#include <cmath>

namespace scree::transport {

/// Roe's superbee: the steepest slope that total variation allows. Keeps contacts sharp, squares smooth
/// waves, and converges slowly for fluxes that are not convex.
/// @see Eq. (T5c), \cite roe1986
struct Superbee {
  static constexpr std::string_view name = "superbee";
  static constexpr std::string_view summary = "steepest TVD slope: sharp contacts, squares smooth waves";

  [[nodiscard]] double operator()(double backward, double forward) const noexcept {
    const double b = std::abs(backward);
    const double f = std::abs(forward);
    const double slope = std::max(std::min(2 * b, f), std::min(b, 2 * f));
    return (backward > 0) == (forward > 0) ? std::copysign(slope, forward) : 0.0;
  }

  [[nodiscard]] double sharpness() const noexcept { return 2; }
};
static_assert(Limiter<Superbee>);

}  // namespace scree::transport
