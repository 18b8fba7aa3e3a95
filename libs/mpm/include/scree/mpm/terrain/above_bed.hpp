#pragma once

#include <scree/mpm/particles.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>

namespace scree::mpm {

/// Checks that no point begins in the ground, or where nothing is known of it.
/// @param allowed how deep a point may lie in it [m]
/// @throws InputError naming the point that is deepest below the bed, and how deep, or the first of which the
/// surface knows nothing, for instance where a raster has no data.
template <int D, int V>
void require_above(const Particles<D, V>& particles, const AnySurface<D>& surface, double allowed = 0);

/// Removes the points that lie in the ground, or where nothing is known of it; the others keep their order.
/// @throws InputError if no point is left.
template <int D, int V>
void keep_above(Particles<D, V>& particles, const AnySurface<D>& surface);

}  // namespace scree::mpm
