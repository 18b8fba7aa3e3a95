#pragma once

#include <scree/tensor.hpp>

#include <algorithm>
#include <cmath>

namespace scree::transport {

/// Relative rounding of a limit of dt, made by some thirty operations: limits that differ by less are equal.
constexpr double limit_rounding = 32 * round_off;

/// The longest step that keeps dt * limit <= cfl [s]; infinite where nothing moves.  Eq. (T9)
///
/// @param limit CFL number that a step of one second would have [1/s], >= 0
[[nodiscard]] inline double longest_step(double limit, double cfl) noexcept {
  return cfl / limit;
}

/// The length of the next step: what remains in the fewest equal parts that keep dt * limit <= cfl.  Eq. (T9)
[[nodiscard]] inline double next_step(double remaining, double limit, double cfl) noexcept {
  const double parts = remaining / longest_step(limit, cfl);
  return remaining / std::max(1.0, std::ceil(parts * (1 - limit_rounding)));
}

/// Whether dt keeps dt * limit <= cfl, to rounding.
[[nodiscard]] inline bool is_stable(double dt, double limit, double cfl) noexcept {
  return dt * limit <= cfl * (1 + 2 * limit_rounding);
}

}  // namespace scree::transport
