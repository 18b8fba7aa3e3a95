#pragma once

#include <scree/tensor.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace scree::rheology {

/// The six components of a symmetric tensor in the order of `Symmetric`, and where each is in the tensor.
struct Component {
  std::string_view name;
  std::size_t row;
  std::size_t column;
};
inline constexpr std::array<Component, 6> symmetric_components{
    {{"xx", 0, 0}, {"yy", 1, 1}, {"zz", 2, 2}, {"xy", 0, 1}, {"xz", 0, 2}, {"yz", 1, 2}}};
inline constexpr std::size_t first_shear = 3;  ///< components from here on are shears

/// What is imposed on one component of a point: a rate of deformation, or a rate of stress. The stress is
/// held where its rate is zero.
struct Control {
  enum class Of { strain_rate, stress_rate };
  Of of = Of::strain_rate;
  double rate = 0;  ///< D_ij, tensorial [1/s], or d sigma_ij/dt, tension positive [Pa/s]
};
[[nodiscard]] constexpr Control strain_rate(double rate) noexcept {
  return {Control::Of::strain_rate, rate};
}
[[nodiscard]] constexpr Control stress_rate(double rate) noexcept {
  return {Control::Of::stress_rate, rate};
}

/// What is imposed on a point at one time, component by component in the order of `symmetric_components`: no
/// motion unless it says otherwise.  Eq. (R28)
struct Controls {
  std::array<Control, 6> on{};
  std::array<double, 3> spin{};  ///< W_xy, W_xz, W_yz [1/s], W = (L - L^T)/2
  /// Of xy, xz, yz: whether D_ij is the shear of planes that stay, L_ji = 0; its spin then comes on top.
  std::array<bool, 3> is_simple_shear{};
  /// Axes of x, y and z as columns: all of this, and the stress it asks for, is with respect to them.
  Tensor<double> axes = isotropic(1.0);
};

/// A time in which the controls of a point stay the same.
struct Stage {
  std::string name;
  double duration = 0;  ///< [s]
  Index num_steps = 0;  ///< of equal length
  Controls controls;
};

/// @throws InputError naming the stage, the number and what was expected, unless the duration is positive,
/// there is a step, all rates are finite and the axes are those of a rotation.
void validate(const Stage& stage);

}  // namespace scree::rheology
