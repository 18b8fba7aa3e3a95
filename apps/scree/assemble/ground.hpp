#pragma once

#include "scree/assemble/carried_input.hpp"
#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/mpm/boundary.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>
#include <scree/symmetry.hpp>

#include <memory>

namespace scree::app {

/// The ground of a scene, in coordinates of the mesh.  @throws InputError if triangles make no surface.
template <int D>
[[nodiscard]] mpm::AnySurface<D> surface_of(const TerrainScene& terrain, const MeshScene& mesh);
/// The surface of a body at the start.  @throws InputError if triangles make no surface.
template <int D>
[[nodiscard]] mpm::AnySurface<D> surface_of(const BodyScene& body);

/// The ground, as what holds the nodes of a mesh.
/// @param place_of of what it reads of the material
/// @throws InputError if it reaches no node, or differs between the ends of a periodic axis.
template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make_terrain(const TerrainScene& terrain,
                                                             const mpm::AnySurface<D>& surface,
                                                             const CartesianGrid<D>& grid,
                                                             Symmetry symmetry = Symmetry::plane,
                                                             const PlaceOfMean& place_of = {});
template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make_body(const BodyScene& body, Symmetry symmetry,
                                                          const PlaceOfMean& place_of);

}  // namespace scree::app
