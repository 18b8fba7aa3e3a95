#pragma once

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>

#include <string>

namespace scree::app {

/// What to add to the message of a run that stops since a point left the mesh: past which cell, when, how
/// fast, and what to change in the scene. Empty if no point is outside.
/// @param time when it was found [s]
template <int D, int V>
[[nodiscard]] std::string leaving_text(const mpm::Particles<D, V>& particles, const CartesianGrid<D>& grid,
                                       double time);

}  // namespace scree::app
