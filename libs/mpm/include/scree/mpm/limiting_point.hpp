#pragma once

#include <scree/mpm/stress_update.hpp>
#include <scree/mpm/time_step.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace scree::mpm {

/// How often a point would cross the cells of a mesh: sum over axes of |v_d| / h_d [1/s].  Eq. (M18)
template <int D, int V>
[[nodiscard]] double advection_rate(const Particles<D, V>& particles, const CartesianGrid<D>& grid,
                                    Index p) noexcept {
  double rate = 0;
  for (int axis = 0; axis < D; ++axis) {
    rate += std::abs(particles.velocity.component(axis)[p]) / grid.spacing()[axis];
  }
  return rate;
}

/// The point that a limit of the step comes from, as points are now; none if it comes from no point. Of the
/// acoustic limit it is the one where sound and motion together are fastest: (M17) has the largest of each.
/// The first point whose rate is no number comes before all. Looked for when asked, over all points: steps
/// only keep how large the largest rate is.
/// @see stable_time_step
template <int D, int V>
[[nodiscard]] std::optional<Index> limiting_point(const Particles<D, V>& particles,
                                                  const StressUpdate<D, V>& stress,
                                                  const CartesianGrid<D>& grid, Limit limit);

/// "material point 12 at (0.5, 1) m", for people: its identity and where it is.
template <int D, int V>
[[nodiscard]] std::string point_name(const Particles<D, V>& particles, Index p);

}  // namespace scree::mpm
