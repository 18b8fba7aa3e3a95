#pragma once

#include <scree/rheology/cam_clay_return.hpp>
#include <scree/rheology/columns.hpp>
#include <scree/rheology/concepts.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/logarithmic_strain.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Clay at large strain: elastic in the logarithmic (Hencky) strain with a bulk modulus in proportion to its
/// pressure, an elliptic yield surface that grows as it is compacted by flow and shrinks as it dilates, until
/// it flows at constant volume in the critical state, q = M p.
///
/// Its memory is the elastic strain at constant volume and the preconsolidation pressure, from which the
/// volume of flow follows. The shear modulus is constant: a constant Poisson's ratio would make one in
/// proportion to pressure, from which cycles of load gain work.
/// @see Eqs. (R62) to (R69) and (R183), from Roscoe & Burland (1968), \cite roscoe1968, with the logarithmic
/// compression of Butterfield (1979), \cite butterfield1979
struct ModifiedCamClay {
  static constexpr std::string_view name = "modified_cam_clay";
  static constexpr std::string_view summary = "clay that hardens by compaction and ends in a critical state";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool remembers_deviator = true;
  static constexpr bool disconnects = false;  ///< it presses, ever less, far below `density`

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real, template <class> class Form>
  struct Memory {
    Form<Real> strain;      ///< elastic logarithmic strain, of trace 0 [-]
    Real preconsolidation;  ///< p_c over `preconsolidation_pressure` [-]
  };
  template <class Real>
  using State = Memory<Real, Symmetric>;
  template <class Real>
  using PlaneState = Memory<Real, PlaneSymmetric>;
  static constexpr std::array<StateColumn, 7> states =
      followed_by(elastic_strain_columns, StateColumn{"preconsolidation", "-", 1, Interval{}});
  static constexpr std::array<std::size_t, 5> plane_states{0, 1, 2, 3, 6};

  double critical_ratio;             ///< M, q/p in the critical state [-]
  double lambda;                     ///< ln(volume) per ln(pressure) in normal compression [-]
  double kappa;                      ///< the same in unloading [-]
  double shear_modulus;              ///< G [Pa], of the material at `density`
  double preconsolidation_pressure;  ///< p_c of the undeformed material [Pa]
  double reference_pressure;         ///< p_r, its pressure at `density` [Pa]
  double density;                    ///< rho_0, of the undeformed material at p_r [kg/m^3]

  using Self = ModifiedCamClay;
  static constexpr std::array<LawParameter<ModifiedCamClay>, 7> parameters{{
      {"critical_ratio", "-", "q/p in the critical state", &Self::critical_ratio, Bound::positive, 1},
      {.name = "lambda",
       .unit = "-",
       .meaning = "ln(volume) per ln(pressure) in normal compression",
       .member = &Self::lambda,
       .bound = Bound::positive,
       .typical = 0.1,
       .exceeds = &Self::kappa},
      {"kappa", "-", "ln(volume) per ln(pressure) in unloading", &Self::kappa, Bound::positive, 0.02},
      {"shear_modulus", "Pa", "elastic shear modulus", &Self::shear_modulus, Bound::positive, 2e6},
      {.name = "preconsolidation_pressure",
       .unit = "Pa",
       .meaning = "largest pressure borne before",
       .member = &Self::preconsolidation_pressure,
       .bound = Bound::positive,
       .typical = 1e5,
       .exceeds = &Self::reference_pressure,
       .may_equal = true},
      {"reference_pressure", "Pa", "pressure at the density", &Self::reference_pressure, Bound::positive,
       5e4},
      {"density", "kg/m^3", "density at the reference pressure", &Self::density, Bound::positive, 1800},
  }};

  /// Cauchy stress [Pa], elastic strain and preconsolidation at the end of the step.
  template <class Real, template <class> class Form>
  [[nodiscard]] Response<Real, Memory<Real, Form>> update(const Deformation<Real>& deformation,
                                                          const Input<Real>& /*input*/,
                                                          const Memory<Real, Form>& old,
                                                          Real dt) const noexcept {
    using std::sqrt;
    const Real compression = deformation.density * (1 / density);  // 1/J
    const Form<Real> trial = trial_strain(old.strain, deformation.velocity_gradient, dt);
    const Real G = shear_modulus * compression;
    const Real q_trial = G * sqrt(6.0 * squared_norm(trial));
    const Real p_c = preconsolidation_pressure * old.preconsolidation;
    const Real u_trial = overconsolidation(compression, old.preconsolidation);
    const Real p_trial = p_c * elementary::exp(-u_trial);
    const auto flowing = cam_clay_return({critical_ratio, lambda, kappa}, u_trial, q_trial, p_c, G);

    const Real ratio = q_trial / (critical_ratio * p_trial);
    const double apart = largest_overconsolidation();
    const auto yields = elementary::expm1(u_trial) < ratio * ratio && u_trial <= apart;
    const Real is_connected = select(apart < u_trial, Real(0.0), Real(1.0));
    const Real p = is_connected * select(yields, flowing.p, p_trial);
    const Real share = select(q_trial == 0.0, Real(0.0), flowing.q / q_trial);
    const Real kept = is_connected * select(yields, share, Real(1.0));
    const Real hardening = elementary::exp((kappa / lambda) * (flowing.u - u_trial));
    const Real preconsolidation = old.preconsolidation * select(yields, hardening, Real(1.0));
    const Form<Real> strain = kept * trial;
    return {((2.0 * G) * strain).tensor() - isotropic(p),
            {strain, preconsolidation},
            select(yields, flowing.unsolved, Real(0.0))};
  }

  /// Speed of pressure waves [m/s], of the elastic material at its pressure.  Eq. (R62)
  template <class Real, template <class> class Form>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& /*input*/,
                                          const Memory<Real, Form>& state) const noexcept {
    const Real compression = deformation.density * (1 / density);
    const Real u = overconsolidation(compression, state.preconsolidation);
    const Real p_c = preconsolidation_pressure * state.preconsolidation;
    const Real p = p_c * elementary::exp(-select(u < 0.0, Real((kappa / lambda) * u),
                                                 u));  // not beyond normal compression
    return {wave_speed(deformation.density, Real(p * (1 / kappa) + (4 * shear_modulus / 3) * compression)),
            Real(0.0)};
  }

 private:
  /// ln(p_c/p) if the whole change of volume is elastic.  Eq. (R64)
  template <class Real>
  [[nodiscard]] Real overconsolidation(const Real& compression, const Real& preconsolidation) const noexcept {
    return std::log(preconsolidation_pressure / reference_pressure) +
           (lambda / kappa) * elementary::log(preconsolidation) - (1 / kappa) * elementary::log(compression);
  }

  /// Below a billionth of p_c the material is apart, and bears nothing.  Eq. (R67)
  [[nodiscard]] static double largest_overconsolidation() noexcept {
    constexpr double least_pressure = 1e-9;  // [-], of p_c
    return -std::log(least_pressure);
  }
};
static_assert(DescribedLaw<ModifiedCamClay> && HasPlaneForm<ModifiedCamClay>);

}  // namespace scree::rheology
