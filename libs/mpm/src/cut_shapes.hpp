#pragma once

#include "stencil.hpp"

#include <scree/mpm/boundary.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/shapes/cubic.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace scree::mpm::detail {

/// Where the stencils of points begin that reach past an end, and their nodes there; counted along the axis.
struct CutStencil {
  Index base;
  std::size_t image;
  std::size_t wall;
  std::size_t inside;
  std::size_t beyond;  ///< the next one; past a stencil of three
};

template <int D, std::size_t S>
[[nodiscard]] CutStencil cut_stencil(const CartesianGrid<D>& grid, const MeshEnd& end) noexcept {
  if (end.side == Side::low) return {.base = -1, .image = 0, .wall = 1, .inside = 2, .beyond = 3};
  const Index num_nodes = grid.nodes().count[static_cast<std::size_t>(end.axis)];
  return {.base = num_nodes + 1 - static_cast<Index>(S),
          .image = S - 1,
          .wall = S - 2,
          .inside = S - 3,
          .beyond = S > 3 ? S - 4 : 0};
}

/// The stencil of one point along all axes.
template <int D, std::size_t S>
struct PointStencil {
  std::array<std::array<double, S>, static_cast<std::size_t>(D)> weight;
  std::array<std::array<Index, S>, static_cast<std::size_t>(D)> node;  ///< their sum numbers a node
  std::array<double, static_cast<std::size_t>(D)> xi;                  ///< from the first [spacings]
};

template <class ShapeType, int D>
[[nodiscard]] PointStencil<D, ShapeType::support> point_stencil(const ShapeType& shape, const Vector<D>& x,
                                                                const ParticleBlock<D>& block,
                                                                const Nodes<D>& nodes) noexcept {
  PointStencil<D, ShapeType::support> stencil;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const int a = static_cast<int>(axis);
    const Place at = place_in_block<ShapeType>(x[a], nodes.grid(), a, block);
    stencil.xi[axis] = at.xi;
    stencil.weight[axis] = shape.weights(at.xi);
    for (std::size_t i = 0; i < ShapeType::support; ++i) {
      stencil.node[axis][i] = nodes.place(at.base + static_cast<Index>(i), axis) * nodes.stride(axis);
    }
  }
  return stencil;
}

/// Calls body(weight, number of a node less its part along `axis`) for the stencil along all other axes.
template <int D, std::size_t S, class Body>
void for_each_beside(const PointStencil<D, S>& stencil, std::size_t axis, Body&& body) noexcept {
  constexpr std::size_t count = D == 1 ? 1 : D == 2 ? S : S * S;
  for (std::size_t k = 0; k < count; ++k) {
    double weight = 1;
    Index node = 0;
    std::size_t rest = k;
    for (std::size_t other = 0; other < D; ++other) {
      if (other == axis) continue;
      weight *= stencil.weight[other][rest % S];
      node += stencil.node[other][rest % S];
      rest /= S;
    }
    body(weight, node);
  }
}

/// Calls body(point, its stencil) for the points of a block whose shape functions an end cuts off.
/// @param position components are `stride` apart [m]
template <class ShapeType, int D, class Body>
void for_each_cut(const ShapeType& shape, const double* position, Index stride, const ParticleBlock<D>& block,
                  const MeshEnd& end, const Nodes<D>& nodes, Body&& body) noexcept {
  const auto axis = static_cast<std::size_t>(end.axis);
  const CutStencil cut = cut_stencil<D, ShapeType::support>(nodes.grid(), end);
  const Index beyond_base = block.first_cell[axis] + block_edge<D> + block_skin<D>;
  if (cut.base < block.first_cell[axis] - block_skin<D> || beyond_base <= cut.base) return;
  for (Index p = block.begin; p < block.end; ++p) {
    const double along = position[p + end.axis * stride];
    if (place_in_block<ShapeType>(along, nodes.grid(), end.axis, block).base != cut.base) continue;
    Vector<D> x;
    for (int a = 0; a < D; ++a) x[a] = position[p + a * stride];
    body(p, point_stencil(shape, x, block, nodes));
  }
}

