#pragma once

#include "stencil.hpp"

#include <scree/mpm/boundary.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>

#include <array>
#include <cstddef>

namespace scree::mpm::detail {

/// Where the stencils of points begin that reach past an end, and their nodes there; counted along the axis.
struct CutStencil {
  Index base;
  std::size_t image;
  std::size_t wall;
  std::size_t inside;
};

template <int D, std::size_t S>
[[nodiscard]] CutStencil cut_stencil(const CartesianGrid<D>& grid, const MeshEnd& end) noexcept {
  if (end.side == Side::low) return {.base = -1, .image = 0, .wall = 1, .inside = 2};
  const Index num_nodes = grid.nodes().count[static_cast<std::size_t>(end.axis)];
  return {.base = num_nodes + 1 - static_cast<Index>(S), .image = S - 1, .wall = S - 2, .inside = S - 3};
}

/// The stencil of one point along all axes.
template <int D, std::size_t S>
struct PointStencil {
  std::array<std::array<double, S>, static_cast<std::size_t>(D)> weight;
  std::array<std::array<Index, S>, static_cast<std::size_t>(D)> node;  ///< their sum numbers a node
};

template <class ShapeType, int D, int V>
[[nodiscard]] PointStencil<D, ShapeType::support> point_stencil(const ShapeType& shape,
                                                                const Particles<D, V>& particles, Index p,
                                                                const ParticleBlock<D>& block,
                                                                const Nodes<D>& nodes) noexcept {
  PointStencil<D, ShapeType::support> stencil;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const int a = static_cast<int>(axis);
    const Place at = place_in_block<ShapeType>(particles.position.component(a)[p], nodes.grid(), a, block);
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

/// What points gave to an image with their gradient of velocity L, they gave at the speed of its place. Twice
/// that goes to the wall, a spacing h away, and less once that to the node inside, 2h away: so
/// 2 h w m L n is missing at the one and too much at the other.  Eq. (M183)
template <class ShapeType, int D, int V>
void move_to_cut(const ShapeType& shape, const Particles<D, V>& particles, const ParticleBlock<D>& block,
                 const MeshEnd& end, Nodes<D>& nodes) noexcept {
  if constexpr (ShapeType::support > 2) {
    const CartesianGrid<D>& grid = nodes.grid();
    const auto axis = static_cast<std::size_t>(end.axis);
    const CutStencil cut = cut_stencil<D, ShapeType::support>(grid, end);
    const Index last_base = block.first_cell[axis] + block_edge<D, ShapeType::support>;
    if (cut.base < block.first_cell[axis] - 1 || last_base < cut.base) return;
    const double* const x = particles.position.component(end.axis);
    const double arm = (end.side == Side::low ? 2 : -2) * grid.spacing()[end.axis];
    for (Index p = block.begin; p < block.end; ++p) {
      if (place_in_block<ShapeType>(x[p], grid, end.axis, block).base != cut.base) continue;
      const auto stencil = point_stencil(shape, particles, p, block, nodes);
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
    }
  }
}

}  // namespace scree::mpm::detail
