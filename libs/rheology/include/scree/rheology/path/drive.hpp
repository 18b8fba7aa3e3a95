#pragma once

#include <scree/rheology/path/path_point.hpp>
#include <scree/rheology/path/stage.hpp>

#include <span>
#include <vector>

namespace scree::rheology {

/// How well the stresses that a path asks for are met.
struct PathOptions {
  double tolerance = 1e-10;  ///< of a stress, relative to the largest component there is [-]
  int max_iterations = 50;   ///< of Newton's, per step
};

/// A point at the end of a step; the first one of a path is its start.
struct PathRecord {
  std::size_t stage = 0;               ///< counted from 0
  PathState at;                        ///< time, density, strain, stress
  Tensor<double> velocity_gradient{};  ///< L of the step [1/s]
  double pressure = 0;                 ///< p [Pa], Eq. (R26)
  double deviatoric_stress = 0;        ///< q [Pa], Eq. (R26)
  double lode_angle = 0;               ///< [rad], Eq. (R26)
  double volumetric_strain = 0;  ///< ln(volume/volume at the start of this call) [-], expansion positive
  double shear_rate = 0;         ///< [1/s]
  double inertial_number = 0;    ///< I [-], Eq. (R12); NaN if the law has none
  double dissipation = 0;        ///< sigma' : D' [W/m^3], Eq. (R6); some of it may be stored
  double stability_number = 0;   ///< C [-], Eq. (R15); NaN if the law has none
  int iterations = 0;            ///< that the step took
  std::vector<double> state;     ///< the law's memory, a number per column
};

/// Leads a point along stages: in each step the rates of deformation that no stage imposes are found by
/// Newton's method with a line search on the law's stress at the end of the step, Eqs. (R27) to (R29). The
/// density goes with the rate of volume. Memory and state of the point change step by step, so
/// that a path may be cut at any stage and gone on with.
/// @returns a record for the start and for the end of each step.
/// @throws InputError if a stage or an option will not do.
/// @throws RunError naming law, stage, time, component, and the stress wanted and reached, if a step has no
/// answer that it can be led to; the point is then as it was before that step.
std::vector<PathRecord> drive(PathPoint& point, std::span<const Stage> stages,
                              const PathOptions& options = {});

/// The same, with the records put at the end of a list as they are made: those of the steps before one that
/// has no answer are then there.
void drive(PathPoint& point, std::span<const Stage> stages, const PathOptions& options,
           std::vector<PathRecord>& records);

}  // namespace scree::rheology
