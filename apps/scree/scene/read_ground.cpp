#include "scree/scene/read_ground.hpp"

#include "scree/scene/choices.hpp"
#include "scree/scene/material_columns.hpp"
#include "scree/scene/read_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace scree::app {

namespace {

using io::above;
using io::at_least;
using io::TomlTable;

[[nodiscard]] std::size_t dimensions_of(const Scene& scene) {
  return static_cast<std::size_t>(scene.mesh.dimensions);
}

/// Numbers along each axis that may be left out.
[[nodiscard]] std::vector<double> numbers_or(std::vector<double> fallback, const TomlTable& table,
                                             std::string_view key, std::string_view meaning) {
  if (!table.has(key)) return fallback;
  auto values = table.numbers(key, meaning, io::any_value(), fallback.size());
  return table.is_sound(key) ? values : fallback;
}

[[nodiscard]] bool has_direction(const std::vector<double>& vector) {
  return std::ranges::any_of(vector, [](double component) { return component != 0; });
}

[[nodiscard]] PlaneScene read_plane(const TomlTable& table, std::size_t dimensions) {
  PlaneScene plane;
  plane.point = table.numbers("point", "a point of the plane [m]", io::any_value(), dimensions);
  plane.normal =
      table.numbers("normal", "normal of the plane, into the material [-]", io::any_value(), dimensions);
  table.check(has_direction(plane.normal), {"normal"}, "must have a direction");
  return plane;
}

void check_dimensions(const TomlTable& table, const Scene& scene, int needed) {
  table.check(scene.mesh.dimensions == needed, {"surface"},
              fmt::format("is for meshes of {} dimensions", needed));
}

[[nodiscard]] RasterScene read_raster(const TomlTable& table, const Scene& scene, SceneFiles& files) {
  RasterScene map;
  auto raster = files.read_raster(table, "map of heights in the ESRI ASCII format [m]");
  map.place = read_map_place(table);
  if (!raster || scene.mesh.dimensions != 3) return map;
  map.heights = *std::move(raster);
  const std::string gap = gap_in_map(map, scene.mesh, false);
  table.check(gap.empty(), {"file", "origin"}, gap);
  return map;
}

/// Whether the law of a contact reads a friction.
[[nodiscard]] bool reads_friction(const ContactScene& contact) {
  const auto* any_law = std::get_if<rheology::AnyWallLaw>(&contact.law);
  if (any_law == nullptr) return false;
  return std::visit(
      [](const auto& law) {
        return std::ranges::any_of(law.inputs,
                                   [](const InputColumn& one) { return one.name == friction_column; });
      },
      *any_law);
}

/// A map of friction, on the map of the ground; nothing if there is none, or it is faulty.
[[nodiscard]] std::optional<RasterScene> read_friction_map(const TomlTable& table, const Scene& scene,
                                                           const TerrainScene& terrain, SceneFiles& files) {
  constexpr std::string_view key = "friction_file";
  if (!table.has(key)) return std::nullopt;
  const auto* ground = std::get_if<RasterScene>(&terrain.surface);
  auto raster = files.read_raster(table, "map of friction in the ESRI ASCII format [-]", key);
  if (!raster) return std::nullopt;
  table.check(scene.mesh.dimensions == 3 && ground != nullptr, {key, "surface"},
              "needs ground that is a map, surface = \"raster\"");
  table.check(reads_friction(terrain.contact), {key, "contact"},
              "needs a contact whose law reads a friction, as \"material_friction\" does");
  const auto& of_material = terrain.contact.of_material;
  table.check(std::ranges::find(of_material, friction_column) == of_material.end(), {key, "contact"},
              "needs a contact whose friction is a number: that holds where the map has no value");
  for (const double value : raster->values) {
    table.check(std::isnan(value) || value > 0, {key},
                fmt::format("has a value of {:g}, and must exceed 0", value));
  }
  if (!table.is_sound(key) || ground == nullptr) return std::nullopt;
  RasterScene map{*std::move(raster), ground->place};
  const std::string gap = gap_in_map(map, scene.mesh, true);
  table.check(gap.empty(), {key, "origin"}, gap);
  return map;
}

/// A rigid body's shape, at the start.
[[nodiscard]] auto read_shape(const TomlTable& table, const Scene& scene, SceneFiles& files) {
  decltype(BodyScene::surface) surface;
  const std::string kind = table.choice("surface", "form of the body", names_of(choices::body_surfaces));
  if (!table.is_sound("surface")) return surface;
  if (kind == "plane") surface = read_plane(table, dimensions_of(scene));
  if (kind == "stl") {
    check_dimensions(table, scene, 3);
    if (auto triangles = files.read_triangles(table, "surface of the body in the STL format [m]")) {
      surface = *std::move(triangles);
    }
  }
  if (kind == "ball") {
    BallScene ball;
    ball.centre = table.numbers("centre", "of the ball [m]", io::any_value(), dimensions_of(scene));
    ball.radius = table.number("radius", "of the ball [m]", above(0));
    ball.is_hollow = table.boolean_or(false, "is_hollow", "whether material is inside of the ball");
    surface = ball;
  }
  return surface;
}

/// Where a body turns about if the scene does not say: the centre of a ball, a plane's point, or the origin.
[[nodiscard]] std::vector<double> own_pivot(const BodyScene& body, std::size_t dimensions) {
  std::vector<double> pivot;
  if (const auto* ball = std::get_if<BallScene>(&body.surface)) pivot = ball->centre;
  if (const auto* plane = std::get_if<PlaneScene>(&body.surface)) pivot = plane->point;
  pivot.resize(dimensions, 0.0);
  return pivot;
}

void read_turn(const TomlTable& table, BodyScene& body, std::size_t dimensions) {
  body.angular_velocity =
      table.number_or(0, "angular_velocity", "of the body, about its axis [rad/s]", io::any_value());
  body.pivot = numbers_or(own_pivot(body, dimensions), table, "pivot", "what the body turns about [m]");
  body.axis = {0, 0, 1};
  if (dimensions < 3) return;
  const auto axis = numbers_or({0, 0, 1}, table, "axis", "that the body turns about [-]");
  table.check(has_direction(axis), {"axis"}, "must have a direction");
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (std::size_t d = 0; d < 3 && length > 0; ++d) body.axis[d] = axis[d] / length;
}

/// Where the pivot of a body is in time; an axis that is not told stays.
[[nodiscard]] WayScene read_way(const TomlTable& table, const BodyScene& body) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  constexpr std::string_view meaning = "of the pivot at these times [m]";
  WayScene way;
  if (!table.has("times")) {
    for (std::size_t d = 0; d < body.pivot.size(); ++d)
      table.check(!table.has(axes[d]), {axes[d]}, "needs the times at which the pivot is there");
    return way;
  }
  way.times = table.numbers("times", "at which the pivot is at the places x, y, z [s]", at_least(0));
  const std::size_t count = way.times.size();
  table.check(count >= 2, {"times"}, "must be at least two");
  table.check(std::ranges::adjacent_find(way.times, std::greater_equal{}) == way.times.end(), {"times"},
              "must increase");
  table.check(!table.has("velocity"), {"times", "velocity"}, "stand in place of a velocity: leave one out");
  bool has_place = false;
  for (std::size_t d = 0; d < body.pivot.size(); ++d) {
    way.places.emplace_back(count, body.pivot[d]);
    if (!table.has(axes[d])) continue;
    has_place = true;
    auto places = table.numbers(axes[d], meaning);
    table.check(places.size() == count, {axes[d], "times"},
                fmt::format("must be as many as times, which are {}", count));
    table.check(places.empty() || places[0] == body.pivot[d],
                {axes[d], "pivot", "times", "surface", "centre", "point"},
                fmt::format("must begin at the pivot, {}", body.pivot[d]));
    if (places.size() == count) way.places[d] = std::move(places);
  }
  table.check(has_place, {"times"}, "need the places of the pivot along one axis at least");
  return way;
}

