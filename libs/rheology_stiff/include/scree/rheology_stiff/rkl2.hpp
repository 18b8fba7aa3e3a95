#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace scree::rheology {

/// Stages with which a step is stable: the least odd s >= 3 with step <= explicit_step (s^2 + s - 2)/4.
/// Eq. (R142). Odd ones, because even ones hardly damp the shortest waves (Eq. (R143)).
/// @param step [s]  @param explicit_step longest stable one of explicit Euler [s], positive
/// @throws InputError if either is out of range, or more than `largest_rkl2` stages would be needed.
[[nodiscard]] int rkl2_stages(double step, double explicit_step);

/// Beyond it round-off of the recursion is no longer small beside the stages.
inline constexpr int largest_rkl2 = 1001;

/// Runge-Kutta-Legendre method of order 2: many cheap stages, whose longest stable step grows with the square
/// of their number. For diffusion alone: rates must be real and negative.
/// @see Eqs. (R141) to (R143), from Meyer, Balsara & Aslam (2014), \cite meyer2014
class Rkl2 {
 public:
  /// Writes du/dt at u.
  using Rate = std::function<void(std::span<const double> u, std::span<double> rate)>;

  /// @param num_values length of u
  explicit Rkl2(std::size_t num_values);

  /// Advances u by `step` in as many stages as it is told, each with one evaluation of the rate.
  /// Allocates nothing.
  /// @param stages at least 2  @throws InputError if u or `stages` does not fit
  void advance(std::span<double> u, double step, int stages, const Rate& rate);

 private:
  std::vector<double> start_;
  std::vector<double> first_rate_;
  std::vector<double> rate_;
  std::vector<double> before_last_;
  std::vector<double> last_;
};

}  // namespace scree::rheology
