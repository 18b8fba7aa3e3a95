#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Weakly compressible Newtonian fluid without tension: one viscosity, whatever the grains.
/// @see Eqs. (R1) to (R3) and (R5)
struct Newtonian {
  static constexpr std::string_view name = "newtonian";
  static constexpr std::string_view summary = "weakly compressible fluid of constant viscosity";
  static constexpr std::size_t most_lanes = 8;  // measured

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double viscosity;     ///< mu [Pa s]
  double bulk_modulus;  ///< K [Pa]
  double density;       ///< rho_0, at which the pressure is zero [kg/m^3]

  static constexpr std::array<LawParameter<Newtonian>, 3> parameters{{
      {"viscosity", "Pa s", "dynamic viscosity", &Newtonian::viscosity, Bound::non_negative, 750},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Newtonian::bulk_modulus, Bound::positive,
       1e7},
      {"density", "kg/m^3", "density without pressure", &Newtonian::density, Bound::positive, 1000},
  }};

  /// Cauchy stress at the end of the step [Pa]; depends on neither a state nor the step.
  template <class Real>
  [[nodiscard]] constexpr Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                             const Input<Real>& /*input*/,
                                                             const State<Real>& /*old*/,
                                                             Real /*dt*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    return {newtonian_stress(deformation.velocity_gradient, Real(viscosity), p), {}};
  }

  /// Wave speed [m/s], Eq. (R2), and viscosity [Pa s].
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/,
                                          const Input<Real>& /*input*/,
                                          const State<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus), viscosity};
  }
};
static_assert(DescribedLaw<Newtonian>);

}  // namespace scree::rheology
