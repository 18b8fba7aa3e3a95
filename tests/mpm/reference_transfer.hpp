#pragma once

#include <scree/mpm/nodes.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/point_transfer.hpp>

namespace scree::mpm {

/// What kernels are compared with: the text of point_transfer.hpp on single numbers, node after node.
template <class ShapeType, class Rule, int D, int V>
class ReferenceTransfer {
 public:
  ReferenceTransfer(const CartesianGrid<D>& grid, const ShapeType& shape, const Rule& rule)
      : grid_{grid}, shape_{shape}, rule_{rule} {
    for (std::size_t axis = 0; axis < D; ++axis) {
      origin_[axis] = grid.origin()[static_cast<int>(axis)];
      inverse_spacing_[axis] = 1 / grid.spacing()[static_cast<int>(axis)];
    }
  }

  void scatter(const Particles<D, V>& particles, Index p, Nodes<D>& nodes, double dt) const {
    const Point<double, D, V> point = load(particles, p);
    const auto stencil = stencil_of(point);
    const Given<double, D, V> given = give<Rule>(point, stencil, dt);
    for_each_node(stencil, nodes, [&](double* node, const Weights& at) {
      node[NodeRecord::mass] += at.weight * given.mass;
      for (std::size_t i = 0; i < V; ++i) {
        double& momentum = node[NodeRecord::momentum + static_cast<int>(i)];
        double& force = Rule::has_increment ? node[NodeRecord::increment() + static_cast<int>(i)] : momentum;
        momentum += at.weight * given.momentum[i];
        for (std::size_t j = 0; j < D; ++j) {
          const double arm = Rule::has_affine_gradient ? at.slope[j] : at.arm[j];
          if (Rule::has_affine) momentum += arm * given.momentum_slope[j][i];
          force += at.slope[j] * given.force[j][i];
        }
      }
    });
  }

  [[nodiscard]] Point<double, D, V> gather(const Particles<D, V>& particles, Index p, Nodes<D>& nodes,
                                           double dt) const {
    const Point<double, D, V> point = load(particles, p);
    Taken<double, D, V> taken{};
    for_each_node(stencil_of(point), nodes, [&](const double* node, const Weights& at) {
      for (std::size_t i = 0; i < V; ++i) {
        const double velocity = node[NodeRecord::momentum + static_cast<int>(i)];
        taken.velocity[i] += at.weight * velocity;
        for (std::size_t j = 0; j < D; ++j) taken.velocity_gradient[j][i] += at.slope[j] * velocity;
        if (Rule::has_increment) {
          taken.increment[i] += at.weight * node[NodeRecord::increment() + static_cast<int>(i)];
        }
      }
    });
    return take(rule_, point, taken, dt);
  }

  [[nodiscard]] static Point<double, D, V> load(const Particles<D, V>& particles, Index p) {
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

 private:
  static constexpr std::size_t S = ShapeType::support;
  /// Of one node, the product over the axes.
  struct Weights {
    double weight = 1;
    Components<double, D> slope;
    Components<double, D> arm;
  };

  [[nodiscard]] Stencil<double, D, S> stencil_of(const Point<double, D, V>& point) const {
    return stencil_at<Rule, D>(shape_, point.position, origin_, inverse_spacing_);
  }

  /// Calls body(record, weights) for every node of a stencil.
  template <class Body>
  static void for_each_node(const Stencil<double, D, S>& stencil, Nodes<D>& nodes, Body&& body) {
    std::size_t count = 1;
    for (int axis = 0; axis < D; ++axis) count *= S;
    for (std::size_t n = 0; n < count; ++n) {
      Weights at;
      at.slope.fill(1);
      at.arm.fill(1);
      Index node = 0;
      std::size_t rest = n;
      for (std::size_t axis = 0; axis < D; ++axis, rest /= S) {
        const std::size_t i = rest % S;
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
  ShapeType shape_;
  Rule rule_;
  Components<double, D> origin_;
  Components<double, D> inverse_spacing_;
};

}  // namespace scree::mpm
