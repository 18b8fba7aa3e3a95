#pragma once

#include <scree/rheology/elementary.hpp>
#include <scree/tensor.hpp>

namespace scree::rheology {

/// Viscosity that stands for a yield stress [Pa s]: tau_y (1 - exp(-m gdot))/gdot, which is tau_y m at rest.
/// Eq. (R8), from Papanastasiou (1987), \cite papanastasiou1987
/// @param shear_rate gdot [1/s]  @param yield_stress tau_y [Pa]
/// @param regularisation_time m [s]: above the rate 1/m the yield stress is felt in full
template <class Real>
[[nodiscard]] Real papanastasiou_viscosity(const Real& shear_rate, double yield_stress,
                                           double regularisation_time) noexcept {
  const Real x = regularisation_time * shear_rate;
  const Real share = select(x == 0.0, Real(1.0), -elementary::expm1(-x) / x);
  return yield_stress * regularisation_time * share;
}

}  // namespace scree::rheology
