#pragma once

#include <scree/index.hpp>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace scree {

/// Half a unit in the last place of 1 [-]: the relative error of one rounding.
constexpr double round_off = std::numeric_limits<double>::epsilon() / 2;

/// D real components. DontAlign: one memory layout whatever instruction set a user compiles for.
template <int D>
using Vector = Eigen::Matrix<double, D, 1, Eigen::DontAlign>;

/// Rows x Cols real components, column by column; unaligned for the same reason.
template <int Rows, int Cols = Rows>
using Matrix = Eigen::Matrix<double, Rows, Cols, Eigen::DontAlign | Eigen::ColMajor>;

/// `a` where `condition` holds, else `b`: a choice that packs and dual numbers can make too. For a pack the
/// condition is a mask, a truth per lane, and `where` is the pack's own.
template <class Condition, class Real>
[[nodiscard]] constexpr Real select(const Condition& condition, const Real& a, const Real& b) noexcept {
  if constexpr (std::is_same_v<Condition, bool>) {
    return condition ? a : b;
  } else {
    Real result = b;
    where(condition, result) = a;
    return result;
  }
}

/// Whether a condition is true, of a pack in any of its lanes.
template <class Condition>
[[nodiscard]] constexpr bool in_any_lane(const Condition& condition) noexcept {
  if constexpr (std::is_same_v<Condition, bool>) {
    return condition;
  } else {
    return any_of(condition);
  }
}

/// A 3x3 tensor of pointwise physics, whatever the dimension of the mesh: plane strain and a 1D column
/// embed exactly. Real is double, a pack of doubles or a dual number.
template <class Real>
struct Tensor {
  std::array<Real, 9> components{};  ///< row by row

  [[nodiscard]] constexpr Real& operator()(std::size_t row, std::size_t column) noexcept {
    return components[3 * row + column];
  }
  [[nodiscard]] constexpr const Real& operator()(std::size_t row, std::size_t column) const noexcept {
    return components[3 * row + column];
  }

  constexpr Tensor& operator+=(const Tensor& other) noexcept {
    for (std::size_t i = 0; i < 9; ++i) components[i] = components[i] + other.components[i];
    return *this;
  }
  constexpr Tensor& operator-=(const Tensor& other) noexcept {
    for (std::size_t i = 0; i < 9; ++i) components[i] = components[i] - other.components[i];
    return *this;
  }
  constexpr Tensor& operator*=(const Real& factor) noexcept {
    for (auto& component : components) component = component * factor;
    return *this;
  }
  // From components to components: a copy that is then added to would go through memory in packs.
  [[nodiscard]] friend constexpr Tensor operator+(const Tensor& a, const Tensor& b) noexcept {
    Tensor sum;
    for (std::size_t i = 0; i < 9; ++i) sum.components[i] = a.components[i] + b.components[i];
    return sum;
  }
  [[nodiscard]] friend constexpr Tensor operator-(const Tensor& a, const Tensor& b) noexcept {
    Tensor difference;
    for (std::size_t i = 0; i < 9; ++i) difference.components[i] = a.components[i] - b.components[i];
    return difference;
  }
  [[nodiscard]] friend constexpr Tensor operator*(const Real& factor, const Tensor& a) noexcept {
    Tensor product;
    for (std::size_t i = 0; i < 9; ++i) product.components[i] = a.components[i] * factor;
    return product;
  }
};

/// factor times the unit tensor.
template <class Real>
[[nodiscard]] constexpr Tensor<Real> isotropic(const Real& factor) noexcept {
  Tensor<Real> result;
  for (std::size_t i = 0; i < 3; ++i) result(i, i) = factor;
  return result;
}

template <class Real>
[[nodiscard]] constexpr Real trace(const Tensor<Real>& a) noexcept {
  return a(0, 0) + a(1, 1) + a(2, 2);
}

template <class Real>
[[nodiscard]] constexpr Tensor<Real> symmetric_part(const Tensor<Real>& a) noexcept {
  Tensor<Real> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result(i, j) = 0.5 * (a(i, j) + a(j, i));
  }
  return result;
}

/// a - tr(a)/3 1.
template <class Real>
[[nodiscard]] constexpr Tensor<Real> deviator(const Tensor<Real>& a) noexcept {
  return a - isotropic<Real>(trace(a) * (1.0 / 3.0));
}

/// The double contraction a : b.
template <class Real>
[[nodiscard]] constexpr Real contract(const Tensor<Real>& a, const Tensor<Real>& b) noexcept {
  Real sum = a.components[0] * b.components[0];
  for (std::size_t i = 1; i < 9; ++i) sum = sum + a.components[i] * b.components[i];
  return sum;
}

/// Shear rate |gdot| = sqrt(2 D':D') of a velocity gradient [1/s]; |du/dy| in simple shear.  Eq. (G4)
template <class Real>
[[nodiscard]] Real shear_rate(const Tensor<Real>& velocity_gradient) noexcept {
  using std::sqrt;
  const Tensor<Real> rate = deviator(symmetric_part(velocity_gradient));
  return sqrt(2.0 * contract(rate, rate));
}

}  // namespace scree
