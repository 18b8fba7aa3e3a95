#include "imex_checks.hpp"

#include <scree/error.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace scree::transport::detail {
namespace {

template <class Exception, class... Part>
[[noreturn]] void fail(const Part&... part) {
  std::ostringstream text;
  text << "ImexIntegrator: ";
  (text << ... << part);
  throw Exception{text.str()};
}

void require_positive(const char* name, double value, const char* unit) {
  if (value > 0 && std::isfinite(value)) return;
  fail<InputError>(name, " = ", value, unit, ": must be positive and finite");
}

void require_fits(const Gmres& solver, Index /*num_values*/) {
  if (solver.max_vectors < 1)
    fail<InputError>("Gmres keeps ", solver.max_vectors, " vectors: must be 1 or more");
}

void require_fits(const ConjugateGradients& solver, Index /*num_values*/) {
  if (solver.max_iterations >= 1) return;
  fail<InputError>("ConjugateGradients may take ", solver.max_iterations, " iterations: must be 1 or more");
}

void require_fits(const Banded& solver, Index num_values) {
  const bool is_inside =
      0 <= solver.lower && solver.lower < num_values && 0 <= solver.upper && solver.upper < num_values;
  if (is_inside) return;
  fail<InputError>("Banded has ", solver.lower, " diagonals below and ", solver.upper,
                   " above: must lie in [0, ", num_values - 1, "]");
}

}  // namespace

void require_valid(Index num_values, const ImexProblem& problem, const ImexOptions& options) {
  if (num_values < 1) fail<InputError>(num_values, " values: must be 1 or more");
  if (!problem.explicit_rate && !problem.implicit_rate) {
    fail<InputError>("neither an explicit nor an implicit rate is given");
  }
  require_positive("relative_tolerance", options.relative_tolerance, "");
  require_positive("absolute_tolerance", options.absolute_tolerance, "");
  if (!(options.largest_step > 0)) {
    fail<InputError>("largest_step = ", options.largest_step, " s: must be positive");
  }
  if (options.max_steps && *options.max_steps < 1) {
    fail<InputError>("max_steps = ", *options.max_steps, ": must be 1 or more");
  }
  if (!(options.stable_part > 0 && options.stable_part <= 1)) {
    fail<InputError>("stable_part = ", options.stable_part, ": must lie in (0, 1]");
  }
  std::visit([&](const auto& solver) { require_fits(solver, num_values); }, options.solver);
  if (!problem.precondition != !problem.prepare_preconditioner) {
    fail<InputError>("a preconditioner needs both precondition and prepare_preconditioner");
  }
  if (problem.precondition && std::holds_alternative<Banded>(options.solver)) {
    fail<InputError>("Banded is a direct solver: it takes no preconditioner");
  }
}

void require_advance(std::size_t num_values, std::size_t expected, double time, double duration) {
  if (num_values != expected) fail<InputError>(num_values, " values where ", expected, " are integrated");
  if (!std::isfinite(time)) fail<InputError>("the time is ", time, " s: must be finite");
  if (duration >= 0 && std::isfinite(duration)) return;
  fail<InputError>("the duration is ", duration, " s: must be zero or positive, and finite");
}

void require_progress(double step, double time, double duration) {
  if (step > 4 * round_off * std::max(std::abs(time), std::abs(time + duration))) return;
  fail<RunError>("the step fell to ", step, " s at time ", time, " s");
}

void require_finite(std::span<const double> u, double time) {
  const auto faulty = std::find_if(u.begin(), u.end(), [](double value) { return !std::isfinite(value); });
  if (faulty == u.end()) return;
  fail<RunError>("value ", faulty - u.begin(), " is ", *faulty, " at time ", time, " s");
}

}  // namespace scree::transport::detail
