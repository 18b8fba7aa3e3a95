#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// Van Leer's limiter: the harmonic mean of the two differences, zero at an extremum. Smooth.
/// @see Eq. (T5b), \cite vanleer1974
struct VanLeer {
  static constexpr std::string_view name = "van_leer";
  static constexpr std::string_view summary = "harmonic mean of the two differences: smooth, no parameter";

  [[nodiscard]] double operator()(double backward, double forward) const noexcept {
    const double product = backward * forward;
    const double sum = backward + forward;
    return product > 0 ? 2 * product / sum : 0.0;
  }

  [[nodiscard]] double sharpness() const noexcept { return 2; }
};
static_assert(Limiter<VanLeer>);

}  // namespace scree::transport
