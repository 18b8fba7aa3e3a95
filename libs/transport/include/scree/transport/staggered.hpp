#pragma once

#include <scree/blocks.hpp>
#include <scree/transport/detail/not_finite.hpp>
#include <scree/transport/detail/staggered_checks.hpp>
#include <scree/transport/detail/staggered_sweep.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace scree::transport {

/// Advances a conservation law by the staggered scheme of Nessyahu & Tadmor, in 2D and 3D that of Jiang &
/// Tadmor: one flux per state instead of a Riemann problem per face, and no numerical viscosity to choose.
///
/// Steps come in pairs, to the corners of the cells and back, so that states are cell averages again.
/// For hyperbolic point laws on a lattice of whole cells; no sources, no diffusion, no laws that differ from
/// face to face. Its viscosity grows as 1/dt: at small steps take Solver.
/// @see Eqs. (T42) to (T46), \cite nessyahu1990 \cite jiang1998
template <class Law, Limiter L, int D>
class StaggeredSolver {
 public:
  static constexpr int N = Law::num_components;
  using Options = SolverOptions<Cartesian<D>, N>;
  static_assert(PointLaw<Law, D>, "the staggered scheme takes laws that are the same everywhere");
  static_assert(!Diffusive<Law> && !HasSource<Law, D>, "the staggered scheme has no diffusion and no source");

  /// @param options cfl in (0, largest_cfl()], of the fastest axis by itself; unless given 9/10 of what is
  /// proven in 1D.  @throws InputError for another one, for a lattice that is not of cells, or a start time
  /// that is not finite.
  StaggeredSolver(const Lattice<D>& lattice, Law law, L limiter,
                  SolverOptions<Cartesian<D>, Law::num_components> options = {})
      : law_{std::move(law)},
        limiter_{limiter},
        boundaries_{options.boundaries},
        cfl_{options.cfl.value_or(usual_part * usual_cfl(limiter))},
        threads_{options.threads},
        time_{options.start_time},
        max_steps_{options.max_steps},
        to_corners_{lattice},
        to_cells_{detail::corners_of(lattice)},
        cells_{lattice.num_sites()},
        corners_{to_cells_.source().num_sites()},
        pieces_{lattice},
        reports_(static_cast<std::size_t>(std::max(threads_.count, 1))) {
    detail::require_staggered(lattice.sites, cfl_, largest_cfl());
    detail::require_start_time(time_);
    detail::require_max_steps(max_steps_);
  }

  /// Up to this the scheme without a limiter is linearly stable, and waves from both sides of a cell do not
  /// meet: 1/2, 0.42, 0.37 in 1D, 2D, 3D.  Eq. (T46)
  [[nodiscard]] static double largest_cfl() noexcept { return detail::largest_staggered_cfl(D); }

  /// The largest CFL number at which a scalar law provably keeps its bounds, and in 1D its total variation; 0
  /// if none is known.  Eq. (T45)
  [[nodiscard]] static double proven_cfl(const L& limiter) noexcept {
    return detail::proven_staggered_cfl(limiter.sharpness(), D);
  }

  [[nodiscard]] Law& law() noexcept { return law_; }
  /// Start time and all that was advanced since [s].
  [[nodiscard]] double time() const noexcept { return time_; }

  /// Advances `u` by `duration` [s].
  /// @param u num_sites x num_components, component fastest.
  /// @throws InputError for a wrong length or duration. @throws RunError if a value is not finite, or steps
  /// get so short that there would be too many; then `u` and the time are as they were.
  Advance advance(std::span<double> u, double duration) {
    detail::require_size(u.size(), cells_.num_sites(), N);
    detail::require_duration(duration);
    cells_.gather(u, threads_);
    Advance result;
    const Cartesian<D> grid{to_corners_.source()};
    detail::StepLimit limit{max_steps_, duration, detail::num_across(grid)};
    double remaining = duration;
    while (remaining > 0) {
      const double length = pair(time_ + (duration - remaining), remaining, result);
      remaining = length < remaining ? remaining - length : 0;
      if (limit.allows_more_after(length, 2) || remaining == 0) continue;
      throw RunError{"Solver: " + limit.text(time_ + (duration - remaining)) + "; waves are fastest at " +
                     detail::place_in(grid, detail::fastest_cell(grid, law_, cells_))};
    }
    cells_.scatter(u, threads_, [](Index /*site*/) { return true; });
    time_ += duration;
    return result;
  }

  /// The longest step that `u` allows [s]; infinite where nothing moves.
  /// @throws as advance.
  [[nodiscard]] double stable_time_step(std::span<const double> u) {
    detail::require_size(u.size(), cells_.num_sites(), N);
    cells_.gather(u, threads_);
    return longest_step(bounds_of(to_corners_, cells_).limit, cfl_);
  }

 private:
  using Sweep = detail::StaggeredSweep<Law, L, D>;
  using Speeds = typename Sweep::Speeds;

  [[nodiscard]] static double usual_cfl(const L& limiter) noexcept {
    return std::min(detail::proven_staggered_cfl(limiter.sharpness(), 1), largest_cfl());
  }

