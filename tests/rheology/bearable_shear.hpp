#pragma once

#include <scree/rheology/path/path_point.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::rheology {

/// Rates [1/s], eight per decade from 1e-6 to 1e8, smallest first.
[[nodiscard]] inline std::vector<double> rates_of_all_sizes() {
  constexpr int per_decade = 8;
  std::vector<double> result;
  for (int i = -6 * per_decade; i <= 8 * per_decade; ++i)
    result.push_back(std::pow(10, static_cast<double>(i) / per_decade));
  return result;
}

/// Stresses on the planes that stay of a point after a step.
struct PlaneStresses {
  double normal;  ///< sigma_yy [Pa]; NaN where the step cannot be taken
  double shear;   ///< sigma_xy [Pa]
};

/// @param shear_rate D_xy = L_xy/2 [1/s]  @param widening D_yy [1/s]
[[nodiscard]] inline PlaneStresses stresses_after(const PathPoint& point, double shear_rate, double widening,
                                                  double dt) {
  Tensor<double> gradient;
  gradient(0, 1) = 2 * shear_rate;
  gradient(1, 1) = widening;
  const double density = point.now.density / (1 + dt * widening);  // Eq. (R27)
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(density > 0)) return {nan, nan};
  const PathPoint::Answer answer = point.answer({gradient, density}, dt);
  if (answer.unsolved != 0) return {nan, nan};
  return {answer.stress(1, 1), answer.stress(0, 1)};
}

/// Largest shear stress at a shear rate with which a normal stress is met [Pa], -infinity if it is not: by
/// bisection between all neighbours in a dense row of widening rates that the normal stress lies between.
[[nodiscard]] inline double shear_stress_at(const PathPoint& point, double shear_rate, double normal,
                                            double dt) {
  std::vector<double> rates = rates_of_all_sizes();
  const std::size_t half = rates.size();
  rates.push_back(0);
  for (std::size_t i = 0; i < half; ++i) rates.push_back(-rates[i]);
  std::ranges::sort(rates);
  const auto excess = [&](double widening) {
    return stresses_after(point, shear_rate, widening, dt).normal - normal;
  };
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < rates.size(); ++i) {
    double low = rates[i - 1];
    double high = rates[i];
    const double at_low = excess(low);
    if (!(at_low * excess(high) <= 0)) continue;
    for (int n = 0; n < 60; ++n) {
      const double middle = (low + high) / 2;
      (at_low * excess(middle) > 0 ? low : high) = middle;
    }
    largest = std::max(largest, stresses_after(point, shear_rate, high, dt).shear);
  }
  return largest;
}

/// Largest shear stress that a step can bear under a normal stress [Pa]. Supposes nothing of a law and knows
/// nothing of the driver: shear rates of all sizes are tried, up to 1e8 1/s or until the stress has fallen to
/// half of what it had been. An answer beyond that would be jumped to, not led to: a long step that shears
/// several times over winds its elastic strain round, and bears less and then more again.
[[nodiscard]] inline double bearable_shear(const PathPoint& point, double normal, double dt) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double rate : rates_of_all_sizes()) {
    const double stress = shear_stress_at(point, rate, normal, dt);
    if (stress < largest / 2) break;
    largest = std::max(largest, stress);
  }
  return largest;
}

}  // namespace scree::rheology
