#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::rheology {

/// Dense flow of fine and coarse grains that rub differently: the mu(I) law with the mean grain size in I and
/// with parameters between those of the fines and those of the coarse, by their shares of the solid volume.
/// Where coarse, rough grains gather the flow stiffens.
/// @see Eqs. (R1) to (R3), (R5), (R11) to (R15) and (R76), from Rognon et al. (2007), \cite rognon2007, and
/// Baker, Johnson & Gray (2016), \cite baker2016
struct MixtureMuOfI {
  static constexpr std::string_view name = "mixture_mu_of_i";
  static constexpr std::string_view summary = "dense flow of two kinds of grains, mu(I) mixed by volume";

  template <class Real>
  struct Input {
    Real grain_size;       ///< arithmetic mean s_a [m]
    Real coarse_fraction;  ///< share of the coarse grains in the solid volume [-]
  };
  static constexpr std::array<InputColumn, 2> inputs{
      {{"grain_size", "m", 1e-3}, {"coarse_fraction", "-", 0.5, {.lower = 0, .upper = 1, .is_open = false}}}};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double mu_s_fine;         ///< friction of slow flow of fines [-]
  double mu_s_coarse;       ///< and of coarse grains
  double mu_2_fine;         ///< friction of fast flow of fines [-]
  double mu_2_coarse;       ///< and of coarse grains
  double I_0_fine;          ///< inertial number half way between them, of fines [-]
  double I_0_coarse;        ///< and of coarse grains
  double grain_density;     ///< rho_s, of the solid [kg/m^3]
  double shear_rate_floor;  ///< [1/s], keeps the viscosity finite at rest; error bound in Eq. (R14)
  double bulk_modulus;      ///< K [Pa]
  double density;           ///< rho_0 of the bulk, at which the pressure is zero [kg/m^3]

  using Self = MixtureMuOfI;
  static constexpr std::array<LawParameter<MixtureMuOfI>, 10> parameters{{
      {"mu_s_fine", "-", "friction of slow flow of fines", &Self::mu_s_fine, Bound::positive, 0.382},
      {"mu_s_coarse", "-", "friction of slow flow of coarse grains", &Self::mu_s_coarse, Bound::positive,
       0.477},
      {.name = "mu_2_fine",
       .unit = "-",
       .meaning = "friction of fast flow of fines",
       .member = &Self::mu_2_fine,
       .bound = Bound::positive,
       .typical = 0.644,
       .exceeds = &Self::mu_s_fine},
      {.name = "mu_2_coarse",
       .unit = "-",
       .meaning = "friction of fast flow of coarse grains",
       .member = &Self::mu_2_coarse,
       .bound = Bound::positive,
       .typical = 0.781,
       .exceeds = &Self::mu_s_coarse},
      {"I_0_fine", "-", "inertial number half way between them, of fines", &Self::I_0_fine, Bound::positive,
       0.279},
      {"I_0_coarse", "-", "inertial number half way between them, of coarse grains", &Self::I_0_coarse,
       Bound::positive, 0.279},
      {"grain_density", "kg/m^3", "density of the solid", &Self::grain_density, Bound::positive, 2500},
      {"shear_rate_floor", "1/s", "rate below which it creeps", &Self::shear_rate_floor, Bound::positive,
       1e-3},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Self::bulk_modulus, Bound::positive, 1e6},
      {"density", "kg/m^3", "density without pressure", &Self::density, Bound::positive, 1500},
  }};

  /// Friction at yield [-], of this mix.  Eqs. (R76), (R164)
  [[nodiscard]] double yield_friction(const Input<double>& input) const noexcept {
    return friction_of(input.coarse_fraction).mu_s;
  }

  /// Viscosity mu p/gdot [Pa s], finite down to p = 0, where there is none.  Eqs. (R13), (R76)
  template <class Real>
  [[nodiscard]] Real viscosity_at(const Tensor<Real>& velocity_gradient, const Input<Real>& input,
                                  const Real& p) const noexcept {
    using std::sqrt;
    const Real gdot = floored_shear_rate(velocity_gradient, shear_rate_floor);
    const Real grain_rate = gdot * input.grain_size * sqrt(grain_density);  // I sqrt(p)
    const Real root_p = sqrt(contact_pressure(p));
    const Friction<Real> mix = friction_of(input.coarse_fraction);
    return mu_of_i_strength(mix.mu_s, mix.mu_2, mix.I_0, grain_rate, root_p) / gdot;
  }

  /// Cauchy stress at the end of the step [Pa]; depends on neither a state nor the step.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& /*old*/,
                                                   Real /*dt*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    const Real eta = viscosity_at(deformation.velocity_gradient, input, p);
    return {newtonian_stress(deformation.velocity_gradient, eta, p), {}};
  }

  /// Wave speed [m/s], Eq. (R2), and viscosity of this mix at this rate and pressure [Pa s].
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& input,
                                          const State<Real>& /*state*/) const noexcept {
    const Real p = pressure(deformation.density, density, bulk_modulus);
    return {wave_speed(density, bulk_modulus), viscosity_at(deformation.velocity_gradient, input, p)};
  }

  /// C of Eq. (R15) for a mix that stays as it is [-]; zero where there is no contact, and so no flow law.
  [[nodiscard]] double stability_number(const Deformation<double>& deformation, const Input<double>& input,
                                        const State<double>& /*state*/) const noexcept {
    const double p = pressure(deformation.density, density, bulk_modulus);
    if (p <= 0) return 0;
    const Friction<double> mix = friction_of(input.coarse_fraction);
    const double gdot = floored_shear_rate(deformation.velocity_gradient, shear_rate_floor);
    const double i = inertial_number(gdot, input.grain_size, p, grain_density);
    const double friction = mix.mu_s + (mix.mu_2 - mix.mu_s) * i / (mix.I_0 + i);
    const double slope = (mix.mu_2 - mix.mu_s) * mix.I_0 / ((mix.I_0 + i) * (mix.I_0 + i));
    return rheology::stability_number(i, friction, slope);
  }

 private:
  /// The parameters of the mu(I) law of one mix [-].
  template <class Real>
  struct Friction {
    Real mu_s, mu_2, I_0;
  };

  /// Between the two by volume.  Eq. (R76)
  template <class Real>
  [[nodiscard]] Friction<Real> friction_of(const Real& coarse) const noexcept {
    return {mu_s_fine + (mu_s_coarse - mu_s_fine) * coarse, mu_2_fine + (mu_2_coarse - mu_2_fine) * coarse,
            I_0_fine + (I_0_coarse - I_0_fine) * coarse};
  }
};
static_assert(DescribedLaw<MixtureMuOfI> && HasStabilityNumber<MixtureMuOfI> &&
              HasLocalYieldFriction<MixtureMuOfI>);

}  // namespace scree::rheology
