#pragma once

#include <scree/error.hpp>
#include <scree/transport/detail/admissible_states.hpp>
#include <scree/transport/detail/fastest_cell.hpp>
#include <scree/transport/detail/place.hpp>
#include <scree/transport/detail/solver_checks.hpp>
#include <scree/transport/detail/step_limit.hpp>
#include <scree/transport/fluxes/kurganov_tadmor.hpp>
#include <scree/transport/grids/cartesian.hpp>
#include <scree/transport/semi_discrete.hpp>
#include <scree/transport/semi_discrete_faces.hpp>
#include <scree/transport/solver_options.hpp>
#include <scree/transport/time/cfl.hpp>
#include <scree/transport/time/ssp_rk2.hpp>
#include <scree/transport/time/stages.hpp>
#include <scree/transport/usual_scheme.hpp>
#include <scree/transport/warning.hpp>

#include <algorithm>
#include <concepts>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree::transport {

/// Advances a conservation law in time, in as many steps as its CFL number asks for.
///
/// Owns its work arrays: advancing allocates nothing. The grid and the law may be changed between advances
/// (new masses, a new driver) through grid() and law(). The same bits for any number of threads.
template <class Grid, class Law, class Reconstruct, class Flux = KurganovTadmor>
class Solver {
 public:
  static constexpr int D = Grid::dimension;
  static constexpr int N = PointLawOf<Law>::num_components;
  using Options = SolverOptions<Grid, N>;

  /// @throws InputError if the CFL number is not in (0, promised_cfl], the start time is not finite, or no
  /// step is allowed.
  Solver(Grid grid, Law law, Reconstruct reconstruction, Stages stages = SspRk2{},
         SolverOptions<Grid, PointLawOf<Law>::num_components> options = {}, Flux flux = {})
      : promised_cfl_{promised_cfl(reconstruction)},
        cfl_{options.cfl.value_or(usual_part * promised_cfl_)},
        stages_{stages},
        semi_discrete_{{std::move(grid), std::move(law), reconstruction, std::move(flux), options.boundaries},
                       promised_cfl_,
                       options.threads},
        now_{num_sites()},
        stage_{num_sites()},
        rates_{num_sites()},
        time_{options.start_time},
        max_steps_{options.max_steps} {
    detail::require_cfl(cfl_, promised_cfl_);
    detail::require_start_time(time_);
    detail::require_max_steps(max_steps_);
  }

  /// With the usual integrator.  @throws as the other.
  Solver(Grid grid, Law law, Reconstruct reconstruction,
         SolverOptions<Grid, PointLawOf<Law>::num_components> options, Flux flux = {})
      : Solver{std::move(grid), std::move(law),     reconstruction,
               SspRk2{},        std::move(options), std::move(flux)} {}

  /// With the usual reconstruction and, if its type is not written out, the usual flux for the law.
  /// @throws as the other.
  Solver(Grid grid, Law law,
         Options options = {}) requires std::same_as<Reconstruct, UsualReconstructionOn<Grid, Law>>
      : Solver{std::move(grid), law, usual_reconstruction_on<Grid>(law), SspRk2{}, std::move(options)} {}

  /// The largest CFL number at which bounds are kept: of a scalar law that is the same everywhere what the
  /// reconstruction promises, else at most 1/2.  Eq. (T9)
  [[nodiscard]] static double promised_cfl(const Reconstruct& reconstruction) noexcept {
    constexpr bool is_simple = N == 1 && !Diffusive<PointLawOf<Law>> && !FaceDependent<Law>;
    const double promised = promised_cfl_on<Grid>(reconstruction);
    return is_simple ? promised : std::min(0.5, promised);
  }

