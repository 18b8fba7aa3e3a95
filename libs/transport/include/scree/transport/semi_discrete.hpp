#pragma once

#include <scree/blocks.hpp>
#include <scree/transport/detail/not_finite.hpp>
#include <scree/transport/detail/slab_sweep.hpp>
#include <scree/transport/discretisation.hpp>

#include <algorithm>
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
    const Lattice<D>& lattice = problem_.grid.lattice();
    const Index num_layers = D == 1 ? 1 : lattice.count[D - 1];
    const Index num_slabs = std::clamp<Index>(threads.count, 1, num_layers);
    for (Index slab = 0; slab < num_slabs; ++slab) {
      slabs_.emplace_back(lattice, num_layers * slab / num_slabs, num_layers * (slab + 1) / num_slabs, cfl);
    }
    reports_.resize(slabs_.size());
  }

  [[nodiscard]] Problem& problem() noexcept { return problem_; }
  [[nodiscard]] const Problem& problem() const noexcept { return problem_; }
  [[nodiscard]] Threads threads() const noexcept { return threads_; }
  [[nodiscard]] Index num_sites() const noexcept { return problem_.grid.lattice().num_sites(); }
  /// Whether there is anything at a site.
  [[nodiscard]] bool holds(Index site) const noexcept { return problem_.grid.density(site) > 0; }

  /// Writes du/dt at `fields` into `rates`; at empty sites zero.
  /// @param time of the boundaries and the source [s]
  /// @throws RunError with the site and its position if a rate of change or a speed is not finite.
  StepBounds operator()(const Fields<N>& fields, Fields<N>& rates, double time) {
    for_each_block(static_cast<Index>(slabs_.size()), threads_, [&](Index block) {
      const auto slab = static_cast<std::size_t>(block);
      reports_[slab] = slabs_[slab](problem_, fields, rates, time);
    });
    detail::SweepReport report;
    for (const auto& slab : reports_) report.add(slab);
    if (report.faulty != no_site) detail::throw_not_finite(problem_.grid.lattice(), report.faulty);
    return {report.limit.value(), report.speed.value()};
  }

 private:
  Problem problem_;
  Threads threads_;
  std::vector<detail::SlabSweep<Problem>> slabs_;
  std::vector<detail::SweepReport> reports_;
};

}  // namespace scree::transport
