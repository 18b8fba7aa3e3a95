#include <scree/error.hpp>
#include <scree/rheology_stiff/stiff_integrator.hpp>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials_handles.hpp>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace scree::rheology {

namespace {

constexpr const char* integrator_name = "StiffIntegrator";

struct FreeCvode {
  void operator()(void* memory) const noexcept { CVodeFree(&memory); }
};
using CvodeMemory = std::unique_ptr<void, FreeCvode>;

template <class... Part>
[[noreturn]] void refuse_integration(const Part&... part) {
  std::ostringstream text;
  text << integrator_name << ": ";
  (text << ... << part);
  throw InputError{text.str()};
}

void require_positive(const char* name, double value) {
  if (value > 0 && std::isfinite(value)) return;
  refuse_integration(name, " = ", value, ": must be positive and finite");
}

void require_valid(std::size_t num_values, const RateForm& form, const StiffIntegratorOptions& options) {
  if (num_values == 0) refuse_integration("0 values: must be 1 or more");
  if (!form.rate) refuse_integration("the law '", form.law, "' has no rate");
  require_positive("relative_tolerance", options.relative_tolerance);
  require_positive("absolute_tolerance", options.absolute_tolerance);
  if (options.largest_count < 1)
    refuse_integration("largest_count = ", options.largest_count, ": must be 1 or more");
}

}  // namespace

class StiffIntegrator::Solver {
 public:
  Solver(std::size_t num_values, RateForm form, const StiffIntegratorOptions& options)
      : form_{std::move(form)},
        context_{sundials::make_context(integrator_name)},
        now_{sundials::require_made(
            sundials::SerialVector{N_VNew_Serial(static_cast<sunindextype>(num_values), context_.get())},
            integrator_name, "N_VNew_Serial")},
        memory_{sundials::require_made(CvodeMemory{CVodeCreate(CV_BDF, context_.get())}, integrator_name,
                                       "CVodeCreate")} {
    N_VConst(0, now_.get());
    check(CVodeSetErrHandlerFn(memory_.get(), &Solver::keep_message, this), "CVodeSetErrHandlerFn");
    check(CVodeSetUserData(memory_.get(), this), "CVodeSetUserData");
    check(CVodeInit(memory_.get(), &Solver::rate, 0, now_.get()), "CVodeInit");
    check(CVodeSStolerances(memory_.get(), options.relative_tolerance, options.absolute_tolerance),
          "CVodeSStolerances");
    check(CVodeSetMaxNumSteps(memory_.get(), options.largest_count), "CVodeSetMaxNumSteps");
    set_linear_solver(static_cast<sunindextype>(num_values));
  }

  StiffIntegratorReport advance(std::span<double> u, double time, double duration) {
    const auto values = sundials::values(now_.get());
    if (u.size() != values.size())
      refuse_integration(u.size(), " values where ", values.size(), " are integrated");
    if (!std::isfinite(time)) refuse_integration("the time is ", time, " s: must be finite");
    if (!(duration >= 0 && std::isfinite(duration))) {
      refuse_integration("the duration is ", duration, " s: must be zero or positive, and finite");
    }
    if (time + duration == time) return {};
    std::ranges::copy(u, values.begin());
    guard_.start();
    said_.clear();
    reached_ = time;
    check(CVodeReInit(memory_.get(), time, now_.get()), "CVodeReInit");
    check(CVodeSetStopTime(memory_.get(), time + duration), "CVodeSetStopTime");
    const int flag = CVode(memory_.get(), time + duration, now_.get(), &reached_, CV_NORMAL);
    guard_.rethrow();
    check(flag, "CVode");
    std::ranges::copy(values, u.begin());
    return report();
  }

 private:
  void set_linear_solver(sunindextype num_values) {
    matrix_ =
        sundials::require_made(sundials::SystemMatrix{SUNDenseMatrix(num_values, num_values, context_.get())},
                               integrator_name, "SUNDenseMatrix");
    linear_solver_ = sundials::require_made(
        sundials::LinearSolver{SUNLinSol_Dense(now_.get(), matrix_.get(), context_.get())}, integrator_name,
        "SUNLinSol_Dense");
    check(CVodeSetLinearSolver(memory_.get(), linear_solver_.get(), matrix_.get()), "CVodeSetLinearSolver");
    if (form_.jacobian) check(CVodeSetJacFn(memory_.get(), &Solver::jacobian), "CVodeSetJacFn");
  }

  [[nodiscard]] StiffIntegratorReport report() const {
    StiffIntegratorReport result;
    long for_differences = 0;
    check(CVodeGetNumSteps(memory_.get(), &result.steps), "CVodeGetNumSteps");
    check(CVodeGetNumRhsEvals(memory_.get(), &result.rate_evaluations), "CVodeGetNumRhsEvals");
    check(CVodeGetNumLinRhsEvals(memory_.get(), &for_differences), "CVodeGetNumLinRhsEvals");
    check(CVodeGetNumNonlinSolvIters(memory_.get(), &result.newton_iterations), "CVodeGetNumNonlinSolvIters");
    result.rate_evaluations += for_differences;
    return result;
  }

  /// @throws RunError naming the law and the time, if `flag` is negative.
  void check(int flag, const char* call) const {
    if (flag >= 0) return;
    std::ostringstream name;
    name << integrator_name << ": the law '" << form_.law << "' at time " << reached_ << " s";
    sundials::check(flag, &CVodeGetReturnFlagName, name.str().c_str(), call, said_);
  }

  static int rate(double time, N_Vector u, N_Vector result, void* self) noexcept {
    auto& solver = *static_cast<Solver*>(self);
    return solver.guard_.run([&] { solver.form_.rate(time, sundials::values(u), sundials::values(result)); });
  }
  static int jacobian(double time, N_Vector u, N_Vector /*rate*/, SUNMatrix result, void* self,
                      N_Vector /*work*/, N_Vector /*work*/, N_Vector /*work*/) noexcept {
    auto& solver = *static_cast<Solver*>(self);
    const auto size = static_cast<std::size_t>(SUNDenseMatrix_LData(result));
    return solver.guard_.run([&] {
      solver.form_.jacobian(time, sundials::values(u), {SUNDenseMatrix_Data(result), size});
    });
  }
  static void keep_message(int code, const char* /*module*/, const char* /*function*/, char* text,
                           void* self) noexcept {
    if (code == CV_WARNING) return;
    auto& solver = *static_cast<Solver*>(self);
    static_cast<void>(solver.guard_.run([&] { solver.said_ = text; }));
  }

  RateForm form_;
  sundials::Guard guard_;
  std::string said_;
  double reached_ = 0;
  sundials::Context context_;
  sundials::SerialVector now_;
  sundials::SystemMatrix matrix_;
  sundials::LinearSolver linear_solver_;
  CvodeMemory memory_;
};

StiffIntegrator::StiffIntegrator(std::size_t num_values, RateForm form,
                                 const StiffIntegratorOptions& options) {
  require_valid(num_values, form, options);
  solver_ = std::make_unique<Solver>(num_values, std::move(form), options);
}
StiffIntegrator::StiffIntegrator(StiffIntegrator&& other) noexcept = default;
StiffIntegrator& StiffIntegrator::operator=(StiffIntegrator&& other) noexcept = default;
StiffIntegrator::~StiffIntegrator() = default;

StiffIntegratorReport StiffIntegrator::advance(std::span<double> u, double time, double duration) {
  return solver_->advance(u, time, duration);
}

}  // namespace scree::rheology
