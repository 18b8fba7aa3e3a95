#pragma once

#include "near_loops.hpp"
#include "stencil_loops.hpp"
#include "tile_part.hpp"
#include "transfer_kernels.hpp"
#include "transpose.hpp"

#include <algorithm>
#include <limits>
#include <utility>

/// Points to nodes and back, a pack of points at a time. Lanes are points for weights and for what a point
/// gives or takes (point_transfer.hpp), fields of a node on the way there and of packs whose points are far
/// apart (stencil_loops.hpp); points in between too on the way back to the others (near_loops.hpp).
namespace scree::mpm::SCREE_INSTRUCTION_SET {

static_assert(pack_size % Pack::size == 0);

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
  static constexpr Index num_beyond = D == 2 ? edge + 1 : 0;
  static constexpr Index num_values =
      (TileShape<D, ShapeType::support>::num_nodes + num_beyond) * Record<Rule>::size;
  /// What goes by slopes goes by steps from node to node: half the multiply-adds.
  static constexpr bool by_steps = Rule::has_affine_gradient && HasConstantMoment<ShapeType>;
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

/// Sets down mass and momentum as one four, and for each axis slopes as others; and forces likewise, without
/// a value of their own but by steps.
template <class TileType, TransferRule Rule, int D, int V, std::size_t S, bool parts_force>
inline void keep(const Given<Pack, D, V>& given, const Stencil<Pack, D, S>& stencil,
                 PackGiven<D, parts_force>& kept) noexcept {
  constexpr Index stride = Index{4} * (1 + D);
  const auto set_down = [](const Pack& first, const Components<Pack, V>& rest, double* fours) {
    to_fours({first, component<V>(rest, 0), component<V>(rest, 1), component<V>(rest, 2)}, fours, stride);
  };
  Components<Pack, V> momentum;
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
  if constexpr (parts_force) {
    const auto set_down_force = [&](const Components<Pack, V>& force, double* fours) {
      if constexpr (Record<Rule>::has_force) {
        to_fours({component<V>(force, 0), component<V>(force, 1), component<V>(force, 2), Pack{0}}, fours,
                 stride);
      } else {
        set_down(Pack{0}, force, fours);  // over mass and momentum
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
      set_down_force(at_first, kept.force[0][0]);
    }
    for (std::size_t j = 0; j < D; ++j) set_down_force(force[j], kept.force[0][1 + j]);
  }
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
    keep<TileType, Rule>(give<Rule>(point, stencil, dt), stencil, given);
    for (int lane = 0; lane < Pack::size; ++lane) {
      scatter_lane<TileType, Rule>(stencils, given, lane, tile.values);
    }
  }
  for_each_run<TileType>(nodes, part.of_block(), [&](double* run, Index in_tile, Index count) {
    const double* from = tile.values + in_tile;
    for (Index i = 0; i < count; ++i) run[i] += from[i];
  });
}

/// What the nodes give to the points of a pack, in fours, point by point.
template <int D>
struct PackTaken {
  alignas(64) double velocity[Pack::size][1 + D][4];
  alignas(64) double increment[Pack::size][4];
};

template <TransferRule Rule, int D, std::size_t S>
inline void gather_lane(const PackStencils<D, S>& stencils, int lane, const Strides<D>& stride,
                        const double* tile, PackTaken<D>& taken) noexcept {
  const double* first = tile + stencils.first[lane];
  const auto sum = sum_of_nodes<D, S, true>(stencils.weight, stencils.slope, lane, stride, first);
  sum.value.store(taken.velocity[lane][0]);
  for (int j = 0; j < D; ++j) sum.slope[j].store(taken.velocity[lane][1 + j]);
  if constexpr (Rule::has_increment) {
    sum_of_nodes<D, S, false>(stencils.weight, stencils.slope, lane, stride, first + Record<Rule>::force)
        .value.store(taken.increment[lane]);
  }
}

template <TransferRule Rule, int D, int V>
inline void read_back(const PackTaken<D>& kept, Taken<Pack, D, V>& taken) noexcept {
  constexpr Index stride = Index{4} * (1 + D);
  Pack fields[4];
  from_fours(kept.velocity[0][0], stride, fields);
  for (std::size_t i = 0; i < V; ++i) taken.velocity[i] = fields[1 + i];
  for (std::size_t j = 0; j < D; ++j) {
    from_fours(kept.velocity[0][1 + j], stride, fields);
    for (std::size_t i = 0; i < V; ++i) taken.velocity_gradient[j][i] = fields[1 + i];
  }
  if constexpr (Rule::has_increment) {
    from_fours(kept.increment[0], 4, fields);
    for (std::size_t i = 0; i < V; ++i) taken.increment[i] = fields[i];
  }
}

/// A pack of points from nodes anywhere in the tile, lane by lane.
template <class TileType, TransferRule Rule, int D, int V, std::size_t S>
inline void gather_lanes(const Stencil<Pack, D, S>& stencil, const BlockPlace<D>& place, const double* tile,
                         Taken<Pack, D, V>& taken) noexcept {
  PackStencils<D, S> stencils;
  PackTaken<D> kept;
  keep<TileType, Rule>(stencil, place, stencils);
  for (int lane = 0; lane < Pack::size; ++lane) {
    gather_lane<Rule>(stencils, lane, TileType::strides(), tile, kept);
  }
  read_back<Rule>(kept, taken);
}

/// A pack of points whose nodes are near.  @tparam N nodes along the first axis
template <class TileType, TransferRule Rule, std::size_t N, int D, int V, std::size_t S>
inline void gather_near(const NearNodes<D, S>& nodes, const Stencil<Pack, D, S>& stencil, const double* first,
                        Taken<Pack, D, V>& taken) noexcept {
  constexpr auto stride = TileType::strides();
  for (std::size_t i = 0; i < V; ++i) {
    const double* const momentum = first + NodeRecord::momentum + i;
    if constexpr (TileType::by_steps) {
      const auto velocity = moments_near<N>(nodes, stride, momentum);
      taken.velocity[i] = velocity.value;
      for (std::size_t j = 0; j < D; ++j) {
        const Pack moment = velocity.slope[j] - nodes.xi[j] * velocity.value;
        taken.velocity_gradient[j][i] = moment * stencil.inverse_moment[j];
      }
    } else {
      const auto velocity = sum_near<N, true>(nodes, stride, momentum);
      taken.velocity[i] = velocity.value;
      for (std::size_t j = 0; j < D; ++j) taken.velocity_gradient[j][i] = velocity.slope[j];
    }
    if constexpr (Rule::has_increment) {
      taken.increment[i] = sum_near<N, false>(nodes, stride, first + Record<Rule>::force + i).value;
    }
  }
}

template <class TileType, TransferRule Rule, int D, int V, std::size_t S>
inline void gather_pack(const Stencil<Pack, D, S>& stencil, const Beginnings<D>& begin,
                        const BlockPlace<D>& place, const double* tile, Taken<Pack, D, V>& taken) noexcept {
  if (!begin.are_near) return gather_lanes<TileType, Rule>(stencil, place, tile, taken);
  const NearNodes<D, S> nodes{stencil, begin};
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto along = static_cast<int>(begin.first[axis] - place.first_base[axis]);
    tile += along * TileType::strides().axis[axis];
  }
  if (begin.are_one[0]) {
    gather_near<TileType, Rule, S>(nodes, stencil, tile, taken);
  } else {
    gather_near<TileType, Rule, S + 1>(nodes, stencil, tile, taken);
  }
}

