#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// Michalak & Ollivier-Gooch's limiter: a cubic that follows Barth & Jespersen's without its kink, and
/// leaves a slope alone that wants two thirds of what is allowed or less. Keeps bounds strictly.
/// @see Eq. (T33c), \cite michalak2009
struct SmoothCubic {
  static constexpr std::string_view name = "smooth_cubic";
  static constexpr std::string_view summary = "a smooth one that keeps bounds strictly: the default";
  static constexpr bool keeps_bounds = true;

  [[nodiscard]] double operator()(double allowed, double wanted, double /*width*/) const noexcept {
    const double ratio = allowed / wanted;  // made whether wanted or not: no branch
    const double factor = ratio * (1 - 4.0 / 27 * ratio * ratio);
    return 3 * wanted > 2 * allowed ? factor : 1.0;
  }
};
static_assert(CellLimiter<SmoothCubic>);

}  // namespace scree::transport
