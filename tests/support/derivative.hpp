#pragma once

#include <cmath>

namespace scree::testing {

/// A dual number: a value and its derivative by one parameter, carried through any template on Real.
struct Dual {
  double value = 0;
  double slope = 0;

  constexpr Dual() = default;
  constexpr Dual(double constant) : value{constant} {}
  constexpr Dual(double x, double dx) : value{x}, slope{dx} {}

  friend constexpr Dual operator-(Dual a) { return {-a.value, -a.slope}; }
  friend constexpr Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
  friend constexpr Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
  friend constexpr Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend constexpr Dual operator/(Dual a, Dual b) {
    return {a.value / b.value, (a.slope - a.value / b.value * b.slope) / b.value};
  }
  friend constexpr bool operator<(Dual a, Dual b) { return a.value < b.value; }
  friend constexpr bool operator<=(Dual a, Dual b) { return a.value <= b.value; }
  friend constexpr bool operator==(Dual a, Dual b) { return a.value == b.value; }

  /// f(a) with the derivative f'(a); a constant stays one, even where f' is infinite.
  static Dual chain(Dual a, double f, double df) { return {f, a.slope == 0 ? 0 : df * a.slope}; }
  friend Dual sqrt(Dual a) { return chain(a, std::sqrt(a.value), 0.5 / std::sqrt(a.value)); }
  friend Dual exp(Dual a) { return chain(a, std::exp(a.value), std::exp(a.value)); }
  friend Dual expm1(Dual a) { return chain(a, std::expm1(a.value), std::exp(a.value)); }
  friend Dual log(Dual a) { return chain(a, std::log(a.value), 1 / a.value); }
  /// The exponent is a constant.
  friend Dual pow(Dual a, Dual exponent) {
    return chain(a, std::pow(a.value, exponent.value),
                 exponent.value * std::pow(a.value, exponent.value - 1));
  }
};

}  // namespace scree::testing
