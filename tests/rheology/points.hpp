#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/rheology/columns.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree::rheology {

/// Densities from disconnected to compressed [kg/m^3].
template <class Law>
[[nodiscard]] std::array<double, 4> densities(const Law& law) {
  return {0.9 * law.density, law.density, 1.001 * law.density, 1.5 * law.density};
}

/// An aggregate of numbers with every member `value`.
template <class Aggregate, class Real>
[[nodiscard]] Aggregate filled_with(Real value) {
  std::array<Real, std::is_empty_v<Aggregate> ? 0 : sizeof(Aggregate) / sizeof(Real)> numbers{};
  return made_of<Aggregate>(numbers, [&](const Real&) { return value; });
}

/// Stress of a law after a step that starts from its initial state.
template <class Law, class Real>
[[nodiscard]] Tensor<Real> stress(const Law& law, const Tensor<Real>& velocity_gradient, Real density,
                                  const typename Law::template Input<Real>& input, double dt) {
  const Deformation<Real> deformation{velocity_gradient, density};
  return law.update(deformation, input, initial_state<Law, Real>(), Real(dt)).stress;
}

/// The same with ordinary inputs.
template <class Law, class Real>
[[nodiscard]] Tensor<Real> stress(const Law& law, const Tensor<Real>& velocity_gradient, Real density) {
  return stress(law, velocity_gradient, density, typical_input<Law, Real>(), 1e-4);
}

/// The same with one number as every input, in SI.
template <class Law, class Real>
[[nodiscard]] Tensor<Real> stress(const Law& law, const Tensor<Real>& velocity_gradient, Real density,
                                  Real input, double dt = 1e-4) {
  using Input = typename Law::template Input<Real>;
  return stress(law, velocity_gradient, density, filled_with<Input>(input), dt);
}

/// A point that a law is led along a path by.
template <class Law>
struct Point {
  Law law;
  typename Law::template State<double> state = initial_state<Law>();
  Tensor<double> stress{};

  using Input = typename Law::template Input<double>;

  void step(const Tensor<double>& velocity_gradient, double density, double dt, const Input& input) {
    const auto response = law.update({velocity_gradient, density}, input, state, dt);
    state = response.state;
    stress = response.stress;
  }
  /// With ordinary inputs.
  void step(const Tensor<double>& velocity_gradient, double density, double dt) {
    step(velocity_gradient, density, dt, typical_input<Law>());
  }
  /// With one number as every input, in SI.
  void step(const Tensor<double>& velocity_gradient, double density, double dt, double input) {
    step(velocity_gradient, density, dt, filled_with<Input>(input));
  }
};

[[nodiscard]] inline Tensor<double> transposed(const Tensor<double>& a) {
  Tensor<double> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result(i, j) = a(j, i);
  }
  return result;
}

/// (a - a^T)/2: the spin W of a velocity gradient.
[[nodiscard]] inline Tensor<double> skew_part(const Tensor<double>& a) {
  return 0.5 * (a - transposed(a));
}

/// dv_x/dy alone [1/s].
[[nodiscard]] inline Tensor<double> simple_shear(double rate) {
  Tensor<double> gradient;
  gradient(0, 1) = rate;
  return gradient;
}

/// What rounding may do to the stress of an elastic law in a step [Pa]: strains are differences of numbers of
/// order one, made by some 60 operations, and met by 2 G.
template <class Law>
[[nodiscard]] double rounding_of_strain(const Law& law) {
  if constexpr (requires { law.shear_modulus; }) {
    return 60 * round_off * 2 * law.shear_modulus;
  } else if constexpr (requires(typename Law::template State<double> state) { state.unloaded_volume; }) {
    return 60 * round_off * law.bulk_modulus;  // the pressure is that of a difference of volumes
  } else {
    return 0;
  }
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

/// The rotation Q by one radian about (1, 2, 2).
[[nodiscard]] inline Tensor<double> rotation_of_points() {
  const Eigen::Matrix3d q = Eigen::AngleAxisd{1.0, Eigen::Vector3d{1, 2, 2} / 3}.toRotationMatrix();
  return {{q(0, 0), q(0, 1), q(0, 2), q(1, 0), q(1, 1), q(1, 2), q(2, 0), q(2, 1), q(2, 2)}};
}

/// Q A Q^T with the rotation Q by one radian about (1, 2, 2).
[[nodiscard]] inline Tensor<double> rotated(const Tensor<double>& a) {
  const Tensor<double> q = rotation_of_points();
  Tensor<double> result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < 9; ++k) {
        result(row, column) += q(row, k / 3) * a.components[k] * q(column, k % 3);
      }
    }
  }
  return result;
}

}  // namespace scree::rheology