[[nodiscard]] BodyScene read_body(const TomlTable& table, const Scene& scene, SceneFiles& files) {
  const std::size_t dimensions = dimensions_of(scene);
  BodyScene body;
  body.surface = read_shape(table, scene, files);
  body.contact = read_contact(table, scene);
  body.velocity = numbers_or(std::vector<double>(dimensions, 0.0), table, "velocity", "of the body [m/s]");
  read_turn(table, body, dimensions);
  body.way = read_way(table, body);
  body.start = table.number_or(0, "start", "of the motion [s]", at_least(0));
  body.stop = std::numeric_limits<double>::infinity();
  if (table.has("stop")) body.stop = table.number("stop", "end of the motion [s]", at_least(0));
  for (const std::string_view key : {"start", "stop"}) {
    table.check(!table.has(key) || !table.has("times") || body.angular_velocity != 0,
                {key, "times", "angular_velocity"},
                "is of the turn alone beside times: give an angular_velocity, or leave it out");
  }
  body.may_overlap = table.boolean_or(false, "may_overlap", "whether it may begin in ground or in a body");
  table.check(!scene.mesh.is_axisymmetric || body.velocity[0] == 0, {"velocity"},
              "must lie along y: round an axis of symmetry a body does not move away from it");
  table.check(!scene.mesh.is_axisymmetric || !table.has("x"), {"x"},
              "must be left out: round an axis of symmetry a body does not move away from it");
  table.check(!scene.mesh.is_axisymmetric || body.angular_velocity == 0, {"angular_velocity"},
              "must be 0: round an axis of symmetry a body does not turn");
  table.check(body.stop >= body.start, {"stop", "start"},
              fmt::format("must not come before start = {:g}", body.start));
  return body;
}

}  // namespace

