#pragma once

#include "stencil_loops.hpp"
#include "tile.hpp"
#include "transfer_kernels.hpp"

/// Packs of points in their columns, and their stencils in memory.
namespace scree::mpm::SCREE_INSTRUCTION_SET {

static_assert(pack_size % Pack::size == 0);

template <int D, int V, class Value>
[[nodiscard]] inline Components<Pack, D> load_position(const PointColumns<D, V, Value>& columns,
                                                       Index p) noexcept {
  Components<Pack, D> position;
  for (int j = 0; j < D; ++j) {
    position[static_cast<std::size_t>(j)] = Pack::load(columns.position + j * columns.stride + p);
  }
  return position;
}

template <int D, int V, class Value>
[[nodiscard]] inline Point<Pack, D, V> load(const PointColumns<D, V, Value>& columns, Index p) noexcept {
  Point<Pack, D, V> point;
  for (int j = 0; j < D; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    point.position[axis] = Pack::load(columns.position + j * columns.stride + p);
    for (int i = 0; i < V; ++i) {
      const Index place = (i + V * j) * columns.stride + p;
      point.velocity_gradient[axis][static_cast<std::size_t>(i)] =
          Pack::load(columns.velocity_gradient + place);
      point.stress[axis][static_cast<std::size_t>(i)] = Pack::load(columns.stress + place);
    }
  }
  for (int i = 0; i < V; ++i) {
    point.velocity[static_cast<std::size_t>(i)] = Pack::load(columns.velocity + i * columns.stride + p);
  }
  point.mass = Pack::load(columns.mass + p);
  point.density = Pack::load(columns.density + p);
  return point;
}

template <int D, int V>
inline void store(const Point<Pack, D, V>& point, const PointColumns<D, V, double>& columns,
                  Index p) noexcept {
  for (int j = 0; j < D; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    point.position[axis].store(columns.position + j * columns.stride + p);
    for (int i = 0; i < V; ++i) {
      point.velocity_gradient[axis][static_cast<std::size_t>(i)].store(columns.velocity_gradient +
                                                                       (i + V * j) * columns.stride + p);
    }
  }
  for (int i = 0; i < V; ++i) {
    point.velocity[static_cast<std::size_t>(i)].store(columns.velocity + i * columns.stride + p);
  }
  point.density.store(columns.density + p);
}

/// A pack's stencils in memory, so that a lane's weights are read one by one.
template <int D, std::size_t S>
struct PackStencils {
  PackWeights<D, S> weight;
  PackWeights<D, S> slope;
  PackWeights<D, S> arm;
  alignas(64) int first[Pack::size];  ///< place in the tile of each lane's first node, in doubles
};

template <class TileType, TransferRule Rule, int D, std::size_t S>
inline void keep(const Stencil<Pack, D, S>& stencil, const BlockPlace<D>& place,
                 PackStencils<D, S>& kept) noexcept {
  Pack first{0};
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (std::size_t i = 0; i < S; ++i) {
      stencil.weight[axis][i].store(kept.weight.along[axis][i]);
      stencil.slope[axis][i].store(kept.slope.along[axis][i]);
      if constexpr (Record<Rule>::has_arm) {
        stencil.arm[axis][i].store(kept.arm.along[axis][i]);
      }
    }
    const auto stride = static_cast<double>(TileType::strides().axis[axis]);
    first = first + (stencil.base[axis] - place.first_base[axis]) * stride;
  }
  double places[Pack::size];
  first.store(places);
  for (int lane = 0; lane < Pack::size; ++lane) kept.first[lane] = static_cast<int>(places[lane]);
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
