#pragma once

#include "derivative.hpp"
#include "points.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace scree::rheology {

/// How the traction on a plane with the normal (cos, sin) answers a short disturbance of velocity and
/// density, by the law's own derivatives: the traction of w exp(i k n.x) is i k `by_velocity` w, and that of
/// rho' is `by_density` rho'.
struct Answer {
  Eigen::Matrix2d by_velocity;  ///< [Pa s]
  Eigen::Vector2d by_density;   ///< [Pa m^3/kg]
  Eigen::Vector2d normal;
};

/// @param dt the step over which the law answers [s]: short, or so long that its memory has followed
template <class Law>
[[nodiscard]] Answer answer_of(const Law& law, const Tensor<double>& base, double density, double angle,
                               double dt) {
  using testing::Dual;
  Answer answer{{}, {}, {std::cos(angle), std::sin(angle)}};
  const auto traction = [&](const Tensor<double>& change, double density_change) {
    Tensor<Dual> dual;
    for (std::size_t i = 0; i < 9; ++i) dual.components[i] = {base.components[i], change.components[i]};
    const auto sigma = stress<Law, Dual>(law, dual, Dual{density, density_change}, Dual{1e-3}, dt);
    return Eigen::Vector2d{sigma(0, 0).slope * answer.normal(0) + sigma(0, 1).slope * answer.normal(1),
                           sigma(1, 0).slope * answer.normal(0) + sigma(1, 1).slope * answer.normal(1)};
  };
  for (int column = 0; column < 2; ++column) {
    Tensor<double> change;
    for (std::size_t j = 0; j < 2; ++j) {
      change(static_cast<std::size_t>(column), j) = answer.normal(static_cast<Eigen::Index>(j));
    }
    answer.by_velocity.col(column) = traction(change, 0);
  }
  answer.by_density = traction({}, 1);
  return answer;
}

/// Fastest growth of a disturbance with wave number k, along any direction [1/s]:
/// rho w' = -k^2 M w + i k b rho', rho'' = -i k rho n.w.
template <class Law>
[[nodiscard]] double fastest_growth(const Law& law, const Tensor<double>& base, double density, double k,
                                    double dt) {
  constexpr int num_directions = 200;
  double fastest = -std::numeric_limits<double>::infinity();
  for (int n = 0; n < num_directions; ++n) {
    const Answer answer = answer_of(law, base, density, std::numbers::pi * n / num_directions, dt);
    Eigen::Matrix3cd system = Eigen::Matrix3cd::Zero();
    const std::complex<double> ik{0, k};
    system.topLeftCorner<2, 2>() = -k * k / density * answer.by_velocity.cast<std::complex<double>>();
    system.topRightCorner<2, 1>() = ik / density * answer.by_density.cast<std::complex<double>>();
    system.bottomLeftCorner<1, 2>() = -ik * density * answer.normal.transpose().cast<std::complex<double>>();
    fastest = std::max(fastest, system.eigenvalues().real().maxCoeff());
  }
  return fastest;
}

}  // namespace scree::rheology
