// Boxes of uniform GIMP fill a cell only if the scene lays as many points.

#include "scenes.hpp"

#include <gtest/gtest.h>

namespace scree::app::testing {
namespace {

[[nodiscard]] std::string message_of(const std::vector<std::string>& overrides) {
  try {
    static_cast<void>(scene_of("granular_column_collapse", overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(GimpScene, TakesBoxesThatFillACell) {
  EXPECT_EQ(message_of({"numerics.shape=gimp", "numerics.points_per_axis=3"}), "no error");
}

TEST(GimpScene, RefusesBoxesThatDoNot) {
  EXPECT_EQ(message_of({"numerics.shape=gimp", "numerics.points_per_axis=2"}),
            "--set numerics.points_per_axis=2: must be [material] points_per_cell = 3: boxes of that many "
            "points fill a cell");
}

TEST(GimpScene, RefusesThemForAStreamToo) {
  std::string text = small_scene();
  text.replace(text.find("y_high = \"slip\""), 15, "y_high = \"open\"");
  text +=
      "[numerics]\nshape = \"gimp\"\npoints_per_axis = 3\n[[inflow]]\nlow = [0.75]\nhigh = [1.0]\n"
      "velocity = [-1, 0]\npoints_per_cell = 2\n";
  std::string message;
  try {
    static_cast<void>(parse_scene(text, "scene.toml"));
  } catch (const InputError& error) {
    message = error.what();
  }

  EXPECT_EQ(message,
            "scene.toml:28: [numerics] points_per_axis = 3: must be [[inflow]] 1 points_per_cell = 2: boxes "
            "of that many points fill a cell");
}

}  // namespace
}  // namespace scree::app::testing
