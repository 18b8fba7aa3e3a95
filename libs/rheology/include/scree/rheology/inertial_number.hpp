#pragma once

#include <scree/tensor.hpp>

#include <cmath>

namespace scree::rheology {

/// Inertial number I = gdot s_a sqrt(rho_s/p) [-]: the time in which pressure moves a grain by its size over
/// the time in which the flow does.  Eq. (R12)
/// @param shear_rate gdot [1/s]  @param grain_size s_a [m]
/// @param pressure p [Pa], positive  @param grain_density rho_s, of the solid [kg/m^3]
template <class Real>
[[nodiscard]] Real inertial_number(const Real& shear_rate, const Real& grain_size, const Real& pressure,
                                   double grain_density) noexcept {
  using std::sqrt;
  return shear_rate * grain_size * sqrt(grain_density / pressure);
}

/// sqrt(gdot^2 + floor^2) [1/s]: the shear rate by which a strength may be divided. Instead of the true rate
/// it costs a relative error of less than (floor/gdot)^2/2.  Eq. (R14)
/// @param velocity_gradient L [1/s]  @param floor [1/s], positive
template <class Real>
[[nodiscard]] Real floored_shear_rate(const Tensor<Real>& velocity_gradient, double floor) noexcept {
  using std::sqrt;
  const Tensor<Real> rate = deviator(symmetric_part(velocity_gradient));
  return sqrt(2.0 * contract(rate, rate) + floor * floor);
}

/// Shear strength mu(I) p [Pa] of the friction law mu(I), finite down to p = 0, where there is none.
/// Eqs. (R11), (R13)
/// @param mu_s, mu_2, I_0 of the law, numbers or those of a mixture [-]
/// @param grain_rate I sqrt(p) [sqrt(Pa)]  @param root_p sqrt(p) [sqrt(Pa)]
template <class Number, class Real>
[[nodiscard]] constexpr Real mu_of_i_strength(const Number& mu_s, const Number& mu_2, const Number& I_0,
                                              const Real& grain_rate, const Real& root_p) noexcept {
  const Real friction = mu_s + (mu_2 - mu_s) * grain_rate / (I_0 * root_p + grain_rate);
  return friction * root_p * root_p;
}

/// Barker's number C [-]: steady shear of an incompressible mu(I) fluid is ill-posed where C > 0, for then
/// disturbances grow without bound as they get shorter.  Eq. (R15), from Barker et al. (2015),
/// \cite barker2015
/// @param inertial_number I  @param friction mu(I)  @param slope dmu/dI
[[nodiscard]] constexpr double stability_number(double inertial_number, double friction,
                                                double slope) noexcept {
  const double a = inertial_number * slope / friction;
  const double b = friction * (1 - a / 2);
  return 4 * a * a - 4 * a + b * b;
}

}  // namespace scree::rheology
