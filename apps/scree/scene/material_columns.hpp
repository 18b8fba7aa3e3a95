#pragma once

#include "scree/scene/scene.hpp"

#include <string_view>
#include <vector>

namespace scree::app {

/// Names of the columns that a run with grains adds to its points. The last three are there only for who
/// reads them.
inline constexpr std::string_view fraction_column = "fraction";
inline constexpr std::string_view grain_size_column = "grain_size";
inline constexpr std::string_view coarse_fraction_column = "coarse_fraction";
inline constexpr std::string_view maximum_packing_column = "maximum_packing";
inline constexpr std::string_view friction_column = "friction";

/// A column of one number that material points carry.
struct MaterialColumn {
  std::string_view name;
  std::string_view unit;
};

/// The columns of a scene's material that a wall may read: what follows from the fractions of each point, as
/// far as the law asks for it, and the friction at which its mix yields.
/// @param scene of which the law and the grains have been read
[[nodiscard]] std::vector<MaterialColumn> material_columns(const Scene& scene);

/// Whether any wall, ground or body of a scene reads this column of the material.
[[nodiscard]] bool is_read_by_walls(const Scene& scene, std::string_view column);

}  // namespace scree::app
