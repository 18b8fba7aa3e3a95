#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/newtonian_stress.hpp>
#include <scree/rheology/plane_symmetric.hpp>
#include <scree/rheology/stress_measures.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// A fluid with a true yield stress: elastic below it, a power of the rate above; Bingham's with n = 1. It
/// stops where `HerschelBulkley` creeps, and the flow rule is solved at the end of the step, so that no step
/// is too long for it.
///
/// Its memory is the deviatoric stress, turned with the material; the pressure follows the density.
/// @see Eqs. (R1), (R2), (R5), (R18), (R21) and (R70) to (R73), from Saramito (2007, 2009),
/// \cite saramito2007, \cite saramito2009
struct ElasticHerschelBulkley {
  static constexpr std::string_view name = "elastic_herschel_bulkley";
  static constexpr std::string_view summary =
      "fluid with a true yield stress, elastic below it; no viscous limit of the step";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool remembers_deviator = true;

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  using State = Symmetric<Real>;  ///< deviator of the Cauchy stress [Pa]
  template <class Real>
  using PlaneState = PlaneSymmetric<Real>;
  static constexpr std::array<StateColumn, 6> states = deviatoric_stress_columns;
  static constexpr std::array<std::size_t, 4> plane_states{0, 1, 2, 3};

  double consistency;    ///< K [Pa s^n]
  double exponent;       ///< n [-]; 1 is Bingham's fluid, in closed form
  double yield_stress;   ///< tau_y [Pa]
  double shear_modulus;  ///< G [Pa], far above the shear stress
  double bulk_modulus;   ///< of compression [Pa]
  double density;        ///< rho_0, at which the pressure is zero [kg/m^3]

  using Self = ElasticHerschelBulkley;
  static constexpr std::array<LawParameter<ElasticHerschelBulkley>, 6> parameters{{
      {"consistency", "Pa s^n", "shear stress beyond yield at a rate of 1/s", &Self::consistency,
       Bound::positive, 100},
      {"exponent", "-", "power of the shear rate; 1 is Bingham's fluid", &Self::exponent, Bound::positive,
       0.4},
      {"yield_stress", "Pa", "shear stress at which flow begins", &Self::yield_stress, Bound::non_negative,
       50},
      {"shear_modulus", "Pa", "elastic shear modulus, far above the shear stress", &Self::shear_modulus,
       Bound::positive, 1e6},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Self::bulk_modulus, Bound::positive, 1e7},
      {"density", "kg/m^3", "density without pressure", &Self::density, Bound::positive, 1000},
  }};

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
                                                   const Input<Real>& /*input*/, const Form<Real>& trial,
                                                   Real dt) const noexcept {
    using std::sqrt;
    const Real p = pressure(deformation.density, density, bulk_modulus);
    const Real is_connected = select(p < 0.0, Real(0.0), Real(1.0));
    const Real tau_trial = sqrt(0.5 * squared_norm(trial));
    const Real excess = tau_trial - yield_stress;
    const Share<Real> left = share_left(excess, Real(shear_modulus * dt));
    const Real kept = select(excess <= 0.0, Real(1.0), (yield_stress + excess * left.value) / tau_trial);
    const Real share = is_connected * kept;
    const Form<Real> deviator = share * trial;
    return {deviator.tensor() - isotropic<Real>(is_connected * p), deviator,
            select(excess <= 0.0, Real(0.0), left.unsolved)};
  }

  /// Speed of pressure waves [m/s], Eq. (R21). No viscosity bounds a step, for flow only lowers what the
  /// elastic solid would answer.
  template <class Real, template <class> class Form>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/,
                                          const Input<Real>& /*input*/,
                                          const Form<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus + 4 * shear_modulus / 3), 0};
  }

 private:
  template <class Real>
  struct Share {
    Real value;
    Real unsolved;
  };

  /// Share of the stress beyond yield that is left at the end of the step, and what is left of its equation
  /// if that is above `tolerance`.  Eqs. (R71), (R72)
  ///
  /// Newton's method for the logarithm of the share: the function is convex and between n and 1 steep, so
  /// that it comes down to the root from the upper bound that it starts at. Six steps reach round-off for n
  /// from 0.1 to 10, whatever the material and the step.
  template <class Real>
  [[nodiscard]] Share<Real> share_left(const Real& excess, const Real& modulus_dt) const noexcept {
    if (exponent == 1) return {consistency / (consistency + modulus_dt), Real(0.0)};
    constexpr int num_steps = 6;
    constexpr double tolerance = 1e-10;  // [-], of the stress beyond yield
    const double m = 1 / exponent;
    const Real log_b = elementary::log(modulus_dt / excess) + m * elementary::log(excess / consistency);
    const Real bound = -exponent * log_b;
    Real z = select(bound < 0.0, bound, Real(0.0));
    for (int i = 0; i < num_steps; ++i) {
      const Real ratio = elementary::exp(log_b + (m - 1) * z);  // of the flow's term to the stress's
      z = z - (z + elementary::log(1.0 + ratio)) / (1.0 + (m - 1) * ratio / (1.0 + ratio));
    }
    const Real rest = z + elementary::log(1.0 + elementary::exp(log_b + (m - 1) * z));
    const Real size = select(rest < 0.0, -rest, rest);
    return {elementary::exp(z), select(size <= tolerance, Real(0.0), size)};
  }
};
static_assert(DescribedLaw<ElasticHerschelBulkley> && HasPlaneForm<ElasticHerschelBulkley>);

}  // namespace scree::rheology
