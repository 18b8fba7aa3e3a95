#pragma once

#include "scree/scene/scene.hpp"

#include <scree/io/toml_reader.hpp>

#include <algorithm>
#include <variant>
#include <vector>

namespace scree::app {

/// The ends of every axis. A wall is the name of one that holds, `y_low = "no_slip"`, or a table of one with
/// friction, `y_low = {law = "coulomb", friction = 0.4}`: the law's parameters, and a key for each column
/// that it reads: a number, the name of a column of the material, or nothing where the scene has such a
/// number. An end may be "open".
/// @param scene of which the mesh, the material, the law and the grains have been read
[[nodiscard]] std::vector<AxisScene> read_axes(const io::TomlTable& boundaries, const Scene& scene);

/// Whether any end is of this kind.
template <class Wall>
[[nodiscard]] bool has_wall(const std::vector<AxisScene>& axes) {
  return std::ranges::any_of(axes, [](const AxisScene& axis) {
    return std::holds_alternative<Wall>(axis.low) || std::holds_alternative<Wall>(axis.high);
  });
}

/// How ground or a body holds material: `contact = "sticks"`, `"slides"`, or a table as a wall's.
/// @param scene of which the law and the grains have been read
[[nodiscard]] ContactScene read_contact(const io::TomlTable& table, const Scene& scene);

}  // namespace scree::app
