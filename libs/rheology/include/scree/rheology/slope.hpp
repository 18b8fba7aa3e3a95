#pragma once

#include <cmath>

namespace scree::rheology {

/// A number and its derivative by one unknown: Newton's method at a point takes the slope of an equation from
/// its own text, whatever number the law is computed in.
template <class Real>
struct Slope {
  Real value;
  Real slope{};  ///< d value/d unknown; of a constant 0

  [[nodiscard]] friend constexpr Slope operator+(const Slope& a, const Slope& b) noexcept {
    return {a.value + b.value, a.slope + b.slope};
  }
  [[nodiscard]] friend constexpr Slope operator-(const Slope& a, const Slope& b) noexcept {
    return {a.value - b.value, a.slope - b.slope};
  }
  [[nodiscard]] friend constexpr Slope operator*(const Slope& a, const Slope& b) noexcept {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  [[nodiscard]] friend constexpr Slope operator/(const Slope& a, const Slope& b) noexcept {
    const Real ratio = a.value / b.value;
    return {ratio, (a.slope - ratio * b.slope) / b.value};
  }
  [[nodiscard]] friend constexpr Slope operator*(const Real& a, const Slope& b) noexcept {
    return {a * b.value, a * b.slope};
  }
  [[nodiscard]] friend constexpr Slope operator+(const Real& a, const Slope& b) noexcept {
    return {a + b.value, b.slope};
  }
  /// Of a positive number.
  [[nodiscard]] friend Slope sqrt(const Slope& a) noexcept {
    using std::sqrt;
    const Real root = sqrt(a.value);
    return {root, 0.5 * a.slope / root};
  }
};

}  // namespace scree::rheology
