#pragma once

#include <scree/tensor.hpp>

#include <functional>
#include <memory>
#include <span>

namespace scree::rheology::detail {

/// F(u) = 0 with a symmetric, positive Jacobian.
struct SymmetricProblem {
  using Values = std::span<const double>;
  std::function<void(Values u, std::span<double> residual)> residual;
  /// Makes ready for the two below, at a new u.
  std::function<void(Values u)> linearise;
  std::function<void(Values v, std::span<double> product)> jacobian_product;
  /// z with J z = r, nearly; symmetric and positive too.
  std::function<void(Values r, std::span<double> z)> precondition;
};

struct NewtonOptions {
  bool is_linear = false;    ///< then the first linear solve is the last
  int largest_newton = 100;  ///< iterations
  int largest_linear = 500;  ///< iterations of each linear solve
};

struct NewtonReport {
  long newton_iterations = 0;
  long linear_iterations = 0;
  long residuals = 0;
};

/// KINSOL's Newton method with line search over conjugate gradients.
class NewtonKrylov {
 public:
  /// @param who is named in errors
  NewtonKrylov(Index num_values, SymmetricProblem problem, NewtonOptions options, const char* who);
  NewtonKrylov(const NewtonKrylov&) = delete;
  NewtonKrylov& operator=(const NewtonKrylov&) = delete;
  ~NewtonKrylov();

  /// Of the size of u; 1/(typical u) and 1/(typical residual), to be set before `solve`.
  [[nodiscard]] std::span<double> inverse_size() noexcept;
  [[nodiscard]] std::span<double> inverse_residual() noexcept;

  /// @param u where it starts and where it ends @param tolerance of the largest scaled residual [-]
  /// @throws RunError with KINSOL's own word and explanation if it does not converge.
  NewtonReport solve(std::span<double> u, double tolerance);

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace scree::rheology::detail
