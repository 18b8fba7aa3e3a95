// Bodies that begin in the ground or in each other: refused, naming both, unless the scene says so.

#include "surroundings.hpp"

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

}  // namespace
}  // namespace scree::app::testing
