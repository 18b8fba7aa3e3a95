#pragma once

#include <scree/mpm/concepts.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace scree::mpm {

/// One value per axis or per component of velocity.
template <class Real, int N>
using Components = std::array<Real, static_cast<std::size_t>(N)>;

/// A coordinate in units of the spacing, counted from where the stencil of node 0 begins. Every question of
/// where a point is must ask it here: another order of operations rounds to another node.
template <class Real>
[[nodiscard]] inline Real coordinate(const Real& x, double origin, double inverse_spacing,
                                     double shift) noexcept {
  return (x - origin) * inverse_spacing - shift;
}

/// Weights of a point on the nodes round it, for each axis; in several dimensions they are multiplied.
template <class Real, int D, std::size_t S>
struct Stencil {
  Components<Real, D> base;                   ///< first node
  Components<Real, D> xi;                     ///< of the point from there [spacings]
  Components<std::array<Real, S>, D> weight;  ///< N_i
  Components<std::array<Real, S>, D> slope;   ///< of forces and of the velocity gradient [1/m]
  Components<std::array<Real, S>, D> arm;     ///< N_i (x_i - x_p) [m], where a rule has need of it
  Components<Real, D> second_moment;          ///< [m^2]
  Components<Real, D> inverse_moment;         ///< spacing over second moment, where constant [1/m]
};

/// A material point, as transfers see it.
template <class Real, int D, int V>
struct Point {
  Components<Real, D> position;                          ///< [m]
  Components<Real, V> velocity;                          ///< [m/s]
  Components<Components<Real, V>, D> velocity_gradient;  ///< [j][i]: dv_i/dx_j [1/s]
  Components<Components<Real, V>, D> stress;             ///< [j][i]: sigma_ij [Pa]
  Real mass;                                             ///< [kg]
  Real density;                                          ///< [kg/m^3]
};

/// What a point gives to the nodes: mass and momentum by the weights, the slopes of momentum by the arms (or,
/// times the second moment, by the affine weights), forces by the slopes.  Eqs. (M8)-(M10)
template <class Real, int D, int V>
struct Given {
  Real mass;                                          ///< [kg]
  Components<Real, V> momentum;                       ///< [kg m/s]
  Components<Components<Real, V>, D> momentum_slope;  ///< [kg/s], [kg m^2/s] if affine
  Components<Components<Real, V>, D> force;           ///< [N m]; times dt if it goes to the momentum
};

/// What a point gives as an affine field times its weights: its value at the first node of the stencil, where
/// it has been `value` at the point, and its steps from node to node, where it has been slopes.  Eq. (M202)
template <class Real, int D, int V, std::size_t S>
inline void turn_to_steps(const Stencil<Real, D, S>& stencil, Components<Real, V>& value,
                          Components<Components<Real, V>, D>& slope) noexcept {
  for (std::size_t j = 0; j < D; ++j) {
    for (std::size_t i = 0; i < V; ++i) {
      slope[j][i] = slope[j][i] * stencil.inverse_moment[j];
      value[i] = value[i] - stencil.xi[j] * slope[j][i];
    }
  }
}

/// What the nodes give to a point.
template <class Real, int D, int V>
struct Taken {
  Components<Real, V> velocity;                          ///< [m/s]
  Components<Real, V> increment;                         ///< of it in this step [m/s]
  Components<Components<Real, V>, D> velocity_gradient;  ///< [1/s]
};

/// Where the stencil of a point begins along an axis [spacings].
template <Shape ShapeType, class Real>
[[nodiscard]] inline Real first_node(const Real& x, double origin, double inverse_spacing) noexcept {
  using std::floor;
  return floor(coordinate(x, origin, inverse_spacing, ShapeType::shift));
}

