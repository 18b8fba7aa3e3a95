#pragma once

#include <scree/blocks.hpp>
#include <scree/error.hpp>
#include <scree/transport/cell_states.hpp>
#include <scree/transport/detail/grid_parts.hpp>
#include <scree/transport/detail/named_boundaries.hpp>
#include <scree/transport/detail/patch.hpp>
#include <scree/transport/detail/patch_sweep.hpp>
#include <scree/transport/discretisation.hpp>
#include <scree/transport/reconstructions/cell_gradient.hpp>
#include <scree/transport/reconstructions/piecewise_constant.hpp>

#include <algorithm>
#include <atomic>
#include <map>
#include <string>
#include <utility>
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
/// Works on one patch of cells after the other, in cache; the cells on a patch's rim are reconstructed in
/// each patch that they touch. Each patch writes only what is its own, so that any number of threads gives
/// the same bits. The geometry is read from the grid once, here; a call allocates nothing.
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
    num_cells_ = static_cast<Index>(parts.volumes.size());
    constexpr bool has_diffusion = Diffusive<PointLawOf<Law>>;
    patches_ = detail::make_patches<D>(parts, {rings(has_diffusion), !is_first_order, has_diffusion});
    const Index num_sweeps = std::clamp<Index>(threads.count, 1, num_patches());
    sweeps_.assign(static_cast<std::size_t>(num_sweeps), Sweep{patches_});
    reports_.resize(sweeps_.size());
  }

  [[nodiscard]] Problem& problem() noexcept { return problem_; }
  [[nodiscard]] const Problem& problem() const noexcept { return problem_; }
  [[nodiscard]] Threads threads() const noexcept { return threads_; }
  [[nodiscard]] Index num_sites() const noexcept { return num_cells_; }
  [[nodiscard]] static constexpr bool holds(Index /*cell*/) noexcept { return true; }

  /// Writes du/dt at `fields` into `rates`.
  /// @param time of the boundaries and the source [s]
  /// @throws RunError with the cell and its position if a rate of change or a speed is not finite.
  StepBounds operator()(const Storage& fields, Storage& rates, double time) {
    return sweep(fields, time,
                 [&](Index cell, const Vector<N>& rate) { detail::values_of<N>(rates, cell) = rate; });
  }

  /// Writes the next stage of a Runge-Kutta step in the same pass: kept u^n + (1 - kept)(u + dt du/dt), with
  /// u the fields and u^n the `start` of the step.  Eq. (T7)
  /// @param next neither of the others
  StepBounds advance_stage(const Storage& fields, const Storage& start, Storage& next, double kept, double dt,
                           double time) {
    return sweep(fields, time, [&, kept, dt](Index cell, const Vector<N>& rate) {
      const Vector<N> advanced = detail::values_of<N>(fields, cell) + dt * rate;
      detail::values_of<N>(next, cell) = kept * detail::values_of<N>(start, cell) + (1 - kept) * advanced;
    });
  }

 private:
  using Sweep = detail::PatchSweep<Problem>;

  [[nodiscard]] Index num_patches() const noexcept { return static_cast<Index>(patches_.size()); }

  /// Each thread takes the next patch that nobody has.
  template <class Write>
  StepBounds sweep(const Storage& fields, double time, const Write& write) {
    std::atomic<Index> next{0};
    for_each_block(static_cast<Index>(sweeps_.size()), threads_, [&](Index block) {
      detail::PatchReport report;
      for (Index i = next++; i < num_patches(); i = next++) {
        report.add(sweeps_.data()[block](problem_, patches_.data()[i], boundaries_, fields, time, write));
      }
      reports_.data()[block] = report;
    });
    detail::PatchReport total;
    for (const detail::PatchReport& report : reports_) total.add(report);
    if (total.faulty != no_site) {
      detail::throw_not_finite_in_cell<D>(total.faulty, problem_.grid.centre(total.faulty));
    }
    return {total.limit, total.speed};
  }

  [[nodiscard]] int rings(bool has_diffusion) const {
    if constexpr (is_first_order) {
      return has_diffusion ? 1 : 0;
    } else {
      require(problem_.reconstruction.rings == 1 || problem_.reconstruction.rings == 2,
              "CellGradient: rings must be 1 or 2");
      return problem_.reconstruction.rings;
    }
  }

  Problem problem_;
  Threads threads_;
  Index num_cells_ = 0;
  std::vector<detail::Patch<D>> patches_;
  std::vector<AnyBoundary<D, N>> boundaries_;
  std::vector<Sweep> sweeps_;  ///< one for each thread
  std::vector<detail::PatchReport> reports_;
};

}  // namespace scree::transport
