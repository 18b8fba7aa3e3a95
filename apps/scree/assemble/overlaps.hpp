#pragma once

#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>

#include <string>

namespace scree::app {

/// Checks that no body begins in the ground or in another body: the solid parts of two that overlap share no
/// node of the mesh. Pairs without a bounded body are left out: planes, hollow balls and ground go on behind
/// each other, where no material comes.
/// @param ground of the scene; none: there is none
/// @throws InputError naming both, the node that is deepest in both, and how deep.
template <int D>
void require_apart(const Scene& scene, const CartesianGrid<D>& grid, const mpm::AnySurface<D>& ground);

/// What to say of ground that lies so close above the low end of the axis of gravity that the wall there
/// acts on what lies on the ground, too; else nothing. A wall that lets slip bears load where shape functions
/// of points reach past it, another may hold or rub where they reach it. Looks at the nodes of that end.
/// @param ground of the scene; none: there is none
template <int D>
[[nodiscard]] std::string wall_under_ground_warning(const Scene& scene, const CartesianGrid<D>& grid,
                                                    const mpm::AnySurface<D>& ground);

}  // namespace scree::app
