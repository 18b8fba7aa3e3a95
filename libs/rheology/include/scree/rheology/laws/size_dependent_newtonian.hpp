#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Weakly compressible Newtonian fluid without tension whose viscosity grows with the mean grain size,
/// mu = M s_a: where coarse grains gather the flow stiffens.
/// @see Eqs. (R1) to (R5), from Marks & Einav, \cite marks2015
struct SizeDependentNewtonian {
  static constexpr std::string_view name = "size_dependent_newtonian";
  static constexpr std::string_view summary =
      "weakly compressible fluid of viscosity proportional to the mean grain size";
  static constexpr std::size_t most_lanes = 8;  // measured

  template <class Real>
  struct Input {
    Real grain_size;  ///< arithmetic mean s_a [m]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double viscosity_per_size;  ///< M [Pa s/m]
  double bulk_modulus;        ///< K [Pa]
  double density;             ///< rho_0, at which the pressure is zero [kg/m^3]

  static constexpr std::array<LawParameter<SizeDependentNewtonian>, 3> parameters{{
      {"viscosity_per_size", "Pa s/m", "dynamic viscosity per mean grain size",
       &SizeDependentNewtonian::viscosity_per_size, Bound::non_negative, 1e6},
      {"bulk_modulus", "Pa", "pressure per relative compression", &SizeDependentNewtonian::bulk_modulus,
       Bound::positive, 1e7},
      {"density", "kg/m^3", "density without pressure", &SizeDependentNewtonian::density, Bound::positive,
       1000},
  }};

  /// Cauchy stress at the end of the step [Pa]; depends on neither a state nor the step.
  template <class Real>
  [[nodiscard]] constexpr Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                             const Input<Real>& input,
                                                             const State<Real>& /*old*/,
                                                             Real /*dt*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    const Real viscosity = viscosity_per_size * input.grain_size;
    return {newtonian_stress(deformation.velocity_gradient, viscosity, p), {}};
  }

  /// Wave speed [m/s], Eq. (R2), and viscosity [Pa s], Eq. (R4).
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/, const Input<Real>& input,
                                          const State<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus), viscosity_per_size * input.grain_size};
  }
};
static_assert(DescribedLaw<SizeDependentNewtonian>);

}  // namespace scree::rheology
