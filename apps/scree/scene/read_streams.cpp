#include "scree/scene/read_streams.hpp"

#include "scree/scene/axes.hpp"
#include "scree/scene/read_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>

namespace scree::app {

namespace {

using io::at_least;
using io::between;
using io::TomlTable;

[[nodiscard]] double cell_edge(const MeshScene& mesh) {
  return mesh.size[static_cast<std::size_t>(normal_component(mesh.dimensions))] /
         static_cast<double>(mesh.cells);
}

/// The axis of the mesh that a velocity lies along; -1 if there is none, or more than one.
[[nodiscard]] int axis_along(const std::vector<double>& velocity, int dimensions) {
  int axis = -1;
  for (int d = 0; d < dimensions; ++d) {
    if (velocity[static_cast<std::size_t>(d)] == 0) continue;
    if (axis >= 0) return -1;
    axis = d;
  }
  return axis;
}

void check_ends_on_nodes(const TomlTable& table, const InflowScene& inflow, std::size_t axis, double edge) {
  constexpr double slack = 1e-6;  // [-], of a cell
  for (const auto& [key, corner] : {std::pair{"low", &inflow.low}, std::pair{"high", &inflow.high}}) {
    const double cells = (*corner)[axis] / edge;
    table.check(std::abs(cells - std::round(cells)) <= slack, {key},
                fmt::format("along the velocity the box must end on nodes, multiples of {:g} m", edge));
  }
  table.check(inflow.high[axis] - inflow.low[axis] >= (2 - slack) * edge, {"high", "low"},
              fmt::format("along the velocity the box must be at least two cells long, {:g} m", 2 * edge));
}

/// Behind a stream nothing may hold the nodes that its box reaches.
void check_behind(const TomlTable& table, const InflowScene& inflow, std::size_t axis, const Scene& scene) {
  const AxisScene& ends = scene.axes[axis];
  const std::string_view name = axis_names(scene.mesh.dimensions)[axis];
  table.check(!ends.is_periodic, {"velocity"}, fmt::format("must not lie along {}, which is periodic", name));
  if (ends.is_periodic) return;
  const bool is_upward = inflow.velocity[axis] > 0;
  const double room = is_upward ? inflow.low[axis] : scene.mesh.size[axis] - inflow.high[axis];
  const bool is_open = std::holds_alternative<OpenEnd>(is_upward ? ends.low : ends.high);
  table.check(is_open || room >= (2 - 1e-6) * cell_edge(scene.mesh), {is_upward ? "low" : "high"},
              fmt::format("the stream comes through a wall: make [boundaries] {}_{} = \"open\", or leave two "
                          "cells behind the box",
                          name, is_upward ? "low" : "high"));
}

void check_place(const TomlTable& table, const InflowScene& inflow, const Scene& scene) {
  if (!table.is_sound("velocity")) return;
  const int axis = axis_along(inflow.velocity, scene.mesh.dimensions);
  table.check(axis >= 0, {"velocity"}, "must lie along one axis of the mesh");
  const bool has_box = table.is_sound("low") && table.is_sound("high");
  if (axis < 0 || !has_box || static_cast<std::size_t>(axis) >= scene.axes.size()) return;
  table.check(!scene.mesh.is_axisymmetric || axis == 1, {"velocity"},
              "must lie along y: round an axis of symmetry a stream along x would change its depth");
  check_ends_on_nodes(table, inflow, static_cast<std::size_t>(axis), cell_edge(scene.mesh));
  check_behind(table, inflow, static_cast<std::size_t>(axis), scene);
}

[[nodiscard]] std::vector<double> read_fractions(const TomlTable& table, const Scene& scene) {
  constexpr std::string_view key = "fractions";
  if (!table.has(key)) return {};
  table.check(scene.grains.has_value(), {key}, "needs the table [grains]");
  if (!scene.grains) return {};
  auto fractions = table.numbers(key, "shares of the classes of [grains] [-]", between(0, 1),
                                 scene.grains->classes.size());
  constexpr double slack = 1e-9;  // [-], of people's decimals
  const double sum = std::accumulate(fractions.begin(), fractions.end(), 0.0);
  table.check(std::abs(sum - 1) <= slack, {key}, fmt::format("must add up to 1, and add up to {:g}", sum));
  for (double& fraction : fractions) fraction /= sum;
  return fractions;
}

[[nodiscard]] InflowScene read_inflow(const TomlTable& table, const Scene& scene) {
  InflowScene inflow;
  BoxRegion box = read_box(table, scene.mesh, "box that the stream enters by");
  inflow.low = std::move(box.low);
  inflow.high = std::move(box.high);
  inflow.velocity = table.numbers("velocity", "of the stream [m/s]", io::any_value(),
                                  static_cast<std::size_t>(scene.mesh.velocity_components));
  inflow.points_per_cell = table.integer_or(scene.material.points_per_cell, "points_per_cell",
                                            "material points along each axis of a cell", between(1, 16));
  inflow.start = table.number_or(0, "start", "time at which it begins [s]", at_least(0));
  inflow.stop = std::numeric_limits<double>::infinity();
  if (table.has("stop")) inflow.stop = table.number("stop", "time at which it ends [s]", at_least(0));
  table.check(inflow.stop > inflow.start, {"stop", "start"},
              fmt::format("must come after start = {:g}", inflow.start));
  inflow.fractions = read_fractions(table, scene);
  check_place(table, inflow, scene);
  return inflow;
}

/// Whether boxes have a place in common, or come closer than `gap` [m] along every axis.
template <class BoxA, class BoxB>
[[nodiscard]] bool meet(const BoxA& a, const BoxB& b, double gap) {
  constexpr double slack = 1e-9;  // [m]
  const std::size_t dimensions = std::min({a.low.size(), a.high.size(), b.low.size(), b.high.size()});
  for (std::size_t d = 0; d < dimensions; ++d) {
    if (a.high[d] + gap <= b.low[d] + slack || b.high[d] + gap <= a.low[d] + slack) return false;
  }
  return dimensions > 0;
}

/// Two streams enter side by side only if they move as one: their boxes hold nodes up to two cells round
/// them.
void check_apart(const TomlTable& table, const InflowScene& inflow, const InflowScene& other,
                 std::size_t number, const MeshScene& mesh) {
  if (inflow.stop <= other.start || other.stop <= inflow.start) return;
  table.check(!meet(inflow, other, 0), {"low"},
              fmt::format("the box overlaps that of [[inflow]] {}", number));
  const bool move_as_one =
      inflow.velocity == other.velocity && inflow.start == other.start && inflow.stop == other.stop;
  if (move_as_one || meet(inflow, other, 0)) return;
  table.check(
      !meet(inflow, other, 2 * cell_edge(mesh)), {"low"},
      fmt::format("the box is less than two cells, {:g} m, from that of [[inflow]] {}, which moves otherwise",
                  2 * cell_edge(mesh), number));
}

[[nodiscard]] OutflowScene read_outflow(const TomlTable& table, const Scene& scene) {
  const auto dimensions = static_cast<std::size_t>(scene.mesh.dimensions);
  OutflowScene outflow;
  outflow.low = table.numbers("low", "lowest corner of the box [m]", io::any_value(), dimensions);
  outflow.high = table.numbers("high", "highest corner of the box [m]", io::any_value(), dimensions);
  if (!table.is_sound("low") || !table.is_sound("high")) return outflow;
  constexpr double slack = 1e-6;  // [-], of a cell
  const double edge = cell_edge(scene.mesh);
  for (std::size_t d = 0; d < dimensions; ++d) {
    const std::string_view name = axis_names(scene.mesh.dimensions)[d];
    table.check(outflow.high[d] - outflow.low[d] >= (1 - slack) * edge, {"high", "low"},
                fmt::format("must exceed low by at least a cell, {:g} m, along {}", edge, name));
    table.check(outflow.low[d] < scene.mesh.size[d], {"low"},
                fmt::format("lies beyond the mesh, which ends at {:g} m along {}", scene.mesh.size[d], name));
    table.check(outflow.high[d] > 0, {"high"},
                fmt::format("lies before the mesh, which begins at 0 m along {}", name));
  }
  return outflow;
}

}  // namespace

std::vector<InflowScene> read_inflows(const std::vector<TomlTable>& tables, const Scene& scene) {
  std::vector<InflowScene> inflows;
  inflows.reserve(tables.size());
  for (const TomlTable& table : tables) {
    const InflowScene inflow = read_inflow(table, scene);
    for (std::size_t i = 0; i < inflows.size(); ++i)
      check_apart(table, inflow, inflows[i], i + 1, scene.mesh);
    inflows.push_back(inflow);
  }
  return inflows;
}

std::vector<OutflowScene> read_outflows(const std::vector<TomlTable>& tables, const Scene& scene) {
  std::vector<OutflowScene> outflows;
  outflows.reserve(tables.size());
  for (const TomlTable& table : tables) {
    const OutflowScene outflow = read_outflow(table, scene);
    for (std::size_t i = 0; i < scene.inflows.size(); ++i) {
      table.check(!meet(outflow, scene.inflows[i], 0), {"low"},
                  fmt::format("the box meets that of [[inflow]] {}", i + 1));
    }
    outflows.push_back(outflow);
  }
  return outflows;
}

}  // namespace scree::app
