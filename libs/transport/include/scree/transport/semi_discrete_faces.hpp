#pragma once

#include <scree/blocks.hpp>
#include <scree/error.hpp>
#include <scree/transport/cell_states.hpp>
#include <scree/transport/detail/cell_slopes.hpp>
#include <scree/transport/detail/face_fluxes.hpp>
#include <scree/transport/detail/face_tables.hpp>
#include <scree/transport/detail/named_boundaries.hpp>
#include <scree/transport/detail/non_orthogonal.hpp>
#include <scree/transport/discretisation.hpp>
#include <scree/transport/reconstructions/cell_gradient.hpp>
#include <scree/transport/reconstructions/piecewise_constant.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scree::transport {

/// The boundaries of a grid by their names: one for each that the grid has.
template <int D, int N>
using NamedBoundaries = std::map<std::string, AnyBoundary<D, N>, std::less<>>;

template <FaceGrid Grid, int N>
struct BoundariesOf<Grid, N> {
  using type = NamedBoundaries<Grid::dimension, N>;
};

/// du/dt of a conservation law on cells of any form.  Eqs. (T30) to (T36)
///
/// Three sweeps: gradients, cell by cell; fluxes, face by face; their balance, cell by cell. Each writes only
/// what is its own, in one order, so that any number of threads gives the same bits. The geometry is read
/// from the grid once, here; a call allocates nothing.
template <FaceGrid Grid, class Law, class Reconstruct, class Flux>
class SemiDiscrete<Grid, Law, Reconstruct, Flux> {
 public:
  using Problem = Discretisation<Grid, Law, Reconstruct, Flux>;
  static constexpr int D = Problem::dimension;
  static constexpr int N = Problem::num_components;
  using Storage = CellStates<N>;
  static constexpr bool is_first_order = std::is_same_v<Reconstruct, PiecewiseConstant>;
  static_assert(is_first_order || CellReconstruction<Reconstruct>);

  /// @throws InputError if the grid is not one (see FaceGrid), naming cell or face and position; if a
  /// boundary has no condition, or a condition no boundary, naming it.
  SemiDiscrete(Problem problem, double /*cfl*/, Threads threads)
      : problem_{std::move(problem)}, threads_{threads} {
    const detail::GridParts<D> parts{problem_.grid};
    detail::check_grid<D>(parts);
    boundaries_ = detail::in_order(problem_.boundaries, parts.boundary_names);
    tables_ = detail::make_face_tables<D>(parts, rings());
    if constexpr (!is_first_order) gradients_.resize(parts.volumes.size());
    if constexpr (is_diffusive) conductances_.resize(parts.faces.size());
    records_.resize(parts.faces.size());
    reports_.resize(static_cast<std::size_t>(num_chunks(tables_.num_cells)));
  }

  [[nodiscard]] Problem& problem() noexcept { return problem_; }
  [[nodiscard]] const Problem& problem() const noexcept { return problem_; }
  [[nodiscard]] Threads threads() const noexcept { return threads_; }
  [[nodiscard]] Index num_sites() const noexcept { return tables_.num_cells; }
  [[nodiscard]] static constexpr bool holds(Index /*cell*/) noexcept { return true; }

  /// Writes du/dt at `fields` into `rates`.
  /// @param time of the boundaries and the source [s]
  /// @throws RunError with the cell and its position if a rate of change or a speed is not finite.
  StepBounds operator()(const Storage& fields, Storage& rates, double time) {
    return sweep(fields, time, [&](Index i, double rate) { rates.data()[i] = rate; });
  }

  /// Writes the next stage of a Runge-Kutta step in the same pass: kept u^n + (1 - kept)(u + dt du/dt), with
  /// u the fields and u^n the `start` of the step.  Eq. (T7)
  /// @param next neither of the others
  StepBounds advance_stage(const Storage& fields, const Storage& start, Storage& next, double kept, double dt,
                           double time) {
    return sweep(fields, time, [&, kept, dt](Index i, double rate) {
      next.data()[i] = kept * start.data()[i] + (1 - kept) * (fields.data()[i] + dt * rate);
    });
  }

 private:
  using State = typename Problem::State;
  using PointLaw = PointLawOf<Law>;
  static constexpr bool is_diffusive = Diffusive<PointLaw>;
  static constexpr Index chunk = 1024;  // cells or faces that a thread takes at a time

