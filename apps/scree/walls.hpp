#pragma once

#include "scree/scene.hpp"

#include <scree/mpm/boundary.hpp>

#include <memory>

namespace scree::app {

/// The wall of a scene at an end of an axis; none if that is open.
template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make_boundary(const WallScene& wall, int axis,
                                                              mpm::Side side);

}  // namespace scree::app