/// Where the stencils of the pack of points from p on begin.
template <Shape ShapeType, int D, int V>
[[nodiscard]] inline Beginnings<D> beginnings(const PointColumns<D, V, double>& columns,
                                              const BlockPlace<D>& place, Index p) noexcept {
  Components<Pack, D> base;
  for (int j = 0; j < D; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    const Pack x = Pack::load(columns.position + j * columns.stride + p);
    base[axis] = first_node<ShapeType>(x, place.origin[axis], place.inverse_spacing[axis]);
  }
  return Beginnings<D>{base};
}

/// What has become of the points of a block, lane by lane.
class MotionOfPacks {
 public:
  template <int D, int V>
  void widen(const Point<Pack, D, V>& point, const BlockPlace<D>& place, double shift) noexcept {
    Pack rate{0};
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Pack& x = point.position[axis];
      const Pack along = coordinate(x, place.origin[axis], place.inverse_spacing[axis], shift);
      is_inside_ &= (Pack{place.first_base[axis]} <= along) & (along < Pack{place.beyond_base[axis]}) &
                    (Pack{place.low[axis]} <= x) & (x <= Pack{place.high[axis]});
      rate = rate + abs(point.velocity[axis]) * place.inverse_spacing[axis];
    }
    constexpr double largest = std::numeric_limits<double>::max();
    lacks_volume_ |= (point.density <= Pack{0}) | (Pack{largest} < point.density);
    rate_ = max(rate_, rate);
  }
  [[nodiscard]] BlockMotion of_block() const noexcept {
    BlockMotion motion;
    motion.advection_rate = largest_lane(rate_)[0];
    motion.needs_sort = !Pack::all_of(is_inside_);
    motion.lacks_volume = !Pack::all_of(~lacks_volume_);
    return motion;
  }

 private:
  Pack::Mask is_inside_ = ~Pack::Mask{};
  Pack::Mask lacks_volume_{};
  Pack rate_{0};
};