  struct Report {
    double limit = 0;  ///< NaN if a rate is not finite
    double speed = 0;
    Index faulty = no_site;  ///< first cell where it is not

    void add(const Report& other) noexcept {
      limit = larger(limit, other.limit);
      speed = larger(speed, other.speed);
      if (faulty == no_site) faulty = other.faulty;
    }
  };

  template <class Write>
  StepBounds sweep(const Storage& fields, double time, const Write& write) {
    if constexpr (!is_first_order) {
      for_each_chunk(0, tables_.num_cells, [&](Index begin, Index end) {
        detail::find_gradients(tables_, problem_.law, problem_.reconstruction, fields, begin, end,
                               gradients_.data());
      });
    }
    for_each_chunk(0, tables_.num_inner, [&](Index begin, Index end) { flux_inside(fields, begin, end); });
    for (std::size_t boundary = 0; boundary < boundaries_.size(); ++boundary) {
      for_each_chunk(tables_.first_boundary[boundary], tables_.first_boundary[boundary + 1],
                     [&](Index begin, Index end) { flux_out(boundary, fields, begin, end, time); });
    }
    for_each_chunk(0, tables_.num_cells, [&](Index begin, Index end) {
      reports_.data()[begin / chunk] = balance(fields, begin, end, time, write);
    });
    return bounds();
  }

  [[nodiscard]] int rings() const {
    if constexpr (is_first_order) {
      return is_diffusive ? 1 : 0;
    } else {
      require(problem_.reconstruction.rings == 1 || problem_.reconstruction.rings == 2,
              "CellGradient: rings must be 1 or 2");
      return problem_.reconstruction.rings;
    }
  }

  [[nodiscard]] static Index num_chunks(Index count) noexcept { return (count + chunk - 1) / chunk; }

  template <class Body>
  void for_each_chunk(Index begin, Index end, Body&& body) const {
    for_each_block(num_chunks(end - begin), threads_, [&](Index block) {
      body(begin + block * chunk, std::min(end, begin + (block + 1) * chunk));
    });
  }

  [[nodiscard]] Vector<N> at_face(const Storage& fields, Index cell, const Vector<D>& offset) const noexcept {
    if constexpr (is_first_order) {
      return detail::values_of<N>(fields, cell);
    } else {
      return detail::extrapolated<D, N>(fields, cell, gradients_.data()[cell], offset);
    }
  }
  [[nodiscard]] State state_at_face(const Storage& fields, Index cell,
                                    const Vector<D>& offset) const noexcept {
    const Vector<N> value = at_face(fields, cell, offset);
    State state;
    for (int k = 0; k < N; ++k) state[static_cast<std::size_t>(k)] = value[k];
    return state;
  }

  /// Fluxes through faces begin .. end - 1 between cells.
  void flux_inside(const Storage& fields, Index begin, Index end) noexcept {
    if constexpr (GridFaceDependent<Law, D>) {
      for (Index face = begin; face < end; ++face) flux_between(fields, face);
    } else {
      detail::FaceTile<N> tile{};
      for (Index first = begin; first < end; first += detail::num_tile_faces) {
        const Index count = std::min(detail::num_tile_faces, end - first);
        reconstruct(fields, first, count, tile);
        detail::flux_through(tables_, problem_.law, problem_.flux, first, count, tile);
        record(tile, first, count);
      }
      if constexpr (is_diffusive) {
        for (Index face = begin; face < end; ++face) diffuse(problem_.law, fields, face);
      }
    }
  }

  /// States on both sides of faces first .. first + count - 1.
  void reconstruct(const Storage& fields, Index first, Index count,
                   detail::FaceTile<N>& tile) const noexcept {
    for (Index i = 0; i < count; ++i) {
      const auto& face = tables_.faces.data()[first + i];
      const Vector<N> left = at_face(fields, face.owner, face.from_owner);
      const Vector<N> right = at_face(fields, face.neighbour, face.from_neighbour);
      for (int k = 0; k < N; ++k) {
        tile.left[static_cast<std::size_t>(k)].data()[i] = left[k];
        tile.right[static_cast<std::size_t>(k)].data()[i] = right[k];
      }
    }
  }

