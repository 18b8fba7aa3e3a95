#include "scree/scene/read_material.hpp"

#include "scree/scene/axes.hpp"
#include "scree/scene/checkpoint_points.hpp"
#include "scree/scene/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace scree::app {

namespace {

using io::at_least;
using io::between;
using io::TomlTable;

void check_inside(const TomlTable& table, std::string_view key, double value, const MeshScene& mesh,
                  std::size_t axis) {
  const std::string_view name = axis_names(mesh.dimensions)[axis];
  const double slack = 1e-9 * mesh.size[axis];
  table.check(value >= -slack, {key},
              fmt::format("reaches out of the mesh, which begins at 0 m along {}", name));
  table.check(value <= mesh.size[axis] + slack, {key},
              fmt::format("reaches out of the mesh, which ends at {:g} m along {}", mesh.size[axis], name));
}

[[nodiscard]] PolygonRegion read_polygon(const TomlTable& table, const MeshScene& mesh) {
  PolygonRegion polygon;
  table.check(mesh.dimensions > 1, {"shape"}, "is for meshes of 2 or 3 dimensions");
  polygon.x = table.numbers("x", "of the corners in order [m]");
  polygon.y = table.numbers("y", "of the corners in order [m]");
  table.check(polygon.x.size() >= 3, {"x"}, "must be at least three corners");
  table.check(polygon.x.size() == polygon.y.size(), {"y", "x"},
              fmt::format("must be as many as x, which are {}", polygon.x.size()));
  if (mesh.dimensions > 1) {
    for (const double x : polygon.x) check_inside(table, "x", x, mesh, 0);
    for (const double y : polygon.y) check_inside(table, "y", y, mesh, 1);
  }
  if (mesh.dimensions < 3) return polygon;
  polygon.across = {table.number_or(0, "z_low", "where the prism begins [m]"),
                    table.number_or(mesh.size[2], "z_high", "where the prism ends [m]")};
  table.check(polygon.across[0] < polygon.across[1], {"z_high", "z_low"},
              fmt::format("must exceed z_low = {:g}", polygon.across[0]));
  check_inside(table, "z_low", polygon.across[0], mesh, 2);
  check_inside(table, "z_high", polygon.across[1], mesh, 2);
  return polygon;
}

[[nodiscard]] LayerRegion read_layer(const TomlTable& table, const MeshScene& mesh) {
  const auto normal = static_cast<std::size_t>(normal_component(mesh.dimensions));
  const LayerRegion layer{table.number_or(0, "bottom", "height where the layer begins [m]"),
                          table.number("top", "height of its surface [m]")};
  table.check(layer.bottom < layer.top, {"top", "bottom"},
              fmt::format("must exceed bottom = {:g}", layer.bottom));
  check_inside(table, "bottom", layer.bottom, mesh, normal);
  check_inside(table, "top", layer.top, mesh, normal);
  return layer;
}

[[nodiscard]] ReleaseRegion read_release(const TomlTable& table, const Scene& scene,
                                         const MapPlace& terrain_place, SceneFiles& files) {
  ReleaseRegion release;
  table.check(scene.mesh.dimensions == 3, {"shape"}, "is for meshes of 3 dimensions");
  table.check(scene.terrain.has_value(), {"shape"}, "needs the table [terrain], on which it lies");
  auto raster = files.read_raster(table, "map of depths in the ESRI ASCII format [m]");
  release.place = terrain_place;
  if (table.has("origin")) {
    const auto origin =
        table.numbers("origin", "place on the map of the mesh's origin [m]", io::any_value(), 2);
    if (origin.size() == 2) release.place.origin = {origin[0], origin[1]};
  }
  if (!raster || scene.mesh.dimensions != 3 || !scene.terrain) return release;
  const std::string gap = gap_in_map({*raster, release.place}, scene.mesh, true);
  table.check(gap.empty(), {"file", "origin"}, gap);
  release.depths = *std::move(raster);
  return release;
}

/// Corners of a box round a region.
[[nodiscard]] BoxRegion box_round(const RegionScene& region, const MeshScene& mesh) {
  BoxRegion box{std::vector<double>(mesh.size.size(), 0.0), mesh.size};
  const auto normal = static_cast<std::size_t>(normal_component(mesh.dimensions));
  if (const auto* own = std::get_if<BoxRegion>(&region)) box = *own;
  if (const auto* layer = std::get_if<LayerRegion>(&region)) {
    box.low[normal] = layer->bottom;
    box.high[normal] = layer->top;
  }
  if (const auto* polygon = std::get_if<PolygonRegion>(&region); polygon != nullptr && mesh.dimensions > 1) {
    const auto [left, right] = std::ranges::minmax(polygon->x);
    const auto [bottom, top] = std::ranges::minmax(polygon->y);
    box.low[0] = left;
    box.high[0] = right;
    box.low[1] = bottom;
    box.high[1] = top;
  }
  return box;
}

void read_regions(const TomlTable& table, const Scene& scene, const MapPlace& terrain_place,
                  SceneFiles& files, MaterialScene& material) {
  for (const TomlTable& region : table.tables("regions")) {
    const std::string shape = region.choice("shape", "of the region", names_of(choices::region_shapes));
    if (!region.is_sound("shape")) continue;
    if (shape == "box") material.regions.emplace_back(read_box(region, scene.mesh, "material"));
    if (shape == "polygon") material.regions.emplace_back(read_polygon(region, scene.mesh));
    if (shape == "layer") material.regions.emplace_back(read_layer(region, scene.mesh));
    if (shape == "release") {
      material.regions.emplace_back(read_release(region, scene, terrain_place, files));
    }
  }
  const bool is_empty = table.is_sound("regions") && table.tables("regions").empty();
  table.check(!is_empty, {"regions"}, "must hold at least one region");
}

void bound(const MeshScene& mesh, MaterialScene& material) {
  for (const RegionScene& region : material.regions) {
    const BoxRegion box = box_round(region, mesh);
    if (box.low.size() != mesh.size.size() || box.high.size() != mesh.size.size()) continue;
    if (material.low.empty()) {
      material.low = box.low;
      material.high = box.high;
    }
    for (std::size_t d = 0; d < mesh.size.size(); ++d) {
      material.low[d] = std::min(material.low[d], box.low[d]);
      material.high[d] = std::max(material.high[d], box.high[d]);
    }
  }
}

/// Points of another run, and a box round them.
[[nodiscard]] MaterialScene read_stored(const TomlTable& table, const Scene& scene, SceneFiles& files) {
  MaterialScene material;
  material.stored = files.find_points(table, scene);
  if (material.stored) {
    BoxRegion box = extent_of(*material.stored, scene.mesh);
    material.low = std::move(box.low);
    material.high = std::move(box.high);
  } else {
    material.low.assign(scene.mesh.size.size(), 0.0);
    material.high = scene.mesh.size;
  }
  const std::filesystem::path name = table.string("checkpoint", "checkpoint of another run");
  table.check(name.lexically_normal() != "checkpoint.h5", {"checkpoint"},
              "is the name that this run gives its own, which it writes over the copy: rename the file, or "
              "put it into a folder");
  return material;
}

}  // namespace

