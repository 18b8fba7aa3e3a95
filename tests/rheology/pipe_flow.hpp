#pragma once

#include "points.hpp"

namespace scree::rheology {

/// Flow rate of a law without memory through a pipe of radius R, over pi R^3 [1/s]: the integral of
/// tau^2 gdot dtau/tau_w^3 up to the stress tau_w at the wall, by parts gdot_w/3 less that of
/// tau^3 dgdot/(3 tau_w^3), which takes the stress that the law has at a rate. By Simpson's rule in u,
/// gdot = gdot_w u^2, in which the powers 1/2, 1 and 3/2 of the rate are smooth.
/// @param wall_rate gdot_w [1/s]  @param num_parts even
template <class Law>
[[nodiscard]] double pipe_flow(const Law& law, double wall_rate, int num_parts) {
  const auto stress_at = [&](double rate) {
    return stress(law, simple_shear(rate), 1.001 * law.density)(0, 1);
  };
  const double at_wall = stress_at(wall_rate);
  double sum = 0;
  for (int i = 0; i <= num_parts; ++i) {
    const double u = static_cast<double>(i) / num_parts;
    const double weight = (i == 0 || i == num_parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * num_parts);
    sum += weight * std::pow(stress_at(wall_rate * u * u) / at_wall, 3) * 2 * u;
  }
  return wall_rate / 3 * (1 - sum);
}

/// What Simpson's rule in `num_parts` may be off by, over the rate at the wall: the integrand 2 u
/// (tau/tau_w)^3 is a polynomial of degree 10 at most for powers up to 3/2, with coefficients that are
/// positive and add up to 2, so its fourth derivative is at most 2 10 9 8 7; a third of that over 180
/// num_parts^4.
[[nodiscard]] inline double error_of_pipe_flow(int num_parts) {
  return 2.0 * 10 * 9 * 8 * 7 / 180 / 3 / std::pow(num_parts, 4);
}

}  // namespace scree::rheology
