#pragma once

#include <scree/rheology/elementary.hpp>
#include <scree/rheology/plane_symmetric.hpp>
#include <scree/rheology/tensor_functions.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace scree::rheology {

namespace detail {

/// c[0] + c[1] x + c[2] x^2 + .., by Horner's rule.
template <std::size_t N, class Real>
[[nodiscard]] constexpr Real polynomial(const std::array<double, N>& c, const Real& x) noexcept {
  Real sum(c[N - 1]);
  for (std::size_t k = N - 1; k-- > 0;) sum = c[k] + sum * x;
  return sum;
}

/// The inverse hyperbolic tangent of x over x, by its square: less than `round_off` is left for x up to
/// 0.152, x^18/19.
template <class Real>
[[nodiscard]] constexpr Real inverse_tanh_over(const Real& square) noexcept {
  constexpr std::array<double, 9> c{1,        1.0 / 3,  1.0 / 5,  1.0 / 7, 1.0 / 9,
                                    1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17};
  return polynomial(c, square);
}

/// 1/n!, 1/(n + step)!, .., as many as N.
template <std::size_t N>
[[nodiscard]] constexpr std::array<double, N> inverse_factorials(std::size_t n, std::size_t step) noexcept {
  std::array<double, N> result{};
  double factorial = 1;
  for (std::size_t k = 2; k <= n; ++k) factorial *= static_cast<double>(k);
  for (double& number : result) {
    number = 1 / factorial;
    for (std::size_t i = 0; i < step; ++i) factorial *= static_cast<double>(++n);
  }
  return result;
}

}  // namespace detail

/// ln(b)/2 of a symmetric tensor of a plane flow; NaN if an eigenvalue is negative. As precise as that of
/// `Symmetric`, near 1 too, and each lane of a pack goes by its own number alone.
/// @see Eq. (R185)
template <class Real>
[[nodiscard]] PlaneSymmetric<Real> half_logarithm(const PlaneSymmetric<Real>& b) noexcept {
  using std::sqrt;
  constexpr double reach = 0.2;        // of b - 1: x is at most 0.152, u 0.143
  constexpr double reach_of_u = 0.15;  // beyond it
  const PlaneSymmetric<Real> excess{b.xx - 1.0, b.yy - 1.0, b.zz - 1.0, b.xy};
  const Real middle = 0.5 * (excess.xx + excess.yy);
  const Real difference = 0.5 * (b.xx - b.yy);
  const Real square = difference * difference + b.xy * b.xy;
  const Real change = 2.0 * middle + middle * middle - square;  // of the determinant in the plane
  // One quotient for all three.
  const Real of_change = 2.0 + change;
  const Real of_zz = 2.0 + excess.zz;
  const Real of_difference = 1.0 + middle;
  const Real both = of_change * of_zz;
  const Real inverse = 1.0 / (both * of_difference);
  Real per_difference = inverse * both;
  const Real per_both = inverse * of_difference;
  const Real x_plane = change * (per_both * of_zz);
  const Real x_zz = excess.zz * (per_both * of_change);
  Real u_square = square * (per_difference * per_difference);
  Real mean = 0.5 * x_plane * detail::inverse_tanh_over(x_plane * x_plane);
  Real zz = x_zz * detail::inverse_tanh_over(x_zz * x_zz);
  Real slope = detail::inverse_tanh_over(u_square);
  const auto is_far = !(squared_norm(excess) <= reach * reach);
  if (detail::in_any_lane(is_far)) [[unlikely]] {
    // By b itself: b - 1 is not exact there, nor of the size of a small eigenvalue.
    const Real half_trace = 0.5 * (b.xx + b.yy);
    const Real determinant = b.xx * b.yy - b.xy * b.xy;
    const Real positive = select(half_trace < 0.0, half_trace, determinant);  // NaN if both are negative
    mean = select(is_far, 0.25 * elementary::log(positive), mean);
    zz = select(is_far, 0.5 * elementary::log(b.zz), zz);
    per_difference = select(is_far, 1.0 / half_trace, per_difference);
    u_square = select(is_far, square * (per_difference * per_difference), u_square);
    const Real larger = half_trace + sqrt(square);
    const Real by_logarithm = 0.5 * elementary::log(larger * (larger / determinant)) / sqrt(u_square);
    slope = select(reach_of_u * reach_of_u < u_square, by_logarithm, detail::inverse_tanh_over(u_square));
  }
  const Real factor = 0.5 * per_difference * slope;
  return {mean + factor * difference, mean - factor * difference, zz, factor * b.xy};
}

/// exp(a) of a symmetric tensor of a plane flow, by series near 0, elsewhere by its eigenvalues: off by some
/// roundings of the largest. Each lane of a pack goes by its own number alone.
/// @see Eq. (R186)
template <class Real>
[[nodiscard]] PlaneSymmetric<Real> exponential(const PlaneSymmetric<Real>& a) noexcept {
  using std::sqrt;
  constexpr double reach = 0.3;  // less than `round_off` is left: 0.3^13/13!, 0.3^14/14! and 0.3^12/13!
  constexpr auto of_exp = detail::inverse_factorials<13>(0, 1);
  constexpr auto of_cosh = detail::inverse_factorials<7>(0, 2);
  constexpr auto of_sinh = detail::inverse_factorials<6>(1, 2);
  const Real middle = 0.5 * (a.xx + a.yy);
  const Real difference = 0.5 * (a.xx - a.yy);
  const Real square = difference * difference + a.xy * a.xy;
  Real exp_middle = detail::polynomial(of_exp, middle);
  Real exp_zz = detail::polynomial(of_exp, a.zz);
  Real cosh = detail::polynomial(of_cosh, square);
  Real sinh_over = detail::polynomial(of_sinh, square);
  const auto is_far = !(squared_norm(a) <= reach * reach);
  if (detail::in_any_lane(is_far)) [[unlikely]] {
    exp_middle = select(is_far, elementary::exp(middle), exp_middle);
    exp_zz = select(is_far, elementary::exp(a.zz), exp_zz);
    const auto is_wide = reach * reach < square;
    const Real radius = sqrt(square);
    const Real larger = elementary::exp(radius);
    const Real smaller = 1.0 / larger;
    cosh = select(is_wide, 0.5 * (larger + smaller), cosh);
    sinh_over = select(is_wide, 0.5 * (larger - smaller) / radius, sinh_over);
  }
  const Real mean = exp_middle * cosh;
  const Real factor = exp_middle * sinh_over;
  return {mean + factor * difference, mean - factor * difference, exp_zz, factor * a.xy};
}

}  // namespace scree::rheology
