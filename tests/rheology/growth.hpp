#pragma once

#include "derivative.hpp"
#include "points.hpp"

#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace scree::rheology {

/// Shear rate [1/s] of an inertial number at a density, for grains of 1 mm.
template <class Law>
[[nodiscard]] double rate_of(const Law& law, double inertial_number, double density) {
  const double p = pressure(density, law.density, law.bulk_modulus);
  return inertial_number / (1e-3 * std::sqrt(law.grain_density / p));
}

/// C of a law in simple shear at an inertial number [-].
template <class Law>
[[nodiscard]] double stability_at(const Law& law, double inertial_number) {
  const double density = 1.001 * law.density;
  return law.stability_number({simple_shear(rate_of(law, inertial_number, density)), density}, {1e-3}, {});
}

/// How much the shortest disturbances of incompressible simple shear along the unit vector
/// xi = (cos angle, sin angle) are resisted [-]: they die as exp(-r eta k^2 t/rho), and grow without bound if
/// r < 0. From the law itself, linearised by dual numbers, not from C: the derivation of Eq. (R15).
///
/// A disturbance w exp(i k xi.x) with w normal to xi changes L by i k w xi^T and p by p'. Momentum along xi
/// gives p', and along w what is left of the resistance.
template <class Law>
[[nodiscard]] double resistance_along(const Law& law, double inertial_number, double angle) {
  using testing::Dual;
  const double density = 1.001 * law.density;
  const auto base = simple_shear(rate_of(law, inertial_number, density));
  const std::array xi{std::cos(angle), std::sin(angle)};
  const std::array w{-xi[1], xi[0]};
  const auto traction_slope = [&](const Tensor<double>& gradient, double density_slope) {
    Tensor<Dual> dual;
    for (std::size_t i = 0; i < 9; ++i) dual.components[i] = {base.components[i], gradient.components[i]};
    const auto sigma = stress<Law, Dual>(law, dual, Dual{density, density_slope});
    std::array<double, 2> traction{};
    for (std::size_t i = 0; i < 2; ++i) traction[i] = sigma(i, 0).slope * xi[0] + sigma(i, 1).slope * xi[1];
    return traction;
  };
  Tensor<double> gradient;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) gradient(i, j) = w[i] * xi[j];
  }
  const auto by_velocity = traction_slope(gradient, 0);
  const auto by_pressure = traction_slope({}, law.density / law.bulk_modulus);
  const auto along = [](const auto& a, const auto& b) { return a[0] * b[0] + a[1] * b[1]; };
  const double resistance =
      along(w, by_velocity) - along(w, by_pressure) * along(xi, by_velocity) / along(xi, by_pressure);
  return resistance / law.stiffness(Deformation<double>{base, density}, {1e-3}, {}).viscosity;
}

/// The direction in which disturbances are least resisted [rad].
template <class Law>
[[nodiscard]] double least_resisted_angle(const Law& law, double inertial_number) {
  constexpr int num_directions = 2000;
  double least = std::numeric_limits<double>::infinity();
  double result = 0;
  for (int n = 0; n < num_directions; ++n) {
    const double angle = std::numbers::pi * n / num_directions;
    const double resistance = resistance_along(law, inertial_number, angle);
    if (resistance < least) {
      least = resistance;
      result = angle;
    }
  }
  return result;
}

/// The resistance in the direction in which it is least [-].
template <class Law>
[[nodiscard]] double least_resistance(const Law& law, double inertial_number) {
  return resistance_along(law, inertial_number, least_resisted_angle(law, inertial_number));
}

/// Where C changes sign between two inertial numbers, by bisection of their logarithm.
template <class Law>
[[nodiscard]] double threshold_between(const Law& law, double low, double high) {
  const bool is_ill_posed = stability_at(law, low) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    ((stability_at(law, middle) > 0) == is_ill_posed ? low : high) = middle;
  }
  return low;
}

}  // namespace scree::rheology
