#pragma once

#include "scenes.hpp"
#include "scree/run/simulation.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace scree::app::testing {

/// A folder of this test, the same in every run of it, with a map of 4 x 3 cells of 0.5 m whose values rise
/// by 0.1 to the east and 0.2 to the north, from 10.15 at the centre of its south-western cell, at
/// (100.25, 50.25) m; a map without data in its north-eastern cell; one of the same slope from 0.15 on, for
/// friction, without data there; and one of depths, 0.3 everywhere.
[[nodiscard]] inline std::filesystem::path folder_with_maps() {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path{SCREE_TEST_MAPS} / test->test_suite_name() / test->name();
  std::filesystem::create_directories(folder);
  const std::string header = "ncols 4\nnrows 3\nxllcorner 100\nyllcorner 50\ncellsize 0.5\n";
  const std::string south = "10.25 10.3 10.35 10.4\n10.15 10.2 10.25 10.3\n";
  std::ofstream{folder / "tilted.asc"} << header << "10.35 10.4 10.45 10.5\n" << south;
  std::ofstream{folder / "holed.asc"} << header << "nodata_value -1\n10.35 10.4 10.45 -1\n" << south;
  std::ofstream{folder / "friction.asc"} << header
                                         << "nodata_value -1\n0.35 0.4 0.45 -1\n0.25 0.3 0.35 0.4\n"
                                            "0.15 0.2 0.25 0.3\n";
  std::ofstream{folder / "depths.asc"} << header << "0.3 0.3 0.3 0.3\n0.3 0.3 0.3 0.3\n0.3 0.3 0.3 0.3\n";
  return folder;
}

/// A mesh of 2 m x 1 m x 1.5 m over the map, with ground and material by these tables.
[[nodiscard]] inline std::string scene_on_map(const std::string& terrain, const std::string& material) {
  return R"([mesh]
dimensions = 3
size = [2.0, 1.0, 1.5]
cells = 4
[boundaries]
x_low = "slip"
x_high = "slip"
y_low = "slip"
y_high = "slip"
z_low = "slip"
z_high = "slip"
)" + terrain +
         material + R"([rheology]
law = "newtonian"
viscosity = 1
bulk_modulus = 1e6
density = 1000
[time]
end = 0.1
)";
}

inline const std::string tilted_ground = R"([terrain]
surface = "raster"
file = "tilted.asc"
origin = [100, 50]
datum = 10
contact = "slides"
)";

[[nodiscard]] inline Scene read_on_map(const std::string& terrain, const std::string& material) {
  return parse_scene(scene_on_map(terrain, material), (folder_with_maps() / "scene.toml").string()).scene;
}

/// A viscous block of 0.4 m x 0.2 m above y = 0.15 m in a mesh of cells of 0.1 m, periodic along x.
[[nodiscard]] inline std::string block_scene(const std::string& surroundings, double slope_degrees) {
  return R"([mesh]
dimensions = 2
size = [0.4, 0.5]
cells = 5
[boundaries]
x = "periodic"
y_low = "slip"
y_high = "slip"
[material]
low = [0.0, 0.15]
high = [0.4, 0.35]
points_per_cell = 2
[gravity]
slope_degrees = )" +
         std::to_string(slope_degrees) + "\n" + viscous_block() + surroundings;
}

template <int D>
[[nodiscard]] double mass_of(const Simulation<D, D>& simulation) {
  double sum = 0;
  for (const double mass : simulation.state.particles.mass.values()) sum += mass;
  return sum;
}

/// Mean of a velocity component [m/s].
template <int D>
[[nodiscard]] double mean_velocity(const Simulation<D, D>& simulation, int component) {
  const auto& particles = simulation.state.particles;
  double momentum = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    momentum += particles.mass.component(0)[p] * particles.velocity.component(component)[p];
  }
  return momentum / mass_of(simulation);
}

}  // namespace scree::app::testing
