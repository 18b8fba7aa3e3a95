#pragma once

#include "scree/scene.hpp"

#include <scree/io/toml_reader.hpp>

#include <vector>

namespace scree::app {

/// The ends of every axis. A wall is the name of one that holds, `y_low = "no_slip"`, or a table of one with
/// friction, `y_low = {law = "coulomb", friction = 0.4}`: the law's parameters, and a key for each column
/// that it reads: a number, the name of a column of the material, or nothing where the scene has such a
/// number. An end may be "open".
/// @param scene of which the mesh, the material, the law and the grains have been read
[[nodiscard]] std::vector<AxisScene> read_axes(const io::TomlTable& boundaries, const Scene& scene);

/// Whether each end has a wall that holds whole components of velocity.
[[nodiscard]] bool has_plain_walls(const std::vector<AxisScene>& axes);

/// How ground or a body holds material: `contact = "sticks"`, `"slides"`, or a table as a wall's.
/// @param scene of which the law and the grains have been read
[[nodiscard]] ContactScene read_contact(const io::TomlTable& table, const Scene& scene);

}  // namespace scree::app
