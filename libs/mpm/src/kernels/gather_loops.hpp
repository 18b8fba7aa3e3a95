#pragma once

#include "near_loops.hpp"
#include "point_packs.hpp"
#include "stencil_loops.hpp"
#include "tile.hpp"
#include "transpose.hpp"

#include <algorithm>
#include <limits>

/// Nodes to points, a pack of points at a time. Lanes are points (near_loops.hpp); but fields of a node where
/// the points of a pack are far apart (stencil_loops.hpp).
namespace scree::mpm::SCREE_INSTRUCTION_SET {

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

/// What becomes of the points from `first` up to but not `end`.
template <Shape ShapeType, TransferRule Rule, int D, int V>
inline void take_packs(const Rule& rule, const PointColumns<D, V, double>& columns,
                       const BlockPlace<D>& place, Index first, Index end, const Taken<Pack, D, V>* taken,
                       double dt, MotionOfPacks& motion) noexcept {
  for (Index p = first; p < end; p += Pack::size, ++taken) {
    const Point<Pack, D, V> next = take<Rule>(rule, load(columns, p), *taken, dt);
    store(next, columns, p);
    motion.widen(next, place, ShapeType::shift);
  }
}

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
  read_tile(nodes, tile);
  MotionOfPacks motion;
  // Some packs at once, so that the next sums do not wait for what ends a chain; and the branches on where
  // stencils begin are known a pack ahead, so that none is mispredicted for long. In space, where sums are
  // long, neither pays.
  constexpr bool is_short = D < 3;
  constexpr Index at_once = Index{is_short ? 8 : 1} * Pack::size;
  Taken<Pack, D, V> taken[static_cast<std::size_t>(at_once / Pack::size)];
  auto next_begin = beginnings<ShapeType>(columns, place, columns.begin);
  for (Index first = columns.begin; first < columns.end; first += at_once) {
    const Index end = is_short ? std::min(first + at_once, columns.end) : first + at_once;
    for (Index p = first; p < end; p += Pack::size) {
      if constexpr (!is_short) next_begin = beginnings<ShapeType>(columns, place, p);
      const auto begin = next_begin;
      if constexpr (is_short) {
        const Index next = std::min(p + Pack::size, columns.end - Pack::size);
        next_begin = beginnings<ShapeType>(columns, place, next);
      }
      const auto position = load_position(columns, p);
      const auto stencil = stencil_at<Rule, D>(shape, position, place.origin, place.inverse_spacing);
      gather_pack<TileType, Rule>(stencil, begin, place, tile.values, taken[(p - first) / Pack::size]);
    }
    take_packs<ShapeType>(rule, columns, place, first, end, taken, dt, motion);
  }
  return motion.of_block();
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
