#pragma once

#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// The spin by which a logarithmic strain turns.

namespace scree::rheology {

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

/// a b of tensors with the same axes, which is symmetric too.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> commuting_product(const Symmetric<Real>& a,
                                                          const Symmetric<Real>& b) noexcept {
  return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
          a.xz * b.xz + a.yz * b.yz + a.zz * b.zz, a.xx * b.xy + a.xy * b.yy + a.xz * b.yz,
          a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.xy * b.xz + a.yy * b.yz + a.yz * b.zz};
}

/// By cofactors, of which a tensor with principal values from 1 on loses no digits that matter.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> inverse(const Symmetric<Real>& a) noexcept {
  const Symmetric<Real> cofactors{a.yy * a.zz - a.yz * a.yz, a.xx * a.zz - a.xz * a.xz,
                                  a.xx * a.yy - a.xy * a.xy, a.xz * a.yz - a.xy * a.zz,
                                  a.xy * a.yz - a.xz * a.yy, a.xy * a.xz - a.xx * a.yz};
  const Real determinant = a.xx * cofactors.xx + a.xy * cofactors.xy + a.xz * cofactors.xz;
  return Real(1.0 / determinant) * cofactors;
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

  /// The tensor that this multiplies an axis by.
  [[nodiscard]] Symmetric<Real> tensor() const noexcept {
    const Symmetric<Real> outer =
        of_first * squared_gaps + of_square * commuting_product(squared_gaps, squared_gaps);
    return {of_unit + outer.xx, of_unit + outer.yy, of_unit + outer.zz, outer.xy, outer.xz, outer.yz};
  }
};

/// The same of a strain of any size: a power of 2 smaller it is NearSpin, from which g is doubled, as a
/// tensor of the same axes as M. All terms are positive and no axes are sought, so that it is as smooth as g
/// where principal values coincide. Each lane of a pack goes by its own number alone.  Eq. (R188)
template <class Real>
struct FarSpin {
  Symmetric<Real> factor;  ///< g(M)

  explicit FarSpin(const Symmetric<Real>& e) noexcept {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Real square = 2.0 * squared_norm(e);
    Real scale(1.0);
    const auto is_beyond = [&] { return reach_of_spin_series < square && square < infinity; };
    while (in_any_lane(is_beyond())) {
      scale = select(is_beyond(), Real(0.5 * scale), scale);
      square = select(is_beyond(), Real(0.25 * square), square);
    }
    const NearSpin<Real> near{scale * e};
    Symmetric<Real> squared_gaps = near.squared_gaps;
    factor = near.tensor();
    while (in_any_lane(scale < 1.0)) {
      const auto is_smaller = scale < 1.0;
      const Symmetric<Real> beyond_1 = commuting_product(squared_gaps, factor);
      const Symmetric<Real> x_coth_x{1.0 + beyond_1.xx, 1.0 + beyond_1.yy, 1.0 + beyond_1.zz,
                                     beyond_1.xy,       beyond_1.xz,       beyond_1.yz};
      const Symmetric<Real> doubled = Real(0.25) * (factor + inverse(x_coth_x));
      factor = {select(is_smaller, doubled.xx, factor.xx), select(is_smaller, doubled.yy, factor.yy),
                select(is_smaller, doubled.zz, factor.zz), select(is_smaller, doubled.xy, factor.xy),
                select(is_smaller, doubled.xz, factor.xz), select(is_smaller, doubled.yz, factor.yz)};
      squared_gaps = Real(4.0) * squared_gaps;
      scale = 2.0 * scale;
    }
  }

  [[nodiscard]] Axis<Real> operator()(const Axis<Real>& axis) const noexcept { return times(factor, axis); }
};

/// The axis by which a step turns a strain e, grown by `half` in half of it: the logarithmic spin over half a
/// step, as it is amid the turn. What half the turn changes it by counts but for the square of the step's
/// strain, which keeps it from turning the spin round in long steps: along the spin the change is at most
/// sqrt(2) |half| of it.
/// @param spin that of the material over half a step
/// @param factor NearSpin or FarSpin of e
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

}  // namespace scree::rheology
