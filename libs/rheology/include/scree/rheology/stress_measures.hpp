#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/tensor.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree::rheology {

/// The memory of a law that keeps the deviator of the Cauchy stress.
inline constexpr std::array<StateColumn, 6> deviatoric_stress_columns{{{"deviatoric_stress_xx", "Pa"},
                                                                       {"deviatoric_stress_yy", "Pa"},
                                                                       {"deviatoric_stress_zz", "Pa"},
                                                                       {"deviatoric_stress_xy", "Pa"},
                                                                       {"deviatoric_stress_xz", "Pa"},
                                                                       {"deviatoric_stress_yz", "Pa"}}};

/// Mean pressure p = -tr(sigma)/3 of a stress [Pa], compression positive.  Eq. (R26)
[[nodiscard]] constexpr double mean_pressure(const Tensor<double>& stress) noexcept {
  return -trace(stress) / 3;
}

/// q = sqrt(3/2 s:s) [Pa]: the difference of the axial and the radial stress in a triaxial test, sqrt(3)
/// times the shear stress in simple shear.  Eq. (R26)
[[nodiscard]] inline double deviatoric_stress(const Tensor<double>& stress) noexcept {
  const Tensor<double> s = deviator(stress);
  return std::sqrt(1.5 * contract(s, s));
}

/// Lode angle theta, cos(3 theta) = 27/2 det(-s)/q^3 [rad]: 0 in triaxial compression, pi/6 in pure shear,
/// pi/3 in triaxial extension; 0 where there is no deviator.  Eq. (R26)
[[nodiscard]] inline double lode_angle(const Tensor<double>& stress) noexcept {
  const double q = deviatoric_stress(stress);
  if (q == 0) return 0;
  const Tensor<double> n = (-1 / q) * deviator(stress);
  const double determinant = n(0, 0) * (n(1, 1) * n(2, 2) - n(1, 2) * n(2, 1)) -
                             n(0, 1) * (n(1, 0) * n(2, 2) - n(1, 2) * n(2, 0)) +
                             n(0, 2) * (n(1, 0) * n(2, 1) - n(1, 1) * n(2, 0));
  // What leaves [-1, 1] does so by rounding; NaN stays NaN.
  return std::acos(std::clamp(13.5 * determinant, -1.0, 1.0)) / 3;
}

}  // namespace scree::rheology
