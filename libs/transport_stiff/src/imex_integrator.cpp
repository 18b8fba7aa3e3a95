#include "arkode_callbacks.hpp"
#include "arkode_handles.hpp"
#include "imex_checks.hpp"

#include <scree/error.hpp>
#include <scree/transport/detail/step_limit.hpp>
#include <scree/transport/time/cfl.hpp>
#include <scree/transport_stiff/imex_integrator.hpp>

#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_pcg.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunmatrix/sunmatrix_band.h>

#include <algorithm>
#include <cmath>

namespace scree::transport {

using detail::check;
using detail::require_made;

class ImexIntegrator::Solver {
 public:
  Solver(Index num_values, ImexProblem problem, const ImexOptions& options)
      : options_{options},
        calls_{std::move(problem), options.absolute_tolerance / options.relative_tolerance},
        context_{sundials::make_context("ImexIntegrator")},
        now_{make_vector(num_values)},
        before_{make_vector(num_values)},
        rate_{make_vector(num_values)} {
    N_VConst(0, now_.get());
    memory_ = require_made(
        detail::ArkodeMemory{ARKStepCreate(explicit_rate(), implicit_rate(), 0, now_.get(), context_.get())},
        "ARKStepCreate");
    check(ARKStepSetErrHandlerFn(memory_.get(), &detail::ArkodeCallbacks::keep_message, &calls_),
          "ARKStepSetErrHandlerFn");
    check(ARKStepSetUserData(memory_.get(), &calls_), "ARKStepSetUserData");
    check(ARKStepSStolerances(memory_.get(), options.relative_tolerance, options.absolute_tolerance),
          "ARKStepSStolerances");
    // Lagrange's interpolation asks for no rates at the end of a step; none is read within steps.
    check(ARKStepSetInterpolantType(memory_.get(), ARK_INTERP_LAGRANGE), "ARKStepSetInterpolantType",
          calls_.said());
    check(ARKStepSetInterpolantDegree(memory_.get(), 1), "ARKStepSetInterpolantDegree", calls_.said());
    set_tables();
    if (calls_.problem().implicit_rate) set_implicit_solver();
    if (options.steps == Steps::adaptive) set_step_bounds();
  }

  ImexReport advance(std::span<double> u, double time, double duration) {
    detail::require_advance(u.size(), detail::values(now_.get()).size(), time, duration);
    ImexReport report;
    if (duration == 0) return report;
    std::ranges::copy(u, detail::values(now_.get()).begin());
    calls_.start();
    check(ARKStepReInit(memory_.get(), explicit_rate(), implicit_rate(), time, now_.get()), "ARKStepReInit",
          calls_.said());
    if (options_.steps == Steps::adaptive) {
      take_adaptive_steps(time, duration);
    } else {
      take_longest_steps(time, duration, report);
    }
    detail::require_finite(detail::values(now_.get()), time + duration);
    std::ranges::copy(detail::values(now_.get()), u.begin());
    complete(report);
    return report;
  }

 private:
  [[nodiscard]] detail::SerialVector make_vector(Index num_values) const {
    return require_made(detail::SerialVector{N_VNew_Serial(num_values, context_.get())}, "N_VNew_Serial");
  }

  [[nodiscard]] ARKRhsFn explicit_rate() const noexcept {
    return calls_.problem().explicit_rate ? &detail::ArkodeCallbacks::explicit_rate : nullptr;
  }
  [[nodiscard]] ARKRhsFn implicit_rate() const noexcept {
    return calls_.problem().implicit_rate ? &detail::ArkodeCallbacks::implicit_rate : nullptr;
  }

  void set_tables() {
    const detail::TablePair tables = detail::make_tables(options_.method);
    check(ARKStepSetTables(memory_.get(), tables.implicit_half->q, tables.implicit_half->p,
                           calls_.problem().implicit_rate ? tables.implicit_half.get() : nullptr,
                           calls_.problem().explicit_rate ? tables.explicit_half.get() : nullptr),
          "ARKStepSetTables", calls_.said());
  }

