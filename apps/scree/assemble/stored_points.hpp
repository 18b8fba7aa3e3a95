#pragma once

#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>

namespace scree::app {

/// The points of the checkpoint that the scene names, those that weigh something in their order: what every
/// run's points have; take_stored() adds the rest.
/// @throws InputError naming the file and a point outside the mesh.
template <int D, int V>
[[nodiscard]] mpm::Particles<D, V> stored_points(const StoredScene& stored, const CartesianGrid<D>& grid);

/// Gives points of stored_points() all that they carried, once the parts of the run have added their columns.
/// What follows from the grains of a point is found anew, by the keys of this scene.
/// @throws InputError naming the file and a column that one side lacks.
template <int D, int V>
void take_stored(const Scene& scene, mpm::Particles<D, V>& particles);

}  // namespace scree::app