TerrainScene read_terrain(const TomlTable& table, const Scene& scene, SceneFiles& files) {
  TerrainScene terrain;
  const std::string kind =
      table.choice("surface", "how the ground is given", names_of(choices::terrain_surfaces));
  if (table.is_sound("surface")) {
    table.check(scene.mesh.dimensions > 1, {"surface"}, "is for meshes of 2 or 3 dimensions");
    if (kind == "plane") terrain.surface = read_plane(table, dimensions_of(scene));
    if (kind == "profile") {
      check_dimensions(table, scene, 2);
      ProfileScene profile{table.numbers("heights", "of the ground, from one end of x to the other [m]")};
      table.check(profile.heights.size() >= 2, {"heights"}, "must be at least two");
      terrain.surface = std::move(profile);
    }
    if (kind == "raster") {
      check_dimensions(table, scene, 3);
      terrain.surface = read_raster(table, scene, files);
    }
    if (kind == "stl") {
      check_dimensions(table, scene, 3);
      TrianglesScene surface;
      if (auto triangles = files.read_triangles(table, "surface of the ground in the STL format [m]")) {
        surface.triangles = *std::move(triangles);
      }
      surface.place = read_map_place(table);
      terrain.surface = std::move(surface);
    }
  }
  terrain.contact = read_contact(table, scene);
  terrain.friction = read_friction_map(table, scene, terrain, files);
  return terrain;
}

std::vector<BodyScene> read_bodies(const std::vector<TomlTable>& tables, const Scene& scene,
                                   SceneFiles& files) {
  std::vector<BodyScene> bodies;
  for (const TomlTable& table : tables) {
    table.check(scene.mesh.dimensions > 1, {"surface"}, "is for meshes of 2 or 3 dimensions");
    bodies.push_back(read_body(table, scene, files));
  }
  return bodies;
}

}  // namespace scree::app
