#pragma once

#include <scree/tensor.hpp>

namespace scree::rheology {

/// The components of a symmetric tensor in plane flow, which has none between the plane and z.
template <class Real>
struct PlaneSymmetric {
  Real xx, yy, zz, xy;

  [[nodiscard]] constexpr Tensor<Real> tensor() const noexcept {
    const Real zero(0.0);
    return {{xx, xy, zero, xy, yy, zero, zero, zero, zz}};
  }
  [[nodiscard]] friend constexpr PlaneSymmetric operator*(const Real& factor,
                                                          const PlaneSymmetric& a) noexcept {
    return {factor * a.xx, factor * a.yy, factor * a.zz, factor * a.xy};
  }
};

/// a : a.
template <class Real>
[[nodiscard]] constexpr Real squared_norm(const PlaneSymmetric<Real>& a) noexcept {
  return a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2.0 * (a.xy * a.xy);
}

/// a - tr(a)/3 1.
template <class Real>
[[nodiscard]] constexpr PlaneSymmetric<Real> deviator(const PlaneSymmetric<Real>& a) noexcept {
  const Real mean = (a.xx + a.yy + a.zz) * (1.0 / 3.0);
  return {a.xx - mean, a.yy - mean, a.zz - mean, a.xy};
}

/// A symmetric tensor carried along by the velocity gradient of a plane flow over a step, f a f^T with
/// f = 2 (1 - L dt/2)^-1 - 1.  Eq. (R18)
template <class Real>
[[nodiscard]] constexpr PlaneSymmetric<Real> carried(const PlaneSymmetric<Real>& a,
                                                     const Tensor<Real>& gradient, const Real& dt) noexcept {
  const Real half = 0.5 * dt;
  const Real m_xx = 1.0 - half * gradient(0, 0);
  const Real m_xy = half * gradient(0, 1);  // less
  const Real m_yx = half * gradient(1, 0);  // less
  const Real m_yy = 1.0 - half * gradient(1, 1);
  const Real m_zz = 1.0 - half * gradient(2, 2);
  const Real determinant = m_xx * m_yy - m_xy * m_yx;
  const Real twice_inverse = 2.0 / (determinant * m_zz);  // one quotient for both
  const Real in_plane = twice_inverse * m_zz;
  const Real f_xx = in_plane * m_yy - 1.0;
  const Real f_xy = in_plane * m_xy;
  const Real f_yx = in_plane * m_yx;
  const Real f_yy = in_plane * m_xx - 1.0;
  const Real f_zz = twice_inverse * determinant - 1.0;
  const Real fa_xx = f_xx * a.xx + f_xy * a.xy;
  const Real fa_xy = f_xx * a.xy + f_xy * a.yy;
  const Real fa_yx = f_yx * a.xx + f_yy * a.xy;
  const Real fa_yy = f_yx * a.xy + f_yy * a.yy;
  return {fa_xx * f_xx + fa_xy * f_xy, fa_yx * f_yx + fa_yy * f_yy, f_zz * f_zz * a.zz,
          fa_xx * f_yx + fa_xy * f_yy};
}

}  // namespace scree::rheology
