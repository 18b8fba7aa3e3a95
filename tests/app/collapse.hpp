#pragma once

#include "scenes.hpp"
#include "scree/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace scree::app::testing {

/// Where a part of what has collapsed lies.
struct FallenPoint {
  double place;  // [m], along the floor, from the plane or axis of symmetry
  double mass;   // [kg/m] or [kg/rad]
};

/// What is to collapse: material from x = 0 on, of 1500 kg/m^3.
struct CollapseScene {
  std::string name;
  double width;  // [m]
  double aspect;
  int cells;          // along the width
  Index num_columns;  // of cells, of the mesh
};

/// The points of a scene at rest after its collapse, by their place. Its moduli are 100 and 30 times its
/// weight, and it is given four times as long as its height takes to fall.
/// @param settings others of the scene, as overrides
[[nodiscard]] inline std::vector<FallenPoint> collapsed(const CollapseScene& collapse,
                                                        std::vector<std::string> settings = {}) {
  const double height = collapse.aspect * collapse.width;
  const double spacing = collapse.width / collapse.cells;
  const auto num_rows = std::lround(collapse.aspect * collapse.cells) + 2;
  const double weight = 1500 * 9.81 * height;  // [Pa]
  settings.insert(
      settings.end(),
      {fmt::format("mesh.size=[{}, {}]", static_cast<double>(collapse.num_columns) * spacing,
                   static_cast<double>(num_rows) * spacing),
       fmt::format("mesh.cells={}", num_rows), fmt::format("material.high=[{}, {}]", collapse.width, height),
       fmt::format("rheology.bulk_modulus={}", 100 * weight),
       fmt::format("rheology.shear_modulus={}", 30 * weight),
       fmt::format("time.end={}", 4 * std::sqrt(2 * height / 9.81))});
  Simulation<2, 2> simulation{scene_of(collapse.name, settings), {1}};
  advance_to_end(simulation);
  const auto& particles = simulation.state.particles;
  std::vector<FallenPoint> points;
  points.reserve(static_cast<std::size_t>(particles.size()));
  for (Index p = 0; p < particles.size(); ++p) {
    const double mass = particles.mass.component(0)[p];
    if (mass > 0) points.push_back({particles.position.component(0)[p], mass});
  }
  std::ranges::sort(points, {}, &FallenPoint::place);
  return points;
}

/// The place that 99.5 % of the mass lie behind [m].
[[nodiscard]] inline double front_of_mass(const std::vector<FallenPoint>& points) {
  double total = 0;
  for (const FallenPoint& point : points) total += point.mass;
  double behind = 0;
  for (const FallenPoint& point : points) {
    behind += point.mass;
    if (behind >= 0.995 * total) return point.place;
  }
  return points.back().place;
}

}  // namespace scree::app::testing
