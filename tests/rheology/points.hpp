#pragma once

#include <scree/constitutive_law.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

namespace scree::rheology {

inline constexpr std::array densities{900.0, 1000.0, 1001.0,
                                      1500.0};  // [kg/m^3], from disconnected to compressed

/// An aggregate of numbers (a law's Input or State) with every member `value`.
template <class Aggregate, class Real>
[[nodiscard]] Aggregate filled_with(Real value) {
  if constexpr (std::is_empty_v<Aggregate>) {
    return {};
  } else {
    std::array<Real, sizeof(Aggregate) / sizeof(Real)> numbers{};
    numbers.fill(value);
    return std::bit_cast<Aggregate>(numbers);
  }
}

/// Stress of a law whose inputs are all 1e-3, in SI, and whose state is zero.
template <class Law, class Real>
[[nodiscard]] Tensor<Real> stress(const Law& law, const Tensor<Real>& velocity_gradient, Real density,
                                  Real input = 1e-3) {
  using Input = typename Law::template Input<Real>;
  using State = typename Law::template State<Real>;
  const Deformation<Real> deformation{velocity_gradient, density};
  return law.update(deformation, filled_with<Input>(input), State{}, Real(1e-4)).stress;
}

/// Velocity gradients with components drawn from [-1, 1] 1/s, always the same ones.
[[nodiscard]] inline std::vector<Tensor<double>> velocity_gradients() {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> component{-1, 1};
  std::vector<Tensor<double>> result(8);
  for (auto& gradient : result) {
    for (auto& entry : gradient.components) entry = component(random);
  }
  return result;
}

/// Largest component, in absolute value.
[[nodiscard]] inline double largest(const Tensor<double>& a) {
  double result = 0;
  for (const double component : a.components) result = std::max(result, std::abs(component));
  return result;
}

/// Q A Q^T with the rotation Q by one radian about (1, 2, 2).
[[nodiscard]] inline Tensor<double> rotated(const Tensor<double>& a) {
  const Eigen::Matrix3d q = Eigen::AngleAxisd{1.0, Eigen::Vector3d{1, 2, 2} / 3}.toRotationMatrix();
  Tensor<double> result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      for (int k = 0; k < 9; ++k) {
        result.components[static_cast<std::size_t>(3 * row + column)] +=
            q(row, k / 3) * a.components[static_cast<std::size_t>(k)] * q(column, k % 3);
      }
    }
  }
  return result;
}

}  // namespace scree::rheology
