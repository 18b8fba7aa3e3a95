// Ground and bodies by their keys in a scene: surfaces as given, and motion with an exact solution.

#include "scree/assemble/ground.hpp"

#include "scree/run/run.hpp"
#include "surroundings.hpp"

#include <scree/mpm/terrain/bed_nodes.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::app::testing {
namespace {

const std::string small_box = "[material]\nlow = [0.0, 0.75, 0.0]\nhigh = [2.0, 1.0, 1.5]\n";

[[nodiscard]] mpm::AnySurface<3> ground_of(const Scene& scene) {
  return surface_of<3>(*scene.terrain, scene.mesh);
}

/// Heights are 0.1 + 0.1 x + 0.2 z over the mesh: 0.15 at (0.25, 0.25), and linear between.
TEST(TerrainScene, LiesWhereItsMapSays) {
  const auto ground = ground_of(read_on_map(tilted_ground, small_box));
  const double stretch = std::sqrt(1 + 0.1 * 0.1 + 0.2 * 0.2);

  for (const Vector<3>& x : {Vector<3>{0, 0, 0}, Vector<3>{2, 0.3, 1.5}, Vector<3>{0.7, 0.9, 1.1}}) {
    const auto seen = ground(x);
    // Numbers of 100 m are differenced over half a metre, in places of which ten are summed.
    const double rounding = 10 * 2 * 100 * round_off;
    EXPECT_NEAR(seen.distance, (x[1] - (0.075 + 0.1 * x[0] + 0.2 * x[2])) / stretch, rounding + 2e-9);
    EXPECT_NEAR((seen.normal - Vector<3>{-0.1, 1, -0.2} / stretch).norm(), 0, 10 * rounding);
  }
}

/// Two triangles of the same slope, counter-clockwise from above, in a file beside the scene; 0.075 m lower.
[[nodiscard]] std::string tilted_triangles() {
  std::ofstream{folder_with_maps() / "tilted.stl"}
      << "solid tilted\n"
         "facet normal 0 0 0\nouter loop\nvertex 90 40 8\nvertex 110 40 10\nvertex 110 60 "
         "14\nendloop\nendfacet\n"
         "facet normal 0 0 0\nouter loop\nvertex 90 40 8\nvertex 110 60 14\nvertex 90 60 "
         "12\nendloop\nendfacet\n"
         "endsolid tilted\n";
  std::string terrain = tilted_ground;
  terrain.replace(terrain.find("raster"), 6, "stl");
  terrain.replace(terrain.find("tilted.asc"), 10, "tilted.stl");
  terrain.replace(terrain.find("datum = 10"), 10, "datum = 11");
  return terrain;
}

TEST(TerrainScene, TrianglesLieWhereTheirMapSays) {
  const auto ground = ground_of(read_on_map(tilted_triangles(), small_box));

  const double stretch = std::sqrt(1 + 0.1 * 0.1 + 0.2 * 0.2);
  for (const Vector<3>& x : {Vector<3>{0, 0.5, 0}, Vector<3>{1.5, 0.9, 0.25}}) {
    const auto seen = ground(x);
    const double rounding = 10 * 2 * 100 * round_off;  // numbers of 100 m, ten of which are summed
    EXPECT_NEAR(seen.distance, (x[1] - 0.1 * x[0] - 0.2 * x[2]) / stretch, rounding);
    EXPECT_NEAR((seen.normal - Vector<3>{-0.1, 1, -0.2} / stretch).norm(), 0, rounding);
  }
}

/// Nodes beyond an open end lie on ground as high as that at the end.
TEST(TerrainScene, GoesOnLevelBeyondTheMesh) {
  const auto ground = ground_of(read_on_map(tilted_ground, small_box));

  EXPECT_EQ(ground({2.25, 0.5, 0.5}).distance, ground({2, 0.5, 0.5}).distance);
  EXPECT_EQ(ground({0.5, 0.5, -0.25}).distance, ground({0.5, 0.5, 0}).distance);
}

/// Every node on the ground is left 1 - mu of a speed of 1 along it, as it comes down as fast; mu is that of
/// the map, 0.075 + 0.1 x + 0.2 z, and the contact's own in and beside the cell without data.
TEST(TerrainScene, TakesItsFrictionFromAMap) {
  std::string terrain = tilted_ground;
  const std::string contact = "contact = {law = \"material_friction\", share = 1, friction = 0.5}\n";
  terrain.replace(terrain.find("contact"), std::string::npos, contact + "friction_file = \"friction.asc\"\n");
  const Scene scene = read_on_map(terrain, small_box);
  const CartesianGrid<3> grid{Vector<3>::Zero(), Vector<3>::Constant(0.25), {8, 4, 6}, {}};
  const mpm::AnySurface<3> level = mpm::PlaneSurface<3>{Vector<3>{0, 0.25, 0}, Vector<3>::Unit(1)};
  mpm::Nodes<3> nodes{grid, {.num_velocities = 3, .has_increment = false}};
  for (const mpm::BedNode& bed : mpm::bed_nodes(grid, level)) {
    nodes[bed.node][mpm::NodeRecord::mass] = 1;
    nodes[bed.node][mpm::NodeRecord::momentum] = 1;
    nodes[bed.node][mpm::NodeRecord::momentum + 1] = -1;
  }

  make_terrain<3>(*scene.terrain, level, grid)->hold(nodes, 1e-3);

  for (const mpm::BedNode& bed : mpm::bed_nodes(grid, level)) {
    const Vector<3> x = mpm::node_position(nodes, bed.node);
    const bool is_inside =
        0 < x[0] && x[0] < 2 && 0 < x[2] && x[2] < 1.5;  // images and the rim are the walls'
    const bool has_data = !(x[0] >= 1.25 && x[2] >= 0.75);
    if (!is_inside) continue;
    const double friction = has_data ? 0.075 + 0.1 * x[0] + 0.2 * x[2] : 0.5;
    EXPECT_NEAR(nodes[bed.node][mpm::NodeRecord::momentum], 1 - friction, 10 * 2 * 100 * round_off);
  }
}

TEST(TerrainScene, ProfileGoesFromEndToEnd) {
  const Scene scene =
      parse_scene(
          block_scene("[terrain]\nsurface = \"profile\"\nheights = [0.1, 0.15, 0.1]\ncontact = \"sticks\"\n",
                      0),
          "scene.toml")
          .scene;
  const auto ground = surface_of<2>(*scene.terrain, scene.mesh);
  const double stretch = std::hypot(1, 0.25);

  EXPECT_NEAR(ground({0.2, 0.2}).distance, 0.05 / stretch, 8 * round_off);
  EXPECT_NEAR(ground({0.1, 0.2}).distance, 0.075 / stretch, 8 * round_off);
}

/// Momentum along the ground, and mu times that across, change by the weight alone while the block slides.
/// It does after h^2/nu = 2e-3 s.
TEST(TerrainScene, LetsABlockSlideAtItsAcceleration) {  // Eq. (M63)
  Simulation<2, 2> block{
      parse_scene(block_scene("[terrain]\nsurface = \"plane\"\npoint = [0, 0.15]\nnormal = [0, 1]\n"
                              "contact = {law = \"coulomb\", friction = 0.1}\n",
                              30),
                  "scene.toml")
          .scene,
      {1}};
  const auto run_until = [&](double time) {
    while (block.clock.time < time) block.step();
  };
  run_until(0.05);
  const double start = block.clock.time;
  const double before = mean_velocity(block, 0) + 0.1 * mean_velocity(block, 1);

  run_until(0.15);

  const double gained = mean_velocity(block, 0) + 0.1 * mean_velocity(block, 1) - before;
  const double degree = std::numbers::pi / 180;
  const double acceleration = 9.81 * (std::sin(30 * degree) - 0.1 * std::cos(30 * degree));
  // 1000 steps of about 100 sums, of speeds up to 1 m/s
  EXPECT_NEAR(gained, (block.clock.time - start) * acceleration, 1000 * 100 * round_off);
}

/// The scene on the map of a material so viscous that it moves as a block, over ground or a body with this
/// contact in place of a smooth one.
[[nodiscard]] std::string viscous_on_map(const std::string& ground, const std::string& contact,
                                         const std::string& material) {
  const std::string text = scene_on_map(with(ground, "\"slides\"", contact), material);
  return with(with(text, "viscosity = 1\n", "viscosity = 1e4\n"), "end = 0.1\n",
              "end = 1\n[numerics]\nshape = \"quadratic\"\nmaximum_dt = 2e-4\n");
}

[[nodiscard]] Simulation<3, 3> simulation_on_map(const std::string& text) {
  return {parse_scene(text, (folder_with_maps() / "scene.toml").string()).scene, {1}};
}

/// A block of 0.75 m x 0.5 m x 0.25 m begins on the slope of the map, at 1 m/s down along it. Momentum along
/// the slope and mu times that into it change by the weight alone, but for points that swing across by an
/// angle alpha: 1 - cos alpha < tan^2 alpha/2 of the friction is missing.
TEST(TerrainScene, LetsABlockSlideDownAMapInSpace) {  // Eq. (M63)
  constexpr double friction = 0.1;
  const std::string block_on_map =
      "[material]\npoints_per_cell = 2\n[[material.regions]]\nshape = \"release\"\nfile = \"block.asc\"\n";
  {
    std::ofstream map{folder_with_maps() / "block.asc"};
    map << "ncols 16\nnrows 12\nxllcorner 100\nyllcorner 50\ncellsize 0.125\nnodata_value -1\n";
    for (int row = 0; row < 12; ++row) {
      for (int column = 0; column < 16; ++column)
        map << (2 <= row && row < 6 && 6 <= column && column < 12 ? " 0.25" : " -1");
      map << '\n';
    }
  }
  const Vector<3> normal = Vector<3>{-0.1, 1, -0.2}.normalized();
  const Vector<3> downhill = (Vector<3>{0, -1, 0} + normal[1] * normal).normalized();
  for (const std::string& terrain : {tilted_ground, tilted_triangles()}) {
    auto block =
        simulation_on_map(with(viscous_on_map(terrain, "{law = \"coulomb\", friction = 0.1}", block_on_map),
                               "cells = 4", "cells = 8"));
    auto& particles = block.state.particles;
    const auto velocity = [&](Index p) {
      const auto of = [&](int axis) { return particles.velocity.component(axis)[p]; };
      return Vector<3>{of(0), of(1), of(2)};
    };
    for (Index p = 0; p < particles.size(); ++p) {
      for (int axis = 0; axis < 3; ++axis) particles.velocity.component(axis)[p] = downhill[axis];
    }
    double widest = 0;  // tangent of alpha

    while (block.clock.time < 0.1) {
      block.step();
      for (Index p = 0; p < particles.size(); ++p) {
        const Vector<3> along = velocity(p) - velocity(p).dot(normal) * normal;
        const double down = along.dot(downhill);
        widest = std::max(widest, (along - down * downhill).norm() / down);
      }
    }

    const double time = block.clock.moved;
    const Vector<3> gained =
        Vector<3>{mean_velocity(block, 0), mean_velocity(block, 1), mean_velocity(block, 2)} - downhill;
    const double impulse = friction * (9.81 * normal[1] * time + gained.dot(normal));
    EXPECT_NEAR(gained.dot(downhill), 9.81 * -downhill[1] * time - impulse,
                impulse * widest * widest / 2 + static_cast<double>(block.clock.step) * 1000 * round_off);
    EXPECT_GT(impulse, friction * 9.81 * time / 2);  // it is on the ground
    EXPECT_LT(widest, 0.1);                          // so that a friction wrong by half a percent is seen
  }
}

/// The block follows as exp(-pi^2 nu t/(4 h^2)), with h^2/nu = 2e-3 s: exp(-72) is left at the end of each
/// part. At rest, places of nodes of up to 0.5 m are rounded a few times and differenced over the step.
TEST(BodyScene, TakesMaterialAlongFromItsStartToItsStop) {
  Simulation<2, 2> block{
      parse_scene(block_scene("[[bodies]]\nsurface = \"plane\"\npoint = [0, 0.15]\nnormal = [0, 1]\n"
                              "contact = {law = \"sticks\", hold = \"pushes_and_pulls\"}\n"
                              "velocity = [0.3, 0]\nstart = 0.02\nstop = 0.08\n",
                              0),
                  "scene.toml")
          .scene,
      {1}};
  const auto mean_at = [&](double time) {
    while (block.clock.time < time) block.step();
    return mean_velocity(block, 0);
  };

  EXPECT_NEAR(mean_at(0.0199), 0, 4 * round_off / 1e-4);
  EXPECT_NEAR(mean_at(0.079), 0.3, 0.3 * 1e-6);
  EXPECT_NEAR(mean_at(0.139), 0, 0.3 * 1e-6);
}

/// There and half of the way back, by places in time; it follows as above.
TEST(BodyScene, TakesMaterialAlongOnItsWay) {
  Simulation<2, 2> block{
      parse_scene(block_scene("[[bodies]]\nsurface = \"plane\"\npoint = [0, 0.15]\nnormal = [0, 1]\n"
                              "contact = {law = \"sticks\", hold = \"pushes_and_pulls\"}\n"
                              "times = [0.02, 0.08, 0.14]\nx = [0, 0.018, 0.009]\n",
                              0),
                  "scene.toml")
          .scene,
      {1}};
  const auto mean_at = [&](double time) {
    while (block.clock.time < time) block.step();
    return mean_velocity(block, 0);
  };

  EXPECT_NEAR(mean_at(0.0199), 0, 4 * round_off / 1e-4);
  EXPECT_NEAR(mean_at(0.079), 0.3, 0.3 * 1e-6);
  EXPECT_NEAR(mean_at(0.139), -0.15, 0.3 * 1e-6);
  EXPECT_NEAR(mean_at(0.199), 0, 0.3 * 1e-6);
}

/// A plate of triangles that moves obliquely under a layer of 0.25 m, which follows as above: with h^2/nu =
/// 6e-3 s exp(-39) is left.
TEST(BodyScene, OfTrianglesTakesMaterialAlong) {
  std::ofstream{folder_with_maps() / "plate.stl"}
      << "solid plate\n"
         "facet normal 0 0 0\nouter loop\nvertex -9 0.25 -9\nvertex 9 0.25 9\nvertex 9 0.25 "
         "-9\nendloop\nendfacet\n"
         "facet normal 0 0 0\nouter loop\nvertex -9 0.25 -9\nvertex -9 0.25 9\nvertex 9 0.25 "
         "9\nendloop\nendfacet\n"
         "endsolid plate\n";
  const std::string plate =
      "[[bodies]]\nsurface = \"stl\"\nfile = \"plate.stl\"\nvelocity = [0.3, 0, -0.2]\ncontact = "
      "\"slides\"\n";
  const std::string box = "[material]\nlow = [0.0, 0.25, 0.0]\nhigh = [2.0, 0.5, 1.5]\npoints_per_cell = 2\n";
  const std::string text = viscous_on_map(plate, "{law = \"sticks\", hold = \"pushes_and_pulls\"}", box);
  auto layer = simulation_on_map(with(with(text, "x_low = \"slip\"\nx_high = \"slip\"", "x = \"periodic\""),
                                      "z_low = \"slip\"\nz_high = \"slip\"", "z = \"periodic\""));

  while (layer.clock.time < 0.1) layer.step();

  EXPECT_NEAR(mean_velocity(layer, 0), 0.3, 0.3 * 1e-6);
  EXPECT_NEAR(mean_velocity(layer, 2), -0.2, 0.3 * 1e-6);
}

TEST(BodyScene, TurnsABallAboutItsCentre) {
  const auto body = [](const std::string& more) {
    return parse_scene(block_scene("[[bodies]]\nsurface = \"ball\"\ncentre = [0.2, 0.1]\nradius = 0.04\n"
                                   "contact = \"sticks\"\nangular_velocity = 2\n" +
                                       more,
                                   0),
                       "scene.toml")
        .scene.bodies.at(0);
  };

  EXPECT_EQ(body("").pivot, (std::vector<double>{0.2, 0.1}));
  EXPECT_EQ(body("pivot = [0, 0]\n").pivot, (std::vector<double>{0, 0}));
  EXPECT_NEAR(surface_of<2>(body(""))({0.2, 0.2}).distance, 0.06, 4 * round_off);
  EXPECT_NEAR(surface_of<2>(body("is_hollow = true\n"))({0.2, 0.11}).distance, 0.03, 4 * round_off);
}

/// The map is found beside the results, which read as the same scene.
TEST(SurroundingsOfAScene, GoWithTheResults) {
  const auto folder = folder_with_maps();
  const std::string text = scene_on_map(tilted_ground, small_box);
  RunOptions options;
  options.directory = folder / "results";
  options.is_quiet = true;
  std::filesystem::remove_all(options.directory);

  ASSERT_EQ(run_scene(parse_scene(text, (folder / "scene.toml").string(), {"time.end=0.001"}), options),
            Outcome::finished);

  const Scene again = read_scene(options.directory / "scene.toml", {}).scene;
  EXPECT_EQ(ground_of(again)({1, 0.5, 1}).distance,
            ground_of(read_on_map(tilted_ground, small_box))({1, 0.5, 1}).distance);
  EXPECT_NE(profile_csv(options.directory, std::nullopt, std::nullopt).find("y,velocity"), std::string::npos);
}

TEST(SurroundingsOfAScene, LeftOutAreNotThere) {
  const Simulation<2, 2> block{parse_scene(block_scene("", 0), "scene.toml").scene, {1}};

  EXPECT_EQ(block.stages().boundaries.size(), 2U);  // walls across y
  EXPECT_EQ(block.stages().leaving, mpm::Leaving::stop);
}

}  // namespace
}  // namespace scree::app::testing
