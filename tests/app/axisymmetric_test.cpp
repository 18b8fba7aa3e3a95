// Scenes of flow round an axis of symmetry.

#include "scenes.hpp"
#include "scree/assemble/make_stages.hpp"
#include "scree/run/coupling.hpp"
#include "scree/run/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::app::testing {
namespace {

constexpr const char* round = "mesh.symmetry=axisymmetric";

[[nodiscard]] std::string message_of(const std::vector<std::string>& overrides) {
  try {
    static_cast<void>(scene_of("granular_column_collapse", overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(AxisymmetricScene, HasTheMassOfARadianOfTheColumnAndKeepsIt) {
  Simulation<2, 2> simulation{scene_of("granular_column_collapse", {round}), {1}};
  const auto mass = [&] {
    double sum = 0;
    for (const double m : simulation.state.particles.mass.values()) sum += m;
    return sum;
  };
  const double first = mass();
  // rho R^2/2 H, denser below by rho g z/K: by less than rho g H/K = 3e-3.
  EXPECT_NEAR(first, 1500 * 0.5 * 0.1 * 0.1 * 0.2, 3e-3 * 1.5);

  for (int n = 0; n < 50; ++n) simulation.step();

  EXPECT_EQ(mass(), first);
}

TEST(AxisymmetricScene, IsRefusedWhatKnowsPlaneFlowsOnly) {
  EXPECT_EQ(message_of({round, "boundaries.x_low=no_slip"}),
            "--set boundaries.x_low=no_slip: the axis of symmetry must be \"slip\"");
  EXPECT_EQ(message_of({round, "gravity.slope_degrees=10"}),
            "--set gravity.slope_degrees=10: flow round an axis has none");
  EXPECT_EQ(message_of({round, "numerics.shape=linear", "numerics.viscosity=implicit"}),
            "--set numerics.viscosity=implicit: is explicit in flow round an axis");
  EXPECT_EQ(message_of({round, "numerics.order=musl"}),
            "--set numerics.order=musl: flow round an axis takes \"usl\", without means over cells");
  EXPECT_EQ(
      message_of({round, "mesh.velocity_components=3"}),
      "--set mesh.symmetry=axisymmetric: flow round an axis takes 2 dimensions and 2 components of velocity");
}

/// A pipe of 0.4 m under a wall, on a terrain at 0.1 m, with a piston from 0.3 m on above it; all drag with
/// 1000 Pa s^2/m^2 times the square of the speed.
[[nodiscard]] Scene pipe_with_drag(const std::string& motion = "") {
  const std::string law = R"({law = "voellmy", friction = 0, turbulence = 10, density = 1000, gravity = 10})";
  return parse_scene(R"([mesh]
dimensions = 2
size = [0.4, 0.4]
cells = 4
symmetry = "axisymmetric"
[boundaries]
x_low = "slip"
x_high = )" + law + R"(
y_low = "slip"
y_high = "slip"
[material]
low = [0.0, 0.1]
high = [0.4, 0.2]
[rheology]
law = "newtonian"
viscosity = 1
bulk_modulus = 1e6
density = 1000
[time]
end = 0.1
[terrain]
surface = "plane"
point = [0.0, 0.1]
normal = [0.0, 1.0]
contact = )" + law + R"(
[[bodies]]
surface = "plane"
point = [0.0, 0.3]
normal = [0.0, -1.0]
contact = )" + law + "\n" +
                         motion,
                     "scene.toml")
      .scene;
}

/// The area over which the drag slows a node of 1 kg that slides at 1 m/s and presses, for 1 s.
[[nodiscard]] double felt_area(const mpm::Boundary<2>& boundary, const CartesianGrid<2>& grid,
                               const Indices<2>& site, int along, double push) {
  mpm::Nodes<2> nodes{grid, {.num_velocities = 2, .has_increment = false}};
  double* node = nodes[nodes.place(site[0], 0) * nodes.stride(0) + nodes.place(site[1], 1) * nodes.stride(1)];
  node[mpm::NodeRecord::mass] = 1;
  node[mpm::NodeRecord::momentum + along] = 1;
  node[mpm::NodeRecord::momentum + 1 - along] = push;
  boundary.hold(nodes, 1);
  const double left = node[mpm::NodeRecord::momentum + along];
  return (1 - left) / (1000 * left * left);
}

TEST(AxisymmetricScene, GivesGroundBodiesAndWallsTheAreasOfARadian) {  // Eqs. (M175)-(M177)
  const Scene scene = pipe_with_drag();
  const auto grid = make_grid<2>(scene);
  const auto boundaries = make_boundaries<2, 2>(scene, grid, ground_of<2>(scene), 1, {});
  const double rounding = 1e-12;  // some dozen round-offs of 1, over 1 - left >= 0.01

  EXPECT_NEAR(felt_area(*boundaries[0], grid, {2, 1}, 0, -1), 0.2 * 0.1, rounding);  // ground
  EXPECT_NEAR(felt_area(*boundaries[1], grid, {3, 3}, 0, 1), 0.3 * 0.1, rounding);   // the piston
  EXPECT_NEAR(felt_area(*boundaries[3], grid, {4, 2}, 1, 1), 0.4 * 0.1, rounding);   // x_high
}

/// The bounds of every run with segregation, here round an axis.
TEST(AxisymmetricScene, KeepsClassMassesBoundsAndSumsWhileGrainsSegregate) {  // Eq. (M180)
  for (const std::string volumes : {"cells", "nodes"}) {
    Simulation<2, 2> simulation{
        scene_of("granular_column_collapse",
                 {round, "mesh.cells=12", "grains.diameters=[1e-3, 3e-3]", "grains.fractions=[0.5, 0.5]",
                  "segregation.closure=shear_rate", "segregation.c=0.001", "segregation.remixing=1e-4",
                  "segregation.control_volumes=" + volumes}),
        {1}};

    while (simulation.clock.time < 0.2) simulation.step();

    FractionExtremes found;
    observe_fractions(simulation.state.particles, found);
    EXPECT_GE(found.lowest, -1e-14);
    EXPECT_LE(found.highest, 1 + 1e-14);
    EXPECT_LE(found.sum_error, 1e-13);
    EXPECT_GT(found.highest, 0.51);  // they do segregate
    const auto masses = class_masses(simulation.state.particles);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(masses[k] / simulation.tally.first_class_masses[k], 1, 1e-12);
    }
  }
}

TEST(AxisymmetricScene, KeepsBodiesBodiesOfRevolution) {
  const auto message = [](const std::string& motion) -> std::string {
    try {
      static_cast<void>(pipe_with_drag(motion));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(
      message("velocity = [0.1, 0.0]\n"),
      "scene.toml:31: [bodies 1] velocity = [0.1, 0.0]: must lie along y: round an axis of symmetry a body "
      "does not move away from it");
  EXPECT_EQ(
      message("angular_velocity = 1\n"),
      "scene.toml:31: [bodies 1] angular_velocity = 1: must be 0: round an axis of symmetry a body does "
      "not turn");
  EXPECT_EQ(
      message("times = [0, 1]\nx = [0.0, 0.1]\n"),
      "scene.toml:32: [bodies 1] x = [0.0, 0.1]: must be left out: round an axis of symmetry a body does not "
      "move away from it");
}

}  // namespace
}  // namespace scree::app::testing