template <int D, int V, Shape ShapeType, TransferRule Rule>
SCREE_KERNEL BlockMotion gather(const AnyShape& any_shape, const AnyTransfer& any_rule,
                                const PointColumns<D, V, double>& given_columns,
                                const BlockPlace<D>& given_place, const TileNodes<D, const double>& nodes,
                                double dt) noexcept {
  const auto columns = given_columns;  // copies: stores to points cannot alias them
  const auto place = given_place;
  using TileType = Tile<D, ShapeType, Rule>;
  const auto shape = *std::get_if<ShapeType>(&any_shape);
  const auto rule = *std::get_if<Rule>(&any_rule);
  TileType tile;
  std::fill_n(tile.values, TileType::num_values, 0.0);
  for_each_run<TileType>(nodes, TilePart<D>::whole(TileType::edge),
                         [&](const double* run, Index in_tile, Index count) {
                           double* to = tile.values + in_tile;
                           for (Index i = 0; i < count; ++i) to[i] = run[i];
                         });
  MotionOfPacks motion;
  // In a plane one pack ahead, so that the core knows a pack's way before it gets there; in space sums are
  // long.
  constexpr bool looks_ahead = D < 3;
  auto next_begin = beginnings<ShapeType>(columns, place, columns.begin);
  for (Index p = columns.begin; p < columns.end; p += Pack::size) {
    if constexpr (!looks_ahead) next_begin = beginnings<ShapeType>(columns, place, p);
    const auto begin = next_begin;
    if constexpr (looks_ahead) {
      const Index next = std::min(p + Pack::size, columns.end - Pack::size);
      next_begin = beginnings<ShapeType>(columns, place, next);
    }
    const Point<Pack, D, V> point = load(columns, p);
    const auto stencil = stencil_at<Rule, D>(shape, point.position, place.origin, place.inverse_spacing);
    Taken<Pack, D, V> taken;
    gather_pack<TileType, Rule>(stencil, begin, place, tile.values, taken);
    const Point<Pack, D, V> next = take<Rule>(rule, point, taken, dt);
    store(next, columns, p);
    motion.widen(next, place, ShapeType::shift);
  }
  return motion.of_block();
}

/// The kernels of every shape with every rule.
template <int D, int V, class Shapes, class Rules>
struct KernelTable;
template <int D, int V, class... S, class... R>
struct KernelTable<D, V, std::variant<S...>, std::variant<R...>> {
  using Entry = TransferKernels<D, V>;
  template <class One>
  struct Row {
    static constexpr Entry entries[] = {{scatter<D, V, One, R>, gather<D, V, One, R>}...};
  };
  static constexpr const Entry* rows[] = {Row<S>::entries...};
};

template <int D, int V>
TransferKernels<D, V> transfer_kernels(std::size_t shape, std::size_t rule) noexcept {
  return KernelTable<D, V, AnyShape, AnyTransfer>::rows[shape][rule];
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