  [[nodiscard]] Grid& grid() noexcept { return semi_discrete_.problem().grid; }
  [[nodiscard]] Law& law() noexcept { return semi_discrete_.problem().law; }
  /// What the parts of the scheme cannot prove: to show to people. Mostly there is nothing.
  [[nodiscard]] static std::vector<std::string_view> warnings() {
    std::vector<std::string_view> result;
    const auto add = [&]<class Part>(std::type_identity<Part> /*part*/) {
      if constexpr (HasWarning<Part>) result.push_back(Part::warning);
    };
    add(std::type_identity<PointLawOf<Law>>{});
    add(std::type_identity<Reconstruct>{});
    add(std::type_identity<Flux>{});
    return result;
  }
  /// Start time and all that was advanced since [s].
  [[nodiscard]] double time() const noexcept { return time_; }

  /// Advances `u` by `duration` [s].
  /// @param u num_sites x num_components, component fastest; not written at empty sites.
  /// @throws InputError for a wrong length or duration, or a state that the law does not admit.
  /// @throws RunError if a value is not finite, a state no longer admissible, or steps get so short that
  /// there would be too many; then `u` and the time are as they were.
  Advance advance(std::span<double> u, double duration) {
    detail::require_size(u.size(), num_sites(), N);
    detail::require_duration(duration);
    now_.gather(u, semi_discrete_.threads());
    detail::require_admissible<InputError>(semi_discrete_, now_);
    Advance result;
    detail::StepLimit limit{max_steps_, duration, detail::num_across(grid())};
    double remaining = duration;
    while (remaining > 0) {
      const double dt = step(time_ + (duration - remaining), remaining, result);
      remaining = dt < remaining ? remaining - dt : 0;
      if (limit.allows_more_after(dt) || remaining == 0) continue;
      throw RunError{"Solver: " + limit.text(time_ + (duration - remaining)) + "; waves are fastest at " +
                     detail::place_in(grid(), detail::fastest_cell(grid(), law(), now_))};
    }
    detail::require_admissible<RunError>(semi_discrete_, now_);
    now_.scatter(u, semi_discrete_.threads(), [&](Index site) { return semi_discrete_.holds(site); });
    time_ += duration;
    return result;
  }

  /// The longest step that `u` allows [s]; infinite where nothing moves.
  /// @throws as advance.
  [[nodiscard]] double stable_time_step(std::span<const double> u) {
    detail::require_size(u.size(), num_sites(), N);
    now_.gather(u, semi_discrete_.threads());
    detail::require_admissible<InputError>(semi_discrete_, now_);
    return longest_step(rates_of(now_, time_).limit, cfl_);
  }

  /// The site of a lattice that stable_time_step() comes from, the first of several; no_site where nothing
  /// moves. Looked for when asked: steps only keep how large the limit is.  @throws as advance.
  [[nodiscard]] Index limiting_site(std::span<const double> u) requires LatticeGrid<Grid> {
    detail::require_size(u.size(), num_sites(), N);
    now_.gather(u, semi_discrete_.threads());
    detail::require_admissible<InputError>(semi_discrete_, now_);
    const double limit = rates_of(now_, time_).limit;
    return limit > 0 ? semi_discrete_.first_not_below(limit, now_, time_) : no_site;
  }

 private:
  using Rates = SemiDiscrete<Grid, Law, Reconstruct, Flux>;
  using Storage = typename Rates::Storage;

  [[nodiscard]] Index num_sites() const noexcept { return semi_discrete_.num_sites(); }

  /// Runs a sweep over some states. Where a rate is not finite, a state that cannot be is the better reason.
  template <class Sweep>
  StepBounds explained(const Storage& states, Sweep&& sweep) {
    try {
      return sweep();
    } catch (const RunError&) {
      detail::require_admissible<RunError>(semi_discrete_, states);
      throw;
    }
  }

  StepBounds rates_of(const Storage& states, double time) {
    return explained(states, [&] { return semi_discrete_(states, rates_, time); });
  }

