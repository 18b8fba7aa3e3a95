#pragma once

#include <scree/tensor.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace scree::rheology {

/// Eigenvalues and unit eigenvectors of a symmetric tensor; column j of `vectors` belongs to `values[j]`.
template <class Real>
struct EigenSystem {
  std::array<Real, 3> values;
  Tensor<Real> vectors;
};

namespace detail {

/// Whether a number, or that of any lane of a pack, is other than 0; of a dual number, whose derivative need
/// not be 0 where it is, always.
template <class Real>
[[nodiscard]] bool may_differ_from_zero(const Real& number) noexcept {
  const auto is_zero = number == 0.0;
  if constexpr (std::is_same_v<Real, double>) {
    return !is_zero;
  } else if constexpr (std::is_same_v<decltype(is_zero), const bool>) {
    return true;
  } else {
    return !all_of(is_zero);
  }
}

/// Turns axes p and q so that a(p, q) vanishes; the smaller of the two angles that do. Where it is 0 in all
/// lanes the turn is none, and is left out: in plane strain that leaves one of fifteen. Done for the sake of
/// another lane it changes signs of zeros at most: of a(r, p) and a(r, q), which matter to none of the
/// results, but not of the diagonal and the vectors, as long as these have no -0.
template <class Real>
void rotate_axes(Tensor<Real>& a, Tensor<Real>& vectors, std::size_t p, std::size_t q) noexcept {
  using std::sqrt;
  if (!may_differ_from_zero(a(p, q))) return;
  const Real difference = a(q, q) - a(p, p);
  const Real twice = 2.0 * a(p, q);
  const Real root = sqrt(difference * difference + twice * twice);
  const Real denominator = select(difference < 0.0, difference - root, difference + root);
  const Real tangent = select(root == 0.0, Real(0.0), twice / denominator);
  const Real cosine = 1.0 / sqrt(1.0 + tangent * tangent);
  const Real sine = tangent * cosine;
  const std::size_t r = 3 - p - q;
  const Real a_rp = cosine * a(r, p) - sine * a(r, q);
  const Real a_rq = sine * a(r, p) + cosine * a(r, q);
  a(r, p) = a(p, r) = a_rp;
  a(r, q) = a(q, r) = a_rq;
  a(p, p) = a(p, p) - tangent * a(p, q);
  a(q, q) = a(q, q) + tangent * a(p, q);
  a(p, q) = a(q, p) = Real(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Real v = vectors(i, p);
    vectors(i, p) = cosine * v - sine * vectors(i, q);
    vectors(i, q) = sine * v + cosine * vectors(i, q);
  }
}

/// Exchanges the eigenvalues p and q, and their vectors, unless the first is the larger.
template <class Real>
void put_larger_first(EigenSystem<Real>& system, std::size_t p, std::size_t q) noexcept {
  const auto is_ascending = system.values[p] < system.values[q];
  const auto exchange = [&](Real& first, Real& second) {
    const Real larger = select(is_ascending, second, first);
    second = select(is_ascending, first, second);
    first = larger;
  };
  exchange(system.values[p], system.values[q]);
  for (std::size_t i = 0; i < 3; ++i) exchange(system.vectors(i, p), system.vectors(i, q));
}

}  // namespace detail

/// The eigen-system of a symmetric tensor by cyclic Jacobi rotations, \cite golub2013.
///
/// Rotations keep round-off at that of the components and the vectors orthogonal even where eigenvalues
/// coincide, where closed forms by the characteristic polynomial lose half of the digits. No lane takes a way
/// of its own, so that packs run it too. Once the rotations are small each sweep squares their error: five
/// sweeps reach round-off from anywhere. A lane of finite components has the bits that it has
/// alone, whatever the others hold; but where a product so small that it vanishes is fused with a sum, a zero
/// may have the other sign.
template <class Real>
[[nodiscard]] EigenSystem<Real> eigen_symmetric(Tensor<Real> a) noexcept {
  constexpr int num_sweeps = 5;
  for (std::size_t i = 0; i < 3; ++i) a(i, i) = a(i, i) + 0.0;  // no -0, nor from any rotation on
  Tensor<Real> vectors = isotropic(Real(1.0));
  for (int sweep = 0; sweep < num_sweeps; ++sweep) {
    detail::rotate_axes(a, vectors, 0, 1);
    detail::rotate_axes(a, vectors, 0, 2);
    detail::rotate_axes(a, vectors, 1, 2);
  }
  return {{a(0, 0), a(1, 1), a(2, 2)}, vectors};
}

/// The same system with its eigenvalues in descending order.
template <class Real>
[[nodiscard]] EigenSystem<Real> descending(EigenSystem<Real> system) noexcept {
  detail::put_larger_first(system, 0, 1);
  detail::put_larger_first(system, 1, 2);
  detail::put_larger_first(system, 0, 1);
  return system;
}

/// The symmetric tensor with these eigenvalues and vectors.
template <class Real>
[[nodiscard]] Tensor<Real> composed(const std::array<Real, 3>& values, const Tensor<Real>& vectors) noexcept {
  Tensor<Real> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      result(i, j) = result(j, i) = values[0] * vectors(i, 0) * vectors(j, 0) +
                                    values[1] * vectors(i, 1) * vectors(j, 1) +
                                    values[2] * vectors(i, 2) * vectors(j, 2);
    }
  }
  return result;
}

}  // namespace scree::rheology
