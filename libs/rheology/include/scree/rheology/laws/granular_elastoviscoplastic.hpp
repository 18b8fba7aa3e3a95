#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/newtonian_stress.hpp>
#include <scree/rheology/plane_symmetric.hpp>
#include <scree/rheology/stress_measures.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Grains that rest, flow and fly: elastic below mu_s p, flowing by mu(I) above it, stress-free once they are
/// looser than the density at which they touch. The flow rule is solved in closed form at the end of the
/// step, so that no step is too long for it: the law for landslides.
///
/// Its memory is the deviatoric stress, turned with the material; the pressure follows the density.
/// @see Eqs. (R1), (R2), (R5), (R11), (R12) and (R18) to (R21), from Dunatunga & Kamrin (2015),
/// \cite dunatunga2015
struct GranularElastoviscoplastic {
  static constexpr std::string_view name = "granular_elastoviscoplastic";
  static constexpr std::string_view summary =
      "grains that rest, flow by mu(I) and disconnect; no viscous limit of the step";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool remembers_deviator = true;

  template <class Real>
  struct Input {
    Real grain_size;  ///< arithmetic mean s_a [m]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  using State = Symmetric<Real>;  ///< deviator of the Cauchy stress [Pa]
  template <class Real>
  using PlaneState = PlaneSymmetric<Real>;
  static constexpr std::array<StateColumn, 6> states = deviatoric_stress_columns;
  static constexpr std::array<std::size_t, 4> plane_states{0, 1, 2, 3};

  double mu_s;           ///< friction at which flow begins [-]
  double mu_2;           ///< friction of fast flow [-]
  double I_0;            ///< inertial number half way between them [-]
  double grain_density;  ///< rho_s, of the solid [kg/m^3]
  double shear_modulus;  ///< G [Pa]
  double bulk_modulus;   ///< K [Pa]
  double density;        ///< rho_0 of the bulk, below which grains do not touch [kg/m^3]

  using Self = GranularElastoviscoplastic;
  static constexpr std::array<LawParameter<GranularElastoviscoplastic>, 7> parameters{{
      {"mu_s", "-", "friction at which flow begins", &Self::mu_s, Bound::positive, 0.382},
      {.name = "mu_2",
       .unit = "-",
       .meaning = "friction of fast flow",
       .member = &Self::mu_2,
       .bound = Bound::positive,
       .typical = 0.644,
       .exceeds = &Self::mu_s},
      {"I_0", "-", "inertial number half way between them", &Self::I_0, Bound::positive, 0.279},
      {"grain_density", "kg/m^3", "density of the solid", &Self::grain_density, Bound::positive, 2500},
      {"shear_modulus", "Pa", "elastic shear modulus", &Self::shear_modulus, Bound::positive, 5e5},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Self::bulk_modulus, Bound::positive, 1e6},
      {"density", "kg/m^3", "density below which grains do not touch", &Self::density, Bound::positive, 1500},
  }};

  /// Friction at yield [-].  Eq. (R164)
  [[nodiscard]] constexpr double yield_friction() const noexcept { return mu_s; }

  /// Cauchy stress and its deviator at the end of the step [Pa].
  template <class Real, template <class> class Form>
  [[nodiscard]] Response<Real, Form<Real>> update(const Deformation<Real>& deformation,
                                                  const Input<Real>& input, const Form<Real>& old,
                                                  Real dt) const noexcept {
    return correct(deformation, input, predict(deformation, old, dt), dt);
  }

  /// The deviator of stress [Pa] if all of the step is elastic.
  template <class Real, template <class> class Form>
  [[nodiscard]] Form<Real> predict(const Deformation<Real>& deformation, const Form<Real>& old,
                                   Real dt) const noexcept {
    const Tensor<Real>& gradient = deformation.velocity_gradient;
    const Form<Real> half = Form<Real>::of(Real(shear_modulus * dt) * deviatoric_rate(gradient));
    return turned(old + half, gradient, dt) + half;
  }

  /// What flow leaves of it.
  template <class Real, template <class> class Form>
  [[nodiscard]] Response<Real, Form<Real>> correct(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const Form<Real>& trial,
                                                   Real dt) const noexcept {
    using std::sqrt;
    const Real p = pressure(deformation.density, density, bulk_modulus);
    const Real is_connected = select(p < 0.0, Real(0.0), Real(1.0));
    const Real tau_trial = sqrt(0.5 * squared_norm(trial));
    const Real kept = share_kept(tau_trial, contact_pressure(p), input.grain_size, dt);
    const Real share = is_connected * kept;
    const Form<Real> deviator = share * trial;
    return {deviator.tensor() - isotropic<Real>(is_connected * p), deviator};
  }

  /// Speed of pressure waves [m/s], Eq. (R21). The viscosity that bounds a step is zero: over a step the
  /// stress changes by at most 2 G D' dt, however slowly the flow would relax it.
  template <class Real, template <class> class Form>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/,
                                          const Input<Real>& /*input*/,
                                          const Form<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus + 4 * shear_modulus / 3), 0};
  }

  /// C of Eq. (R15) [-] at the inertial number of the flow, which the stress tells; zero where the grains
  /// rest or do not touch.
  [[nodiscard]] double stability_number(const Deformation<double>& deformation,
                                        const Input<double>& /*input*/,
                                        const State<double>& state) const noexcept {
    const double p = pressure(deformation.density, density, bulk_modulus);
    const double tau = std::sqrt(0.5 * squared_norm(state));
    if (!(p > 0) || tau <= mu_s * p || tau >= mu_2 * p) return 0;
    const double friction = tau / p;
    const double i = I_0 * (friction - mu_s) / (mu_2 - friction);
    const double slope = (mu_2 - mu_s) * I_0 / ((I_0 + i) * (I_0 + i));
    return rheology::stability_number(i, friction, slope);
  }

 private:
  /// tau/tau_trial [-] of the flow rule at the end of the step, 1 below yield.  Eqs. (R19), (R20)
  template <class Real>
  [[nodiscard]] Real share_kept(const Real& tau_trial, const Real& p, const Real& grain_size,
                                const Real& dt) const noexcept {
    using std::sqrt;
    const Real S_0 = mu_s * p;
    const Real S_2 = mu_2 * p;
    const Real xi = I_0 * shear_modulus / sqrt(grain_density) * sqrt(p) * dt / grain_size;
    const Real b = S_2 + tau_trial + xi;
    const Real H = S_2 * tau_trial + S_0 * xi;
    const Real excess = tau_trial - S_2 + xi;
    const Real root = sqrt(excess * excess + 4.0 * (S_2 - S_0) * xi);  // of b^2 - 4 H, as a sum of positives
    const Real flowing = 2.0 * H / ((b + root) * tau_trial);
    return select(tau_trial <= S_0, Real(1.0), flowing);
  }
};
static_assert(DescribedLaw<GranularElastoviscoplastic> && HasPlaneForm<GranularElastoviscoplastic> &&
              HasStabilityNumber<GranularElastoviscoplastic> && HasYieldFriction<GranularElastoviscoplastic>);

}  // namespace scree::rheology
