#include "newton_krylov.hpp"

#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>
#include <sundials_handles.hpp>
#include <sunlinsol/sunlinsol_pcg.h>

#include <algorithm>
#include <cmath>

namespace scree::rheology::detail {

namespace {

struct FreeKinsol {
  void operator()(void* memory) const noexcept { KINFree(&memory); }
};
using KinsolMemory = std::unique_ptr<void, FreeKinsol>;

}  // namespace

class NewtonKrylov::Solver {
 public:
  Solver(Index num_values, SymmetricProblem problem, NewtonOptions options, const char* who)
      : problem_{std::move(problem)},
        options_{options},
        who_{who},
        context_{sundials::make_context(who)},
        u_{make_vector(num_values)},
        inverse_size_{make_vector(num_values)},
        inverse_residual_{make_vector(num_values)},
        memory_{sundials::require_made(KinsolMemory{KINCreate(context_.get())}, who, "KINCreate")} {
    check(KINSetErrHandlerFn(memory_.get(), &Solver::keep_message, this), "KINSetErrHandlerFn");
    check(KINSetUserData(memory_.get(), this), "KINSetUserData");
    check(KINInit(memory_.get(), &Solver::residual, u_.get()), "KINInit");
    set_linear_solver();
    check(KINSetNumMaxIters(memory_.get(), options.largest_newton), "KINSetNumMaxIters");
    check(KINSetMaxSetupCalls(memory_.get(), 1), "KINSetMaxSetupCalls");
    check(KINSetScaledStepTol(memory_.get(), smallest_step), "KINSetScaledStepTol");
    // From rest KINSOL would deduce too short a bound of the step. Each value may change by a thousand times
    // its typical size.
    const double longest = 1e3 * std::sqrt(static_cast<double>(num_values));
    check(KINSetMaxNewtonStep(memory_.get(), longest), "KINSetMaxNewtonStep");
    if (!options.is_linear) return;
    // Then what is asked of the linear solve is what is asked of the residual; no more than that, because
    // KINSOL asks no linear solve for less than a hundredth of the tolerance.
    check(KINSetEtaForm(memory_.get(), KIN_ETACONSTANT), "KINSetEtaForm");
    check(KINSetEtaConstValue(memory_.get(), round_off), "KINSetEtaConstValue");
  }

  [[nodiscard]] std::span<double> inverse_size() noexcept { return sundials::values(inverse_size_.get()); }
  [[nodiscard]] std::span<double> inverse_residual() noexcept {
    return sundials::values(inverse_residual_.get());
  }

  NewtonReport solve(std::span<double> u, double tolerance) {
    const auto values = sundials::values(u_.get());
    std::ranges::copy(u, values.begin());
    guard_.start();
    said_.clear();
    check(KINSetFuncNormTol(memory_.get(), tolerance), "KINSetFuncNormTol");
    const int flag =
        KINSol(memory_.get(), u_.get(), KIN_LINESEARCH, inverse_size_.get(), inverse_residual_.get());
    guard_.rethrow();
    check(flag, "KINSol");
    if (flag == KIN_STEP_LT_STPTOL) refuse_small_step();
    std::ranges::copy(values, u.begin());
    NewtonReport report;
    check(KINGetNumNonlinSolvIters(memory_.get(), &report.newton_iterations), "KINGetNumNonlinSolvIters");
    check(KINGetNumLinIters(memory_.get(), &report.linear_iterations), "KINGetNumLinIters");
    check(KINGetNumFuncEvals(memory_.get(), &report.residuals), "KINGetNumFuncEvals");
    return report;
  }

 private:
  // Of a step, in typical sizes: below it Newton's method has stalled, as no residual that can be evaluated
  // to the tolerance lets it.
  static constexpr double smallest_step = 4 * round_off;

  [[nodiscard]] sundials::SerialVector make_vector(Index num_values) const {
    return sundials::require_made(sundials::SerialVector{N_VNew_Serial(num_values, context_.get())}, who_,
                                  "N_VNew_Serial");
  }

