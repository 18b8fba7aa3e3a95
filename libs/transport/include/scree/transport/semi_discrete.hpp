#pragma once

#include <scree/blocks.hpp>
#include <scree/transport/detail/not_finite.hpp>
#include <scree/transport/detail/slab_sweep.hpp>
#include <scree/transport/discretisation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::transport {

/// du/dt of a conservation law on a lattice.  Eqs. (T2), (T10)
///
/// The loops over sites are headers: compiled with -O3 -fno-trapping-math (and -fno-math-errno for laws that
/// take roots) they run on whole vectors. Owns its work space, so that a call allocates nothing. Slabs of
/// layers along the last axis run on threads (1D: one), with the same bits for any number of them.
template <LatticeGrid Grid, class Law, class Reconstruct, class Flux>
class SemiDiscrete<Grid, Law, Reconstruct, Flux> {
 public:
  using Problem = Discretisation<Grid, Law, Reconstruct, Flux>;
  static constexpr int D = Problem::dimension;
  static constexpr int N = Problem::num_components;
  using Storage = Fields<N>;
  static_assert(Reconstruction<Reconstruct, N>);

  /// @param cfl the CFL number that steps will keep to; at walls the bounds depend on it.  Eq. (T9)
  SemiDiscrete(Problem problem, double cfl, Threads threads)
      : problem_{std::move(problem)}, threads_{threads} {
    const Index num_layers = D == 1 ? 1 : problem_.grid.count()[D - 1];
    const Index num_slabs = std::clamp<Index>(threads.count, 1, num_layers);
    for (Index slab = 0; slab < num_slabs; ++slab) {
      slabs_.emplace_back(problem_.grid, num_layers * slab / num_slabs, num_layers * (slab + 1) / num_slabs,
                          cfl);
    }
    reports_.resize(slabs_.size());
  }

  [[nodiscard]] Problem& problem() noexcept { return problem_; }
  [[nodiscard]] const Problem& problem() const noexcept { return problem_; }
  [[nodiscard]] Threads threads() const noexcept { return threads_; }
  [[nodiscard]] Index num_sites() const noexcept {
    Index product = 1;
    for (const Index n : problem_.grid.count()) product *= n;
    return product;
  }
  /// Whether there is anything at a site.
  [[nodiscard]] bool holds(Index site) const noexcept { return problem_.grid.density(site) > 0; }

  /// Writes du/dt at `fields` into `rates`; at empty sites zero.
  /// @param time of the boundaries and the source [s]
  /// @throws RunError with the site and its position if a rate of change or a speed is not finite.
  StepBounds operator()(const Fields<N>& fields, Fields<N>& rates, double time) {
    return sweep(fields, time, detail::WriteRate{rates.data(), rates.stride()});
  }

  /// Writes the next stage of a Runge-Kutta step in the same pass: kept u^n + (1 - kept)(u + dt du/dt), with
  /// u the fields and u^n the `start` of the step.  Eq. (T7)
  /// @param next neither of the others
  StepBounds advance_stage(const Fields<N>& fields, const Fields<N>& start, Fields<N>& next, double kept,
                           double dt, double time) {
    return sweep(fields, time,
                 detail::WriteStage{start.data(), fields.data(), next.data(), next.stride(), kept, dt});
  }

  /// The first site that a CFL number per second of `limit` [1/s] or more comes from; no_site if there is
  /// none.
  [[nodiscard]] Index first_not_below(double limit, const Fields<N>& fields, double time) {
    Index found = no_site;
    for (std::size_t slab = 0; slab < slabs_.size() && found == no_site; ++slab) {
      found = slabs_[slab].first_not_below(limit, problem_, fields, time);
    }
    return found;
  }

 private:
  template <class Write>
  StepBounds sweep(const Fields<N>& fields, double time, const Write& write) {
    for_each_block(static_cast<Index>(slabs_.size()), threads_, [&](Index block) {
      const auto slab = static_cast<std::size_t>(block);
      reports_[slab] = slabs_[slab](problem_, fields, time, write);
    });
    detail::SweepReport report;
    for (const auto& slab : reports_) report.add(slab);
    if (!std::isfinite(report.limit)) throw_first_fault(fields, time);
    return {report.limit, report.speed};
  }

  [[noreturn]] void throw_first_fault(const Fields<N>& fields, double time) {
    const detail::Numbering<D> numbering{problem_.grid.count(), problem_.grid.is_periodic()};
    const Indices<D> site =
        numbering.site(first_not_below(std::numeric_limits<double>::infinity(), fields, time));
    detail::throw_not_finite<D>(site, problem_.grid.position(site));
  }

  Problem problem_;
  Threads threads_;
  std::vector<detail::SlabSweep<Problem>> slabs_;
  std::vector<detail::SweepReport> reports_;
};

}  // namespace scree::transport
