// Material in regions of a scene: where points are, how many, and how they are pressed at the start.

#include "surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace scree::app::testing {
namespace {

/// A mesh of 1 m x 1 m in cells of 0.125 m with material by these tables.
[[nodiscard]] Scene plane_with(const std::string& material) {
  return parse_scene(R"([mesh]
dimensions = 2
size = [1.0, 1.0]
cells = 8
[boundaries]
x_low = "slip"
x_high = "slip"
y_low = "slip"
y_high = "slip"
)" + material + R"([rheology]
law = "newtonian"
viscosity = 1
bulk_modulus = 1e6
density = 1000
[time]
end = 0.1
)",
                     "scene.toml")
      .scene;
}

[[nodiscard]] std::vector<Vector<2>> places_of(const Simulation<2, 2>& simulation) {
  const auto& particles = simulation.state.particles;
  std::vector<Vector<2>> places;
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    places.emplace_back(particles.position.component(0)[p], particles.position.component(1)[p]);
  }
  return places;
}

/// Points stand in the middle of shares of 1/16 m. Below the diagonal of the square are 16 x 15/2 of these
/// middles; those on it count by the rule of the polygon.
TEST(RegionScene, PolygonHoldsThePlacesInsideIt) {
  const Simulation<2, 2> triangle{
      plane_with("[material]\npoints_per_cell = 2\n[[material.regions]]\nshape = \"polygon\"\n"
                 "x = [0.0, 1.0, 1.0]\ny = [0.0, 0.0, 0.99]\n"),
      {1}};

  EXPECT_EQ(triangle.num_points(), 16 * 15 / 2);
  for (const Vector<2>& x : places_of(triangle)) EXPECT_LT(x[1], 0.99 * x[0]);
}

TEST(RegionScene, PlacesInTwoRegionsCountOnce) {
  const Simulation<2, 2> boxes{
      plane_with("[material]\npoints_per_cell = 2\n"
                 "[[material.regions]]\nshape = \"box\"\nlow = [0.0, 0.0]\nhigh = [0.5, 0.5]\n"
                 "[[material.regions]]\nshape = \"box\"\nlow = [0.25, 0.0]\nhigh = [0.75, 0.5]\n"),
      {1}};

  EXPECT_EQ(boxes.num_points(), 12 * 8);
  EXPECT_EQ(boxes.scene().material.low, (std::vector<double>{0, 0}));
  EXPECT_EQ(boxes.scene().material.high, (std::vector<double>{0.75, 0.5}));
}

[[nodiscard]] std::vector<Vector<2>> random_places(const std::string& seed) {
  return places_of(
      Simulation<2, 2>{plane_with("[material]\npoints_per_cell = 2\nlayout = \"random\"\nseed = " + seed +
                                  "\n[[material.regions]]\nshape = \"layer\"\ntop = 0.5\n"),
                       {1}});
}

TEST(RegionScene, RandomPlacesAreDrawnFromTheirSeed) {
  const auto one = random_places("1");

  EXPECT_EQ(one.size(), 16U * 8U);
  EXPECT_TRUE(one == random_places("1"));
  EXPECT_FALSE(one == random_places("2"));
}

/// Ground rises from 0 to 1 along x: of a layer up to 0.5 half is left, less than a share along its length.
TEST(RegionScene, LayerFillsTheGroundUp) {
  const Simulation<2, 2> lake{
      plane_with("[terrain]\nsurface = \"profile\"\nheights = [0.0, 1.0]\ncontact = \"slides\"\n"
                 "[material]\npoints_per_cell = 2\n[[material.regions]]\nshape = \"layer\"\ntop = 0.5\n"),
      {1}};

  EXPECT_EQ(lake.num_points(), 8 * 7 / 2);  // middles above the diagonal, in rows of 1/16 m
  for (const Vector<2>& x : places_of(lake)) EXPECT_GT(x[1], x[0]);
}

/// Under a surface that is not level, each point bears what is straight above it: in the triangle of the
/// first test, 0.99 x - y of it. K is so large that the pressure changes the density by 1e-2 at most, and it
/// by half of that; a share's surface is found to 1e-6 of it.
TEST(RegionScene, PointsBearWhatIsStraightAboveThem) {
  const Simulation<2, 2> triangle{
      plane_with("[material]\npoints_per_cell = 2\n[[material.regions]]\nshape = \"polygon\"\n"
                 "x = [0.0, 1.0, 1.0]\ny = [0.0, 0.0, 0.99]\n"),
      {1}};
  const auto& particles = triangle.state.particles;

  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    const double depth = 0.99 * particles.position.component(0)[p] - particles.position.component(1)[p];
    const double compression = particles.density.component(0)[p] / 1000 - 1;
    const double expected = 1000 * 9.81 * depth / 1e6;
    EXPECT_NEAR(compression, expected, expected * expected + 1e-6 * 1000 * 9.81 / 1e6);
  }
}

/// 0.3 m deep everywhere, straight up: 24 x 18 columns of shares of 1/12 m hold 3.6 shares each, 3 or 4.
TEST(RegionScene, ReleaseLiesOnTheGroundAsDeepAsItsMapSays) {
  const Simulation<3, 3> release{
      read_on_map(tilted_ground,
                  "[material]\n[[material.regions]]\nshape = \"release\"\nfile = \"depths.asc\"\n"),
      {1}};
  const auto& particles = release.state.particles;

  EXPECT_GE(release.num_points(), 24 * 18 * 3);
  EXPECT_LE(release.num_points(), 24 * 18 * 4);
  for (Index p = 0; p < particles.size(); ++p) {
    const double bed =
        0.075 + 0.1 * particles.position.component(0)[p] + 0.2 * particles.position.component(2)[p];
    EXPECT_GT(particles.position.component(1)[p], bed);
    EXPECT_LE(particles.position.component(1)[p], bed + 0.3 + 1e-8);  // ends of the map, to 1e-9 of its cell
  }
}

TEST(TooFewPoints, AreWarnedOf) {
  const auto warning_of = [](const std::string& material) {
    return Simulation<2, 2>{plane_with(material), {1}}.too_few_points();
  };

  EXPECT_EQ(warning_of("[material]\nlow = [0.0, 0.0]\nhigh = [1.0, 0.5]\npoints_per_cell = 2\n"), "");
  EXPECT_EQ(warning_of("[material]\nlow = [0.0, 0.0]\nhigh = [1.0, 0.5]\npoints_per_cell = 1\n"),
            "32 of 32 cells with material hold fewer than 4 points, which carry stress badly: give more "
            "[material] points_per_cell, or material more cells");
}

/// A cell and a half deep: 8 cells of 4 points and 8 of 2. A single point beside them makes these the most.
TEST(TooFewPoints, AreWarnedOfFromMoreThanHalfOfTheCellsOn) {
  const std::string box = "[[material.regions]]\nshape = \"box\"\n";
  const std::string half =
      "[material]\npoints_per_cell = 2\n" + box + "low = [0.0, 0.0]\nhigh = [1.0, 0.1875]\n";
  const auto warning_of = [](const std::string& material) {
    return Simulation<2, 2>{plane_with(material), {1}}.too_few_points();
  };

  EXPECT_EQ(warning_of(half), "");
  EXPECT_EQ(warning_of(half + box + "low = [0.0, 0.25]\nhigh = [0.0625, 0.3125]\n"),
            "9 of 17 cells with material hold fewer than 4 points, which carry stress badly: give more "
            "[material] points_per_cell, or material more cells");
}

}  // namespace
}  // namespace scree::app::testing
