// Scenes of flow round an axis of symmetry.

#include "scenes.hpp"
#include "scree/simulation.hpp"

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
  EXPECT_EQ(message_of({round, "numerics.order=musl"}),
            "--set numerics.order=musl: flow round an axis takes \"usl\", without means over cells");
  EXPECT_EQ(
      message_of({round, "mesh.velocity_components=3"}),
      "--set mesh.symmetry=axisymmetric: flow round an axis takes 2 dimensions and 2 components of velocity");
}

}  // namespace
}  // namespace scree::app::testing
