#pragma once

#include <scree/rheology/kinematics.hpp>
#include <scree/tensor.hpp>

namespace scree::rheology {

/// The components of a symmetric tensor in plane flow, which has none between the plane and z.
template <class Real>
struct PlaneSymmetric {
  Real xx, yy, zz, xy;

  [[nodiscard]] static constexpr PlaneSymmetric of(const Symmetric<Real>& a) noexcept {
    return {a.xx, a.yy, a.zz, a.xy};
  }
  [[nodiscard]] constexpr Tensor<Real> tensor() const noexcept {
    const Real zero(0.0);
    return {{xx, xy, zero, xy, yy, zero, zero, zero, zz}};
  }
  [[nodiscard]] friend constexpr PlaneSymmetric operator+(const PlaneSymmetric& a,
                                                          const PlaneSymmetric& b) noexcept {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy};
  }
  [[nodiscard]] friend constexpr PlaneSymmetric operator*(const Real& factor,
                                                          const PlaneSymmetric& a) noexcept {
    return {factor * a.xx, factor * a.yy, factor * a.zz, factor * a.xy};
  }
};

/// a : a; zz first, which turns in the plane do not wait for.
template <class Real>
[[nodiscard]] constexpr Real squared_norm(const PlaneSymmetric<Real>& a) noexcept {
  return a.zz * a.zz + 2.0 * (a.xy * a.xy) + a.xx * a.xx + a.yy * a.yy;
}

/// A deviator of the plane alone: half the difference of xx and yy, and xy.
template <class Real>
struct PlaneDeviator {
  Real difference, xy;
};

/// The deviator turned in its plane by `turned_about` the axis n/m.  Eq. (R18): by twice 2 atan(n/m)
template <class Real>
[[nodiscard]] constexpr PlaneDeviator<Real> turned_about(const Real& n, const Real& m,
                                                         const PlaneDeviator<Real>& a) noexcept {
  const Real nn = n * n;
  const Real mm = m * m;
  const Real scale = 1.0 / ((mm + nn) * (mm + nn));
  const Real sine = 4.0 * (n * m) * (mm - nn);
  const Real cosine = (mm - nn) * (mm - nn) - 4.0 * (mm * nn);
  return {scale * (cosine * a.difference - sine * a.xy), scale * (sine * a.difference + cosine * a.xy)};
}

/// The tensor turned by the spin of a plane flow over a step, by the midpoint rule.  Eq. (R18)
template <class Real>
[[nodiscard]] constexpr PlaneSymmetric<Real> turned(const PlaneSymmetric<Real>& a,
                                                    const Tensor<Real>& gradient, const Real& dt) noexcept {
  const Real mean = 0.5 * (a.xx + a.yy);
  const PlaneDeviator<Real> deviator{0.5 * (a.xx - a.yy), a.xy};
  const auto [difference, xy] = turned_about(half_spin(gradient, dt).z, Real(1.0), deviator);
  return {mean + difference, mean - difference, a.zz, xy};
}

}  // namespace scree::rheology
