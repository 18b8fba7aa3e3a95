#pragma once

#include "point_packs.hpp"
#include "stencil_loops.hpp"
#include "tile.hpp"
#include "transpose.hpp"

#include <algorithm>

/// Points to nodes, a pack of points at a time. Lanes are points for weights and for what a point gives
/// (point_transfer.hpp), and fields of a node in the loop over a stencil (stencil_loops.hpp).
namespace scree::mpm::SCREE_INSTRUCTION_SET {

/// The given in fours, point by point.
template <int D, bool parts_force>
struct PackGiven {
  alignas(64) double momentum[Pack::size][1 + D][4];
  alignas(64) double force[parts_force ? Pack::size : 1][1 + D][4];
};

template <int V>
[[nodiscard]] inline Pack component(const Components<Pack, V>& values, int i) noexcept {
  return i < V ? values[static_cast<std::size_t>(i)] : Pack{0};
}

/// Sets down mass and momentum as one four, and slopes for each axis as others.
template <class TileType, TransferRule Rule, int D, int V, std::size_t S, bool parts_force>
inline void keep_momentum(const Given<Pack, D, V>& given, const Stencil<Pack, D, S>& stencil,
                          PackGiven<D, parts_force>& kept) noexcept {
  constexpr Index stride = Index{4} * (1 + D);
  const auto set_down = [](const Pack& first, const Components<Pack, V>& rest, double* fours) {
    to_fours({first, component<V>(rest, 0), component<V>(rest, 1), component<V>(rest, 2)}, fours, stride);
  };
  Components<Pack, V> momentum;  // number by number, here as below: packs would be copied in halves
  for (std::size_t i = 0; i < V; ++i) momentum[i] = given.momentum[i];
  Components<Components<Pack, V>, D> slope;
  for (std::size_t j = 0; j < D; ++j) {
    for (std::size_t i = 0; i < V; ++i) {
      slope[j][i] = parts_force        ? given.momentum_slope[j][i]
                    : Rule::has_affine ? given.momentum_slope[j][i] + given.force[j][i]
                                       : given.force[j][i];
    }
  }
  if constexpr (TileType::by_steps) turn_to_steps<Pack, D, V>(stencil, momentum, slope);
  set_down(given.mass, momentum, kept.momentum[0][0]);
  if constexpr (Rule::has_affine || !parts_force) {
    for (std::size_t j = 0; j < D; ++j) set_down(Pack{0}, slope[j], kept.momentum[0][1 + j]);
  }
}

/// Sets down forces that go by themselves: for each axis one four, and if by steps their value before those.
template <class TileType, TransferRule Rule, int D, int V, std::size_t S>
inline void keep_force(const Given<Pack, D, V>& given, const Stencil<Pack, D, S>& stencil,
                       PackGiven<D, true>& kept) noexcept {
  constexpr Index stride = Index{4} * (1 + D);
  const auto set_down = [](const Components<Pack, V>& force, double* fours) {
    const Pack x = component<V>(force, 0);
    const Pack y = component<V>(force, 1);
    const Pack z = component<V>(force, 2);
    if constexpr (Record<Rule>::has_force) {
      to_fours({x, y, z, Pack{0}}, fours, stride);
    } else {
      to_fours({Pack{0}, x, y, z}, fours, stride);  // over mass and momentum
    }
  };
  Components<Components<Pack, V>, D> force;
  for (std::size_t j = 0; j < D; ++j) {
    for (std::size_t i = 0; i < V; ++i) force[j][i] = given.force[j][i];
  }
  if constexpr (TileType::by_steps) {
    Components<Pack, V> at_first;
    at_first.fill(Pack{0});
    turn_to_steps<Pack, D, V>(stencil, at_first, force);
    set_down(at_first, kept.force[0][0]);
  }
  for (std::size_t j = 0; j < D; ++j) set_down(force[j], kept.force[0][1 + j]);
}

template <class TileType, TransferRule Rule, int D, std::size_t S, bool parts_force>
inline void scatter_lane(const PackStencils<D, S>& stencils, const PackGiven<D, parts_force>& given, int lane,
                         double* tile) noexcept {
  constexpr auto stride = TileType::strides();
  constexpr bool has_slope = Rule::has_affine || !parts_force;
  double* first = tile + stencils.first[lane];
  ToNodes<D> momentum;
  momentum.value = Four::load(given.momentum[lane][0]);
  if constexpr (has_slope) {
    for (int j = 0; j < D; ++j) momentum.slope[j] = Four::load(given.momentum[lane][1 + j]);
  }
  if constexpr (TileType::by_steps) {
    add_affine<D, S>(momentum, stencils.weight, lane, stride, first);
  } else {
    add_to_nodes<D, S, true, has_slope>(momentum, stencils.weight,
                                        Record<Rule>::has_arm ? stencils.arm : stencils.slope, lane, stride,
                                        first);
  }
  if constexpr (parts_force) {
    double* const place = first + Record<Rule>::force;
    ToNodes<D> force;
    for (int j = 0; j < D; ++j) force.slope[j] = Four::load(given.force[lane][1 + j]);
    if constexpr (TileType::by_steps) {
      force.value = Four::load(given.force[lane][0]);
      add_affine<D, S>(force, stencils.weight, lane, stride, place);
    } else {
      add_to_nodes<D, S, false, true>(force, stencils.weight, stencils.slope, lane, stride, place);
    }
  }
}

template <int D, int V, Shape ShapeType, TransferRule Rule>
SCREE_KERNEL void scatter(const AnyShape& any_shape, const PointColumns<D, V, const double>& given_columns,
                          const BlockPlace<D>& given_place, const TileNodes<D, double>& nodes,
                          double dt) noexcept {
  const auto columns = given_columns;  // copies: stores to points cannot alias them
  const auto place = given_place;
  using TileType = Tile<D, ShapeType, Rule>;
  const auto shape = *std::get_if<ShapeType>(&any_shape);
  TileType tile;
  std::fill_n(tile.values, TileType::num_values, 0.0);
  PackStencils<D, ShapeType::support> stencils;
  PackGiven<D, Record<Rule>::parts_force> given;
  PartOfPacks<D, ShapeType::support> part;
  for (Index p = columns.begin; p < columns.end; p += Pack::size) {
    const Point<Pack, D, V> point = load(columns, p);
    const auto stencil = stencil_at<Rule, D>(shape, point.position, place.origin, place.inverse_spacing);
    keep<TileType, Rule>(stencil, place, stencils);
    for (std::size_t axis = 0; axis < D; ++axis) {
      part.widen(axis, stencil.base[axis] - place.first_base[axis]);
    }
    const auto from_points = give<Rule>(point, stencil, dt);
    keep_momentum<TileType, Rule>(from_points, stencil, given);
    if constexpr (Record<Rule>::parts_force) keep_force<TileType, Rule>(from_points, stencil, given);
    for (int lane = 0; lane < Pack::size; ++lane) {
      scatter_lane<TileType, Rule>(stencils, given, lane, tile.values);
    }
  }
  for_each_run<TileType>(nodes, part.of_block(), [&](double* run, Index in_tile, Index count) {
    const double* from = tile.values + in_tile;
    for (Index i = 0; i < count; ++i) run[i] += from[i];
  });
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
