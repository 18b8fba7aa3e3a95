#pragma once

#include <array>
#include <limits>

namespace scree::transport::detail {

/// The places between 0 and 1 where the slope of a flux may be extreme, and the slopes there. Unused entries
/// are at NaN, which lies between no two states.
struct SteepestSlopes {
  static constexpr int max_count = 6;
  std::array<double, max_count> at;
  std::array<double, max_count> slope{};

  SteepestSlopes() noexcept { at.fill(std::numeric_limits<double>::quiet_NaN()); }
};

/// Of f = u^2 (1 - C (1 - u)^2)/(u^2 + M (1 - u)^2): all roots of f'', whose numerator is a polynomial of
/// degree six.  Eq. (T19)
[[nodiscard]] SteepestSlopes steepest_slopes_of_fractional_flow(double gravity, double viscosity_ratio);

}  // namespace scree::transport::detail
