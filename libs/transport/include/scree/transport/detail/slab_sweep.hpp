#pragma once

#include <scree/transport/detail/row_balance.hpp>
#include <scree/transport/detail/slab_fluxes.hpp>
#include <scree/transport/detail/slab_layout.hpp>
#include <scree/transport/detail/wall_kernel.hpp>
#include <scree/transport/discretisation.hpp>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace scree::transport::detail {

/// What a sweep saw; NaN if a rate of change or a speed was not finite.
struct SweepReport {
  double limit = 0;  ///< CFL number per second, at its worst site [1/s]
  double speed = 0;  ///< largest wave speed at a face [m/s]

  void add(const SweepReport& other) noexcept {
    limit = larger(limit, other.limit);
    speed = larger(speed, other.speed);
  }
};

/// du/dt on some layers of a lattice, row by row.
///
/// Each face's flux is computed once and used on both sides. Along the rows (axis 0) a row's fluxes are
/// kept; along the other axes the flux and the reconstruction at the last row that was passed. The first
/// faces of the layers are computed by two slabs, by the same code from the same data.
template <class Problem>
class SlabSweep {
 public:
  static constexpr int D = Problem::dimension;
  static constexpr int N = Problem::num_components;

  /// Layers first_layer .. end_layer - 1 along the last axis (which 1D has not: one row).
  SlabSweep(const typename Problem::Grid& grid, Index first_layer, Index end_layer, double cfl)
      : layout_{grid, first_layer, end_layer, cfl},
        row_fluxes_(static_cast<std::size_t>(layout_.num_tiles())) {
    for (auto& line : spare_) line = std::make_unique<Line>();
    for (int axis = 1; axis < D; ++axis) {
      for (Index line = 0; line < layout_.num_lines(axis); ++line) lines_.push_back(std::make_unique<Line>());
    }
  }

  /// Hands du/dt of the slab's sites to `write`, component by component.
  template <class Write>
  [[nodiscard]] SweepReport operator()(const Problem& problem, const Fields<N>& fields, double time,
                                       const Write& write) noexcept {
    largest_limit_ = {};
    largest_speed_ = {};
    first_found_ = no_site;
    const Flow flow{problem, fields, time};
    const Index end = layout_.end_row();
    for (Index row = layout_.first_row(); row < end; ++row) {
      const Place place = layout_.place_of(row);
      sweep_along_row(flow, place);
      for (int axis = 1; axis < D; ++axis) {
        if (layout_.starts_line(place, axis)) start_lines(flow, place, axis);
      }
      for (Index tile = 0; tile < layout_.num_tiles(); ++tile) balance_tile(flow, place, tile, write);
    }
    return {largest_limit_.value(), largest_speed_.value()};
  }

  /// The first site whose CFL number per second is not below `limit` [1/s]; it counts as not below where a
  /// rate of change is not finite. no_site if there is none. Sweeps once more.
  [[nodiscard]] Index first_not_below(double limit, const Problem& problem, const Fields<N>& fields,
                                      double time) noexcept {
    is_looking_ = true;
    sought_limit_ = limit;
    static_cast<void>((*this)(problem, fields, time, [](Index, Index, double) {}));
    is_looking_ = false;
    return first_found_;
  }

 private:
  using Law = typename Problem::Law;
  using State = typename Problem::State;
  using Grid = typename Problem::Grid;
  using Flow = detail::Flow<Problem>;
  using Place = RowPlace<D>;
  using Fluxes = FluxTileOf<Problem>;
  static constexpr bool has_walls = HasMirror<PointLawOf<Law>, D> && !Grid::is_full;
  using Parts = BalanceParts<Fluxes, HasSource<Law, D>, has_walls>;
  /// What the sweep carries from one row to the next along an axis.
  struct Line {
    Fluxes flux;   ///< through the low faces of the row to come
    Tile<N> high;  ///< reconstruction at the high faces of the row that was passed
  };

  [[nodiscard]] std::unique_ptr<Line>& line(const Place& place, int axis, Index tile) noexcept {
    return lines_[layout_.line(place, axis, tile)];
  }

  /// Fluxes out through faces that `count` sites of a row have at an end of an axis.
  void flux_out(const Flow& flow, const Indices<D>& site, Index first, Index count, int axis, End end,
                double* flux) noexcept {
    const double distance = layout_.geometry(axis).distance_beyond(end);
    detail::flux_out(flow, {site, first, count, axis, end, distance}, flux, largest_speed_);
  }

  /// Reconstruction along a row, at `count` of its sites from coordinate `from` on.
  void reconstruct_along(const Flow& flow, Index start, Index from, Index count, double* low,
                         double* high) noexcept {
    const Index first = start + from;
    const Index last = from + count - 1;
    row_copy_.copy(flow.sites(), layout_.numbering().neighbour(first, from, 0, -1), first,
                   layout_.numbering().neighbour(start + last, last, 0, 1), count);
    reconstruct_row(row_copy_, flow.problem.reconstruction,
                    StencilRow{-1, 0, 1, count, layout_.geometry(0).ratios_along(from)}, low, high);
  }