BoxRegion read_box(const TomlTable& table, const MeshScene& mesh, std::string_view of) {
  BoxRegion box;
  const auto dimensions = static_cast<std::size_t>(mesh.dimensions);
  box.low = table.numbers("low", fmt::format("lowest corner of the {} [m]", of), io::any_value(), dimensions);
  box.high =
      table.numbers("high", fmt::format("highest corner of the {} [m]", of), io::any_value(), dimensions);
  if (!table.is_sound("low") || !table.is_sound("high")) return box;
  for (std::size_t d = 0; d < dimensions; ++d) {
    table.check(
        box.low[d] < box.high[d], {"high", "low"},
        fmt::format("must exceed low, which is {:g} m along {}", box.low[d], axis_names(mesh.dimensions)[d]));
    check_inside(table, "low", box.low[d], mesh, d);
    check_inside(table, "high", box.high[d], mesh, d);
  }
  return box;
}

MaterialScene read_material(const TomlTable& table, const Scene& scene, const MapPlace& terrain_place,
                            SceneFiles& files) {
  if (table.has("checkpoint")) return read_stored(table, scene, files);
  MaterialScene material;
  if (table.has("regions")) {
    read_regions(table, scene, terrain_place, files, material);
    bound(scene.mesh, material);
  } else {
    BoxRegion box = read_box(table, scene.mesh, "material");
    material.low = std::move(box.low);
    material.high = std::move(box.high);
  }
  material.points_per_cell =
      table.integer_or(3, "points_per_cell", "material points along each axis of a cell", between(1, 16));
  if (table.choice_or("regular", "layout", "how points lie in a cell", names_of(choices::layouts)) ==
      "random") {
    material.random_seed = static_cast<std::uint64_t>(
        table.integer_or(0, "seed", "what the drawing of places begins with", at_least(0)));
  }
  material.surface_pressure = table.number_or(
      0, "surface_pressure", "pressure on the top of the material at the start [Pa]", at_least(0));
  return material;
}

}  // namespace scree::app
