#pragma once

#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/mpm/particles.hpp>

#include <filesystem>

namespace scree::app {

/// What a scene takes of the checkpoint of another run, without its points.
/// @throws InputError if the file is no checkpoint, is cut off, or is of a run with other traits_of_points().
[[nodiscard]] StoredScene find_stored_points(const std::filesystem::path& path, const Scene& scene);

/// A box round the points of a checkpoint, along the axes of the mesh.
[[nodiscard]] BoxRegion extent_of(const StoredScene& stored, const MeshScene& mesh);

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