  void check(int flag, const char* call) const {
    sundials::check(flag, &KINGetReturnFlagName, who_, call, said_);
  }

  void set_linear_solver() {
    linear_solver_ =
        sundials::require_made(sundials::LinearSolver{SUNLinSol_PCG(u_.get(), SUN_PREC_LEFT,
                                                                    options_.largest_linear, context_.get())},
                               who_, "SUNLinSol_PCG");
    check(KINSetLinearSolver(memory_.get(), linear_solver_.get(), nullptr), "KINSetLinearSolver");
    check(KINSetPreconditioner(memory_.get(), &Solver::prepare, &Solver::precondition),
          "KINSetPreconditioner");
    check(KINSetJacTimesVecFn(memory_.get(), &Solver::jacobian_product), "KINSetJacTimesVecFn");
  }

  [[noreturn]] void refuse_small_step() const {
    double norm = 0;
    check(KINGetFuncNorm(memory_.get(), &norm), "KINGetFuncNorm");
    throw RunError{std::string{who_} + ": KINSol stalled: its step vanished at a scaled residual of " +
                   std::to_string(norm)};
  }

  static int residual(N_Vector u, N_Vector result, void* self) noexcept {
    auto& solver = *static_cast<Solver*>(self);
    return solver.guard_.run(
        [&] { solver.problem_.residual(sundials::values(u), sundials::values(result)); });
  }
  static int prepare(N_Vector u, N_Vector /*u_scale*/, N_Vector /*f*/, N_Vector /*f_scale*/,
                     void* self) noexcept {
    auto& solver = *static_cast<Solver*>(self);
    return solver.guard_.run([&] { solver.problem_.linearise(sundials::values(u)); });
  }
  static int precondition(N_Vector /*u*/, N_Vector /*u_scale*/, N_Vector /*f*/, N_Vector /*f_scale*/,
                          N_Vector v, void* self) noexcept {
    auto& solver = *static_cast<Solver*>(self);
    return solver.guard_.run([&] { solver.problem_.precondition(sundials::values(v), sundials::values(v)); });
  }
  /// `prepare` has been called at this u.
  static int jacobian_product(N_Vector v, N_Vector product, N_Vector /*u*/, booleantype* /*is_new*/,
                              void* self) noexcept {
    auto& solver = *static_cast<Solver*>(self);
    return solver.guard_.run(
        [&] { solver.problem_.jacobian_product(sundials::values(v), sundials::values(product)); });
  }
  static void keep_message(int code, const char* /*module*/, const char* /*function*/, char* text,
                           void* self) noexcept {
    if (code == KIN_WARNING) return;
    auto& solver = *static_cast<Solver*>(self);
    static_cast<void>(solver.guard_.run([&] { solver.said_ = text; }));
  }

  SymmetricProblem problem_;
  NewtonOptions options_;
  const char* who_;
  sundials::Guard guard_;
  std::string said_;
  sundials::Context context_;
  sundials::SerialVector u_;
  sundials::SerialVector inverse_size_;
  sundials::SerialVector inverse_residual_;
  sundials::LinearSolver linear_solver_;
  KinsolMemory memory_;
};

NewtonKrylov::NewtonKrylov(Index num_values, SymmetricProblem problem, NewtonOptions options, const char* who)
    : solver_{std::make_unique<Solver>(num_values, std::move(problem), options, who)} {}
NewtonKrylov::~NewtonKrylov() = default;

std::span<double> NewtonKrylov::inverse_size() noexcept {
  return solver_->inverse_size();
}
std::span<double> NewtonKrylov::inverse_residual() noexcept {
  return solver_->inverse_residual();
}
NewtonReport NewtonKrylov::solve(std::span<double> u, double tolerance) {
  return solver_->solve(u, tolerance);
}

}  // namespace scree::rheology::detail
