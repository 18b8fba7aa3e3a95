#pragma once

namespace scree::testing {

/// A dual number: a value and its derivative by one parameter, carried through any template on Real.
struct Dual {
  double value = 0;
  double slope = 0;

  constexpr Dual() = default;
  constexpr Dual(double constant) : value{constant} {}
  constexpr Dual(double x, double dx) : value{x}, slope{dx} {}

  friend constexpr Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
  friend constexpr Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
  friend constexpr Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend constexpr bool operator<(Dual a, Dual b) { return a.value < b.value; }
};

}  // namespace scree::testing
