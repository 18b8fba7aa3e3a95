#pragma once

#include "scree/scene/scene.hpp"

#include <scree/grainsize/segregation.hpp>
#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/step.hpp>

#include <optional>
#include <span>
#include <vector>

namespace scree::app {

/// What the fractions of all points have been at their worst since the run began.
struct FractionExtremes {
  double lowest = 1;     ///< smallest fraction [-]
  double highest = 0;    ///< largest fraction [-]
  double sum_error = 0;  ///< largest |sum - 1| [-]
};

/// Widens `extremes` by the fractions as they are.
template <int D, int V>
void observe_fractions(const mpm::Particles<D, V>& particles, FractionExtremes& extremes);

/// Mass of each size class in all points [kg].
template <int D, int V>
[[nodiscard]] std::vector<double> class_masses(const mpm::Particles<D, V>& particles);

/// What bounds the steps that segregation is cut into. It never bounds the step of momentum.
template <int D>
struct SegregationLimit {
  double dt;           ///< the longest one [s].  Eq. (G18)
  Vector<D> position;  ///< of the control volume that it comes from [m]
};

/// Where material points and grain size meet: fractions to the control volumes, one segregation step there,
/// the change back to the points.
template <int D, int V>
class Coupling {
 public:
  /// @param gravity_direction unit vector along the axes of the mesh, or zero
  /// @param symmetry of the mesh
  Coupling(const SegregationScene& scene, const grainsize::SizeClasses& classes, const CartesianGrid<D>& grid,
           const mpm::AnyShape& shape, const Vector<D>& gravity_direction, Symmetry symmetry,
           Threads threads);

  /// Lets the grains of all points segregate over dt [s]: changes their fractions.  @throws RunError if they
  /// are absurdly fast.
  grainsize::SegregationReport advance(mpm::State<D, V>& state, double dt);

  /// That of the last call as it began; none before the first, or if nothing moves. Looked for when asked.
  [[nodiscard]] std::optional<SegregationLimit<D>> last_limit();

 private:
  [[nodiscard]] std::optional<SegregationLimit<D>> limit();
  void drive_of_points(const mpm::Particles<D, V>& particles);
  void require_few_substeps(double dt);
  void to_sites(const mpm::State<D, V>& state, const mpm::Column& fractions);

  grainsize::SizeClasses classes_;
  grainsize::AnyClosure closure_;
  mpm::CarriedMap map_;
  Threads threads_;
  mpm::CarriedCells<D, V> cells_;
  grainsize::Segregation<D> segregation_;
  mpm::Column point_drive_{{"segregation_drive", "", "closure's own"}, 1};
  bool has_advanced_ = false;          // so that what follows is that of a step that was possible
  std::vector<double> masses_;         // num_sites
  std::vector<double> drive_;          // num_sites
  std::vector<double> means_;          // num_sites x (num_classes + 1)
  std::vector<double> old_fractions_;  // num_sites x num_classes
  std::vector<double> new_fractions_;  // num_sites x num_classes
};

}  // namespace scree::app
