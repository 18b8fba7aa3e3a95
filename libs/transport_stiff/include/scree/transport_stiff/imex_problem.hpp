#pragma once

#include <scree/tensor.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <variant>

namespace scree::transport {

/// u' = E(t, u) + I(t, u): E is cheap and bounds the step by its stability, I is stiff and is solved for.
/// Either may be left out. What a function throws comes out of `ImexIntegrator::advance`.  Eq. (T50)
struct ImexProblem {
  using Values = std::span<const double>;

  /// Writes E(time, u) [unit of u/s]; returns the longest step that is stable at u [s], > 0; infinity if any
  /// is.
  std::function<double(double time, Values u, std::span<double> rate)> explicit_rate = {};
  /// Writes I(time, u) [unit of u/s].
  std::function<void(double time, Values u, std::span<double> rate)> implicit_rate = {};
  /// Writes J v with J = dI/du at (time, u). Left out, it is a difference of two implicit rates.
  std::function<void(double time, Values u, Values v, std::span<double> product)> jacobian_product = {};
  /// Makes ready for `precondition` at a new u or gamma [s].
  std::function<void(double time, Values u, double gamma)> prepare_preconditioner = {};
  /// Writes z with (1 - gamma J) z = residual, nearly.
  std::function<void(Values residual, std::span<double> z)> precondition = {};
};

/// Matrix-free, for any Jacobian. `max_vectors` of the length of u are kept.
struct Gmres {
  int max_vectors = 20;
};
/// Matrix-free, for Jacobians that are symmetric: three vectors, whatever the number of iterations.
struct ConjugateGradients {
  int max_iterations = 100;
};
/// Direct, for Jacobians with so many diagonals below and above the main one; these are made by differences,
/// from lower + upper + 1 implicit rates.
struct Banded {
  int lower;
  int upper;
};
using ImplicitSolver = std::variant<Gmres, ConjugateGradients, Banded>;

/// A pair of Runge-Kutta tables: what is taken as it is, and what is solved for. All implicit halves are
/// L-stable.
enum class ImexMethod {
  ssp2,  ///< SSP2(2,2,2), order 2: the explicit half is SSPRK2.  Eq. (T51), \cite pareschi2005
  ars2,  ///< ARS(2,2,2), order 2 in the stiff limit too; its explicit half keeps no bounds.  Eq. (T52),
         ///< \cite ascher1997
  ark3,  ///< ARK3(2)4L[2]SA, order 3, as are ark4 and ark5 of order 4 and 5.  Eq. (T53), \cite kennedy2003
  ark4,  ///< ARK4(3)6L[2]SA
  ark5   ///< ARK5(4)8L[2]SA
};

/// How long a step is made.
enum class Steps {
  longest,  ///< as long as explicit_rate and `largest_step` allow; no control of the error
  adaptive  ///< so that the estimated error of each stays within the tolerances; and no longer than that
};

/// What an integrator may be told.
struct ImexOptions {
  ImexMethod method = ImexMethod::ark3;
  Steps steps = Steps::adaptive;     ///< how their length is chosen
  double relative_tolerance = 1e-6;  ///< of steps and of implicit solves [-]
  double absolute_tolerance =
      1e-9;  ///< the same [unit of u]; over the relative one it is a typical size of u
  double largest_step = std::numeric_limits<double>::infinity();  ///< [s]
  /// Steps that one advance may take. Unless given, of adaptive ones any number, of the longest ones a
  /// thousand times as many as the first one asks for and as there are values: more means that steps have
  /// collapsed.
  std::optional<Index> max_steps = {};
  double stable_part = 0.9;  ///< of the stable step that is taken: leaves room for growth within it [-]
  ImplicitSolver solver = Gmres{};  ///< of the linear systems in Newton's method
};

/// What an advance did.
struct ImexReport {
  long steps = 0;     ///< taken
  long rejected = 0;  ///< attempts that were thrown away: too large an error, no convergence, too long
  long explicit_evaluations = 0;  ///< of E
  long implicit_evaluations = 0;  ///< of I, those for differences too
  long newton_iterations = 0;
  long linear_iterations = 0;  ///< of Gmres or ConjugateGradients
  double last_step = 0;        ///< length of the last step [s]
};

}  // namespace scree::transport