template <TransferRule Rule, int D, Shape ShapeType, class Real>
[[nodiscard]] inline Stencil<Real, D, ShapeType::support> stencil_at(
    const ShapeType& shape, const Components<Real, D>& position, const Components<double, D>& origin,
    const Components<double, D>& inverse_spacing) noexcept {
  using std::floor;
  Stencil<Real, D, ShapeType::support> stencil;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Real along = coordinate(position[axis], origin[axis], inverse_spacing[axis], ShapeType::shift);
    stencil.base[axis] = floor(along);
    const Real xi = along - stencil.base[axis] + ShapeType::shift;
    stencil.xi[axis] = xi;
    stencil.weight[axis] = shape.weights(xi);
    stencil.slope[axis] = Rule::has_affine_gradient ? shape.affine(xi) : shape.gradients(xi);
    const double spacing = 1 / inverse_spacing[axis];
    for (std::size_t i = 0; i < ShapeType::support; ++i) {
      stencil.slope[axis][i] = stencil.slope[axis][i] * inverse_spacing[axis];
      stencil.arm[axis][i] = stencil.weight[axis][i] * ((static_cast<double>(i) - xi) * spacing);
    }
    if constexpr (HasConstantMoment<ShapeType>) {
      stencil.inverse_moment[axis] = ShapeType::inverse_moment * inverse_spacing[axis];
    }
    stencil.second_moment[axis] = shape.second_moment(xi) * (spacing * spacing);
  }
  return stencil;
}

template <TransferRule Rule, class Real, int D, int V, std::size_t S>
[[nodiscard]] inline Given<Real, D, V> give(const Point<Real, D, V>& point,
                                            const Stencil<Real, D, S>& stencil, double dt) noexcept {
  Given<Real, D, V> given;
  given.mass = point.mass;
  for (std::size_t i = 0; i < V; ++i) given.momentum[i] = point.mass * point.velocity[i];
  const Real minus_volume = -point.mass / point.density;
  const Real factor = Rule::has_increment ? minus_volume : minus_volume * dt;
  for (std::size_t j = 0; j < D; ++j) {
    const Real inertia = Rule::has_affine_gradient ? point.mass * stencil.second_moment[j] : Real(point.mass);
    for (std::size_t i = 0; i < V; ++i) {
      given.momentum_slope[j][i] = inertia * point.velocity_gradient[j][i];
      given.force[j][i] = factor * point.stress[j][i];
    }
  }
  return given;
}

/// det(1 + dt L), dt [s], L [1/s]: the volume, over its own, that an affine motion x + dt v makes of a body.
/// Components of velocity without an axis have no part in it.  [-], Eq. (M125)
template <class Real, int D, int V>
[[nodiscard]] inline Real volume_ratio(const Components<Components<Real, V>, D>& velocity_gradient,
                                       double dt) noexcept {
  Components<Components<Real, D>, D> F;  // [j][i]
  for (std::size_t j = 0; j < D; ++j) {
    for (std::size_t i = 0; i < D; ++i) F[j][i] = (i == j ? 1.0 : 0.0) + dt * velocity_gradient[j][i];
  }
  if constexpr (D == 1) {
    return F[0][0];
  } else if constexpr (D == 2) {
    return F[0][0] * F[1][1] - F[0][1] * F[1][0];
  } else {
    return F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) -
           F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
           F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
  }
}

/// The point after a step.  Eqs. (M8), (M9), (M12), (M13)
template <TransferRule Rule, class Real, int D, int V>
[[nodiscard]] inline Point<Real, D, V> take(const Rule& rule, const Point<Real, D, V>& point,
                                            const Taken<Real, D, V>& taken, double dt) noexcept {
  Point<Real, D, V> next = point;
  for (std::size_t j = 0; j < D; ++j) next.position[j] = point.position[j] + dt * taken.velocity[j];
  for (std::size_t j = 0; j < D; ++j) {  // number by number: packs would be copied in halves, which stalls
    for (std::size_t i = 0; i < V; ++i) next.velocity_gradient[j][i] = taken.velocity_gradient[j][i];
  }
  next.density = point.density / volume_ratio<Real, D, V>(taken.velocity_gradient, dt);
  if constexpr (Rule::has_increment) {
    const double share = rule.increment_share();
    for (std::size_t i = 0; i < V; ++i) {
      next.velocity[i] = share * (point.velocity[i] + taken.increment[i]) + (1 - share) * taken.velocity[i];
    }
  } else {
    for (std::size_t i = 0; i < V; ++i) next.velocity[i] = taken.velocity[i];
  }
  return next;
}

}  // namespace scree::mpm
