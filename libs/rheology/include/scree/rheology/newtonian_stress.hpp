#pragma once

#include <scree/constitutive_law.hpp>

#include <cmath>

namespace scree::rheology {

/// Pressure of a weakly compressible material [Pa], compression positive; exactly zero at rho_0, so that it
/// does not depend on how a compiler rounds whether material at rest is connected.  Eqs. (R1), (R5)
/// @param density rho [kg/m^3]  @param reference_density rho_0, at which p = 0 [kg/m^3]
/// @param bulk_modulus K [Pa]
template <class Real>
[[nodiscard]] constexpr Real pressure(const Real& density, double reference_density,
                                      double bulk_modulus) noexcept {
  return (bulk_modulus / reference_density) * (density - reference_density);
}

/// The pressure where grains touch, zero where they do not [Pa]: what friction may be made from.  Eq. (R5)
template <class Real>
[[nodiscard]] constexpr Real contact_pressure(const Real& p) noexcept {
  return select(p < 0.0, Real(0.0), p);
}

/// Speed of pressure waves sqrt(dp/drho) [m/s].  Eq. (R2)
/// @param reference_density rho_0 [kg/m^3]  @param bulk_modulus K [Pa]
template <class Real>
[[nodiscard]] Real wave_speed(const Real& reference_density, const Real& bulk_modulus) noexcept {
  using std::sqrt;
  return sqrt(bulk_modulus / reference_density);
}

/// Stress of a fluid that resists compression and shear, but no tension [Pa]: -p 1 + 2 mu D' while p >= 0,
/// nothing once p < 0, when the material is disconnected.  Eqs. (R3), (R5)
///
/// The zero is made by a product, so that a NaN in any argument reaches the stress.
/// @param viscosity mu [Pa s]  @param p pressure [Pa], compression positive
template <class Real>
[[nodiscard]] constexpr Tensor<Real> newtonian_stress(const Tensor<Real>& velocity_gradient,
                                                      const Real& viscosity, const Real& p) noexcept {
  const Real is_connected = select(p < 0.0, Real(0.0), Real(1.0));
  const Tensor<Real> rate = deviator(symmetric_part(velocity_gradient));
  return is_connected * (Real(2.0) * viscosity * rate - isotropic<Real>(p));
}

}  // namespace scree::rheology
