#pragma once

#include <scree/rheology/eigen_symmetric.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>

#include <array>
#include <cstddef>
#include <type_traits>

namespace scree::rheology {

namespace detail {

/// The product of two symmetric tensors that commute, which is symmetric.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> commuting_product(const Symmetric<Real>& a,
                                                          const Symmetric<Real>& b) noexcept {
  return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
          a.xz * b.xz + a.yz * b.yz + a.zz * b.zz, a.xx * b.xy + a.xy * b.yy + a.xz * b.yz,
          a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.xy * b.xz + a.yy * b.yz + a.yz * b.zz};
}

/// The inverse times the determinant.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> adjugate(const Symmetric<Real>& a) noexcept {
  return {a.yy * a.zz - a.yz * a.yz, a.xx * a.zz - a.xz * a.xz, a.xx * a.yy - a.xy * a.xy,
          a.xz * a.yz - a.xy * a.zz, a.xy * a.yz - a.xz * a.yy, a.xy * a.xz - a.xx * a.yz};
}

/// c[0] 1 + c[1] a + c[2] a^2 + .., by Horner's rule. By Cayley and Hamilton a^3 = I_1 a^2 - I_2 a + I_3 1,
/// so that the sum so far is one of 1, a and a^2.  Eq. (R184)
template <std::size_t N, class Real>
[[nodiscard]] constexpr Symmetric<Real> power_series(const std::array<double, N>& c,
                                                     const Symmetric<Real>& a) noexcept {
  const Symmetric<Real> minors = adjugate(a);
  const Real I_1 = a.xx + a.yy + a.zz;
  const Real I_2 = minors.xx + minors.yy + minors.zz;
  const Real I_3 = a.xx * minors.xx + a.xy * minors.xy + a.xz * minors.xz;
  Real of_unit(c[N - 3]);
  Real of_a(c[N - 2]);
  Real of_square(c[N - 1]);
  for (std::size_t k = N - 3; k-- > 0;) {
    const Real of_cube = of_square;
    of_square = of_a + I_1 * of_cube;
    of_a = of_unit - I_2 * of_cube;
    of_unit = c[k] + I_3 * of_cube;
  }
  const Symmetric<Real> square = commuting_product(a, a);
  return {of_unit + of_a * a.xx + of_square * square.xx, of_unit + of_a * a.yy + of_square * square.yy,
          of_unit + of_a * a.zz + of_square * square.zz, of_a * a.xy + of_square * square.xy,
          of_a * a.xz + of_square * square.xz,           of_a * a.yz + of_square * square.yz};
}

template <class Condition>
[[nodiscard]] bool in_any_lane(const Condition& condition) noexcept {
  if constexpr (std::is_same_v<Condition, bool>) {
    return condition;
  } else {
    return any_of(condition);
  }
}

/// Puts b in place of a where the condition holds; member by member, for a copy of all of them would go
/// through memory in packs.
template <class Condition, class Real>
void replace_where(const Condition& condition, Symmetric<Real>& a, const Symmetric<Real>& b) noexcept {
  a.xx = select(condition, b.xx, a.xx);
  a.yy = select(condition, b.yy, a.yy);
  a.zz = select(condition, b.zz, a.zz);
  a.xy = select(condition, b.xy, a.xy);
  a.xz = select(condition, b.xz, a.xz);
  a.yz = select(condition, b.yz, a.yz);
}

/// f(a) by the eigenvalues and axes of a.
template <class Real, class Function>
[[nodiscard]] Symmetric<Real> by_axes(const Symmetric<Real>& a, const Function& f) noexcept {
  EigenSystem<Real> system = eigen_symmetric(a.tensor());
  for (Real& value : system.values) value = f(value);
  return symmetric(composed(system.values, system.vectors));
}

}  // namespace detail

/// ln(b)/2 of a symmetric tensor; NaN if an eigenvalue is negative.
///
/// Near 1 it is a series, off by some roundings of itself, b - 1 being exact; elsewhere it is made along the
/// axes of b, off by roundings of 1. Each lane of a pack goes by its own number alone.
/// @see Eqs. (R183) and (R184)
template <class Real>
[[nodiscard]] Symmetric<Real> half_logarithm(const Symmetric<Real>& b) noexcept {
  constexpr double reach = 0.25;  // of b - 1: eigenvalues of x are at most 1/7
  // Less than `round_off` is left: (1/7)^18/19 of the first term.
  constexpr std::array<double, 18> inverse_tanh{0, 1,        0, 1.0 / 3,  0, 1.0 / 5,  0, 1.0 / 7, 0, 1.0 / 9,
                                                0, 1.0 / 11, 0, 1.0 / 13, 0, 1.0 / 15, 0, 1.0 / 17};
  const Symmetric<Real> excess{b.xx - 1.0, b.yy - 1.0, b.zz - 1.0, b.xy, b.xz, b.yz};
  const auto is_far = !(squared_norm(excess) <= reach * reach);
  const Symmetric<Real> sum{b.xx + 1.0, b.yy + 1.0, b.zz + 1.0, b.xy, b.xz, b.yz};
  const Symmetric<Real> minors = detail::adjugate(sum);
  const Real determinant = sum.xx * minors.xx + sum.xy * minors.xy + sum.xz * minors.xz;
  const Symmetric<Real> x = (1.0 / determinant) * detail::commuting_product(excess, minors);
  Symmetric<Real> result = detail::power_series(inverse_tanh, x);
  if (detail::in_any_lane(is_far)) [[unlikely]] {
    const auto half_log = [](const Real& value) { return 0.5 * elementary::log(value); };
    detail::replace_where(is_far, result, detail::by_axes(b, half_log));
  }
  return result;
}

/// exp(a) of a symmetric tensor, by a series near 0, elsewhere as a power of two of one that is: off by some
/// roundings of its largest eigenvalue, in proportion to the norm of a. Each lane of a pack goes by its own
/// number alone.
/// @see Eqs. (R183) and (R184)
template <class Real>
[[nodiscard]] Symmetric<Real> exponential(const Symmetric<Real>& a) noexcept {
  constexpr double reach = 0.3;  // beyond 2 half_logarithm(b) of its own series, -ln(1 - 0.25)
  constexpr auto inverse_factorials = [] {
    std::array<double, 13> result{1};  // less than `round_off` is left: 0.3^13/13!
    for (std::size_t k = 1; k < 13; ++k) result[k] = result[k - 1] / static_cast<double>(k);
    return result;
  }();
  Real share(1.0);
  const auto is_far = [&] { return reach * reach < squared_norm(share * a); };
  int num_halvings = 0;
  for (; detail::in_any_lane(is_far()); ++num_halvings) share = select(is_far(), 0.5 * share, share);
  Symmetric<Real> result = detail::power_series(inverse_factorials, share * a);
  for (; num_halvings > 0; --num_halvings) {
    detail::replace_where(share < 1.0, result, detail::commuting_product(result, result));
    share = select(share < 1.0, 2.0 * share, share);
  }
  return result;
}

}  // namespace scree::rheology
