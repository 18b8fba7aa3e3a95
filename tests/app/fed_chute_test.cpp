// A thin stream down a wall with friction, end to end.

#include "scenes.hpp"
#include "scree/run/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace scree::app::testing {
namespace {

constexpr double slope = 26 * std::numbers::pi / 180;
constexpr double gravity = 9.81;  // [m/s^2]

/// After 0.6 s, before grains reach the end of the chute.
[[nodiscard]] Simulation<2, 2> chute_under(const std::string& shape) {
  std::vector<std::string> keys{"numerics.shape=\"" + shape + "\"", "time.end=0.6"};
  if (shape == "gimp") keys.emplace_back("numerics.points_per_axis=3");
  Simulation<2, 2> chute{scene_of("fed_chute", keys), {1}};
  advance_to_end(chute);
  return chute;
}

[[nodiscard]] double front(const Simulation<2, 2>& chute) {
  const auto& particles = chute.state.particles;
  double x = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    if (particles.mass.component(0)[p] > 0) x = std::max(x, particles.position.component(0)[p]);
  }
  return x;
}

/// Points that slide shear themselves apart under shapes that reach past the wall unless what comes home has
/// the speed of its place, (M183): then the run was lost at 0.26 s. No grain may be faster than without
/// friction: by what it has fallen, from the surface of the stream at most.
TEST(FedChute, HoldsUnderEveryShape) {
  const double reached = front(chute_under("linear"));
  for (const std::string shape : {"quadratic", "cubic", "gimp"}) {
    const Simulation<2, 2> chute = chute_under(shape);

    EXPECT_NEAR(front(chute), reached, 2 * chute.grid().spacing()[0]) << shape;  // two supports of a front
    const auto& particles = chute.state.particles;
    for (Index p = 0; p < particles.size(); ++p) {
      const double x = particles.position.component(0)[p];
      const double u = particles.velocity.component(0)[p];
      const double v = particles.velocity.component(1)[p];
      const double fallen = x * std::sin(slope) + 0.04 * std::cos(slope);  // [m]
      EXPECT_LE(u * u + v * v, 0.4 * 0.4 + 2 * gravity * fallen) << shape;
    }
  }
}

}  // namespace
}  // namespace scree::app::testing
