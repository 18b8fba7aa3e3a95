#pragma once

#include <scree/rheology/path/drive.hpp>

#include <Eigen/Core>
#include <array>

namespace scree::rheology::detail {

/// Numbers of those components of a point that a stage controls by their stress.
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

/// What a step of a point asks for.
struct StepRequest {
  const Controls& controls;
  std::array<double, 6> wanted;  ///< stresses at its end, with respect to the axes [Pa]; of those controlled
  double dt;                     ///< [s]
};

/// The motion of a step, and what it leads to.
struct Trial {
  Deformation<double> deformation;
  PathPoint::Answer answer;
  Unknowns residual;      ///< reached less wanted stress of each unknown [Pa]
  bool is_sound = false;  ///< stress and density are finite, and the law's own equations are solved
};

/// What became of a step.
struct StepResult {
  Trial trial;
  Unknowns rates;  ///< found, of the components under stress control [1/s]
  int iterations = 0;
  bool is_met = false;  ///< all stresses are as wanted
};

/// Components under stress control.
[[nodiscard]] std::size_t num_unknowns(const Controls& controls) noexcept;

/// The motion that meets a request, by Newton's method from a first guess.  Eqs. (R28), (R29)
[[nodiscard]] StepResult solve_step(const PathPoint& point, const StepRequest& request, const Unknowns& guess,
                                    const PathOptions& options);

/// A tensor given with respect to axes, in fixed ones; and the other way round.
[[nodiscard]] Tensor<double> from_axes(const Tensor<double>& axes, const Tensor<double>& a) noexcept;
[[nodiscard]] Tensor<double> to_axes(const Tensor<double>& axes, const Tensor<double>& a) noexcept;

}  // namespace scree::rheology::detail
