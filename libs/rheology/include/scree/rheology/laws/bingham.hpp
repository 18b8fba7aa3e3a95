#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/newtonian_stress.hpp>
#include <scree/rheology/yield_stress.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Weakly compressible Bingham fluid without tension: it flows in earnest only above its yield stress. Below
/// it creeps, with the viscosity K + tau_y m, which also bounds an explicit step.
/// @see Eqs. (R1) to (R3), (R5), (R8) and (R9)
struct Bingham {
  static constexpr std::string_view name = "bingham";
  static constexpr std::string_view summary = "fluid with a yield stress, regularised (Papanastasiou)";
  static constexpr std::size_t most_lanes = 8;  // measured

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double viscosity;            ///< K, of the yielded material [Pa s]
  double yield_stress;         ///< tau_y [Pa]
  double regularisation_time;  ///< m [s]
  double bulk_modulus;         ///< of compression [Pa]
  double density;              ///< rho_0, at which the pressure is zero [kg/m^3]

  static constexpr std::array<LawParameter<Bingham>, 5> parameters{{
      {"viscosity", "Pa s", "viscosity of the yielded material", &Bingham::viscosity, Bound::non_negative,
       750},
      {"yield_stress", "Pa", "shear stress below which it only creeps", &Bingham::yield_stress,
       Bound::non_negative, 1000},
      {"regularisation_time", "s", "inverse of the rate above which it has yielded",
       &Bingham::regularisation_time, Bound::positive, 100},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Bingham::bulk_modulus, Bound::positive,
       1e7},
      {"density", "kg/m^3", "density without pressure", &Bingham::density, Bound::positive, 1000},
  }};

  /// Viscosity at a shear rate [Pa s].  Eq. (R9)
  template <class Real>
  [[nodiscard]] Real viscosity_at(const Real& shear_rate) const noexcept {
    return viscosity + papanastasiou_viscosity(shear_rate, yield_stress, regularisation_time);
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
static_assert(DescribedLaw<Bingham>);

}  // namespace scree::rheology
