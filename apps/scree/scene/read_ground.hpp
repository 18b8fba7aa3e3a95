#pragma once

#include "scree/scene/map_files.hpp"
#include "scree/scene/scene.hpp"

#include <scree/io/toml_reader.hpp>

#include <vector>

namespace scree::app {

/// The ground, from the table [terrain].
/// @param scene of which the mesh, the law and the grains have been read
[[nodiscard]] TerrainScene read_terrain(const io::TomlTable& table, const Scene& scene, SceneFiles& files);

/// A rigid body each, from [[bodies]].
/// @param scene of which the mesh, the law and the grains have been read
[[nodiscard]] std::vector<BodyScene> read_bodies(const std::vector<io::TomlTable>& tables, const Scene& scene,
                                                 SceneFiles& files);

}  // namespace scree::app
