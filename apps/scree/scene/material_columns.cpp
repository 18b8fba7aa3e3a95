#include "scree/scene/material_columns.hpp"

#include "scree/scene/law_columns.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace scree::app {

std::vector<MaterialColumn> material_columns(const Scene& scene) {
  std::vector<MaterialColumn> columns;
  if (!scene.grains) return columns;
  columns.push_back({grain_size_column, "m"});
  if (scene.mixture.coarse_size) columns.push_back({coarse_fraction_column, "-"});
  if (scene.mixture.packing) columns.push_back({maximum_packing_column, "-"});
  if (has_local_friction(scene.law)) columns.push_back({friction_column, "-"});
  return columns;
}

bool is_read_by_walls(const Scene& scene, std::string_view column) {
  const auto reads = [&](const std::vector<std::string>& of_material) {
    return std::ranges::find(of_material, column) != of_material.end();
  };
  const auto wall_reads = [&](const WallScene& wall) {
    const auto* friction = std::get_if<FrictionScene>(&wall);
    return friction != nullptr && reads(friction->of_material);
  };
  const auto body_reads = [&](const BodyScene& body) { return reads(body.contact.of_material); };
  const auto end_reads = [&](const AxisScene& ends) { return wall_reads(ends.low) || wall_reads(ends.high); };
  return (scene.terrain && reads(scene.terrain->contact.of_material)) ||
         std::ranges::any_of(scene.bodies, body_reads) || std::ranges::any_of(scene.axes, end_reads);
}

}  // namespace scree::app