  /// Reconstruction at `count` sites of a row along another axis, on which all have one `coordinate`.
  void reconstruct_across(const Flow& flow, Index here, Index coordinate, int axis, Index count, double* low,
                          double* high) noexcept {
    reconstruct_row(flow.sites(), flow.problem.reconstruction,
                    layout_.stencil_across(here, coordinate, axis, count), low, high);
  }

  /// Fluxes through the low faces of all sites of a row along the row, and through its last high face.
  void sweep_along_row(const Flow& flow, const Place& place) noexcept {
    for (Index tile = 0; tile < layout_.num_tiles(); ++tile) {
      carry_over();
      reconstruct_along(flow, place.start, tile * tile_width, layout_.count_of(tile), low_.row(0),
                        high_.row(0));
      if (tile == 0) start_row(flow, place);
      const Index skipped = tile == 0 ? 1 : 0;
      const Index from = tile * tile_width + skipped;
      const Index site = place.start + from;
      double* flux = row_fluxes_[static_cast<std::size_t>(tile)].row(0);
      const FaceRow row{site - 1, site, layout_.count_of(tile) - skipped, 0,
                        layout_.geometry(0).distances_along(from)};
      flux_through_row(flow, row, high_.row(0) + skipped - 1, low_.row(0) + skipped, flux + skipped,
                       largest_speed_);
      if (tile > 0) copy_face(flux, row_fluxes_[static_cast<std::size_t>(tile - 1)].row(0) + tile_width);
    }
    end_row(flow, place);
  }

  /// The reconstruction at the last high face of a full tile becomes the one before the next tile's first.
  void carry_over() noexcept {
    for (int k = 0; k < N; ++k) high_.row(k)[-1] = high_.row(k)[tile_width - 1];
  }

  static void copy_face(const double* source, double* target) noexcept {
    for (int k = 0; k < Fluxes::num_rows; ++k) target[k * Fluxes::stride] = source[k * Fluxes::stride];
  }

  /// Flux through the first low face of a row: of a boundary, or from the row's last site.
  void start_row(const Flow& flow, const Place& place) noexcept {
    double* flux = row_fluxes_[0].row(0);
    if (!layout_.is_periodic(0)) return flux_out(flow, place.site, place.start, 1, 0, End::low, flux);
    const Index last = layout_.last();
    if (layout_.num_tiles() == 1) {
      for (int k = 0; k < N; ++k) high_.row(k)[-1] = high_.row(k)[last];
    } else {
      reconstruct_along(flow, place.start, last, 1, unwanted_.row(0), high_.row(0) - 1);
    }
    const FaceRow row{place.start + last, place.start, 1, 0, layout_.geometry(0).distances_along(0)};
    flux_through_row(flow, row, high_.row(0) - 1, low_.row(0), flux, largest_speed_);
  }

  void end_row(const Flow& flow, const Place& place) noexcept {
    const Index last = layout_.last();
    double* flux = row_fluxes_.back().row(0) + layout_.count_of(layout_.num_tiles() - 1);
    if (layout_.is_periodic(0)) return copy_face(row_fluxes_[0].row(0), flux);
    Indices<D> site = place.site;
    site[0] = last;
    flux_out(flow, site, place.start + last, 1, 0, End::high, flux);
  }

  /// Flux through the low faces of a row that is the first of its lines along `axis`, and reconstruction at
  /// its high ones.
  void start_lines(const Flow& flow, const Place& place, int axis) noexcept {
    const Index coordinate = place.along(axis);
    for (Index tile = 0; tile < layout_.num_tiles(); ++tile) {
      const Index here = place.start + tile * tile_width;
      const Index count = layout_.count_of(tile);
      Line& first = *line(place, axis, tile);
      reconstruct_across(flow, here, coordinate, axis, count, low_.row(0), first.high.row(0));
      const Index below = layout_.numbering().neighbour(here, coordinate, axis, -1);
      if (below == no_site) {
        flux_out(flow, layout_.site_of(place, tile), here, count, axis, End::low, first.flux.row(0));
        continue;
      }
      const Index coordinate_below = layout_.numbering().beside(coordinate, axis, -1);
      reconstruct_across(flow, below, coordinate_below, axis, count, unwanted_.row(0), high_.row(0));
      const FaceRow row{below, here, count, axis, layout_.geometry(axis).distance_across(coordinate)};
      flux_through_row(flow, row, high_.row(0), low_.row(0), first.flux.row(0), largest_speed_);
    }
  }

