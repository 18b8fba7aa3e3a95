#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/newtonian_stress.hpp>
#include <scree/rheology/yield_stress.hpp>

#include <array>
#include <string_view>

namespace scree::rheology {

/// Weakly compressible Herschel-Bulkley fluid without tension: above its yield stress a power of the shear
/// rate, thinning for n < 1 and thickening for n > 1. With n = 1 it is `Bingham`.
/// @see Eqs. (R1) to (R3), (R5), (R8) and (R10)
struct HerschelBulkley {
  static constexpr std::string_view name = "herschel_bulkley";
  static constexpr std::string_view summary =
      "fluid with a yield stress and a power of the shear rate, regularised (Papanastasiou)";

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double consistency;          ///< K [Pa s^n]
  double exponent;             ///< n [-]
  double yield_stress;         ///< tau_y [Pa]
  double regularisation_time;  ///< m [s]
  double bulk_modulus;         ///< of compression [Pa]
  double density;              ///< rho_0, at which the pressure is zero [kg/m^3]

  static constexpr std::array<LawParameter<HerschelBulkley>, 6> parameters{{
      {"consistency", "Pa s^n", "shear stress beyond yield at a rate of 1/s", &HerschelBulkley::consistency,
       Bound::non_negative, 100},
      {"exponent", "-", "power of the shear rate", &HerschelBulkley::exponent, Bound::positive, 0.4},
      {"yield_stress", "Pa", "shear stress below which it only creeps", &HerschelBulkley::yield_stress,
       Bound::non_negative, 50},
      {"regularisation_time", "s", "inverse of the rate above which it has yielded",
       &HerschelBulkley::regularisation_time, Bound::positive, 100},
      {"bulk_modulus", "Pa", "pressure per relative compression", &HerschelBulkley::bulk_modulus,
       Bound::positive, 1e7},
      {"density", "kg/m^3", "density without pressure", &HerschelBulkley::density, Bound::positive, 1000},
  }};

  /// Viscosity at a shear rate [Pa s].  Eq. (R10)
  template <class Real>
  [[nodiscard]] Real viscosity_at(const Real& shear_rate) const noexcept {
    const double slow = 1 / regularisation_time;  // [1/s]
    const Real rate_squared = shear_rate * shear_rate + slow * slow;
    return consistency * elementary::pow(rate_squared, Real((exponent - 1) / 2)) +
           papanastasiou_viscosity(shear_rate, yield_stress, regularisation_time);
  }

  /// Cauchy stress at the end of the step [Pa]; depends on neither a state nor the step.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& /*input*/, const State<Real>& /*old*/,
                                                   Real /*dt*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    const Real mu = viscosity_at(shear_rate(deformation.velocity_gradient));
    return {newtonian_stress(deformation.velocity_gradient, mu, p), {}};
  }

  /// Wave speed [m/s], Eq. (R2), and viscosity at this rate [Pa s].
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& /*input*/,
                                          const State<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus), viscosity_at(shear_rate(deformation.velocity_gradient))};
  }
};
static_assert(DescribedLaw<HerschelBulkley>);

}  // namespace scree::rheology
