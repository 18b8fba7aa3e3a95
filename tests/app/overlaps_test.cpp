// Bodies that begin in the ground or in each other: refused, naming both, unless the scene says so.

#include "scree/assemble/overlaps.hpp"

#include "scree/assemble/make_stages.hpp"
#include "surroundings.hpp"

#include <utility>
#include <vector>

namespace scree::app::testing {
namespace {

/// The mesh of the block's scene is 0.4 m x 0.5 m with nodes 0.1 m apart; the block lies above y = 0.15 m.
[[nodiscard]] std::string ball(const std::string& centre, double radius, const std::string& more = "") {
  return "[[bodies]]\nsurface = \"ball\"\ncentre = " + centre + "\nradius = " + std::to_string(radius) +
         "\ncontact = \"slides\"\n" + more;
}

[[nodiscard]] std::string message_of(const std::string& surroundings) {
  try {
    const Simulation<2, 2> block{parse_scene(block_scene(surroundings, 0), "scene.toml").scene, {1}};
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string ground =
    "[terrain]\nsurface = \"plane\"\npoint = [0.0, 0.12]\nnormal = [0.0, 1.0]\ncontact = \"slides\"\n";

TEST(Overlap, OfABodyAndTheGroundIsRefused) {
  EXPECT_EQ(
      message_of(ground + ball("[0.2, 0.05]", 0.08)),
      "[[bodies]] 1 and [terrain] overlap: the place (0.2, 0) m is 0.03 m deep in the one and 0.12 m in "
      "the other; move them apart, or say may_overlap = true of the body");
}

TEST(Overlap, OfTwoBodiesIsRefused) {
  EXPECT_EQ(
      message_of(ball("[0.15, 0.45]", 0.08) + ball("[0.25, 0.42]", 0.09)),
      "[[bodies]] 2 and [[bodies]] 1 overlap: the place (0.2, 0.4) m is 0.0361484 m deep in the one and "
      "0.00928932 m in the other; move them apart, or say may_overlap = true of the body");
}

TEST(Overlap, OfABallAndAPlaneIsRefused) {
  const std::string plane =
      "[[bodies]]\nsurface = \"plane\"\npoint = [0.0, 0.12]\nnormal = [0.0, 1.0]\ncontact = \"slides\"\n";

  EXPECT_EQ(
      message_of(plane + ball("[0.2, 0.05]", 0.08)),
      "[[bodies]] 2 and [[bodies]] 1 overlap: the place (0.2, 0) m is 0.03 m deep in the one and 0.12 m in "
      "the other; move them apart, or say may_overlap = true of the body");
}

TEST(Overlap, IsAllowedIfTheSceneSaysSo) {
  EXPECT_EQ(message_of(ground + ball("[0.2, 0.05]", 0.08, "may_overlap = true\n")), "no error");
}

/// Planes go on behind each other: two make a funnel.
TEST(Overlap, OfPlanesIsNone) {
  EXPECT_EQ(message_of(ground + "[[bodies]]\nsurface = \"plane\"\npoint = [0.0, 0.1]\nnormal = [0.1, 1.0]\n"
                                "contact = \"slides\"\n"),
            "no error");
}

/// On a node, (0.2, 0) m, that lies in both by less than a millionth of a cell, as round-off may have it.
TEST(Overlap, IsNoneOfBodiesThatTouch) {
  EXPECT_EQ(message_of(ball("[0.1, 0.0]", 0.1) + ball("[0.29999999, 0.0]", 0.1)), "no error");
  EXPECT_EQ(
      message_of(ball("[0.1, 0.0]", 0.101) + ball("[0.299, 0.0]", 0.1)),
      "[[bodies]] 2 and [[bodies]] 1 overlap: the place (0.2, 0) m is 0.001 m deep in the one and 0.001 m in "
      "the other; move them apart, or say may_overlap = true of the body");
}

/// Where it fails: bodies that share no node of the mesh are not seen to overlap, here by 0.03 m of 0.1 m.
TEST(Overlap, ThinnerThanACellIsNotSeen) {
  EXPECT_EQ(message_of(ball("[0.115, 0.45]", 0.05) + ball("[0.185, 0.45]", 0.05)), "no error");
}

/// The same block in space, 0.4 m wide, with nodes 0.1 m apart.
[[nodiscard]] std::string message_in_space(const std::string& surroundings) {
  const std::string scene = R"([mesh]
dimensions = 3
size = [0.4, 0.4, 0.5]
cells = 4
[boundaries]
x = "periodic"
y = "periodic"
z_low = "slip"
z_high = "slip"
[material]
low = [0.0, 0.0, 0.15]
high = [0.4, 0.4, 0.25]
points_per_cell = 1
)";
  try {
    const Simulation<3, 3> block{parse_scene(scene + viscous_block() + surroundings, "scene.toml").scene,
                                 {1}};
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Overlap, InSpaceIsRefused) {
  const std::string ground_in_space =
      "[terrain]\nsurface = \"plane\"\npoint = [0.0, 0.0, 0.12]\nnormal = [0.0, 0.0, 1.0]\n"
      "contact = \"slides\"\n";

  EXPECT_EQ(
      message_in_space(ground_in_space + ball("[0.2, 0.2, 0.05]", 0.08)),
      "[[bodies]] 1 and [terrain] overlap: the place (0.2, 0.2, 0) m is 0.03 m deep in the one and 0.12 m in "
      "the other; move them apart, or say may_overlap = true of the body");
  EXPECT_EQ(
      message_in_space(ball("[0.15, 0.2, 0.45]", 0.08) + ball("[0.25, 0.2, 0.42]", 0.09)),
      "[[bodies]] 2 and [[bodies]] 1 overlap: the place (0.2, 0.2, 0.4) m is 0.0361484 m deep in the one and "
      "0.00928932 m in the other; move them apart, or say may_overlap = true of the body");
  EXPECT_EQ(message_in_space(ground_in_space + ball("[0.2, 0.2, 0.05]", 0.08, "may_overlap = true\n")),
            "no error");
}

TEST(Overlap, InSpaceIsNoneOfBodiesBesideEachOther) {  // seen along y they cover each other
  EXPECT_EQ(message_in_space(ball("[0.2, 0.1, 0.42]", 0.09) + ball("[0.2, 0.3, 0.42]", 0.09)), "no error");
}

TEST(Overlap, InSpaceThinnerThanACellIsNotSeen) {
  EXPECT_EQ(message_in_space(ball("[0.115, 0.2, 0.45]", 0.05) + ball("[0.185, 0.2, 0.45]", 0.05)),
            "no error");
}

/// What a person is told of the block on level ground at some height, in cells of 0.1 m.
[[nodiscard]] std::string warning_of(double height, const std::string& shape, const std::string& wall) {
  std::string text = with(block_scene(ground, 0), "y_low = \"slip\"", "y_low = " + wall);
  text = with(text, "point = [0.0, 0.12]", "point = [0.0, " + std::to_string(height) + "]");
  const Scene scene =
      parse_scene(with(text, "[numerics]", "[numerics]\nshape = " + shape), "scene.toml").scene;
  const auto grid = make_grid<2>(scene);
  return wall_under_ground_warning(scene, grid, ground_of<2>(scene));
}

TEST(WallUnderGround, IsWarnedOfWithItsKeys) {
  EXPECT_EQ(
      warning_of(0.03, "\"quadratic\"", "\"slip\""),
      "[terrain] lies 0.03 m above [boundaries] y_low at (0, 0) m, and what lies less than 0.05 m above this "
      "wall bears part of its load on it without friction: make the end \"open\", which ground closes, or "
      "the ground higher");
  const std::string held =
      "[terrain] lies 0.03 m above [boundaries] y_low at (0, 0) m, and what lies less than 0.15 m above this "
      "wall may be held or rubbed by it, too: make the end \"open\", which ground closes, or "
      "the ground higher";
  EXPECT_EQ(warning_of(0.03, "\"quadratic\"", "\"no_slip\""), held);
  EXPECT_EQ(warning_of(0.03, "\"quadratic\"", "{law = \"coulomb\", friction = 0.3}"), held);
}

/// By the nodes that the shape functions of material on the ground have: past the wall, whose mirror images
/// slip feels, or on it.
TEST(WallUnderGround, IsWarnedOfAsFarAsShapesReach) {
  const std::string gimp = "\"gimp\"\npoints_per_axis = 2";  // boxes of half a cell: 1 + 1/4 cells
  for (const auto& [shape, reach] : std::vector<std::pair<std::string, double>>{
           {"\"linear\"", 0.1}, {gimp, 0.125}, {"\"quadratic\"", 0.15}, {"\"cubic\"", 0.2}}) {
    const auto is_warned = [&shape = shape](double height, const std::string& wall) {
      return !warning_of(height, shape, wall).empty();
    };
    EXPECT_TRUE(is_warned(reach - 0.001, "\"no_slip\"")) << shape;
    EXPECT_FALSE(is_warned(reach + 0.001, "\"no_slip\"")) << shape;
    EXPECT_TRUE(is_warned(reach - 0.001, "{law = \"coulomb\", friction = 0.3}")) << shape;
    EXPECT_EQ(is_warned(reach - 0.1 - 0.001, "\"slip\""), reach > 0.1) << shape;
    EXPECT_FALSE(is_warned(reach - 0.1 + 0.001, "\"slip\"")) << shape;
    EXPECT_FALSE(is_warned(0.01, "\"open\"")) << shape;
  }
  EXPECT_TRUE(warning_of(0, "\"linear\"", "\"slip\"").empty());
}

/// Speed of a block of 0.2 m after 0.05 s down ground at 30 degrees with friction 0.3, which lies at a height
/// over a wall, in cells of 0.1 m under quadratic shapes [m/s].
[[nodiscard]] double speed_over(double height, const std::string& wall) {
  std::string text = with(block_scene(ground, 30), "y_low = \"slip\"", "y_low = " + wall);
  text = with(text, "point = [0.0, 0.12]", "point = [0.0, " + std::to_string(height) + "]");
  text = with(text, "contact = \"slides\"", "contact = {law = \"coulomb\", friction = 0.3}");
  text = with(text, "low = [0.0, 0.15]", "low = [0.0, " + std::to_string(height) + "]");
  text = with(text, "high = [0.4, 0.35]", "high = [0.4, " + std::to_string(height + 0.2) + "]");
  text = with(text, "[numerics]", "[numerics]\nshape = \"quadratic\"");
  Simulation<2, 2> block{parse_scene(text, "scene.toml").scene, {1}};
  advance_to(0.05, block);
  return mean_velocity(block, 0);
}

/// 0.01 m over a wall that lets slip the block is a tenth faster and more than over an end that ground
/// closes; at 0.03 m none of its points is within reach of the wall, whose nodes the ground holds.
TEST(WallUnderGround, BearsLoadWithoutFriction) {
  EXPECT_GT(speed_over(0.01, "\"slip\""), 1.1 * speed_over(0.01, "\"open\""));
  EXPECT_EQ(speed_over(0.03, "\"slip\""), speed_over(0.03, "\"open\""));
}

/// A wall that holds the block's lowest nodes makes it a film that does not slip. It is slower than the
/// steady film of height H whose foot slips as if at rest a cell of width h below, g sin(30) (H^2 / 3 + H h)
/// / nu: shapes carry the speed from held nodes to points less than h/2 above them within (y + h/2) / 2 < h.
TEST(WallUnderGround, HoldsWhatDoesNotSlipOnIt) {
  const double gravity = 9.81;          // [m/s^2]
  const double height = 0.2;            // [m]
  const double width = 0.1;             // [m]
  const double viscosity = 2e4 / 1000;  // kinematic [m^2/s]; steady after some H^2 / nu = 2e-3 s
  const double film = gravity / 2 * (height * height / 3 + height * width) / viscosity;

  const double speed = speed_over(0.01, "\"no_slip\"");  // lowest points 0.035 m above the nodes held

  EXPECT_GT(speed, 0);
  EXPECT_LT(speed, film);
  EXPECT_LT(film, speed_over(0.01, "\"open\"") / 10);
}

/// Along the wall: the ground has taken the momentum into it before, so nothing presses on it.
TEST(WallUnderGround, AddsNoFrictionInProportionToPressure) {
  for (const std::string friction : {"0.1", "0.5"}) {
    EXPECT_EQ(speed_over(0.06, "{law = \"coulomb\", friction = " + friction + "}"),
              speed_over(0.06, "\"open\""));
  }
}

}  // namespace
}  // namespace scree::app::testing