  /// One step of at most `remaining`. Should a later stage be so fast that the step breaks the promised CFL
  /// number there, the step is taken again, shorter. @return its length [s]
  double step(double time, double remaining, Advance& result) {
    StepBounds bounds = rates_of(now_, time);
    result.stable_dt = longest_step(bounds.limit, cfl_);
    double dt = next_step(remaining, bounds.limit, cfl_);
    for (;;) {
      const double limit = run_stages(time, dt, bounds, result);
      if (is_stable(dt, limit, promised_cfl_)) break;
      dt = usual_part * longest_step(limit, cfl_);
      bounds = rates_of(now_, time);
    }
    ++result.substeps;
    return dt;
  }

  /// The stages of a step, whose first rates are there, up to one that breaks the promised CFL number; the
  /// last one writes now_. @return the largest limit of all stages [1/s]
  double run_stages(double time, double dt, const StepBounds& first, Advance& result) {
    const std::size_t num_stages = stages_.kept.size();
    double limit = first.limit;
    double part = 0;  // of dt, at the stage in hand
    result.largest_speed = std::max(result.largest_speed, first.speed);
    combine(stages_.kept[0], dt, now_, num_stages == 1 ? now_ : stage_);
    for (std::size_t stage = 1; stage < num_stages; ++stage) {
      part = (1 - stages_.kept[stage - 1]) * (part + 1);
      Storage& next = stage + 1 == num_stages ? now_ : stage_;
      const StepBounds bounds = advance_stage(stages_.kept[stage], dt, time + part * dt, next);
      limit = std::max(limit, bounds.limit);
      result.largest_speed = std::max(result.largest_speed, bounds.speed);
      if (!is_stable(dt, limit, promised_cfl_)) break;
    }
    return limit;
  }

  /// A stage after the first: next = kept u^n + (1 - kept)(stage + dt du/dt), unless it shows that dt is too
  /// long. In one pass where the grid can: each stage reads and writes all states once less.
  StepBounds advance_stage(double kept, double dt, double time, Storage& next) {
    if constexpr (requires { semi_discrete_.advance_stage(stage_, now_, rates_, kept, dt, time); }) {
      const StepBounds bounds = explained(
          stage_, [&] { return semi_discrete_.advance_stage(stage_, now_, rates_, kept, dt, time); });
      if (is_stable(dt, bounds.limit, promised_cfl_)) std::swap(next, rates_);
      return bounds;
    } else {
      const StepBounds bounds = rates_of(stage_, time);
      if (is_stable(dt, bounds.limit, promised_cfl_)) combine(kept, dt, stage_, next);
      return bounds;
    }
  }

  /// next = kept u^n + (1 - kept)(stage + dt rates).  Eq. (T7)
  void combine(double kept, double dt, const Storage& stage, Storage& next) {
    const auto n = static_cast<Index>(now_.all().size());
    constexpr Index chunk = 8192;
    for_each_block((n + chunk - 1) / chunk, semi_discrete_.threads(), [&](Index block) {
      const Index end = std::min(n, (block + 1) * chunk);
      for (Index i = block * chunk; i < end; ++i) {
        const double advanced = stage.data()[i] + dt * rates_.data()[i];
        next.data()[i] = kept * now_.data()[i] + (1 - kept) * advanced;
      }
    });
  }

  // [-] Of the promised CFL number: leaves room for speeds that grow within a step.
  static constexpr double usual_part = 0.9;

  double promised_cfl_;
  double cfl_;
  Stages stages_;
  Rates semi_discrete_;
  Storage now_;
  Storage stage_;
  Storage rates_;
  double time_;
  std::optional<Index> max_steps_;
};
template <class Grid, class Law>
Solver(Grid, Law) -> Solver<Grid, Law, UsualReconstructionOn<Grid, Law>, UsualFlux<Law, Grid::dimension>>;
template <class Grid, class Law>
Solver(Grid, Law, SolverOptions<Grid, PointLawOf<Law>::num_components>)
    -> Solver<Grid, Law, UsualReconstructionOn<Grid, Law>, UsualFlux<Law, Grid::dimension>>;

}  // namespace scree::transport
