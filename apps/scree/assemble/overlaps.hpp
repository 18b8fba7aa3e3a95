#pragma once

#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>

namespace scree::app {

/// Checks that no body begins in the ground or in another body: the solid parts of two that overlap share no
/// node of the mesh. Pairs without a bounded body are left out: planes, hollow balls and ground go on behind
/// each other, where no material comes.
/// @param ground of the scene; none: there is none
/// @throws InputError naming both, the node that is deepest in both, and how deep.
template <int D>
void require_apart(const Scene& scene, const CartesianGrid<D>& grid, const mpm::AnySurface<D>& ground);

}  // namespace scree::app
