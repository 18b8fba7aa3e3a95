#pragma once

#include <scree/transport/boundaries.hpp>
#include <scree/transport/detail/maximum.hpp>
#include <scree/transport/detail/staggered_kernels.hpp>
#include <scree/transport/face.hpp>
#include <scree/transport/fluxes/kurganov_tadmor.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace scree::transport::detail {

/// The largest wave speeds along each axis [m/s].
template <int D>
struct SpeedsAlong {
  std::array<Maximum, static_cast<std::size_t>(D)> axis{};

  void add(const SpeedsAlong& other) noexcept {
    for (std::size_t a = 0; a < D; ++a) axis[a].add(other.axis[a]);
  }
};

/// Half of a pair of staggered steps, row by row: from the cells to their corners, or back.
template <class Law, class L, int D>
class StaggeredSweep {
 public:
  static constexpr int N = Law::num_components;
  using State = typename Law::State;
  using Speeds = SpeedsAlong<D>;

  /// @param source the lattice that this half starts from: cells, or their corners (Sites::nodes)
  explicit StaggeredSweep(const Lattice<D>& source) : source_{source} {}

  [[nodiscard]] const Lattice<D>& source() const noexcept { return source_; }
  [[nodiscard]] Index num_rows() const noexcept { return source_.num_sites() / source_.count[0]; }

  /// Speeds along rows begin .. end - 1.
  [[nodiscard]] Speeds speeds(const Law& law, const Fields<N>& fields, Index begin,
                              Index end) const noexcept {
    Speeds result;
    Tile<1> speed;
    for (Index row = begin; row < end; ++row) {
      const Place place = place_of(row);
      for (int axis = 0; axis < D; ++axis) {
        for_each_part(place, axis, 0, source_.count[0], [&](const LineRow& part) {
          const Index above = part.above == no_site ? part.here : part.above;
          for (Index from = 0; from < part.count; from += tile_width) {
            const Index count = std::min(tile_width, part.count - from);
            speeds_above<D>(law, fields, {part.below, part.here + from, above + from, count}, axis,
                            speed.row(0));
            result.axis[static_cast<std::size_t>(axis)].add(speed.row(0), count);
          }
        });
      }
    }
    return result;
  }

  /// The first site that has a state, or a speed to a neighbour, that is not finite.
  [[nodiscard]] Index first_faulty(const Law& law, const Fields<N>& fields) const noexcept {
    for (Index site = 0; site < source_.num_sites(); ++site) {
      const State u = fields[site];
      for (const double value : u) {
        if (!std::isfinite(value)) return site;
      }
      const Indices<D> at = source_.site(site);
      for (int axis = 0; axis < D; ++axis) {
        const Index above = neighbour(site, at[static_cast<std::size_t>(axis)], axis, 1);
        const State next = above == no_site ? u : fields[above];
        const Vector<D> normal = Vector<D>::Unit(axis);
        if (!std::isfinite(law.max_speed(u, next, normal))) return site;
      }
    }
    return 0;
  }

  /// What a step is made of.
  struct Step {
    const Law& law;
    const L& limiter;
    const BoxBoundaries<D, N>& boundaries;
    double dt;    ///< [s]
    double time;  ///< half way through it, of the boundaries [s]
  };

  /// Makes the pieces of rows begin .. end - 1. @return the speeds at walls
  Speeds make_pieces(const Step& step, const Fields<N>& fields, Pieces<D, N>& pieces, Index begin,
                     Index end) const noexcept {
    Speeds walls;
    Tile<N> half;
    for (Index row = begin; row < end; ++row) {
      const Place place = place_of(row);
      const Index first_entry = entry_of(pieces, place.site);
      for (Index tile = 0; tile < source_.count[0]; tile += tile_width) {
        const Index count = std::min(tile_width, source_.count[0] - tile);
        const Index entry = first_entry + tile;
        for (int k = 0; k < N; ++k) {
          const double* u = fields.data() + k * fields.stride() + place.start + tile;
          std::copy_n(u, count, half.row(k));
          std::copy_n(u, count, pieces.state(k) + entry);
        }
        for (int axis = 0; axis < D; ++axis) {
          for_each_part(place, axis, tile, count, [&](const LineRow& part) {
            const Index from = part.here - place.start - tile;
            add_slopes<D>(step.law, step.limiter, fields, flat_at_ends(part), axis,
                          step.dt / source_.spacing[axis], half.row(0) + from,
                          pieces.passed(axis, 0) + entry + from, pieces.component_stride());
          });
        }
        for (int axis = 0; axis < D; ++axis) {
          add_fluxes<D>(step.law, half, count, axis, step.dt / source_.spacing[axis],
                        pieces.passed(axis, 0) + entry, pieces.component_stride());
        }
        add_walls(step, place, tile, half, pieces, walls);
      }
    }
    return walls;
  }