  void set_implicit_solver() {
    const int side = calls_.problem().precondition ? SUN_PREC_LEFT : SUN_PREC_NONE;
    std::visit([&](const auto& solver) { make_linear_solver(solver, side); }, options_.solver);
    check(ARKStepSetLinearSolver(memory_.get(), linear_solver_.get(), matrix_.get()),
          "ARKStepSetLinearSolver", calls_.said());
    check(ARKStepSetMaxNonlinIters(memory_.get(), largest_newton), "ARKStepSetMaxNonlinIters", calls_.said());
    // The rates of the stages are evaluated, not deduced from the equations they solve: these are solved to
    // a tolerance only, and invariants would be kept no better.
    check(ARKStepSetDeduceImplicitRhs(memory_.get(), SUNFALSE), "ARKStepSetDeduceImplicitRhs");
    if (calls_.problem().precondition) {
      check(ARKStepSetPreconditioner(memory_.get(), &detail::ArkodeCallbacks::prepare,
                                     &detail::ArkodeCallbacks::precondition),
            "ARKStepSetPreconditioner", calls_.said());
    }
    if (!matrix_) {
      check(ARKStepSetJacTimes(memory_.get(), nullptr, &detail::ArkodeCallbacks::jacobian_product),
            "ARKStepSetJacTimes", calls_.said());
    }
  }

  void make_linear_solver(const Gmres& solver, int side) {
    linear_solver_ = require_made(
        detail::LinearSolver{SUNLinSol_SPGMR(now_.get(), side, solver.max_vectors, context_.get())},
        "SUNLinSol_SPGMR");
  }
  void make_linear_solver(const ConjugateGradients& solver, int side) {
    linear_solver_ = require_made(
        detail::LinearSolver{SUNLinSol_PCG(now_.get(), side, solver.max_iterations, context_.get())},
        "SUNLinSol_PCG");
  }
  void make_linear_solver(const Banded& solver, int /*side*/) {
    const auto num_values = N_VGetLength(now_.get());
    matrix_ = require_made(
        detail::SystemMatrix{SUNBandMatrix(num_values, solver.upper, solver.lower, context_.get())},
        "SUNBandMatrix");
    linear_solver_ = require_made(
        detail::LinearSolver{SUNLinSol_Band(now_.get(), matrix_.get(), context_.get())}, "SUNLinSol_Band");
  }

  void set_step_bounds() {
    const double largest = std::isfinite(options_.largest_step) ? options_.largest_step : 0;  // 0: none
    check(ARKStepSetMaxStep(memory_.get(), largest), "ARKStepSetMaxStep", calls_.said());
    const long max_steps = options_.max_steps.value_or(-1);  // -1: no limit
    check(ARKStepSetMaxNumSteps(memory_.get(), max_steps), "ARKStepSetMaxNumSteps", calls_.said());
    if (!calls_.problem().explicit_rate) return;
    check(ARKStepSetStabilityFn(memory_.get(), &detail::ArkodeCallbacks::bound_step, &calls_),
          "ARKStepSetStabilityFn", calls_.said());
    check(ARKStepSetCFLFraction(memory_.get(), std::min(options_.stable_part, largest_fraction)),
          "ARKStepSetCFLFraction", calls_.said());
  }

  /// Longest step [s] from the state `now_` at `time`.
  [[nodiscard]] double longest_from(double time) {
    const double stable = calls_.stable_step(time, now_.get(), rate_.get());
    return std::min(options_.stable_part * stable, options_.largest_step);
  }

  void take_adaptive_steps(double time, double duration) {
    const double first = std::min(longest_from(time), duration);
    const double end = time + duration;
    // 0: ARKODE's own estimate.
    check(ARKStepSetInitStep(memory_.get(), first < duration ? first : 0), "ARKStepSetInitStep",
          calls_.said());
    const double smallest = 4 * round_off * std::max(std::abs(time), std::abs(end));
    check(ARKStepSetMinStep(memory_.get(), smallest), "ARKStepSetMinStep", calls_.said());
    check(ARKStepSetStopTime(memory_.get(), end), "ARKStepSetStopTime", calls_.said());
    evolve(end, ARK_NORMAL);
  }

