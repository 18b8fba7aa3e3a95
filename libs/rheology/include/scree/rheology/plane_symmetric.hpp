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

}  // namespace scree::rheology
