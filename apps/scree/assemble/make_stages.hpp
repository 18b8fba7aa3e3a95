#pragma once

#include "scree/assemble/carried_input.hpp"
#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/step.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>
#include <scree/symmetry.hpp>

#include <memory>
#include <vector>

namespace scree::app {

template <int D>
[[nodiscard]] CartesianGrid<D> make_grid(const Scene& scene);

/// What the mesh of a scene is a cut through.
[[nodiscard]] inline Symmetry symmetry_of(const Scene& scene) noexcept {
  return scene.mesh.is_axisymmetric ? Symmetry::axial : Symmetry::plane;
}

/// The ground of a scene; none if it has none.
template <int D>
[[nodiscard]] mpm::AnySurface<D> ground_of(const Scene& scene);

/// The parts of a step but for what holds the material, and the columns of points that they read.
/// @throws InputError if points lack what the law of the scene reads.
template <int D, int V>
[[nodiscard]] mpm::Stages<D, V> make_stages(const Scene& scene, const CartesianGrid<D>& grid,
                                            mpm::Particles<D, V>& particles);

/// What holds material: ground and bodies first, so that the walls of the mesh have the last word but for the
/// boxes that streams enter by.
/// @param reach of the shape function [spacings]
/// @param place_of of what they read of the material
/// @throws InputError if ground, bodies and streams do not keep apart.
template <int D, int V>
[[nodiscard]] std::vector<std::unique_ptr<mpm::Boundary<D>>> make_boundaries(const Scene& scene,
                                                                             const CartesianGrid<D>& grid,
                                                                             const mpm::AnySurface<D>& ground,
                                                                             double reach,
                                                                             const PlaceOfMean& place_of);

}  // namespace scree::app
