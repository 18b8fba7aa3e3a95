#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::rheology {

/// The mu(I) law changed so that its equations are well posed: friction falls to zero with I as slowly as it
/// may below I_1, and grows in proportion to I, by mu_inf, far above I_0. With mu_inf = 0 only the slow side
/// is mended, and fast flow stays ill-posed.
/// @see Eqs. (R1) to (R3), (R5), (R12) to (R17), from Barker & Gray (2017), \cite barker2017
struct RegularisedMuOfI {
  static constexpr std::string_view name = "regularised_mu_of_i";
  static constexpr std::string_view summary = "dense granular flow, mu(I) made well posed (Barker & Gray)";

  template <class Real>
  struct Input {
    Real grain_size;  ///< arithmetic mean s_a [m]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double mu_s;              ///< friction of slow flow, were it not for I_1 [-]
  double mu_2;              ///< friction of fast flow, were it not for mu_inf [-]
  double mu_inf;            ///< growth of friction with I in very fast flow [-]
  double alpha;             ///< decay of friction in slow flow, below 2 [-]
  double I_0;               ///< inertial number half way between mu_s and mu_2 [-]
  double I_1;               ///< inertial number below which friction decays to zero [-]
  double grain_density;     ///< rho_s, of the solid [kg/m^3]
  double shear_rate_floor;  ///< [1/s], keeps the viscosity finite at rest; error bound in Eq. (R14)
  double bulk_modulus;      ///< K [Pa]
  double density;           ///< rho_0 of the bulk, at which the pressure is zero [kg/m^3]

  using Self = RegularisedMuOfI;
  static constexpr std::array<LawParameter<RegularisedMuOfI>, 10> parameters{{
      {"mu_s", "-", "friction of slow flow", &Self::mu_s, Bound::positive, 0.342},
      {.name = "mu_2",
       .unit = "-",
       .meaning = "friction of fast flow",
       .member = &Self::mu_2,
       .bound = Bound::positive,
       .typical = 0.557,
       .exceeds = &Self::mu_s},
      {"mu_inf", "-", "growth of friction with I in very fast flow", &Self::mu_inf, Bound::non_negative,
       0.05},
      {"alpha", "-", "decay of friction in very slow flow", &Self::alpha, Bound::positive, 1.9, 2},
      {"I_0", "-", "inertial number half way between mu_s and mu_2", &Self::I_0, Bound::positive, 0.069},
      {"I_1", "-", "inertial number below which friction decays", &Self::I_1, Bound::positive, 0.00398},
      {"grain_density", "kg/m^3", "density of the solid", &Self::grain_density, Bound::positive, 2500},
      {"shear_rate_floor", "1/s", "rate below which it creeps", &Self::shear_rate_floor, Bound::positive,
       1e-3},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Self::bulk_modulus, Bound::positive, 1e6},
      {"density", "kg/m^3", "density without pressure", &Self::density, Bound::positive, 1500},
  }};

  /// Friction at an inertial number, positive [-].  Eqs. (R16), (R17)
  [[nodiscard]] double friction(double inertial_number) const noexcept {
    return strength(inertial_number, 1.0);
  }

  /// Viscosity mu p/gdot [Pa s]; written so that it is finite down to p = 0, where there is none.  Eq. (R13)
  template <class Real>
  [[nodiscard]] Real viscosity_at(const Tensor<Real>& velocity_gradient, const Real& grain_size,
                                  const Real& p) const noexcept {
    using std::sqrt;
    const Real gdot = floored_shear_rate(velocity_gradient, shear_rate_floor);
    return strength(Real(gdot * grain_size * sqrt(grain_density)), Real(sqrt(contact_pressure(p)))) / gdot;
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
    return rheology::stability_number(i, friction(i), friction_slope(i));
  }

 private:
  /// Shear strength mu p [Pa] from I sqrt(p) and sqrt(p) [sqrt(Pa)].
  template <class Real>
  [[nodiscard]] Real strength(const Real& grain_rate, const Real& root_p) const noexcept {
    using std::sqrt;
    const Real fast =
        root_p *
        (mu_s * I_0 * root_p * root_p + mu_2 * grain_rate * root_p + mu_inf * grain_rate * grain_rate) /
        (I_0 * root_p + grain_rate);
    const Real slow =
        root_p * root_p * sqrt(alpha / (slowest() + elementary::log(I_1 * root_p / grain_rate)));
    return select(grain_rate <= I_1 * root_p, slow, fast);
  }

  /// alpha / mu(I_1)^2: the logarithm of A/I_1, which joins the two branches.  Eq. (R17)
  [[nodiscard]] double slowest() const noexcept {
    const double mu_1 = (mu_s * I_0 + mu_2 * I_1 + mu_inf * I_1 * I_1) / (I_0 + I_1);
    return alpha / (mu_1 * mu_1);
  }

  /// dmu/dI [-].
  [[nodiscard]] double friction_slope(double i) const noexcept {
    const double mu = friction(i);
    if (i <= I_1) return mu * mu * mu / (2 * alpha * i);
    return ((mu_2 + 2 * mu_inf * i) - mu) / (I_0 + i);
  }
};
static_assert(DescribedLaw<RegularisedMuOfI> && HasStabilityNumber<RegularisedMuOfI>);

}  // namespace scree::rheology
