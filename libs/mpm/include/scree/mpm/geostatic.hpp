#pragma once

#include <scree/blocks.hpp>
#include <scree/mpm/stress_update.hpp>

#include <functional>

namespace scree::mpm {

/// Sets density and mass of all points so that pressure balances gravity under a free surface:
/// dp/dz = rho(p) g from the pressure on the surface down. Each point keeps its volume. Densities have the
/// same bits for any number of threads.  Eq. (M24), (M201)
/// @param axis the one that gravity presses along
/// @param surface height of the free surface along it [m]; points above it keep their density
/// @param gravity acceleration against the axis [m/s^2], not negative
/// @param surface_pressure on the surface [Pa], not negative
/// @throws RunError naming the law and the depth of the first point for which it has no density.
template <int D, int V>
void set_geostatic(Particles<D, V>& particles, const StressUpdate<D, V>& stress, int axis, double surface,
                   double gravity, double surface_pressure = 0, Threads threads = {});

/// The same under a surface that is not level.
/// @param surface_above its height straight above a point [m]
template <int D, int V>
void set_geostatic(Particles<D, V>& particles, const StressUpdate<D, V>& stress, int axis,
                   const std::function<double(const Vector<D>&)>& surface_above, double gravity,
                   double surface_pressure = 0, Threads threads = {});

}  // namespace scree::mpm
