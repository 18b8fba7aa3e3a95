#pragma once

#include <limits>
#include <string>

namespace scree::io {

/// The numbers that a key may have: an interval, each end in it or not.
struct Bounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool is_lower_open = false;
  bool is_upper_open = false;

  /// False for NaN.
  [[nodiscard]] constexpr bool contain(double value) const noexcept {
    return (is_lower_open ? lower < value : lower <= value) &&
           (is_upper_open ? value < upper : value <= upper);
  }
  /// What a value must do: "must exceed 0", "must lie in (0, 1]"; empty if anything goes.
  [[nodiscard]] std::string to_text() const;
};

[[nodiscard]] constexpr Bounds any_value() noexcept {
  return {};
}
[[nodiscard]] constexpr Bounds above(double lower) noexcept {
  return {.lower = lower, .is_lower_open = true};
}
[[nodiscard]] constexpr Bounds at_least(double lower) noexcept {
  return {.lower = lower};
}
[[nodiscard]] constexpr Bounds below(double upper) noexcept {
  return {.upper = upper, .is_upper_open = true};
}
[[nodiscard]] constexpr Bounds at_most(double upper) noexcept {
  return {.upper = upper};
}
/// Both ends included.
[[nodiscard]] constexpr Bounds between(double lower, double upper) noexcept {
  return {.lower = lower, .upper = upper};
}

/// The shortest decimal that reads back as the same double: "0.1", "1e-09".
[[nodiscard]] std::string to_text(double value);

}  // namespace scree::io
