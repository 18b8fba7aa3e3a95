#pragma once

#include "scree/scene/map_files.hpp"
#include "scree/scene/scene.hpp"

#include <scree/io/toml_reader.hpp>

namespace scree::app {

/// Material at rest, from the table [material]: a box by its corners, or whatever lies in the regions.
/// @param scene of which the mesh has been read
/// @param terrain_place where maps lie unless the regions say otherwise
[[nodiscard]] MaterialScene read_material(const io::TomlTable& table, const Scene& scene,
                                          const MapPlace& terrain_place, SceneFiles& files);

/// Corners of a box inside the mesh.
/// @param of what the box is, for people
[[nodiscard]] BoxRegion read_box(const io::TomlTable& table, const MeshScene& mesh, std::string_view of);

}  // namespace scree::app
