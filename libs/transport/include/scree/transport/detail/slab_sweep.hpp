#pragma once

#include <scree/transport/detail/row_kernels.hpp>
#include <scree/transport/detail/row_sums.hpp>
#include <scree/transport/discretisation.hpp>

#include <cmath>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace scree::transport::detail {

/// What a sweep saw.
struct SweepReport {
  Maximum limit;           ///< CFL number per second, at its worst site [1/s]
  Maximum speed;           ///< largest wave speed at a face [m/s]
  Index faulty = no_site;  ///< first site where the rate of change is not finite

  void add(const SweepReport& other) noexcept {
    limit.add(other.limit);
    speed.add(other.speed);
    if (faulty == no_site) faulty = other.faulty;
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
  SlabSweep(const Lattice<D>& lattice, Index first_layer, Index end_layer, double cfl)
      : lattice_{lattice},
        first_layer_{first_layer},
        end_layer_{end_layer},
        cfl_{cfl},
        num_tiles_{(lattice.count[0] + tile_width - 1) / tile_width},
        row_fluxes_(static_cast<std::size_t>(num_tiles_)),
        spare_{std::make_unique<Line>()} {
    for (int axis = 1; axis < D; ++axis) {
      const Index num_lines = rows_per_plane(axis) * num_tiles_;
      for (Index line = 0; line < num_lines; ++line) lines_.push_back(std::make_unique<Line>());
    }
  }

  /// Writes du/dt of the slab's sites into `rates`.
  [[nodiscard]] SweepReport operator()(const Problem& problem, const Fields<N>& fields, Fields<N>& rates,
                                       double time) noexcept {
    time_ = time;
    SweepReport report;
    const Index rows_per_layer = D == 1 ? 1 : rows_per_plane(D - 1);
    for (Index row = first_layer_ * rows_per_layer; row < end_layer_ * rows_per_layer; ++row) {
      const Place place{row, row * lattice_.count[0], lattice_.site(row * lattice_.count[0])};
      sweep_along_row(problem, fields, place.start);
      for (int axis = 1; axis < D; ++axis) {
        if (starts_line(place, axis)) start_lines(problem, fields, place, axis, report);
      }
      for (Index tile = 0; tile < num_tiles_; ++tile) {
        balance(problem, fields, place, tile, report);
        if constexpr (HasSource<typename Problem::Law, D>) add_source(problem, fields, place, tile);
        sums_.finish(problem.grid, place.start + tile * tile_width, count_of(tile), rates.data(),
                     rates.stride());
        inspect(place.start + tile * tile_width, count_of(tile), report);
      }
    }
    return report;
  }

 private:
  /// A row: its number, first site, and that site's coordinates.
  struct Place {
    Index row;
    Index start;
    Indices<D> site;
  };
  /// What the sweep carries from one row to the next along an axis.
  struct Line {
    FluxTile<N> flux;  ///< through the low faces of the row to come
    Tile<N> high;      ///< reconstruction at the high faces of the row that was passed
  };
  using State = typename Problem::State;

  [[nodiscard]] Index rows_per_plane(int axis) const noexcept {
    return lattice_.stride(axis) / lattice_.count[0];
  }

  [[nodiscard]] Index count_of(Index tile) const noexcept {
    return std::min(tile_width, lattice_.count[0] - tile * tile_width);
  }

  [[nodiscard]] bool starts_line(const Place& place, int axis) const noexcept {
    const Index coordinate = place.site[static_cast<std::size_t>(axis)];
    return coordinate == 0 || (axis == D - 1 && coordinate == first_layer_);
  }

  [[nodiscard]] std::unique_ptr<Line>& line(const Place& place, int axis, Index tile) noexcept {
    const Index before = axis == 1 ? 0 : 1;  // the lines of axis 1 come first: one row of them
    const Index row = before + place.row % rows_per_plane(axis);
    return lines_[static_cast<std::size_t>(row * num_tiles_ + tile)];
  }

  /// The neighbour of `site`, which has `coordinate` along `axis`; no_site past an end.
  [[nodiscard]] Index neighbour(Index site, Index coordinate, int axis, Index step) const noexcept {
    const auto a = static_cast<std::size_t>(axis);
    const Index stride = lattice_.stride(axis);
    const Index target = coordinate + step;
    if (target >= 0 && target < lattice_.count[a]) return site + step * stride;
    if (!lattice_.is_periodic[a]) return no_site;
    return site + (step - step * lattice_.count[a]) * stride;
  }

  [[nodiscard]] StencilRow stencil(Index here, Index coordinate, int axis, Index count) const noexcept {
    const Index below = neighbour(here, coordinate, axis, -1);
    const Index above = neighbour(here, coordinate, axis, 1);
    if (below == no_site || above == no_site) return {here, here, here, count};
    return {below, here, above, count};
  }

  /// Fluxes through a row of boundary faces of `axis`, at its low end (side 0) or high end (side 1), along
  /// the axis.  Eq. (T8)
  void flux_out(const Problem& problem, const Fields<N>& fields, const FaceRow& row, int side,
                double* flux) const noexcept {
    const double sign = side == 0 ? -1 : 1;
    BoundaryFace<D> at{centre_out(row, sign), sign * Vector<D>::Unit(row.axis), time_};
    const auto apply = [&](const auto& boundary) {
      for (Index i = 0; i < row.count; ++i) {
        FaceFlux<State> face{};
        if constexpr (!std::remove_cvref_t<decltype(boundary)>::is_closed) {
          const auto law = law_at(problem.law, Face{row.owner + i, no_site, row.axis, row.distance});
          face = boundary.flux(problem.flux, law, fields[row.owner + i], at);
        }
        write(face, problem.grid.density(row.owner + i), sign, flux + i);
        at.centre[0] += lattice_.spacing[0];
      }
    };
    std::visit(apply, problem.boundaries[static_cast<std::size_t>(row.axis)][static_cast<std::size_t>(side)]);
  }

  /// Centre of the first face of such a row.
  [[nodiscard]] Vector<D> centre_out(const FaceRow& row, double sign) const noexcept {
    const Indices<D> site = lattice_.site(row.owner);
    Vector<D> centre = lattice_.position(site);
    if (lattice_.sites == Sites::cells) centre[row.axis] += sign * lattice_.spacing[row.axis] / 2;
    return centre;
  }

  static void write(const FaceFlux<State>& face, double density, double sign, double* flux) noexcept {
    using Out = FluxTile<N>;
    const bool is_open = density > 0;
    for (int k = 0; k < N; ++k) {
      flux[k * Out::stride] = is_open ? sign * density * face.value[static_cast<std::size_t>(k)] : 0.0;
    }
    flux[Out::speed * Out::stride] = is_open ? face.speed : 0.0;
    flux[Out::drain * Out::stride] = is_open ? density * face.speed : 0.0;
    flux[Out::diffusion * Out::stride] = 0;
  }

  /// Reconstruction at the sites of one tile of a row along the row itself; its end sites have neighbours
  /// of their own.
  void reconstruct_tile(const Problem& problem, const Fields<N>& fields, Index start, Index tile) noexcept {
    const Index last = lattice_.count[0] - 1;
    const Index begin = tile * tile_width;
    const Index end = begin + count_of(tile);
    const auto part = [&](Index from, Index to) {
      if (from >= to) return;
      reconstruct(problem.grid, problem.reconstruction, fields, stencil(start + from, from, 0, to - from),
                  low_.row(0) + (from - begin), high_.row(0) + (from - begin));
    };
    part(begin, std::min<Index>(end, 1));
    part(std::max<Index>(begin, 1), std::min(end, last));
    part(std::max<Index>({begin, last, 1}), end);
  }

  /// Fluxes through the low faces of all sites of a row along the row, and through its last high face.
  void sweep_along_row(const Problem& problem, const Fields<N>& fields, Index start) noexcept {
    for (Index tile = 0; tile < num_tiles_; ++tile) {
      carry_over();
      reconstruct_tile(problem, fields, start, tile);
      if (tile == 0) start_row(problem, fields, start);
      const Index skipped = tile == 0 ? 1 : 0;
      const Index site = start + tile * tile_width + skipped;
      const FaceRow row{site - 1, site, count_of(tile) - skipped, 0, lattice_.spacing[0]};
      double* flux = row_fluxes_[static_cast<std::size_t>(tile)].row(0);
      flux_between(problem.grid, problem.law, problem.flux, fields, row, high_.row(0) + skipped - 1,
                   low_.row(0) + skipped, flux + skipped);
      if (tile > 0) copy_face(flux, row_fluxes_[static_cast<std::size_t>(tile - 1)].row(0) + tile_width);
    }
    end_row(problem, fields, start);
  }

  /// The reconstruction at the last high face of a full tile becomes the one before the next tile's first.
  void carry_over() noexcept {
    for (int k = 0; k < N; ++k) high_.row(k)[-1] = high_.row(k)[tile_width - 1];
  }

  static void copy_face(const double* source, double* target) noexcept {
    using In = FluxTile<N>;
    for (int k = 0; k < N + 3; ++k) target[k * In::stride] = source[k * In::stride];
  }

  /// Flux through the first low face of a row: of a boundary, or from the row's last site.
  void start_row(const Problem& problem, const Fields<N>& fields, Index start) noexcept {
    double* flux = row_fluxes_[0].row(0);
    const double distance = lattice_.spacing[0];
    if (!lattice_.is_periodic[0]) return flux_out(problem, fields, {start, no_site, 1, 0, distance}, 0, flux);
    const Index last = lattice_.count[0] - 1;
    Tile<N>& low = spare_->high;  // not wanted
    reconstruct(problem.grid, problem.reconstruction, fields, stencil(start + last, last, 0, 1), low.row(0),
                high_.row(0) - 1);
    flux_between(problem.grid, problem.law, problem.flux, fields, {start + last, start, 1, 0, distance},
                 high_.row(0) - 1, low_.row(0), flux);
  }

  void end_row(const Problem& problem, const Fields<N>& fields, Index start) noexcept {
    const Index last = lattice_.count[0] - 1;
    double* flux = row_fluxes_.back().row(0) + count_of(num_tiles_ - 1);
    if (lattice_.is_periodic[0]) return copy_face(row_fluxes_[0].row(0), flux);
    flux_out(problem, fields, {start + last, no_site, 1, 0, lattice_.spacing[0]}, 1, flux);
  }

  /// Flux through the low faces of a row that is the first of its lines along `axis`, and reconstruction at
  /// its high ones.
  void start_lines(const Problem& problem, const Fields<N>& fields, const Place& place, int axis,
                   SweepReport& report) noexcept {
    const Index coordinate = place.site[static_cast<std::size_t>(axis)];
    const Index size = lattice_.count[static_cast<std::size_t>(axis)];
    for (Index tile = 0; tile < num_tiles_; ++tile) {
      const Index here = place.start + tile * tile_width;
      const Index below = neighbour(here, coordinate, axis, -1);
      const FaceRow row{below == no_site ? here : below, here, count_of(tile), axis, lattice_.spacing[axis]};
      Line& first = *line(place, axis, tile);
      reconstruct(problem.grid, problem.reconstruction, fields, stencil(here, coordinate, axis, row.count),
                  low_.row(0), first.high.row(0));
      if (below == no_site) {
        flux_out(problem, fields, row, 0, first.flux.row(0));
      } else {
        const Index coordinate_below = (coordinate + size - 1) % size;
        reconstruct(problem.grid, problem.reconstruction, fields,
                    stencil(below, coordinate_below, axis, row.count), spare_->high.row(0), high_.row(0));
        flux_between(problem.grid, problem.law, problem.flux, fields, row, high_.row(0), low_.row(0),
                     first.flux.row(0));
      }
      report.speed.add(first.flux.row(FluxTile<N>::speed), row.count);
    }
  }

  /// Flux through the high faces of a tile along `axis`, which are the low faces of the next row.
  void advance_line(const Problem& problem, const Fields<N>& fields, const Place& place, int axis, Index tile,
                    Line& next) noexcept {
    const Index coordinate = place.site[static_cast<std::size_t>(axis)];
    const Index size = lattice_.count[static_cast<std::size_t>(axis)];
    const Index here = place.start + tile * tile_width;
    const Index above = neighbour(here, coordinate, axis, 1);
    const FaceRow row{here, above, count_of(tile), axis, lattice_.spacing[axis]};
    if (above == no_site) return flux_out(problem, fields, row, 1, next.flux.row(0));
    reconstruct(problem.grid, problem.reconstruction, fields,
                stencil(above, (coordinate + 1) % size, axis, row.count), low_.row(0), next.high.row(0));
    flux_between(problem.grid, problem.law, problem.flux, fields, row, line(place, axis, tile)->high.row(0),
                 low_.row(0), next.flux.row(0));
  }

  /// Adds up what goes out of the sites of a tile through all their faces.
  void balance(const Problem& problem, const Fields<N>& fields, const Place& place, Index tile,
               SweepReport& report) noexcept {
    sums_.clear();
    add_along_row(place, tile, report);
    for (int axis = 1; axis < D; ++axis) {
      auto& passed = line(place, axis, tile);
      advance_line(problem, fields, place, axis, tile, *spare_);
      const AxisWeights weights{lattice_, place.site, axis, cfl_};
      sums_.add(passed->flux.row(0), spare_->flux.row(0), weights, 0, count_of(tile));
      report.speed.add(spare_->flux.row(FluxTile<N>::speed), count_of(tile));
      std::swap(passed, spare_);
    }
  }

  /// Counts a source as a flux that enters.  Eq. (T1)
  void add_source(const Problem& problem, const Fields<N>& fields, const Place& place, Index tile) noexcept {
    Indices<D> site = place.site;
    for (Index i = 0; i < count_of(tile); ++i) {
      site[0] = tile * tile_width + i;
      const Index here = place.start + site[0];
      const double density = problem.grid.density(here);
      if (!(density > 0)) continue;
      const State source = problem.law.source(fields[here], lattice_.position(site), time_);
      for (int k = 0; k < N; ++k) sums_.outflow.row(k)[i] -= density * source[static_cast<std::size_t>(k)];
    }
  }

  void add_along_row(const Place& place, Index tile, SweepReport& report) noexcept {
    const Index last = lattice_.count[0] - 1;
    const Index begin = tile * tile_width;
    const Index end = begin + count_of(tile);
    const auto& fluxes = row_fluxes_[static_cast<std::size_t>(tile)];
    const auto part = [&](Index from, Index to) {
      if (from >= to) return;
      Indices<D> site = place.site;
      site[0] = from;
      sums_.add(fluxes.row(0), fluxes.row(0) + 1, AxisWeights{lattice_, site, 0, cfl_}, from - begin,
                to - begin);
    };
    part(begin, std::min<Index>(end, 1));
    part(std::max<Index>(begin, 1), std::min(end, last));
    part(std::max<Index>({begin, last, 1}), end);
    report.speed.add(fluxes.row(FluxTile<N>::speed), count_of(tile) + 1);
  }

  void inspect(Index first, Index count, SweepReport& report) const noexcept {
    report.limit.add(sums_.limit.data(), count);
    if (report.faulty != no_site || std::isfinite(report.limit.value())) return;
    report.faulty = first;
    while (std::isfinite(sums_.limit[static_cast<std::size_t>(report.faulty - first)])) ++report.faulty;
  }

  Lattice<D> lattice_;
  Index first_layer_;
  Index end_layer_;
  double cfl_;
  Index num_tiles_;
  std::vector<FluxTile<N>> row_fluxes_;       // of the row in hand, along it
  std::vector<std::unique_ptr<Line>> lines_;  // of the axes across the rows
  std::unique_ptr<Line> spare_;
  Tile<N> low_{};
  Tile<N> high_{};
  RowSums<N> sums_{};
  double time_ = 0;
};

}  // namespace scree::transport::detail
