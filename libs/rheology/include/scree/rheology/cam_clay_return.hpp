#pragma once

#include <scree/rheology/elementary.hpp>
#include <scree/tensor.hpp>

#include <cmath>

namespace scree::rheology {

/// The parameters of Modified Cam-Clay that flow depends on.
struct CamClayFlow {
  double M;       ///< q/p of the critical state [-]
  double lambda;  ///< slope of normal compression, ln(volume) per ln(pressure) [-]
  double kappa;   ///< slope of unloading [-]
};

/// A yielding stress, by u = ln(p_c/p).
template <class Real>
struct CamClayStress {
  Real p;         ///< [Pa]
  Real q;         ///< [Pa]
  Real u;         ///< [-]
  Real unsolved;  ///< what is left of Eq. (R66), over its terms [-]
};

namespace detail {

/// Eq. (R66) and its derivative, at z = q/(M p) below the critical state (on the wet side) or 1/z = q/(M p)
/// above it (on the dry side): 0 at the end of the step.
template <class Real>
struct CamClayResidual {
  Real value;
  Real slope;
  Real scale;  ///< sum of its terms, in absolute value
  CamClayStress<Real> stress;
};

/// A step of Modified Cam-Clay at one volume: where on the state boundary surface, Eq. (R65), it ends.
template <class Real>
struct CamClayStep {
  CamClayFlow flow;
  Real u_trial;
  Real q_trial;    ///< [Pa]
  Real p_normal;   ///< pressure of normal compression at this volume [Pa]
  Real stiffness;  ///< A = 6 G h/M [Pa]
  Real side;       ///< 1 on the wet side, -1 on the dry one

  [[nodiscard]] CamClayResidual<Real> operator()(const Real& z) const noexcept {
    const double plastic = 1 - flow.kappa / flow.lambda;
    const auto is_dry = side < 0.0;
    const Real inverse = select(is_dry, Real(1.0 / z), Real(1.0));
    const Real share = z * z / (1.0 + z * z);
    const Real u = elementary::log((1.0 + z * z) * inverse * inverse);
    const Real p = p_normal * elementary::exp(-plastic * u);
    const Real ratio = select(is_dry, inverse, z);  // q/(M p)
    const Real q = flow.M * ratio * p;
    const Real missing = q_trial - q;
    const Real ahead = side * (u - u_trial);
    // dq/dz and z du/dz; on the dry side by d(1/z).
    const Real q_slope =
        flow.M * p * inverse * inverse *
        select(is_dry, Real(2.0 * plastic * (1.0 - share) - 1.0), Real(1.0 - 2.0 * plastic * share));
    const Real u_slope = 2.0 * select(is_dry, Real(1.0 - share), share);
    const Real value = stiffness * z * ahead - (1.0 - z * z) * missing;
    const Real slope = stiffness * (ahead + u_slope) + 2.0 * z * missing + (1.0 - z * z) * q_slope;
    const Real spread = select(u_trial < 0.0, -u_trial, u_trial);
    return {value, slope, stiffness * z * (1.0 + u + spread) + q_trial + q, {p, q, u, Real(0.0)}};
  }
};

}  // namespace detail

/// Stress at the end of a step of Modified Cam-Clay whose trial stress has left the yield surface: flow and
/// hardening by backward Euler, which is one equation in one unknown once the state boundary surface is used.
///
/// The root is bracketed by the critical state, z = 1, and the point of the surface with the trial's u.
/// Newton steps begin there; one that leaves the bracket is replaced by the middle, on the dry side that of
/// the logarithm. Of three million random steps (kappa from 0.002 to 0.1, lambda up to 11 kappa, u from -80
/// to 20.7, G/p_c from 0.1 to 1e4) none was left unsolved. The last step is Newton's own, so that dual
/// numbers carry the derivative.
/// @param u_trial ln(p_c/p) of the trial stress  @param q_trial [Pa]  @param p_c before the step [Pa]
/// @param shear_modulus of the Cauchy stress [Pa]
/// @see Eqs. (R63) to (R66)
template <class Real>
[[nodiscard]] CamClayStress<Real> cam_clay_return(const CamClayFlow& flow, const Real& u_trial,
                                                  const Real& q_trial, const Real& p_c,
                                                  const Real& shear_modulus) noexcept {
  using std::sqrt;
  constexpr int num_iterations = 16;
  constexpr double tolerance = 1e-10;  // of the terms: stresses are off by as little
  const double h = flow.kappa * (1 - flow.kappa / flow.lambda);
  const double critical = std::log(2.0);
  const auto is_dry = critical < u_trial;
  const detail::CamClayStep<Real> step{flow,
                                       u_trial,
                                       q_trial,
                                       p_c * elementary::exp(-(flow.kappa / flow.lambda) * u_trial),
                                       (6 * h / flow.M) * shear_modulus,
                                       select(is_dry, Real(-1.0), Real(1.0))};
  const Real excess = elementary::expm1(u_trial);
  const Real ratio = select(excess <= 0.0, Real(0.0), sqrt(excess));
  Real low = select(is_dry, Real(1.0 / ratio), ratio);
  Real high(1.0);
  Real z = low;
  for (int i = 0; i < num_iterations; ++i) {
    const auto residual = step(z);
    low = select(residual.value < 0.0, z, low);
    high = select(residual.value < 0.0, high, z);
    const Real next = z - residual.value / residual.slope;
    const Real middle = select(is_dry, Real(sqrt(low * high)), Real(0.5 * (low + high)));
    z = select(next < low, middle, select(high < next, middle, next));
  }
  const auto last = step(z);
  z = z - last.value / last.slope;
  const auto found = step(z);
  CamClayStress<Real> stress = found.stress;
  const Real left = select(found.value < 0.0, -found.value, found.value) / found.scale;
  stress.unsolved = select(left <= tolerance, Real(0.0), left);
  return stress;
}

}  // namespace scree::rheology