  /// Two steps of at most `remaining` together, in the fewest equal pairs. Should the corners or a wall be so
  /// fast that the scheme would not be stable, they are taken again, shorter. @return their length [s]
  double pair(double time, double remaining, Advance& result) {
    const StepBounds first = bounds_of(to_corners_, cells_);
    result.stable_dt = longest_step(first.limit, cfl_);
    double length = next_step(remaining, first.limit, 2 * cfl_);
    for (;;) {
      const double dt = length / 2;
      StepBounds seen = first;
      include(seen, make_pieces(to_corners_, cells_, dt, time + dt / 2));
      join(to_cells_, corners_);
      include(seen, bounds_of(to_cells_, corners_));
      include(seen, make_pieces(to_cells_, corners_, dt, time + 3 * dt / 2));
      result.largest_speed = std::max(result.largest_speed, seen.speed);
      if (is_stable(dt, seen.limit, largest_cfl())) break;
      length = 2 * usual_part * longest_step(seen.limit, cfl_);
    }
    join(to_corners_, cells_);
    result.substeps += 2;
    return length;
  }

  static void include(StepBounds& bounds, const StepBounds& other) noexcept {
    bounds.limit = std::max(bounds.limit, other.limit);
    bounds.speed = std::max(bounds.speed, other.speed);
  }

  /// Of all faces between sites.  @throws RunError if a state or a speed is not finite.
  [[nodiscard]] StepBounds bounds_of(const Sweep& sweep, const Fields<N>& fields) {
    for_each_slab(sweep.num_rows(), [&](Index begin, Index end, Speeds& report) {
      report = sweep.speeds(law_, fields, begin, end);
    });
    const StepBounds bounds = reported(sweep);
    if (std::isfinite(bounds.limit)) return bounds;
    throw_faulty(sweep, fields);
  }

  /// @return the bounds at the walls; one that is not finite shows in the states that come of it
  StepBounds make_pieces(const Sweep& sweep, const Fields<N>& fields, double dt, double time) {
    const typename Sweep::Step step{law_, limiter_, boundaries_, dt, time};
    for_each_slab(sweep.num_rows(), [&](Index begin, Index end, Speeds& report) {
      report = sweep.make_pieces(step, fields, pieces_, begin, end);
    });
    sweep.close(pieces_);
    return reported(sweep);
  }

  [[nodiscard]] StepBounds reported(const Sweep& sweep) const noexcept {
    Speeds speeds;
    for (const Speeds& report : reports_) speeds.add(report);
    StepBounds bounds{0, 0};
    for (int axis = 0; axis < D; ++axis) {
      const double speed = speeds.axis[static_cast<std::size_t>(axis)].value();
      bounds.limit = larger(bounds.limit, speed / sweep.source().spacing[axis]);
      bounds.speed = larger(bounds.speed, speed);
    }
    return bounds;
  }

  /// New states from the pieces.  @throws RunError if one is not finite.
  void join(const Sweep& target, Fields<N>& fields) {
    const Index row_length = target.source().count[0];
    for_each_slab(target.num_rows(), [&](Index begin, Index end, Speeds& report) {
      report = {};
      for (Index row = begin; row < end; ++row) {
        const Index start = row * row_length;
        detail::join(pieces_, pieces_.entry(target.source().site(start)), row_length, fields.data() + start,
                     fields.stride());
        for (int k = 0; k < N; ++k)
          report.axis[0].add(fields.data() + k * fields.stride() + start, row_length);
      }
    });
    Speeds largest;
    for (const Speeds& report : reports_) largest.add(report);
    if (std::isfinite(largest.axis[0].value())) return;
    throw_faulty(target, fields);
  }

  [[noreturn]] void throw_faulty(const Sweep& sweep, const Fields<N>& fields) const {
    const Indices<D> site = sweep.source().site(sweep.first_faulty(law_, fields));
    detail::throw_not_finite<D>(site, sweep.source().position(site));
  }

  /// Calls body(begin, end, report) for as many runs of rows as there are threads.
  template <class Body>
  void for_each_slab(Index num_rows, Body&& body) {
    const auto num_slabs = static_cast<Index>(reports_.size());
    for_each_block(num_slabs, threads_, [&](Index slab) {
      body(num_rows * slab / num_slabs, num_rows * (slab + 1) / num_slabs,
           reports_[static_cast<std::size_t>(slab)]);
    });
  }

  // [-] Of a CFL number: leaves room for speeds that grow within a step.
  static constexpr double usual_part = 0.9;

  Law law_;
  L limiter_;
  BoxBoundaries<D, N> boundaries_;
  double cfl_;
  Threads threads_;
  double time_;
  std::optional<Index> max_steps_;
  Sweep to_corners_;
  Sweep to_cells_;
  Fields<N> cells_;
  Fields<N> corners_;
  detail::Pieces<D, N> pieces_;
  std::vector<Speeds> reports_;
};

}  // namespace scree::transport
