#pragma once

#include "schemes.hpp"

#include <scree/mpm/nodes.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/point_transfer.hpp>

#include <cstddef>
#include <variant>

namespace scree::mpm {

template <int D, int V>
[[nodiscard]] Point<double, D, V> load(const Particles<D, V>& particles, Index p) {
  Point<double, D, V> point;
  for (int j = 0; j < D; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    point.position[axis] = particles.position.component(j)[p];
    for (int i = 0; i < V; ++i) {
      const auto component = static_cast<std::size_t>(i);
      point.velocity_gradient[axis][component] = particles.velocity_gradient.component(i + V * j)[p];
      point.stress[axis][component] = particles.stress.component(i + V * j)[p];
    }
  }
  for (int i = 0; i < V; ++i) {
    point.velocity[static_cast<std::size_t>(i)] = particles.velocity.component(i)[p];
  }
  point.mass = particles.mass.component(0)[p];
  point.density = particles.density.component(0)[p];
  return point;
}

/// What kernels are compared with: the text of point_transfer.hpp on single numbers, node after node.
template <int D, int V>
class ReferenceTransfer {
 public:
  ReferenceTransfer(const CartesianGrid<D>& grid, const Scheme& scheme) : grid_{grid}, scheme_{scheme} {}

  void scatter(const Particles<D, V>& particles, Index p, Nodes<D>& nodes, double dt) const {
    const Point<double, D, V> point = load(particles, p);
    const WidestStencil stencil = stencil_of(point);
    const Given<double, D, V> given =
        std::visit([&]<class Rule>(const Rule&) { return give<Rule>(point, stencil, dt); }, scheme_.rule);
    const bool has_increment = scheme_.has_increment();
    const bool has_affine = scheme_.has_affine();
    const bool has_affine_gradient = scheme_.has_affine_gradient();
    for_each_node(stencil, nodes, [&](double* node, const Weights& at) {
      node[NodeRecord::mass] += at.weight * given.mass;
      for (std::size_t i = 0; i < V; ++i) {
        double& momentum = node[NodeRecord::momentum + static_cast<int>(i)];
        double& force = has_increment ? node[NodeRecord::increment() + static_cast<int>(i)] : momentum;
        momentum += at.weight * given.momentum[i];
        for (std::size_t j = 0; j < D; ++j) {
          const double arm = has_affine_gradient ? at.slope[j] : at.arm[j];
          if (has_affine) momentum += arm * given.momentum_slope[j][i];
          force += at.slope[j] * given.force[j][i];
        }
      }
    });
  }

  [[nodiscard]] Point<double, D, V> gather(const Particles<D, V>& particles, Index p, Nodes<D>& nodes,
                                           double dt) const {
    const Point<double, D, V> point = load(particles, p);
    Taken<double, D, V> taken{};
    const bool has_increment = scheme_.has_increment();
    for_each_node(stencil_of(point), nodes, [&](const double* node, const Weights& at) {
      for (std::size_t i = 0; i < V; ++i) {
        const double velocity = node[NodeRecord::momentum + static_cast<int>(i)];
        taken.velocity[i] += at.weight * velocity;
        for (std::size_t j = 0; j < D; ++j) taken.velocity_gradient[j][i] += at.slope[j] * velocity;
        if (has_increment) {
          taken.increment[i] += at.weight * node[NodeRecord::increment() + static_cast<int>(i)];
        }
      }
    });
    return std::visit([&](const auto& rule) { return take(rule, point, taken, dt); }, scheme_.rule);
  }

 private:
  /// Of any shape; what it does not touch is not read.
  using WidestStencil = Stencil<double, D, 4>;
  /// Of one node, the product over the axes.
  struct Weights {
    double weight = 1;
    Components<double, D> slope;
    Components<double, D> arm;
  };

  [[nodiscard]] WidestStencil stencil_of(const Point<double, D, V>& point) const {
    Components<double, D> origin;
    Components<double, D> inverse_spacing;
    for (std::size_t axis = 0; axis < D; ++axis) {
      origin[axis] = grid_.origin()[static_cast<int>(axis)];
      inverse_spacing[axis] = 1 / grid_.spacing()[static_cast<int>(axis)];
    }
    WidestStencil widest{};
    std::visit(
        [&]<class Rule>(const auto& shape, const Rule&) {
          const auto stencil = stencil_at<Rule, D>(shape, point.position, origin, inverse_spacing);
          widest.base = stencil.base;
          widest.second_moment = stencil.second_moment;
          for (std::size_t axis = 0; axis < D; ++axis) {
            for (std::size_t i = 0; i < shape.support; ++i) {
              widest.weight[axis][i] = stencil.weight[axis][i];
              widest.slope[axis][i] = stencil.slope[axis][i];
              widest.arm[axis][i] = stencil.arm[axis][i];
            }
          }
        },
        scheme_.shape, scheme_.rule);
    return widest;
  }

  /// Calls body(record, weights) for every node of a stencil.
  template <class Body>
  void for_each_node(const WidestStencil& stencil, Nodes<D>& nodes, Body&& body) const {
    const std::size_t support = scheme_.support();
    std::size_t count = 1;
    for (int axis = 0; axis < D; ++axis) count *= support;
    for (std::size_t n = 0; n < count; ++n) {
      Weights at;
      at.slope.fill(1);
      at.arm.fill(1);
      Index node = 0;
      std::size_t rest = n;
      for (std::size_t axis = 0; axis < D; ++axis, rest /= support) {
        const std::size_t i = rest % support;
        node += nodes.place(static_cast<Index>(stencil.base[axis]) + static_cast<Index>(i), axis) *
                nodes.stride(axis);
        at.weight *= stencil.weight[axis][i];
        for (std::size_t j = 0; j < D; ++j) {
          at.slope[j] *= j == axis ? stencil.slope[axis][i] : stencil.weight[axis][i];
          at.arm[j] *= j == axis ? stencil.arm[axis][i] : stencil.weight[axis][i];
        }
      }
      body(nodes[node], at);
    }
  }

  CartesianGrid<D> grid_;
  Scheme scheme_;
};

}  // namespace scree::mpm
