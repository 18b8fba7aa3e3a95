#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/rheology/eigen_symmetric.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/plane_symmetric.hpp>

#include <array>
#include <cmath>
#include <cstddef>

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

namespace detail {

/// The square of x up to which g(x) is its series: less than 1e-15 of it is left, which meets a product of
/// order x^2 in the strain.
inline constexpr double reach_of_spin_series = 1.0 / 32;
/// g(x) = (x coth x - 1)/x^2, by powers of x^2.  Eq. (R184)
inline constexpr std::array<double, 6> spin_series{1.0 / 3,     -1.0 / 45,   2.0 / 945,
                                                   -1.0 / 4725, 2.0 / 93555, -1382.0 / 638512875};

/// g(x) by its series.
template <class Real>
[[nodiscard]] constexpr Real near_spin_factor(const Real& square) noexcept {
  const Real fourth = square * square;
  const Real first = spin_series[0] + spin_series[1] * square;
  const Real second = spin_series[2] + spin_series[3] * square;
  const Real third = spin_series[4] + spin_series[5] * square;
  return first + fourth * (second + fourth * third);
}

/// g(x) for any square of x. Each lane of a pack goes by its own number alone.
template <class Real>
[[nodiscard]] Real spin_factor(const Real& square) noexcept {
  using std::sqrt;
  Real factor = near_spin_factor(square);
  const auto is_far = !(square <= reach_of_spin_series);
  if (in_any_lane(is_far)) [[unlikely]] {
    const Real x = sqrt(select(is_far, square, Real(1.0)));
    factor = select(is_far, (x - 1.0 + 2.0 * x / elementary::expm1(2.0 * x)) / (x * x), factor);
  }
  return factor;
}

/// The axis of a b - b a.
template <class Real>
[[nodiscard]] constexpr Axis<Real> commutator(const Symmetric<Real>& a, const Symmetric<Real>& b) noexcept {
  return {a.xz * b.xy - b.xz * a.xy + (a.yz * b.yy - b.yz * a.yy) + (a.zz * b.yz - b.zz * a.yz),
          a.xx * b.xz - b.xx * a.xz + (a.xy * b.yz - b.xy * a.yz) + (a.xz * b.zz - b.xz * a.zz),
          a.xy * b.xx - b.xy * a.xx + (a.yy * b.xy - b.yy * a.xy) + (a.yz * b.xz - b.yz * a.xz)};
}

/// a times the axis.
template <class Real>
[[nodiscard]] constexpr Axis<Real> times(const Symmetric<Real>& a, const Axis<Real>& axis) noexcept {
  return {a.xx * axis.x + a.xy * axis.y + a.xz * axis.z, a.xy * axis.x + a.yy * axis.y + a.yz * axis.z,
          a.xz * axis.x + a.yz * axis.y + a.zz * axis.z};
}

/// g of the gaps between the principal values of a strain e of trace 0, as a function of axes: what
/// `commutator(e, d)` has to be multiplied by to be the excess of the logarithmic spin over the material's.
/// A polynomial of the tensor M = 4 J_2 1 - 3 e^2, whose principal values are the squares of the gaps and
/// whose invariants are 6 J_2, 9 J_2^2 and 4 J_2^3 - 27 J_3^2.  Eq. (R186)
template <class Real>
struct NearSpin {
  Symmetric<Real> squared_gaps;  ///< M
  Real of_unit, of_first, of_square;

