#pragma once

#include "scree/assemble/carried_input.hpp"
#include "scree/scene/scene.hpp"

#include <scree/mpm/boundary.hpp>
#include <scree/symmetry.hpp>

#include <memory>

namespace scree::app {

/// The wall of a scene at an end of an axis; none if that is open.
/// @param symmetry of the mesh
/// @param place_of of what it reads of the material
template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make_boundary(const WallScene& wall, int axis, mpm::Side side,
                                                              Symmetry symmetry, const PlaceOfMean& place_of);

}  // namespace scree::app
