#pragma once

#include <scree/tensor.hpp>
#include <scree/transport_stiff/imex_problem.hpp>

#include <memory>
#include <span>

namespace scree::transport {

/// Additive Runge-Kutta method: each stage takes E as it is and solves for I, by Newton's method.
///
/// A linear invariant of both E and I (a mass) is kept to round-off however loosely the implicit stages are
/// solved: the step is a sum of rates, not a solution of the stage equations.  Eqs. (T50) - (T54)
class ImexIntegrator {
 public:
  /// @throws InputError if an option is out of range or parts do not fit; RunError if memory runs out.
  ImexIntegrator(Index num_values, ImexProblem problem, ImexOptions options = {});
  ImexIntegrator(const ImexIntegrator&) = delete;
  ImexIntegrator& operator=(const ImexIntegrator&) = delete;
  ImexIntegrator(ImexIntegrator&& other) noexcept;
  ImexIntegrator& operator=(ImexIntegrator&& other) noexcept;
  ~ImexIntegrator();

  /// Advances `u` from `time` to time + duration [s]. What it does depends on its arguments only, not on
  /// earlier calls. After the first call, nothing is allocated in it.
  /// @throws InputError for a wrong length, time or duration. @throws RunError with the solver's own word and
  /// explanation if a step fails, or if u becomes infinite or NaN. Then `u` is as it was.
  ImexReport advance(std::span<double> u, double time, double duration);

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace scree::transport