/// What points gave to an image with their gradient of velocity L, they gave at the speed of its place. Twice
/// that goes to the wall, a spacing h away, and less once that to the node inside, 2h away: so
/// 2 h w m L n is missing at the one and too much at the other.  Eq. (M183)
template <class ShapeType, int D, int V>
void move_to_cut(const ShapeType& shape, const Particles<D, V>& particles, const ParticleBlock<D>& block,
                 const MeshEnd& end, Nodes<D>& nodes) noexcept {
  if constexpr (ShapeType::support > 2) {
    const auto axis = static_cast<std::size_t>(end.axis);
    const CutStencil cut = cut_stencil<D, ShapeType::support>(nodes.grid(), end);
    const double arm = (end.side == Side::low ? 2 : -2) * nodes.grid().spacing()[end.axis];
    const auto move = [&](Index p, const auto& stencil) {
      const double moment = arm * stencil.weight[axis][cut.image] * particles.mass.component(0)[p];
      for_each_beside(stencil, axis, [&](double weight, Index node) {
        double* const wall = nodes[node + stencil.node[axis][cut.wall]];
        double* const inside = nodes[node + stencil.node[axis][cut.inside]];
        for (int i = 0; i < V; ++i) {
          const double missing = weight * moment * particles.velocity_gradient.component(i + V * end.axis)[p];
          wall[NodeRecord::momentum + i] += missing;
          inside[NodeRecord::momentum + i] -= missing;
        }
      });
    };
    for_each_cut(shape, particles.position.component(0), particles.size(), block, end, nodes, move);
  }
}

/// By how much the slope of the best affine velocity, where three nodes are left, exceeds the one that
/// kernels take: times this the second difference of velocity along the axis. Of cubic shapes, with their
/// weights put in: on the wall itself it is 0, and no moment that is left is divided by.
/// [1/m], Eq. (M197)
template <int D>
[[nodiscard]] double missing_slope(const PointStencil<D, Cubic::support>& stencil, const CutStencil& cut,
                                   std::size_t axis, double spacing) noexcept {
  const double arm = static_cast<double>(cut.beyond) - stencil.xi[axis];
  const double s = 2 - std::abs(arm);  // from the wall [spacings]
  return 3 * s * s * stencil.weight[axis][cut.image] * arm / ((3 - 3 * s + s * s) * spacing);
}

/// The force of points that take their gradient by these slopes.  @param time 1, or of an impulse [s]
template <int D, int V>
void push_by_cut(const Cubic& shape, const Particles<D, V>& particles, const ParticleBlock<D>& block,
                 const MeshEnd& end, double time, Nodes<D>& nodes) noexcept {
  const auto axis = static_cast<std::size_t>(end.axis);
  const CutStencil cut = cut_stencil<D, Cubic::support>(nodes.grid(), end);
  const NodeRecord layout = nodes.record();
  const int place = layout.has_increment ? layout.increment() : NodeRecord::momentum;
  const auto push = [&](Index p, const auto& stencil) {
    const double slope = missing_slope(stencil, cut, axis, nodes.grid().spacing()[end.axis]);
    const double volume = particles.mass.component(0)[p] / particles.density.component(0)[p];
    for_each_beside(stencil, axis, [&](double weight, Index node) {
      double* const wall = nodes[node + stencil.node[axis][cut.wall]] + place;
      double* const inside = nodes[node + stencil.node[axis][cut.inside]] + place;
      double* const beyond = nodes[node + stencil.node[axis][cut.beyond]] + place;
      for (int i = 0; i < V; ++i) {
        const double force =
            -time * weight * slope * volume * particles.stress.component(i + V * end.axis)[p];
        wall[i] += force;
        inside[i] -= 2 * force;
        beyond[i] += force;
      }
    });
  };
  for_each_cut(shape, particles.position.component(0), particles.size(), block, end, nodes, push);
}

/// What points take by these slopes beyond what kernels take.
/// @param position of all points when they gathered [m]
template <int D, int V>
void mend_gradients(const Cubic& shape, const double* position, const Nodes<D>& nodes, const MeshEnd& end,
                    double dt, const ParticleBlock<D>& block, Particles<D, V>& particles) noexcept {
  const auto axis = static_cast<std::size_t>(end.axis);
  const CutStencil cut = cut_stencil<D, Cubic::support>(nodes.grid(), end);
  const auto mend = [&](Index p, const auto& stencil) {
    const double slope = missing_slope(stencil, cut, axis, nodes.grid().spacing()[end.axis]);
    const double before = volume_ratio<double, D, V>(gradient_of(particles, p), dt);
    for_each_beside(stencil, axis, [&](double weight, Index node) {
      const double* const wall = nodes[node + stencil.node[axis][cut.wall]] + NodeRecord::momentum;
      const double* const inside = nodes[node + stencil.node[axis][cut.inside]] + NodeRecord::momentum;
      const double* const beyond = nodes[node + stencil.node[axis][cut.beyond]] + NodeRecord::momentum;
      for (int i = 0; i < V; ++i) {
        particles.velocity_gradient.component(i + V * end.axis)[p] +=
            weight * slope * (wall[i] - 2 * inside[i] + beyond[i]);
      }
    });
    particles.density.component(0)[p] *= before / volume_ratio<double, D, V>(gradient_of(particles, p), dt);
  };
  for_each_cut(shape, position, particles.size(), block, end, nodes, mend);
}

}  // namespace scree::mpm::detail
