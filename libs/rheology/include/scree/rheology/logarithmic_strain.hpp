#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/logarithmic_spin.hpp>
#include <scree/rheology/plane_symmetric.hpp>

#include <array>

// The elastic logarithmic (Hencky) strain e at constant volume, carried from step to step by itself: no law
// that keeps it needs the left Cauchy-Green tensor exp(2 e), nor a logarithm of one.

namespace scree::rheology {

/// The memory of a law that keeps an elastic logarithmic strain.
inline constexpr std::array<StateColumn, 6> elastic_strain_columns{{{"elastic_strain_xx", "-"},
                                                                    {"elastic_strain_yy", "-"},
                                                                    {"elastic_strain_zz", "-"},
                                                                    {"elastic_strain_xy", "-"},
                                                                    {"elastic_strain_xz", "-"},
                                                                    {"elastic_strain_yz", "-"}}};

/// The elastic logarithmic strain [-] at the end of a step if all of the step is elastic: half of the step's
/// deviatoric strain, a turn by the logarithmic spin amid the turn, the other half. Of second order in the
/// step; exact in a flow without spin along the axes of the strain. A spin alone turns it by the rotation of
/// Eq. (R18).
/// @param old strain before the step, of trace 0 as the result is  @param gradient of velocity [1/s]
/// @see Eqs. (R23) and (R183) to (R185), after Xiao et al. (1997), \cite xiao1997
template <class Real>
[[nodiscard]] Symmetric<Real> trial_strain(const Symmetric<Real>& old, const Tensor<Real>& gradient,
                                           const Real& dt) noexcept {
  const Symmetric<Real> half = Real(0.5 * dt) * deviatoric_rate(gradient);
  const Symmetric<Real> strained = old + half;
  const Axis<Real> spin = half_spin(gradient, dt);
  Axis<Real> axis = detail::logarithmic_spin(strained, half, spin, detail::NearSpin<Real>{strained});
  const auto is_far = !(2.0 * squared_norm(strained) <= detail::reach_of_spin_series);
  if (in_any_lane(is_far)) [[unlikely]] {
    const auto far = detail::logarithmic_spin(strained, half, spin, detail::FarSpin<Real>{strained});
    axis = {select(is_far, far.x, axis.x), select(is_far, far.y, axis.y), select(is_far, far.z, axis.z)};
  }
  return turned_about(axis, strained) + half;
}

/// The same in a plane flow, where one gap and one axis are left.  Eq. (R187)
template <class Real>
[[nodiscard]] PlaneSymmetric<Real> trial_strain(const PlaneSymmetric<Real>& old, const Tensor<Real>& gradient,
                                                const Real& dt) noexcept {
  const Real quarter = 0.25 * dt;
  const PlaneDeviator<Real> half{quarter * (gradient(0, 0) - gradient(1, 1)),
                                 quarter * (gradient(0, 1) + gradient(1, 0))};
  const Real half_zz = (1.0 / 6.0) * dt * (2.0 * gradient(2, 2) - (gradient(0, 0) + gradient(1, 1)));
  const Real half_squared =
      2.0 * (half.difference * half.difference + half.xy * half.xy) + 1.5 * (half_zz * half_zz);
  const PlaneDeviator<Real> e{0.5 * (old.xx - old.yy) + half.difference, old.xy + half.xy};
  const Real factor = detail::spin_factor(Real(4.0 * (e.difference * e.difference + e.xy * e.xy)));
  const Real excess = factor * (2.0 * (half.difference * e.xy - e.difference * half.xy));
  const Real change = factor * (4.0 * (half.difference * e.difference + half.xy * e.xy));
  const Real m = 1.0 + half_squared;
  const Real n = (half_spin(gradient, dt).z - excess) * (m - change);
  const PlaneDeviator<Real> turned = turned_about(n, m, e);
  const Real difference = turned.difference + half.difference;
  const Real zz = old.zz + 2.0 * half_zz;
  return {difference - 0.5 * zz, -0.5 * zz - difference, zz, turned.xy + half.xy};
}

}  // namespace scree::rheology
