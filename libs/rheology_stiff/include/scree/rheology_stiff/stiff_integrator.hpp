#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace scree::rheology {

/// How the memory of a law changes at one point: u' = rate(t, u), as stiff as it likes.
struct RateForm {
  using Values = std::span<const double>;

  std::string law;  ///< named in errors
  /// Writes du/dt [unit of u/s]. What it throws comes out of `advance`.
  std::function<void(double time, Values u, std::span<double> rate)> rate;
  /// Writes d rate/du, column by column; left out, it is made of differences.
  std::function<void(double time, Values u, std::span<double> jacobian)> jacobian = {};
};

/// What an integrator may be told.
struct StiffIntegratorOptions {
  double relative_tolerance = 1e-6;  ///< [-]
  double absolute_tolerance = 1e-9;  ///< [unit of u]
  long largest_count = 100000;       ///< steps of one `advance`
};

/// What an advance took.
struct StiffIntegratorReport {
  long steps = 0;
  long rate_evaluations = 0;  ///< those for differences too
  long newton_iterations = 0;
};

/// Implicit integration of a law at one point, for laws without a return in closed form, and as the oracle of
/// those that have one: backward differentiation of variable order and step, by CVODE. One per thread.
/// Eq. (R145)
class StiffIntegrator {
 public:
  /// @throws InputError if an option is out of range or nothing is to be integrated.
  StiffIntegrator(std::size_t num_values, RateForm form, const StiffIntegratorOptions& options = {});
  StiffIntegrator(const StiffIntegrator&) = delete;
  StiffIntegrator& operator=(const StiffIntegrator&) = delete;
  StiffIntegrator(StiffIntegrator&& other) noexcept;
  StiffIntegrator& operator=(StiffIntegrator&& other) noexcept;
  ~StiffIntegrator();

  /// Advances u from `time` to time + duration [s]. What it does depends on its arguments only, not on
  /// earlier calls.
  /// @throws InputError for a wrong length, or times that are not finite or run backwards.
  /// @throws RunError naming the law, the time that was reached and CVODE's own word, if a step fails. Then u
  /// is as it was.
  StiffIntegratorReport advance(std::span<double> u, double time, double duration);

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace scree::rheology
