#pragma once

#include "scree/scene.hpp"

#include <scree/mpm/boundary.hpp>
#include <scree/symmetry.hpp>

#include <memory>

namespace scree::app {

/// The wall of a scene at an end of an axis; none if that is open.
/// @param symmetry of the mesh
template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make_boundary(const WallScene& wall, int axis, mpm::Side side,
                                                              Symmetry symmetry);

}  // namespace scree::app
