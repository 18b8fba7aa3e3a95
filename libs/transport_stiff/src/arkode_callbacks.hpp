#pragma once

#include <scree/transport_stiff/imex_problem.hpp>

#include <sundials_handles.hpp>

#include <string>
#include <utility>

namespace scree::transport::detail {

/// A problem as ARKODE calls it, and what happened in these calls. Nothing is thrown through C: an exception
/// is kept, the call fails, and `rethrow` throws it on the other side.
class ArkodeCallbacks {
 public:
  /// @param typical size of the values of u where they are zero [unit of u]: scales differences
  ArkodeCallbacks(ImexProblem problem, double typical) : problem_{std::move(problem)}, typical_{typical} {}

  [[nodiscard]] const ImexProblem& problem() const noexcept { return problem_; }
  [[nodiscard]] const std::string& said() const noexcept { return said_; }
  [[nodiscard]] long explicit_evaluations() const noexcept { return explicit_evaluations_; }
  [[nodiscard]] long implicit_evaluations() const noexcept { return implicit_evaluations_; }

  /// Forgets what happened.
  void start() noexcept;
  /// Throws what a call has thrown, if one has.
  void rethrow() { guard_.rethrow(); }

  /// Longest stable step [s] at (time, u); writes E there.
  [[nodiscard]] double stable_step(double time, N_Vector u, N_Vector rate);
  /// The shortest stable step [s] of all evaluations of E since the last call of this.
  [[nodiscard]] double take_shortest() noexcept;

  // The functions that ARKODE calls; `self` is the object.
  static int explicit_rate(double time, N_Vector u, N_Vector rate, void* self) noexcept;
  static int implicit_rate(double time, N_Vector u, N_Vector rate, void* self) noexcept;
  static int jacobian_product(N_Vector v, N_Vector product, double time, N_Vector u, N_Vector rate,
                              void* self, N_Vector work) noexcept;
  static int prepare(double time, N_Vector u, N_Vector rate, int is_jacobian_fine, int* is_jacobian_new,
                     double gamma, void* self) noexcept;
  static int precondition(double time, N_Vector u, N_Vector rate, N_Vector residual, N_Vector z, double gamma,
                          double tolerance, int side, void* self) noexcept;
  static int bound_step(N_Vector u, double time, double* step, void* self) noexcept;
  static void keep_message(int code, const char* module, const char* function, char* text,
                           void* self) noexcept;

 private:
  template <class Body>
  static int guard(void* self, Body&& body) noexcept;
  double evaluate_explicit(double time, N_Vector u, N_Vector rate);
  void evaluate_implicit(double time, N_Vector u, N_Vector rate);
  void difference(double time, N_Vector u, N_Vector rate, N_Vector v, N_Vector product, N_Vector beside);

  ImexProblem problem_;
  double typical_;
  sundials::Guard guard_;
  std::string said_;
  long explicit_evaluations_ = 0;
  long implicit_evaluations_ = 0;
  double shortest_ = 0;
};

}  // namespace scree::transport::detail
