#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::rheology {

/// Dense granular flow: friction that grows from mu_s to mu_2 with the inertial number of the local mean
/// grain size. Weakly compressible, without tension, and without a true yield: below mu_s p it creeps as the
/// floor of the shear rate lets it.
///
/// Ill-posed where `stability_number` is positive: slow flow and fast flow, but not between.
/// @see Eqs. (R1) to (R3), (R5) and (R11) to (R15), from Jop, Forterre & Pouliquen (2006), \cite jop2006
struct MuOfI {
  static constexpr std::string_view name = "mu_of_i";
  static constexpr std::string_view summary = "dense granular flow, friction by the inertial number";

  template <class Real>
  struct Input {
    Real grain_size;  ///< arithmetic mean s_a [m]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double mu_s;              ///< friction of slow flow [-]
  double mu_2;              ///< friction of fast flow [-]
  double I_0;               ///< inertial number half way between them [-]
  double grain_density;     ///< rho_s, of the solid [kg/m^3]
  double shear_rate_floor;  ///< [1/s], keeps the viscosity finite at rest; error bound in Eq. (R14)
  double bulk_modulus;      ///< K [Pa]
  double density;           ///< rho_0 of the bulk, at which the pressure is zero [kg/m^3]

  static constexpr std::array<LawParameter<MuOfI>, 7> parameters{{
      {"mu_s", "-", "friction of slow flow", &MuOfI::mu_s, Bound::positive, 0.382},
      {.name = "mu_2",
       .unit = "-",
       .meaning = "friction of fast flow",
       .member = &MuOfI::mu_2,
       .bound = Bound::positive,
       .typical = 0.644,
       .exceeds = &MuOfI::mu_s},
      {"I_0", "-", "inertial number half way between them", &MuOfI::I_0, Bound::positive, 0.279},
      {"grain_density", "kg/m^3", "density of the solid", &MuOfI::grain_density, Bound::positive, 2500},
      {"shear_rate_floor", "1/s", "rate below which it creeps", &MuOfI::shear_rate_floor, Bound::positive,
       1e-3},
      {"bulk_modulus", "Pa", "pressure per relative compression", &MuOfI::bulk_modulus, Bound::positive, 1e6},
      {"density", "kg/m^3", "density without pressure", &MuOfI::density, Bound::positive, 1500},
  }};

  /// Friction at yield [-].  Eq. (R164)
  [[nodiscard]] constexpr double yield_friction() const noexcept { return mu_s; }

  /// Friction at an inertial number [-].  Eq. (R11)
  [[nodiscard]] double friction(double inertial_number) const noexcept {
    return mu_s + (mu_2 - mu_s) * inertial_number / (I_0 + inertial_number);
  }

  /// Viscosity mu p/gdot [Pa s]; written so that it is finite down to p = 0, where there is none.  Eq. (R13)
  template <class Real>
  [[nodiscard]] Real viscosity_at(const Tensor<Real>& velocity_gradient, const Real& grain_size,
                                  const Real& p) const noexcept {
    using std::sqrt;
    const Real gdot = floored_shear_rate(velocity_gradient, shear_rate_floor);
    const Real grain_rate = gdot * grain_size * sqrt(grain_density);  // I sqrt(p)
    const Real root_p = sqrt(contact_pressure(p));
    return mu_of_i_strength(mu_s, mu_2, I_0, grain_rate, root_p) / gdot;
  }

  /// Cauchy stress at the end of the step [Pa]; depends on neither a state nor the step.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& /*old*/,
                                                   Real /*dt*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    const Real eta = viscosity_at(deformation.velocity_gradient, input.grain_size, p);
    return {newtonian_stress(deformation.velocity_gradient, eta, p), {}};
  }

  /// Wave speed [m/s], Eq. (R2), and viscosity at this rate and pressure [Pa s].
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& input,
                                          const State<Real>& /*state*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    return {wave_speed(density, bulk_modulus),
            viscosity_at(deformation.velocity_gradient, input.grain_size, p)};
  }

  /// C of Eq. (R15) [-]; zero where there is no contact, and so no flow law.
  [[nodiscard]] double stability_number(const Deformation<double>& deformation, const Input<double>& input,
                                        const State<double>& /*state*/) const noexcept {
    const double p = pressure(deformation.density, density, bulk_modulus);
    if (p <= 0) return 0;
    const double gdot = floored_shear_rate(deformation.velocity_gradient, shear_rate_floor);
    const double i = inertial_number(gdot, input.grain_size, p, grain_density);
    const double slope = (mu_2 - mu_s) * I_0 / ((I_0 + i) * (I_0 + i));
    return rheology::stability_number(i, friction(i), slope);
  }
};
static_assert(DescribedLaw<MuOfI> && HasStabilityNumber<MuOfI> && HasYieldFriction<MuOfI>);

}  // namespace scree::rheology
