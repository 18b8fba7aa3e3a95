#pragma once

#include "scree/assemble/filling.hpp"
#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/step.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>

namespace scree::app {

/// The material, and streams that enter from the start.
/// @throws InputError if material begins in the ground, in a body or in a stream.
template <int D, int V>
[[nodiscard]] mpm::Particles<D, V> make_points(const Scene& scene, const Filling<D>& filling,
                                               const CartesianGrid<D>& grid,
                                               const mpm::AnySurface<D>& ground);

/// Puts points at rest under their own weight. Where nothing presses they keep their law's density.
/// @throws InputError if the law does not bear the pressure on the surface.
template <int D, int V>
void settle(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages,
            mpm::Particles<D, V>& particles, Threads threads);

}  // namespace scree::app
