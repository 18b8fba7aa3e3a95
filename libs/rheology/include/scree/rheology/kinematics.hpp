#pragma once

#include <scree/tensor.hpp>

namespace scree::rheology {

/// The six components of a symmetric tensor, as a law keeps them. Named members, not an array: they stay in
/// registers.
template <class Real>
struct Symmetric {
  Real xx, yy, zz, xy, xz, yz;

  /// Itself: what `PlaneSymmetric` keeps of it, in the form of three dimensions.
  [[nodiscard]] static constexpr Symmetric of(const Symmetric& a) noexcept { return a; }
  [[nodiscard]] constexpr Tensor<Real> tensor() const noexcept {
    return {{xx, xy, xz, xy, yy, yz, xz, yz, zz}};
  }
  [[nodiscard]] friend constexpr Symmetric operator+(const Symmetric& a, const Symmetric& b) noexcept {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
  }
  [[nodiscard]] friend constexpr Symmetric operator-(const Symmetric& a, const Symmetric& b) noexcept {
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
  }
  [[nodiscard]] friend constexpr Symmetric operator*(const Real& factor, const Symmetric& a) noexcept {
    return {factor * a.xx, factor * a.yy, factor * a.zz, factor * a.xy, factor * a.xz, factor * a.yz};
  }
};

/// The six components of a tensor that is symmetric up to round-off: those above its diagonal.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> symmetric(const Tensor<Real>& a) noexcept {
  return {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(0, 2), a(1, 2)};
}

/// D', the rate of deformation at constant volume, of a velocity gradient.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> deviatoric_rate(const Tensor<Real>& gradient) noexcept {
  const Real mean = trace(gradient) * (1.0 / 3.0);
  return {gradient(0, 0) - mean,
          gradient(1, 1) - mean,
          gradient(2, 2) - mean,
          0.5 * (gradient(0, 1) + gradient(1, 0)),
          0.5 * (gradient(0, 2) + gradient(2, 0)),
          0.5 * (gradient(1, 2) + gradient(2, 1))};
}

/// a : a.
template <class Real>
[[nodiscard]] constexpr Real squared_norm(const Symmetric<Real>& a) noexcept {
  return a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2.0 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz);
}

/// The axis of an antisymmetric tensor: its components zy, xz and yx.
template <class Real>
struct Axis {
  Real x, y, z;

  [[nodiscard]] friend constexpr Axis operator+(const Axis& a, const Axis& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[nodiscard]] friend constexpr Axis operator-(const Axis& a, const Axis& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[nodiscard]] friend constexpr Axis operator*(const Real& factor, const Axis& a) noexcept {
    return {factor * a.x, factor * a.y, factor * a.z};
  }
  [[nodiscard]] friend constexpr Axis cross(const Axis& a, const Axis& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// The axis of W dt/2, the spin of a velocity gradient over half a step.
template <class Real>
[[nodiscard]] constexpr Axis<Real> half_spin(const Tensor<Real>& gradient, const Real& dt) noexcept {
  const Real quarter = 0.25 * dt;
  return {quarter * (gradient(2, 1) - gradient(1, 2)), quarter * (gradient(0, 2) - gradient(2, 0)),
          quarter * (gradient(1, 0) - gradient(0, 1))};
}

/// Omega a - a Omega, of the antisymmetric tensor Omega with an axis: the rate at which it turns a.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> rate_of_turning(const Axis<Real>& axis,
                                                        const Symmetric<Real>& a) noexcept {
  const auto& [x, y, z] = axis;
  return {2.0 * (y * a.xz - z * a.xy),
          2.0 * (z * a.xy - x * a.yz),
          2.0 * (x * a.yz - y * a.xz),
          z * (a.xx - a.yy) + y * a.yz - x * a.xz,
          y * (a.zz - a.xx) + x * a.xy - z * a.yz,
          x * (a.yy - a.zz) + z * a.xz - y * a.xy};
}

/// A symmetric tensor turned to r a r^T by the rotation r = 1 + 2/(1 + w^2) (Omega + Omega^2), where Omega
/// has the axis w, as long as the tangent of half the angle.  Eq. (R18)
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> turned_about(const Axis<Real>& axis,
                                                     const Symmetric<Real>& a) noexcept {
  const auto& [x, y, z] = axis;
  const Real c = 2.0 / (1.0 + x * x + y * y + z * z);
  // Rows of r.
  const Real xx = 1.0 - c * (y * y + z * z);
  const Real xy = c * (x * y - z);
  const Real xz = c * (x * z + y);
  const Real yx = c * (x * y + z);
  const Real yy = 1.0 - c * (x * x + z * z);
  const Real yz = c * (y * z - x);
  const Real zx = c * (x * z - y);
  const Real zy = c * (y * z + x);
  const Real zz = 1.0 - c * (x * x + y * y);
  // The first two rows of r a; the trace, which stays, spares the third.
  const Real ax = xx * a.xx + xy * a.xy + xz * a.xz;
  const Real ay = xx * a.xy + xy * a.yy + xz * a.yz;
  const Real az = xx * a.xz + xy * a.yz + xz * a.zz;
  const Real bx = yx * a.xx + yy * a.xy + yz * a.xz;
  const Real by = yx * a.xy + yy * a.yy + yz * a.yz;
  const Real bz = yx * a.xz + yy * a.yz + yz * a.zz;
  const Real turned_xx = ax * xx + ay * xy + az * xz;
  const Real turned_yy = bx * yx + by * yy + bz * yz;
  const Real turned_zz = (a.xx + a.yy + a.zz) - turned_xx - turned_yy;
  return {turned_xx,
          turned_yy,
          turned_zz,
          ax * yx + ay * yy + az * yz,
          ax * zx + ay * zy + az * zz,
          bx * zx + by * zy + bz * zz};
}

/// The symmetric tensor a turned by the spin of a velocity gradient over a step, by the midpoint rule.
/// Eq. (R18), from Hughes & Winget (1980), \cite hughes1980
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> turned(const Symmetric<Real>& a, const Tensor<Real>& gradient,
                                               const Real& dt) noexcept {
  return turned_about(half_spin(gradient, dt), a);
}

/// The matrix product a b.
template <class Real>
[[nodiscard]] constexpr Tensor<Real> product(const Tensor<Real>& a, const Tensor<Real>& b) noexcept {
  Tensor<Real> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
    }
  }
  return result;
}

/// f a f^T, symmetric if a is: a tensor carried along by the deformation or rotation f.
template <class Real>
[[nodiscard]] constexpr Tensor<Real> carried_by(const Tensor<Real>& f, const Tensor<Real>& a) noexcept {
  const Tensor<Real> fa = product(f, a);
  Tensor<Real> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      result(i, j) = result(j, i) = fa(i, 0) * f(j, 0) + fa(i, 1) * f(j, 1) + fa(i, 2) * f(j, 2);
    }
  }
  return result;
}

}  // namespace scree::rheology