  /// Fills the entries beyond the ends, once all rows are there: from the other end of a periodic axis, or as
  /// the mirror images that make the flux through a wall what its boundary says.
  void close(Pieces<D, N>& pieces) const noexcept {
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const Index n = source_.count[a];
      if (source_.is_periodic[a]) {
        if (is_of_cells()) copy_layer(pieces, axis, n, 0, true);
        copy_layer(pieces, axis, is_of_cells() ? 1 : 0, is_of_cells() ? n + 1 : n, true);
      } else if (is_of_cells()) {
        copy_layer(pieces, axis, 1, 0, false);
        copy_layer(pieces, axis, n, n + 1, false);
      }
    }
  }

 private:
  /// A row: its first site, and that site's coordinates.
  struct Place {
    Index start;
    Indices<D> site;
  };

  [[nodiscard]] bool is_of_cells() const noexcept { return source_.sites == Sites::cells; }

  [[nodiscard]] Place place_of(Index row) const noexcept {
    return {row * source_.count[0], source_.site(row * source_.count[0])};
  }

  [[nodiscard]] Index entry_of(const Pieces<D, N>& pieces, Indices<D> site) const noexcept {
    for (Index& coordinate : site) coordinate += is_of_cells() ? 1 : 0;
    return pieces.entry(site);
  }

  /// The neighbour of `site`, which has `coordinate` along `axis`; no_site past an end.
  [[nodiscard]] Index neighbour(Index site, Index coordinate, int axis, Index step) const noexcept {
    const auto a = static_cast<std::size_t>(axis);
    const Index target = coordinate + step;
    if (target >= 0 && target < source_.count[a]) return site + step * source_.stride(axis);
    if (!source_.is_periodic[a]) return no_site;
    return site + (step - step * source_.count[a]) * source_.stride(axis);
  }

  /// Calls body(stencil) for the parts of a tile whose neighbours along `axis` lie alike; no_site where there
  /// are none.
  template <class Body>
  void for_each_part(const Place& place, int axis, Index tile, Index count, Body&& body) const noexcept {
    const auto part = [&](Index from, Index to, Index coordinate) {
      if (from >= to) return;
      const Index here = place.start + from;
      body(LineRow{neighbour(here, coordinate, axis, -1), here, neighbour(here, coordinate, axis, 1),
                   to - from});
    };
    if (axis > 0) return part(tile, tile + count, place.site[static_cast<std::size_t>(axis)]);
    const Index last = source_.count[0] - 1;
    part(tile, std::min<Index>(tile + count, 1), 0);
    part(std::max<Index>(tile, 1), std::min(tile + count, last), std::max<Index>(tile, 1));
    part(std::max<Index>({tile, last, 1}), tile + count, last);
  }

  [[nodiscard]] static LineRow flat_at_ends(const LineRow& row) noexcept {
    const bool is_inside = row.below != no_site && row.above != no_site;
    return is_inside ? row : LineRow{row.here, row.here, row.here, row.count};
  }

  /// What passes through the walls that a tile stands at.  Eq. (T44)
  void add_walls(const Step& step, const Place& place, Index tile, const Tile<N>& half, Pieces<D, N>& pieces,
                 Speeds& speeds) const noexcept {
    const Index count = std::min(tile_width, source_.count[0] - tile);
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      if (source_.is_periodic[a]) continue;
      const Index last = source_.count[a] - 1;
      for (const int side : {0, 1}) {
        const Index end = side == 0 ? 0 : last;
        const bool is_whole = axis > 0 && place.site[a] == end;
        const bool is_one = axis == 0 && tile <= end && end < tile + count;
        if (is_whole) add_wall(step, place, {tile, count, axis, side}, half.row(0), pieces, speeds);
        if (is_one) add_wall(step, place, {end, 1, axis, side}, half.row(0) + (end - tile), pieces, speeds);
      }
    }
  }

  /// Some sites of a row at the low (side 0) or high end of an axis.
  struct WallRow {
    Index first;  ///< of them, counted from the row's start
    Index count;
    int axis;
    int side;
  };

  void add_wall(const Step& step, const Place& place, const WallRow& row, const double* half,
                Pieces<D, N>& pieces, Speeds& speeds) const noexcept {
    const auto a = static_cast<std::size_t>(row.axis);
    const double sign = row.side == 0 ? -1 : 1;
    const double passed = 2 * sign * step.dt / source_.spacing[row.axis];
    Indices<D> site = place.site;
    site[0] = row.first;
    BoundaryFace<D> at{centre_out(site, row.axis, sign), sign * Vector<D>::Unit(row.axis), step.time};
    const Index entry = entry_of(pieces, site);
    const Index outward = (row.side == 0 ? -1 : 1) * pieces.stride(row.axis);
    const auto apply = [&](const auto& boundary) {
      for (Index i = 0; i < row.count; ++i) {
        State inside;
        for_each_component<N>(
            [&](std::size_t k) { inside[k] = half[static_cast<Index>(k) * Tile<N>::stride + i]; });
        const FaceFlux<State> face = boundary.flux(KurganovTadmor{}, step.law, inside, at);
        for (int k = 0; k < N; ++k) {
          double* own = pieces.passed(row.axis, k) + entry + i;
          const double through = passed * face.value[static_cast<std::size_t>(k)];
          if (is_of_cells()) {
            own[outward] = 2 * through - *own;
          } else {
            *own = through;
          }
        }
        speeds.axis[a].add(&face.speed, 1);
        at.centre[0] += source_.spacing[0];
      }
    };
    std::visit(apply, step.boundaries[a][static_cast<std::size_t>(row.side)]);
  }

  [[nodiscard]] Vector<D> centre_out(const Indices<D>& site, int axis, double sign) const noexcept {
    Vector<D> centre = source_.position(site);
    if (is_of_cells()) centre[axis] += sign * source_.spacing[axis] / 2;
    return centre;
  }

  /// Copies the entries at one coordinate along an axis to another one; `whole` or all but what is passed on
  /// along the axis itself.
  static void copy_layer(Pieces<D, N>& pieces, int axis, Index source, Index target, bool whole) noexcept {
    const Index run = pieces.stride(axis);
    const Index period = run * pieces.extent().count[static_cast<std::size_t>(axis)];
    for (int k = 0; k < Pieces<D, N>::num_rows; ++k) {
      if (!whole && k / N == axis + 1) continue;
      double* values = pieces.state(k);
      for (Index start = 0; start < pieces.extent().num_sites(); start += period) {
        std::copy_n(values + start + source * run, run, values + start + target * run);
      }
    }
  }

  Lattice<D> source_;
};

}  // namespace scree::transport::detail
