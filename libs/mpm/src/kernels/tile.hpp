#pragma once

#include "stencil_loops.hpp"
#include "tile_part.hpp"
#include "transfer_kernels.hpp"

#include <algorithm>

/// The nodes of a block in cache, and their way there and back.
namespace scree::mpm::SCREE_INSTRUCTION_SET {

/// The record of a node in fours: mass and momentum, and the force if it has a place of its own.
template <TransferRule Rule>
struct Record {
  static constexpr bool has_arm = Rule::has_affine && !Rule::has_affine_gradient;
  static constexpr bool has_force = Rule::has_increment;
  /// Forces go to the nodes by themselves: to a place, or by weights, that slopes of momentum do not share.
  static constexpr bool parts_force = has_force || has_arm;
  static constexpr std::ptrdiff_t size = has_force ? 8 : 4;
  static constexpr std::ptrdiff_t force = has_force ? NodeRecord::increment() : 0;
};

template <int D, Shape ShapeType, TransferRule Rule>
struct Tile {
  static constexpr Index edge = TileShape<D, ShapeType::support>::edge;
  /// Zeros follow the nodes of a plane: packs whose stencils begin at neighbours along one axis read one node
  /// more along the other too (Beginnings::are_one).
  static constexpr Index num_beyond = D == 2 ? edge : 0;
  static constexpr Index num_beyond_values = num_beyond * Record<Rule>::size;
  static constexpr Index num_values =
      TileShape<D, ShapeType::support>::num_nodes * Record<Rule>::size + num_beyond_values;
  /// What goes by slopes goes by steps from node to node, (M202): half the multiply-adds.
  static constexpr bool by_steps =
      Rule::has_affine && Rule::has_affine_gradient && HasConstantMoment<ShapeType>;
  [[nodiscard]] static constexpr Strides<D> strides() noexcept {
    Strides<D> stride{};
    stride.axis[0] = Record<Rule>::size;
    for (int axis = 1; axis < D; ++axis) stride.axis[axis] = stride.axis[axis - 1] * edge;
    return stride;
  }

  alignas(64) double values[static_cast<std::size_t>(num_values)];
};

/// Neighbouring nodes of a row, by their doubles.
struct NodesOfRow {
  Index place;    ///< of the first in the mesh, without the parts of the other axes
  Index in_tile;  ///< likewise
  Index count;
};

/// Calls body(record of a node, its copy in the tile, how many doubles) for runs of neighbouring nodes of a
/// part of a tile.
template <class TileType, int D, class Value, class Body>
inline void for_each_run(const TileNodes<D, Value>& nodes, const TilePart<D>& part, Body&& body) noexcept {
  constexpr Index record_size = TileType::strides().axis[0];
  NodesOfRow runs[static_cast<std::size_t>(TileType::edge)];
  int num_runs = 0;
  for (Index i = part.begin[0]; i < part.end[0]; ++i) {
    const Index* const place = &nodes.offset[0][static_cast<std::size_t>(i)];
    if (*place < 0) continue;
    const bool follows = i > part.begin[0] && place[-1] >= 0 && *place == place[-1] + record_size;
    if (!follows) runs[num_runs++] = {*place, i * record_size, 0};
    runs[num_runs - 1].count += record_size;
  }
  for_each_row<D - 1, D>(nodes.offset, TileType::strides(), part, 0, 0, [&](Index place, Index in_tile) {
    for (int r = 0; r < num_runs; ++r) {
      body(nodes.values + place + runs[r].place, in_tile + runs[r].in_tile, runs[r].count);
    }
  });
}

/// Copies the nodes of a block, and zeros for what it lacks or what lies beyond.
template <class TileType, int D>
inline void read_tile(const TileNodes<D, const double>& nodes, TileType& tile) noexcept {
  bool lacks_nodes = false;
  for (const auto& along : nodes.offset) {
    for (Index i = 0; i < TileType::edge; ++i) lacks_nodes |= along[static_cast<std::size_t>(i)] < 0;
  }
  const Index first_zero = lacks_nodes ? 0 : TileType::num_values - TileType::num_beyond_values;
  std::fill(tile.values + first_zero, tile.values + TileType::num_values, 0.0);
  for_each_run<TileType>(nodes, TilePart<D>::whole(TileType::edge),
                         [&](const double* run, Index in_tile, Index count) {
                           double* to = tile.values + in_tile;
                           for (Index i = 0; i < count; ++i) to[i] = run[i];
                         });
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