  /// Flux through the high faces of a tile along `axis`, which are the low faces of the next row.
  void advance_line(const Flow& flow, const Place& place, int axis, Index tile, const Line& current,
                    Line& next) noexcept {
    const Index coordinate = place.along(axis);
    const Index here = place.start + tile * tile_width;
    const Index count = layout_.count_of(tile);
    const Index above = layout_.numbering().neighbour(here, coordinate, axis, 1);
    if (above == no_site) {
      return flux_out(flow, layout_.site_of(place, tile), here, count, axis, End::high, next.flux.row(0));
    }
    reconstruct_across(flow, above, layout_.numbering().beside(coordinate, axis, 1), axis, count, low_.row(0),
                       next.high.row(0));
    const FaceRow row{here, above, count, axis, layout_.geometry(axis).distance_across(coordinate + 1)};
    flux_through_row(flow, row, current.high.row(0), low_.row(0), next.flux.row(0), largest_speed_);
  }

  /// Adds up what goes out of the sites of a tile through all their faces.
  template <class Write>
  void balance_tile(const Flow& flow, const Place& place, Index tile, const Write& write) noexcept {
    const double* along_row = row_fluxes_[static_cast<std::size_t>(tile)].row(0);
    TileFluxes<D> fluxes{
        layout_.geometry(0).fluxes_along(along_row, along_row + 1, tile * tile_width), {}, sources_.row(0)};
    for (int axis = 1; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      std::unique_ptr<Line>& current = line(place, axis, tile);
      std::unique_ptr<Line>& next = spare_[a - 1];
      advance_line(flow, place, axis, tile, *current, *next);
      fluxes.across[a - 1] =
          layout_.geometry(axis).fluxes_across(current->flux.row(0), next->flux.row(0), place.site[a]);
      std::swap(current, next);
    }
    if constexpr (has_walls) {
      fluxes.along.walls = find_walls(flow, place, 0, tile);
      for (int axis = 1; axis < D; ++axis) {
        fluxes.across[static_cast<std::size_t>(axis - 1)].walls = find_walls(flow, place, axis, tile);
      }
    }
    if constexpr (HasSource<Law, D>) find_sources(flow, place, tile);
    const Index first = place.start + tile * tile_width;
    in_packs(layout_.count_of(tile), [&](Index begin, Index count) {
      balance<Parts>(flow.problem.grid, first + begin, count, fluxes.part(begin), write,
                     limits_.data() + begin, largest_limit_.lanes() + begin);
    });
    if (is_looking_) look_in(first, layout_.count_of(tile));
  }

  /// What the walls along `axis` do to the sites of a tile.  Eq. (T65)
  [[nodiscard]] const double* find_walls(const Flow& flow, const Place& place, int axis,
                                         Index tile) noexcept {
    const Index begin = tile * tile_width;
    const Index end = begin + layout_.count_of(tile);
    double* walls = walls_[static_cast<std::size_t>(axis)].row(0);
    const auto part = [&](Index from, Index to) {
      if (from >= to) return;
      Index coordinate = from;
      if constexpr (D > 1) coordinate = axis == 0 ? from : place.along(axis);
      const Index here = place.start + from;
      const WallRow row{layout_.numbering().neighbour(here, coordinate, axis, -1),
                        here,
                        layout_.numbering().neighbour(here, coordinate, axis, 1),
                        to - from,
                        axis,
                        layout_.geometry(axis).distance_beyond(End::low)};
      reflect_at_walls(flow.problem, flow.fields, row, walls + (from - begin));
    };
    if (axis == 0) {
      layout_.for_each_part(begin, end, part);
    } else {
      part(begin, end);
    }
    return walls;
  }

  /// What enters by a source: density x rate.  Eq. (T1)
  void find_sources(const Flow& flow, const Place& place, Index tile) noexcept {
    Indices<D> site = layout_.site_of(place, tile);
    for (Index i = 0; i < layout_.count_of(tile); ++i, ++site[0]) {
      const Index here = place.start + site[0];
      const double density = flow.problem.grid.density(here);
      State source{};
      if (density > 0)
        source = flow.problem.law.source(flow.fields[here], flow.problem.grid.position(site), flow.time);
      for (int k = 0; k < N; ++k) sources_.row(k)[i] = density * source[static_cast<std::size_t>(k)];
    }
  }

  void look_in(Index first, Index count) noexcept {
    for (Index i = 0; i < count && first_found_ == no_site; ++i) {
      if (!(limits_[static_cast<std::size_t>(i)] < sought_limit_)) first_found_ = first + i;
    }
  }

  SlabLayout<Grid> layout_;
  std::vector<Fluxes> row_fluxes_;            // of the row in hand, along it
  std::vector<std::unique_ptr<Line>> lines_;  // of the axes across the rows
  std::array<std::unique_ptr<Line>, static_cast<std::size_t>(D - 1)> spare_;
  RowCopy<N> row_copy_{};  // of the tile in hand
  Tile<N> low_{};
  Tile<N> high_{};
  Tile<N> unwanted_{};
  Tile<N> sources_{};
  std::array<WallTile<N>, has_walls ? D : 0> walls_{};
  alignas(64) Lanes limits_{};
  Largest largest_limit_{};
  Largest largest_speed_{};
  bool is_looking_ = false;
  double sought_limit_ = 0;
  Index first_found_ = no_site;
};

}  // namespace scree::transport::detail
