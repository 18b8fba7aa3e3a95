#pragma once

#include <scree/tensor.hpp>

namespace scree::rheology {

/// The six components of a symmetric tensor, as a law keeps them. Named members, not an array: they stay in
/// registers.
template <class Real>
struct Symmetric {
  Real xx, yy, zz, xy, xz, yz;

  [[nodiscard]] constexpr Tensor<Real> tensor() const noexcept {
    return {{xx, xy, xz, xy, yy, yz, xz, yz, zz}};
  }
  [[nodiscard]] friend constexpr Symmetric operator+(const Symmetric& a, const Symmetric& b) noexcept {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
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

/// a - tr(a)/3 1.
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> deviator(const Symmetric<Real>& a) noexcept {
  const Real mean = (a.xx + a.yy + a.zz) * (1.0 / 3.0);
  return {a.xx - mean, a.yy - mean, a.zz - mean, a.xy, a.xz, a.yz};
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

/// The symmetric tensor a turned by the spin of a velocity gradient over a step, r a r^T with the rotation r
/// of `midpoint_increment`, in closed form: r = 1 + 2/(1 + w^2) (Omega + Omega^2), where Omega = W dt/2 has
/// the axis w.  Eq. (R18)
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> turned(const Symmetric<Real>& a, const Tensor<Real>& gradient,
                                               const Real& dt) noexcept {
  const Real quarter = 0.25 * dt;
  const Real x = quarter * (gradient(2, 1) - gradient(1, 2));
  const Real y = quarter * (gradient(0, 2) - gradient(2, 0));
  const Real z = quarter * (gradient(1, 0) - gradient(0, 1));
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

/// (a - a^T)/2: the spin W of a velocity gradient.
template <class Real>
[[nodiscard]] constexpr Tensor<Real> skew_part(const Tensor<Real>& a) noexcept {
  Tensor<Real> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result(i, j) = 0.5 * (a(i, j) - a(j, i));
  }
  return result;
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

/// Deformation over a step with velocity gradient L: (1 - A/2)^-1 (1 + A/2) with A = L dt, the midpoint rule
/// of dF/dt = L F. It is of second order, and a rotation up to round-off if A is a spin.
/// Eq. (R18), from Hughes & Winget (1980), \cite hughes1980
/// @param a velocity gradient times step [-]; its eigenvalues stay away from 2
template <class Real>
[[nodiscard]] constexpr Tensor<Real> midpoint_increment(const Tensor<Real>& a) noexcept {
  const Tensor<Real> m = isotropic(Real(1.0)) - Real(0.5) * a;
  Tensor<Real> cofactor;  // transposed: inverse times determinant
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3;
    const std::size_t i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      cofactor(j, i) = m(i1, j1) * m(i2, j2) - m(i1, j2) * m(i2, j1);
    }
  }
  const Real determinant = m(0, 0) * cofactor(0, 0) + m(0, 1) * cofactor(1, 0) + m(0, 2) * cofactor(2, 0);
  // (1 - A/2)^-1 (1 + A/2) = 2 (1 - A/2)^-1 - 1
  return (2.0 / determinant) * cofactor - isotropic(Real(1.0));
}

/// A symmetric tensor carried along by a velocity gradient over a step, f a f^T with the f of
/// `midpoint_increment`.  Eq. (R18)
template <class Real>
[[nodiscard]] constexpr Symmetric<Real> carried(const Symmetric<Real>& a, const Tensor<Real>& gradient,
                                                const Real& dt) noexcept {
  return symmetric(carried_by(midpoint_increment(dt * gradient), a.tensor()));
}

}  // namespace scree::rheology
