#pragma once

#include <scree/transport/detail/axis_geometry.hpp>
#include <scree/transport/detail/numbering.hpp>
#include <scree/transport/detail/row_balance.hpp>
#include <scree/transport/detail/row_kernels.hpp>
#include <scree/transport/detail/wall_kernel.hpp>
#include <scree/transport/discretisation.hpp>

#include <cmath>
#include <memory>
#include <utility>
#include <variant>
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
      : numbering_{grid.count(), grid.is_periodic()},
        first_layer_{first_layer},
        end_layer_{end_layer},
        num_tiles_{(grid.count()[0] + tile_width - 1) / tile_width},
        row_fluxes_(static_cast<std::size_t>(num_tiles_)) {
    for (int axis = 0; axis < D; ++axis) geometry_.emplace_back(grid, axis, cfl);
    for (auto& line : spare_) line = std::make_unique<Line>();
    for (int axis = 1; axis < D; ++axis) {
      const Index num_lines = numbering_.rows_per_layer(axis) * num_tiles_;
      for (Index line = 0; line < num_lines; ++line) lines_.push_back(std::make_unique<Line>());
    }
  }

  /// Hands du/dt of the slab's sites to `write`, component by component.
  template <class Write>
  [[nodiscard]] SweepReport operator()(const Problem& problem, const Fields<N>& fields, double time,
                                       const Write& write) noexcept {
    time_ = time;
    largest_limit_ = {};
    largest_speed_ = {};
    first_fault_ = no_site;
    const Index rows_per_layer = D == 1 ? 1 : numbering_.rows_per_layer(D - 1);
    for (Index row = first_layer_ * rows_per_layer; row < end_layer_ * rows_per_layer; ++row) {
      const Index start = row * numbering_.count[0];
      const Place place{row, start, numbering_.site(start)};
      sweep_along_row(problem, fields, place);
      for (int axis = 1; axis < D; ++axis) {
        if (starts_line(place, axis)) start_lines(problem, fields, place, axis);
      }
      for (Index tile = 0; tile < num_tiles_; ++tile) balance_tile(problem, fields, place, tile, write);
    }
    return {largest_limit_.value(), largest_speed_.value()};
  }

  /// The first site where a rate of change is not finite; no_site if there is none. Sweeps once more.
  [[nodiscard]] Index first_fault(const Problem& problem, const Fields<N>& fields, double time) noexcept {
    is_looking_for_faults_ = true;
    static_cast<void>((*this)(problem, fields, time, [](Index, Index, double) {}));
    is_looking_for_faults_ = false;
    return first_fault_;
  }

 private:
  /// A row: its number, first site, and that site's coordinates.
  struct Place {
    Index row;
    Index start;
    Indices<D> site;
  };
  using Law = typename Problem::Law;
  using State = typename Problem::State;
  using Grid = typename Problem::Grid;
  using Fluxes = FluxTile<N, Diffusive<PointLawOf<Law>>>;
  static constexpr bool has_walls = HasMirror<PointLawOf<Law>, D> && !Grid::is_full;
  using Parts = BalanceParts<Fluxes, HasSource<Law, D>, has_walls>;
  using Geometry = AxisGeometry<Grid::has_equal_spacing>;
  /// What the sweep carries from one row to the next along an axis.
  struct Line {
    Fluxes flux;   ///< through the low faces of the row to come
    Tile<N> high;  ///< reconstruction at the high faces of the row that was passed
  };

  [[nodiscard]] Index count_of(Index tile) const noexcept {
    return std::min(tile_width, numbering_.count[0] - tile * tile_width);
  }

  [[nodiscard]] bool is_periodic(int axis) const noexcept {
    return numbering_.is_periodic[static_cast<std::size_t>(axis)];
  }

  [[nodiscard]] const Geometry& geometry(int axis) const noexcept {
    return geometry_[static_cast<std::size_t>(axis)];
  }

  [[nodiscard]] bool starts_line(const Place& place, int axis) const noexcept {
    const Index coordinate = place.site[static_cast<std::size_t>(axis)];
    return coordinate == 0 || (axis == D - 1 && coordinate == first_layer_);
  }

  [[nodiscard]] std::unique_ptr<Line>& line(const Place& place, int axis, Index tile) noexcept {
    const Index before = axis == 1 ? 0 : 1;  // the lines of axis 1 come first: one row of them
    const Index row = before + place.row % numbering_.rows_per_layer(axis);
    return lines_[static_cast<std::size_t>(row * num_tiles_ + tile)];
  }

  /// Sites of a row along axis 0, from the site with coordinate `from`.
  [[nodiscard]] auto stencil_along(Index start, Index from, Index count) const noexcept {
    return stencil_of(start + from, from, 0, count, geometry(0).ratios_along(from));
  }

  /// Sites of a row that all have one `coordinate` along another axis.
  [[nodiscard]] auto stencil_across(Index here, Index coordinate, int axis, Index count) const noexcept {
    return stencil_of(here, coordinate, axis, count, geometry(axis).ratios_across(coordinate));
  }

  template <class Ratios>
  [[nodiscard]] StencilRow<Ratios> stencil_of(Index here, Index coordinate, int axis, Index count,
                                              Ratios ratios) const noexcept {
    const Index below = numbering_.neighbour(here, coordinate, axis, -1);
    const Index above = numbering_.neighbour(here, coordinate, axis, 1);
    if (below == no_site || above == no_site) return {here, here, here, count, ratios};
    return {below, here, above, count, ratios};
  }

  template <class Ratios>
  static void reconstruct_row(const Problem& problem, const Fields<N>& fields, const StencilRow<Ratios>& row,
                              double* low, double* high) noexcept {
    in_packs(row.count, [&](Index begin, Index count) {
      reconstruct(problem.grid, problem.reconstruction, fields, row.part(begin, count), low + begin,
                  high + begin);
    });
  }

  template <class Distance>
  void flux_through_row(const Problem& problem, const Fields<N>& fields, const FaceRow<Distance>& row,
                        const double* left, const double* right, double* flux) noexcept {
    in_packs(row.count, [&](Index begin, Index count) {
      flux_between(problem.grid, problem.law, problem.flux, fields, row.part(begin, count), left + begin,
                   right + begin, flux + begin, largest_speed_.lanes() + begin);
    });
  }

  /// Fluxes through boundary faces of `axis`, at the low or high end, of `count` sites from the one with
  /// coordinates `site` on, along the axis.  Eq. (T8)
  void flux_out(const Problem& problem, const Fields<N>& fields, Indices<D> site, Index first, Index count,
                int axis, End end, double* flux) noexcept {
    const double sign = end == End::low ? -1 : 1;
    BoundaryFace<D> at{{}, sign * Vector<D>::Unit(axis), time_};
    const double distance = geometry(axis).distance_beyond(end);
    const auto apply = [&](const auto& boundary) {
      for (Index i = 0; i < count; ++i) {
        FaceFlux<State> face{};
        if constexpr (!std::remove_cvref_t<decltype(boundary)>::is_closed) {
          at.centre = problem.grid.position(site);
          at.centre[axis] = problem.grid.end(axis, end);
          const auto law = law_at(problem.law, Face{first + i, no_site, axis, distance});
          face = boundary.flux(problem.flux, law, fields[first + i], at);
        }
        write_flux(face, problem.grid.density(first + i), sign, flux + i);
        ++site[0];
      }
    };
    std::visit(apply, problem.boundaries[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)]);
  }

  void write_flux(const FaceFlux<State>& face, double density, double sign, double* flux) noexcept {
    const bool is_open = density > 0;
    for (int k = 0; k < N; ++k) {
      flux[k * Fluxes::stride] = is_open ? sign * density * face.value[static_cast<std::size_t>(k)] : 0.0;
    }
    flux[Fluxes::drain * Fluxes::stride] = is_open ? density * face.speed : 0.0;
    if constexpr (Fluxes::has_diffusion) flux[Fluxes::diffusion * Fluxes::stride] = 0;
    double& fastest = *largest_speed_.lanes();
    if (is_open && face.speed > fastest) fastest = face.speed;
  }

  /// Reconstruction at the sites of one tile of a row along the row itself; its end sites have neighbours
  /// of their own.
  void reconstruct_tile(const Problem& problem, const Fields<N>& fields, Index start, Index tile) noexcept {
    const Index begin = tile * tile_width;
    const auto part = [&](Index from, Index to) {
      if (from >= to) return;
      reconstruct_row(problem, fields, stencil_along(start, from, to - from), low_.row(0) + (from - begin),
                      high_.row(0) + (from - begin));
    };
    for_each_part(begin, begin + count_of(tile), part);
  }

  /// Cuts sites begin .. end - 1 of a row into those with neighbours beside them and the row's end sites.
  template <class Part>
  void for_each_part(Index begin, Index end, Part&& part) const noexcept {
    const Index last = numbering_.count[0] - 1;
    part(begin, std::min<Index>(end, 1));
    part(std::max<Index>(begin, 1), std::min(end, last));
    part(std::max<Index>({begin, last, 1}), end);
  }

  /// Fluxes through the low faces of all sites of a row along the row, and through its last high face.
  void sweep_along_row(const Problem& problem, const Fields<N>& fields, const Place& place) noexcept {
    for (Index tile = 0; tile < num_tiles_; ++tile) {
      carry_over();
      reconstruct_tile(problem, fields, place.start, tile);
      if (tile == 0) start_row(problem, fields, place);
      const Index skipped = tile == 0 ? 1 : 0;
      const Index from = tile * tile_width + skipped;
      const Index site = place.start + from;
      double* flux = row_fluxes_[static_cast<std::size_t>(tile)].row(0);
      const FaceRow row{site - 1, site, count_of(tile) - skipped, 0, geometry(0).distances_along(from)};
      flux_through_row(problem, fields, row, high_.row(0) + skipped - 1, low_.row(0) + skipped,
                       flux + skipped);
      if (tile > 0) copy_face(flux, row_fluxes_[static_cast<std::size_t>(tile - 1)].row(0) + tile_width);
    }
    end_row(problem, fields, place);
  }

  /// The reconstruction at the last high face of a full tile becomes the one before the next tile's first.
  void carry_over() noexcept {
    for (int k = 0; k < N; ++k) high_.row(k)[-1] = high_.row(k)[tile_width - 1];
  }

  static void copy_face(const double* source, double* target) noexcept {
    for (int k = 0; k < Fluxes::num_rows; ++k) target[k * Fluxes::stride] = source[k * Fluxes::stride];
  }

  /// Flux through the first low face of a row: of a boundary, or from the row's last site.
  void start_row(const Problem& problem, const Fields<N>& fields, const Place& place) noexcept {
    double* flux = row_fluxes_[0].row(0);
    if (!is_periodic(0)) return flux_out(problem, fields, place.site, place.start, 1, 0, End::low, flux);
    const Index last = numbering_.count[0] - 1;
    reconstruct_row(problem, fields, stencil_along(place.start, last, 1), unwanted_.row(0), high_.row(0) - 1);
    const FaceRow row{place.start + last, place.start, 1, 0, geometry(0).distances_along(0)};
    flux_through_row(problem, fields, row, high_.row(0) - 1, low_.row(0), flux);
  }

  void end_row(const Problem& problem, const Fields<N>& fields, const Place& place) noexcept {
    const Index last = numbering_.count[0] - 1;
    double* flux = row_fluxes_.back().row(0) + count_of(num_tiles_ - 1);
    if (is_periodic(0)) return copy_face(row_fluxes_[0].row(0), flux);
    Indices<D> site = place.site;
    site[0] = last;
    flux_out(problem, fields, site, place.start + last, 1, 0, End::high, flux);
  }

  /// Flux through the low faces of a row that is the first of its lines along `axis`, and reconstruction at
  /// its high ones.
  void start_lines(const Problem& problem, const Fields<N>& fields, const Place& place, int axis) noexcept {
    const Index coordinate = place.site[static_cast<std::size_t>(axis)];
    for (Index tile = 0; tile < num_tiles_; ++tile) {
      const Index here = place.start + tile * tile_width;
      const Index count = count_of(tile);
      Line& first = *line(place, axis, tile);
      reconstruct_row(problem, fields, stencil_across(here, coordinate, axis, count), low_.row(0),
                      first.high.row(0));
      const Index below = numbering_.neighbour(here, coordinate, axis, -1);
      if (below == no_site) {
        flux_out(problem, fields, site_of(place, tile), here, count, axis, End::low, first.flux.row(0));
        continue;
      }
      const Index coordinate_below = numbering_.beside(coordinate, axis, -1);
      reconstruct_row(problem, fields, stencil_across(below, coordinate_below, axis, count), unwanted_.row(0),
                      high_.row(0));
      const FaceRow row{below, here, count, axis, geometry(axis).distance_across(coordinate)};
      flux_through_row(problem, fields, row, high_.row(0), low_.row(0), first.flux.row(0));
    }
  }

  /// Flux through the high faces of a tile along `axis`, which are the low faces of the next row.
  void advance_line(const Problem& problem, const Fields<N>& fields, const Place& place, int axis, Index tile,
                    Line& next) noexcept {
    const Index coordinate = place.site[static_cast<std::size_t>(axis)];
    const Index here = place.start + tile * tile_width;
    const Index count = count_of(tile);
    const Index above = numbering_.neighbour(here, coordinate, axis, 1);
    if (above == no_site) {
      return flux_out(problem, fields, site_of(place, tile), here, count, axis, End::high, next.flux.row(0));
    }
    reconstruct_row(problem, fields,
                    stencil_across(above, numbering_.beside(coordinate, axis, 1), axis, count), low_.row(0),
                    next.high.row(0));
    const FaceRow row{here, above, count, axis, geometry(axis).distance_across(coordinate + 1)};
    flux_through_row(problem, fields, row, line(place, axis, tile)->high.row(0), low_.row(0),
                     next.flux.row(0));
  }

  [[nodiscard]] static Indices<D> site_of(const Place& place, Index tile) noexcept {
    Indices<D> site = place.site;
    site[0] = tile * tile_width;
    return site;
  }

  /// Adds up what goes out of the sites of a tile through all their faces.
  template <class Write>
  void balance_tile(const Problem& problem, const Fields<N>& fields, const Place& place, Index tile,
                    const Write& write) noexcept {
    const double* along_row = row_fluxes_[static_cast<std::size_t>(tile)].row(0);
    TileFluxes<D> fluxes{
        geometry(0).fluxes_along(along_row, along_row + 1, tile * tile_width), {}, sources_.row(0)};
    for (int axis = 1; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      std::unique_ptr<Line>& next = spare_[a - 1];
      advance_line(problem, fields, place, axis, tile, *next);
      std::swap(next, line(place, axis, tile));
      fluxes.across[a - 1] = geometry(axis).fluxes_across(
          next->flux.row(0), line(place, axis, tile)->flux.row(0), place.site[a]);
    }
    if constexpr (has_walls) {
      fluxes.along.walls = find_walls(problem, fields, place, 0, tile);
      for (int axis = 1; axis < D; ++axis) {
        fluxes.across[static_cast<std::size_t>(axis - 1)].walls =
            find_walls(problem, fields, place, axis, tile);
      }
    }
    if constexpr (HasSource<Law, D>) find_sources(problem, fields, place, tile);
    const Index first = place.start + tile * tile_width;
    in_packs(count_of(tile), [&](Index begin, Index count) {
      balance<Parts>(problem.grid, first + begin, count, fluxes.part(begin), write, limits_.data() + begin,
                     largest_limit_.lanes() + begin);
    });
    if (is_looking_for_faults_) look_for_faults(first, count_of(tile));
  }

  /// What the walls along `axis` do to the sites of a tile.  Eq. (T65)
  [[nodiscard]] const double* find_walls(const Problem& problem, const Fields<N>& fields, const Place& place,
                                         int axis, Index tile) noexcept {
    const Index begin = tile * tile_width;
    const Index end = begin + count_of(tile);
    double* walls = walls_[static_cast<std::size_t>(axis)].row(0);
    const auto part = [&](Index from, Index to) {
      if (from >= to) return;
      const Index coordinate = axis == 0 ? from : place.site[static_cast<std::size_t>(axis)];
      const Index here = place.start + from;
      const WallRow row{numbering_.neighbour(here, coordinate, axis, -1),
                        here,
                        numbering_.neighbour(here, coordinate, axis, 1),
                        to - from,
                        axis,
                        geometry(axis).distance_beyond(End::low)};
      reflect_at_walls(problem, fields, row, walls + (from - begin));
    };
    if (axis == 0) {
      for_each_part(begin, end, part);
    } else {
      part(begin, end);
    }
    return walls;
  }

  /// What enters by a source: density x rate.  Eq. (T1)
  void find_sources(const Problem& problem, const Fields<N>& fields, const Place& place,
                    Index tile) noexcept {
    Indices<D> site = site_of(place, tile);
    for (Index i = 0; i < count_of(tile); ++i, ++site[0]) {
      const Index here = place.start + site[0];
      const double density = problem.grid.density(here);
      State source{};
      if (density > 0) source = problem.law.source(fields[here], problem.grid.position(site), time_);
      for (int k = 0; k < N; ++k) sources_.row(k)[i] = density * source[static_cast<std::size_t>(k)];
    }
  }

  void look_for_faults(Index first, Index count) noexcept {
    for (Index i = 0; i < count && first_fault_ == no_site; ++i) {
      if (!std::isfinite(limits_[static_cast<std::size_t>(i)])) first_fault_ = first + i;
    }
  }

  Numbering<D> numbering_;
  std::vector<Geometry> geometry_;
  Index first_layer_;
  Index end_layer_;
  Index num_tiles_;
  std::vector<Fluxes> row_fluxes_;            // of the row in hand, along it
  std::vector<std::unique_ptr<Line>> lines_;  // of the axes across the rows
  std::array<std::unique_ptr<Line>, static_cast<std::size_t>(D - 1)> spare_;
  Tile<N> low_{};
  Tile<N> high_{};
  Tile<N> unwanted_{};
  Tile<N> sources_{};
  std::array<WallTile<N>, has_walls ? D : 0> walls_{};
  alignas(64) Lanes limits_{};
  Largest largest_limit_{};
  Largest largest_speed_{};
  double time_ = 0;
  bool is_looking_for_faults_ = false;
  Index first_fault_ = no_site;
};

}  // namespace scree::transport::detail
