#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Grains in a liquid that flow as one: the viscosity of the liquid, raised without bound as the solid
/// fraction nears the largest that the local mix of sizes can have. Beyond it the grains are jammed, and
/// creep with a viscosity that is a parameter.
/// @see Eqs. (R1) to (R3), (R5), (R74) and (R75), from Krieger & Dougherty (1959), \cite krieger1959
struct Suspension {
  static constexpr std::string_view name = "suspension";
  static constexpr std::string_view summary =
      "grains in a liquid, of a viscosity that grows up to the packing of the local mix of sizes";
  static constexpr std::size_t most_lanes = 8;  // measured

  template <class Real>
  struct Input {
    Real maximum_packing;  ///< phi_max, solid fraction at which the local mix of sizes jams [-]
  };
  static constexpr std::array<InputColumn, 1> inputs{
      {{"maximum_packing", "-", 0.64, {.lower = 0, .upper = 1}}}};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double liquid_viscosity;     ///< eta_f [Pa s]
  double intrinsic_viscosity;  ///< [eta], of the first grains [-]; 2.5 for spheres
  double solid_fraction;       ///< phi_0, at `density` [-]
  double jammed_viscosity;     ///< that of grains at phi_max and beyond, and the highest [Pa s]
  double bulk_modulus;         ///< K [Pa]
  double density;              ///< rho_0 of the suspension, at which the pressure is zero [kg/m^3]

  static constexpr std::array<LawParameter<Suspension>, 6> parameters{{
      {"liquid_viscosity", "Pa s", "viscosity without grains", &Suspension::liquid_viscosity, Bound::positive,
       1},
      {"intrinsic_viscosity", "-", "what the first grains add per solid fraction",
       &Suspension::intrinsic_viscosity, Bound::positive, 2.5},
      {"solid_fraction", "-", "share of the volume that is grains, without pressure",
       &Suspension::solid_fraction, Bound::non_negative, 0.5, 1},
      {.name = "jammed_viscosity",
       .unit = "Pa s",
       .meaning = "viscosity of jammed grains, and the highest",
       .member = &Suspension::jammed_viscosity,
       .bound = Bound::positive,
       .typical = 1000,
       .exceeds = &Suspension::liquid_viscosity},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Suspension::bulk_modulus, Bound::positive,
       1e7},
      {"density", "kg/m^3", "density without pressure", &Suspension::density, Bound::positive, 1800},
  }};

  /// Viscosity at a solid fraction [Pa s].  Eqs. (R74), (R75)
  template <class Real>
  [[nodiscard]] Real viscosity_at(const Real& fraction, const Real& maximum_packing) const noexcept {
    const auto is_jammed = maximum_packing <= fraction;
    const Real room = select(is_jammed, Real(1.0), Real(1.0 - fraction / maximum_packing));
    const Real flowing =
        liquid_viscosity * elementary::exp(-(intrinsic_viscosity * maximum_packing) * elementary::log(room));
    const Real highest = jammed_viscosity;
    return select(is_jammed, highest, select(highest < flowing, highest, flowing));
  }

  /// Cauchy stress at the end of the step [Pa]; depends on neither a state nor the step.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& /*old*/,
                                                   Real /*dt*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    const Real eta = viscosity_at(fraction_at(deformation.density), input.maximum_packing);
    return {newtonian_stress(deformation.velocity_gradient, eta, p), {}};
  }

  /// Wave speed [m/s], Eq. (R2), and viscosity of this mix at this density [Pa s].
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& input,
                                          const State<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus),
            viscosity_at(fraction_at(deformation.density), input.maximum_packing)};
  }

 private:
  /// Grains and liquid are compressed as one.
  template <class Real>
  [[nodiscard]] Real fraction_at(const Real& rho) const noexcept {
    return rho * (solid_fraction / density);
  }
};
static_assert(DescribedLaw<Suspension>);

}  // namespace scree::rheology