  /// Steps as long as they may be. One that turns out to be too long for its own stages is taken again,
  /// shorter.
  void take_longest_steps(double time, double duration, ImexReport& report) {
    const double start = time;
    double remaining = duration;
    double bound = longest_from(time);
    detail::StepLimit limit{options_.max_steps, duration, N_VGetLength(now_.get())};
    while (remaining > 0) {
      const double step = next_step(remaining, 1 / bound, 1);
      detail::require_progress(step, start, duration);
      N_VScale(1, now_.get(), before_.get());
      check(ARKStepSetFixedStep(memory_.get(), step), "ARKStepSetFixedStep", calls_.said());
      static_cast<void>(calls_.take_shortest());
      const double reached = evolve(time + step, ARK_ONE_STEP);
      const double allowed = calls_.take_shortest();
      if (!is_stable(step, 1 / allowed, 1)) {
        ++report.rejected;
        bound = options_.stable_part * allowed;
        step_back(time);
        continue;
      }
      time = reached;
      remaining = step < remaining ? remaining - step : 0;
      if (remaining == 0) break;
      if (!limit.allows_more_after(step)) throw RunError{"ImexIntegrator: " + limit.text(time)};
      bound = longest_from(time);
    }
  }

  void step_back(double time) {
    N_VScale(1, before_.get(), now_.get());
    check(ARKStepReset(memory_.get(), time, now_.get()), "ARKStepReset", calls_.said());
  }

  /// @return the time that was reached [s]
  double evolve(double end, int task) {
    double reached = 0;
    const int flag = ARKStepEvolve(memory_.get(), end, now_.get(), &reached, task);
    calls_.rethrow();
    check(flag, "ARKStepEvolve", calls_.said());
    return reached;
  }

  void complete(ImexReport& report) {
    long attempts = 0;
    long steps = 0;
    check(ARKStepGetNumSteps(memory_.get(), &steps), "ARKStepGetNumSteps");
    check(ARKStepGetNumStepAttempts(memory_.get(), &attempts), "ARKStepGetNumStepAttempts");
    check(ARKStepGetLastStep(memory_.get(), &report.last_step), "ARKStepGetLastStep");
    report.steps = steps - report.rejected;
    report.rejected += attempts - steps;
    report.explicit_evaluations = calls_.explicit_evaluations();
    report.implicit_evaluations = calls_.implicit_evaluations();
    if (!calls_.problem().implicit_rate) return;
    check(ARKStepGetNumNonlinSolvIters(memory_.get(), &report.newton_iterations),
          "ARKStepGetNumNonlinSolvIters");
    check(ARKStepGetNumLinIters(memory_.get(), &report.linear_iterations), "ARKStepGetNumLinIters");
  }

  // Newton iterations in a stage. ARKODE's own 3 suit adaptive steps, which it can shorten.
  static constexpr int largest_newton = 20;
  // [-] Of the stable step; ARKODE takes nothing from 1 on.
  static constexpr double largest_fraction = 1 - 2 * round_off;

  ImexOptions options_;
  detail::ArkodeCallbacks calls_;
  detail::Context context_;
  detail::SerialVector now_;
  detail::SerialVector before_;  // at the start of the step in hand
  detail::SerialVector rate_;
  detail::SystemMatrix matrix_;
  detail::LinearSolver linear_solver_;
  detail::ArkodeMemory memory_;
};

ImexIntegrator::ImexIntegrator(Index num_values, ImexProblem problem, ImexOptions options) {
  detail::require_valid(num_values, problem, options);
  solver_ = std::make_unique<Solver>(num_values, std::move(problem), options);
}
ImexIntegrator::ImexIntegrator(ImexIntegrator&& other) noexcept = default;
ImexIntegrator& ImexIntegrator::operator=(ImexIntegrator&& other) noexcept = default;
ImexIntegrator::~ImexIntegrator() = default;

ImexReport ImexIntegrator::advance(std::span<double> u, double time, double duration) {
  return solver_->advance(u, time, duration);
}

}  // namespace scree::transport
