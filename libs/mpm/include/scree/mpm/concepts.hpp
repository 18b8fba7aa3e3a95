#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>

namespace scree::mpm {

/// A shape function along one axis, in units of the spacing. A stencil begins at node floor(x - shift);
/// xi is the distance of the point from that node. In several dimensions shapes are multiplied. A shape may
/// have parameters; what the functions tell then belongs to those.
///
/// - weights(xi): N_i, sum 1
/// - gradients(xi): dN_i/dxi, sum 0
/// - affine(xi): N_i (i - xi) / second_moment(xi): what takes nodal velocities to the affine part
/// - second_moment(xi): sum N_i (i - xi)^2
template <class S>
concept Shape = requires(const S shape, double xi) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::summary } -> std::convertible_to<std::string_view>;
  { S::support } -> std::convertible_to<std::size_t>;
  { S::shift } -> std::convertible_to<double>;
  { shape.weights(xi) }
  noexcept->std::same_as<std::array<double, S::support>>;
  { shape.gradients(xi) }
  noexcept->std::same_as<std::array<double, S::support>>;
  { shape.affine(xi) }
  noexcept->std::same_as<std::array<double, S::support>>;
  { shape.second_moment(xi) }
  noexcept->std::same_as<double>;
};

/// A shape whose second moment is the same wherever the point is, 1/inverse_moment [spacings^2]: what goes by
/// its affine weights is N_i times an affine field.
template <class S>
concept HasConstantMoment = Shape<S> && requires {
  { S::inverse_moment } -> std::convertible_to<double>;
};

/// How velocity travels between points and nodes. `has_affine`: points pass on their velocity gradient too,
/// by N_i (x_i - x_p). `has_affine_gradient`: forces and the velocity gradient go by the shape's affine
/// weights, else by its gradients. `increment_share`: how much of a point's new velocity is its old one plus
/// the nodes' increment, the rest being the nodes' velocity. `has_increment`: that share can differ from
/// zero, so that forces have a place of their own at the nodes.
template <class T>
concept TransferRule = requires(const T rule) {
  { T::name } -> std::convertible_to<std::string_view>;
  { T::summary } -> std::convertible_to<std::string_view>;
  { T::has_affine } -> std::convertible_to<bool>;
  { T::has_affine_gradient } -> std::convertible_to<bool>;
  { T::has_increment } -> std::convertible_to<bool>;
  { rule.increment_share() }
  noexcept->std::same_as<double>;
};

}  // namespace scree::mpm
