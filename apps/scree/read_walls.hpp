#pragma once

#include "scree/scene.hpp"

#include <scree/io/toml_reader.hpp>

#include <vector>

namespace scree::app {

/// The ends of every axis. A wall is the name of one that holds, `y_low = "no_slip"`, or a table of one with
/// friction, `y_low = {law = "coulomb", friction = 0.4}`: the law's parameters, and a key for each column
/// that it reads, which may be left out where the scene has such a number.
/// @param scene of which the mesh, the material, the law and the grains have been read
[[nodiscard]] std::vector<AxisScene> read_axes(const io::TomlTable& boundaries, const Scene& scene);

/// Whether any wall has friction.
[[nodiscard]] bool has_friction(const std::vector<AxisScene>& axes);

}  // namespace scree::app
