// Dry grains down a slope, end to end: Bagnold's profile in closed form.

#include "scenes.hpp"
#include "scree/run/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::app::testing {
namespace {

/// Largest |u - u_exact| over the exact surface speed of 2.642217862 m/s.
[[nodiscard]] double bagnold_error(const Simulation<1, 2>& simulation) {
  const double height = 0.1;                 // [m]
  const double surface_speed = 2.642217862;  // [m/s]
  const auto& particles = simulation.state.particles;
  double error = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    const double depth = std::max(1 - particles.position.component(0)[p] / height, 0.0);
    const double exact = surface_speed * (1 - std::pow(depth, 1.5));
    error = std::max(error, std::abs(particles.velocity.component(1)[p] - exact) / surface_speed);
  }
  return error;
}

/// In the topmost cell neither pressure nor shear rate is resolved: an error of gdot dx there, which is
/// 1.5 (dx/H)^1.5 of the surface speed 2/3 (I/d) sqrt(nu g cos) H^1.5. Compression by rho g H/K comes to
/// that; of the start exp(-40/4.4) is left.
TEST(GranularSlope, MakesBagnoldsProfile) {
  Simulation<1, 2> column{scene_of("granular_slope_column"), {1}};

  advance_to_end(column);

  const double compression = 1500 * 9.81 * std::cos(24 * std::numbers::pi / 180) * 0.1 / 2e6;  // [-]
  EXPECT_LE(bagnold_error(column),
            1.5 * std::pow(column.grid().spacing()[0] / 0.1, 1.5) + compression + 1e-4);
}

/// I = 0.089 is well-posed; in the topmost cell, where neither pressure nor shear rate is resolved, it may be
/// anything.
TEST(GranularSlope, IsIllPosedAtMostInTheTopmostCell) {  // Eq. (R15)
  Simulation<1, 2> column{scene_of("granular_slope_column"), {1}};

  advance_to_end(column);

  const auto share = column.ill_posed_share();
  ASSERT_TRUE(share.has_value());
  EXPECT_LE(*share, column.grid().spacing()[0] / 0.1);
}

/// No viscous limit: all steps are bound by sound or by the flow itself.
TEST(GranularSlope, HasNoViscousLimit) {
  Simulation<1, 2> column{scene_of("granular_slope_column", {"time.end=0.1"}), {1}};

  advance_to_end(column);

  EXPECT_EQ(column.tally.steps_by_limit[static_cast<std::size_t>(mpm::Limit::viscous)], 0);
}

}  // namespace
}  // namespace scree::app::testing