  explicit NearSpin(const Symmetric<Real>& e) noexcept {
    const Real xy = e.xy * e.xy;
    const Real xz = e.xz * e.xz;
    const Real yz = e.yz * e.yz;
    const Real xx = e.xx * e.xx + (xy + xz);
    const Real yy = e.yy * e.yy + (xy + yz);
    const Real zz = e.zz * e.zz + (xz + yz);
    const Real J_2 = 0.5 * (xx + yy + zz);
    const Real xz_minor = e.xy * e.yz - e.yy * e.xz;
    const Real J_3 = e.zz * (e.xx * e.yy - xy) + e.xz * xz_minor + e.yz * (e.xy * e.xz - e.xx * e.yz);
    squared_gaps = {4.0 * J_2 - 3.0 * xx,
                    4.0 * J_2 - 3.0 * yy,
                    4.0 * J_2 - 3.0 * zz,
                    3.0 * (e.xy * e.zz - e.xz * e.yz),
                    3.0 * (e.xz * e.yy - e.xy * e.yz),
                    3.0 * (e.yz * e.xx - e.xy * e.xz)};
    const Real I_1 = 6.0 * J_2;
    const Real I_2 = 9.0 * (J_2 * J_2);
    const Real I_3 = 4.0 * (J_2 * J_2 * J_2) - 27.0 * (J_3 * J_3);
    // Horner's rule, ending each power with the square by the theorem of Cayley and Hamilton.
    of_unit = Real(spin_series[3]);
    of_first = Real(spin_series[4]);
    of_square = Real(spin_series[5]);
    for (std::size_t k = 3; k-- > 0;) {
      const Real of_cube = of_square;
      of_square = of_first + I_1 * of_cube;
      of_first = of_unit - I_2 * of_cube;
      of_unit = spin_series[k] + I_3 * of_cube;
    }
  }

  [[nodiscard]] Axis<Real> operator()(const Axis<Real>& axis) const noexcept {
    const Axis<Real> once = times(squared_gaps, axis);
    const Axis<Real> inner{of_first * axis.x + of_square * once.x, of_first * axis.y + of_square * once.y,
                           of_first * axis.z + of_square * once.z};
    const Axis<Real> outer = times(squared_gaps, inner);
    return {of_unit * axis.x + outer.x, of_unit * axis.y + outer.y, of_unit * axis.z + outer.z};
  }
};

/// The same along the principal axes of e, which has any size.
template <class Real>
struct SpinByAxes {
  EigenSystem<Real> system;

  explicit SpinByAxes(const Symmetric<Real>& e) noexcept : system(eigen_symmetric(e.tensor())) {}

  [[nodiscard]] Axis<Real> operator()(const Axis<Real>& axis) const noexcept {
    const auto& [values, vectors] = system;
    Axis<Real> sum{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Real gap = values[(k + 1) % 3] - values[(k + 2) % 3];
      const Real along = vectors(0, k) * axis.x + vectors(1, k) * axis.y + vectors(2, k) * axis.z;
      const Real factor = spin_factor(Real(gap * gap)) * along;
      sum = {sum.x + factor * vectors(0, k), sum.y + factor * vectors(1, k), sum.z + factor * vectors(2, k)};
    }
    return sum;
  }
};

/// The axis by which a step turns a strain e, grown by `half` in half of it: the logarithmic spin over half a
/// step, as it is amid the turn. What half the turn changes it by counts but for the square of the step's
/// strain, which keeps it from turning the spin round in long steps: along the spin the change is at most
/// sqrt(2) |half| of it.
/// @param spin that of the material over half a step
/// @param factor NearSpin or SpinByAxes of e
template <class Real, class Factor>
[[nodiscard]] Axis<Real> logarithmic_spin(const Symmetric<Real>& e, const Symmetric<Real>& half,
                                          const Axis<Real>& spin, const Factor& factor) noexcept {
  const Axis<Real> at_first = factor(commutator(e, half));
  // Seen from the strain, which has turned, the step's strain turns the other way.
  const Symmetric<Real> turned_back = half - rate_of_turning(spin - at_first, half);
  const Axis<Real> seen = factor(commutator(e, turned_back));
  const Axis<Real> change = seen - at_first + cross(spin, at_first);
  const Real share = 1.0 / (1.0 + squared_norm(half));
  return spin - at_first - share * change;
}

}  // namespace detail

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
    const auto far = detail::logarithmic_spin(strained, half, spin, detail::SpinByAxes<Real>{strained});
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
