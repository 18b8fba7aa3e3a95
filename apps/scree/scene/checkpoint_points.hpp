#pragma once

#include "scree/scene/scene.hpp"

#include <scree/io/checkpoint.hpp>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace scree::app {

/// @throws InputError if the file is no checkpoint of this version, or is cut off.
[[nodiscard]] io::Checkpoint open_checkpoint(const std::filesystem::path& path);

/// Which of the stored points weigh something: others only fill blocks.
[[nodiscard]] std::vector<std::size_t> heavy_points(const io::Checkpoint& checkpoint);

/// Values of a column, of the points chosen: component after component.
[[nodiscard]] std::vector<double> values_of(const io::Checkpoint& checkpoint, std::string_view column,
                                            int num_components, const std::vector<std::size_t>& points);

/// What a scene takes of the checkpoint of another run, without its points.
/// @throws InputError if the file is no checkpoint, is cut off, or is of a run with other traits_of_points().
[[nodiscard]] StoredScene find_stored_points(const std::filesystem::path& path, const Scene& scene);

/// A box round the points of a checkpoint, along the axes of the mesh.
[[nodiscard]] BoxRegion extent_of(const StoredScene& stored, const MeshScene& mesh);

}  // namespace scree::app