  void record(const detail::FaceTile<N>& tile, Index first, Index count) noexcept {
    for (Index i = 0; i < count; ++i) {
      auto& record = records_.data()[first + i];
      for (std::size_t k = 0; k < N; ++k) record.flux[k] = tile.flux[k].data()[i];
      record.speed = tile.speed.data()[i];
    }
  }

  /// The same through one face, for laws that differ from face to face.
  void flux_between(const Storage& fields, Index number) noexcept {
    const auto& face = tables_.faces.data()[number];
    const auto law = law_at<D>(problem_.law, problem_.grid.face(tables_.original.data()[number]));
    const FaceFlux<State> flux =
        problem_.flux(law, state_at_face(fields, face.owner, face.from_owner),
                      state_at_face(fields, face.neighbour, face.from_neighbour), tables_.normal(number));
    records_.data()[number] = {flux.value, flux.speed};
    if constexpr (is_diffusive) diffuse(law, fields, number);
  }

  /// Fluxes out through faces begin .. end - 1 of a boundary.  Eq. (T8)
  void flux_out(std::size_t number, const Storage& fields, Index begin, Index end, double time) noexcept {
    const auto apply = [&](const auto& boundary) {
      for (Index i = begin; i < end; ++i) {
        FaceFlux<State> flux{};
        if constexpr (!std::remove_cvref_t<decltype(boundary)>::is_closed) {
          const GridFace<D> face = problem_.grid.face(tables_.original.data()[i]);
          const auto& law = law_at<D>(problem_.law, face);
          flux = boundary.flux(problem_.flux, law, state_at_face(fields, face.owner, face.from_owner),
                               BoundaryFace<D>{face.centre, face.normal, time});
        }
        records_.data()[i] = {flux.value, flux.speed};
      }
    };
    std::visit(apply, boundaries_.data()[number]);
  }

  void diffuse(const PointLaw& law, const Storage& fields, Index face) noexcept {
    auto& record = records_.data()[face];
    conductances_.data()[face] = detail::add_diffusion(law, tables_, fields, face, record.flux);
  }

  /// du/dt of cells begin .. end - 1 from the fluxes through their faces.  Eqs. (T30), (T34)
  template <class Write>
  Report balance(const Storage& fields, Index begin, Index end, double time, const Write& write) noexcept {
    Report report;
    for (Index cell = begin; cell < end; ++cell) {
      Vector<N> rate = Vector<N>::Zero();
      double half_sum = 0;  // of rates x speeds
      double most = 0;      // of closeness x speed
      double diffusion = 0;
      for (const auto& face : tables_.faces_of(cell)) {
        const auto& record = records_.data()[face.face];
        rate += face.rate * Eigen::Map<const Vector<N>>{record.flux.data()};
        half_sum += 0.5 * std::abs(face.rate) * record.speed;
        most = std::max(most, face.closeness * record.speed);
        report.speed = std::max(report.speed, record.speed);
        if constexpr (is_diffusive) diffusion += std::abs(face.rate) * conductances_.data()[face.face];
      }
      if constexpr (HasSource<Law, D>) {
        const State source = problem_.law.source(fields[cell], problem_.grid.centre(cell), time);
        for (int k = 0; k < N; ++k) rate[k] += source[static_cast<std::size_t>(k)];
      }
      for (int k = 0; k < N; ++k) write(cell * N + k, rate[k]);
      // Zero, or NaN where a rate or a speed is not finite: the maxima would pass over it.
      const double fault = 0 * (rate.sum() + half_sum + diffusion);
      report.limit = larger(report.limit, (is_first_order ? half_sum : most) + diffusion + fault);
      if (report.faulty == no_site && !(fault == 0)) report.faulty = cell;
    }
    return report;
  }

  [[nodiscard]] StepBounds bounds() const {
    Report total;
    for (const Report& report : reports_) total.add(report);
    if (total.faulty != no_site) {
      detail::throw_not_finite_in_cell<D>(total.faulty, problem_.grid.centre(total.faulty));
    }
    return {total.limit, total.speed};
  }

  Problem problem_;
  Threads threads_;
  detail::FaceTables<D> tables_;
  std::vector<AnyBoundary<D, N>> boundaries_;
  std::vector<detail::Gradient<D, N>> gradients_;
  std::vector<detail::FaceRecord<N>> records_;
  std::vector<double> conductances_;  ///< of diffusion, of each face: diffusivity / distance [m/s]
  std::vector<Report> reports_;
};

}  // namespace scree::transport
