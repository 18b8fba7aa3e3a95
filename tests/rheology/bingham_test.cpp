#include "inclined_layer.hpp"
#include "pipe_flow.hpp"
#include "points.hpp"
#include "zigzag.hpp"

#include <scree/rheology/laws/bingham.hpp>
#include <scree/rheology/laws/newtonian.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace scree::rheology {
namespace {

constexpr Bingham law{
    .viscosity = 750, .yield_stress = 1000, .regularisation_time = 100, .bulk_modulus = 1e7, .density = 1000};

TEST(Bingham, IsExactOnceYielded) {  // Eq. (R9): exp(-m gdot) is less than round-off from m gdot = 37 on
  EXPECT_EQ(stress(law, simple_shear(4), 1000.0)(0, 1), 1000 + 750 * 4);
}

/// Buckingham (1921): through a pipe flows (tau_w/4 K) (1 - 4 phi/3 + phi^4/3) pi R^3, with the share
/// phi = tau_y/tau_w of its radius that is a plug.
TEST(Bingham, FlowsThroughAPipeAsBuckinghamSays) {  // Eq. (R9)
  Bingham mud = law;
  mud.regularisation_time = 1e9;  // yielded at each rate that is looked at but zero, where nothing flows
  const int num_parts = 400;
  for (const double wall_rate : {0.1, 1.0, 100.0}) {
    const double wall_stress = mud.yield_stress + mud.viscosity * wall_rate;
    const double plug = mud.yield_stress / wall_stress;
    const double exact = wall_stress / (4 * mud.viscosity) * (1 - 4 * plug / 3 + std::pow(plug, 4) / 3);

    EXPECT_NEAR(pipe_flow(mud, wall_rate, num_parts), exact, error_of_pipe_flow(num_parts) * wall_rate);
  }
}

TEST(Bingham, HasAFiniteViscosityAtRest) {  // Eq. (R8)
  EXPECT_EQ(law.viscosity_at(0.0), 750 + 1000 * 100);
  for (const double rate : {1e-300, 1e-30, 1e-12}) {
    // 1 - x/2 to first order, and four roundings.
    EXPECT_NEAR(law.viscosity_at(rate), 100750, (100 * rate + 4 * round_off) * 100750);
  }
}

TEST(Bingham, IsNewtonianWithoutYieldStress) {
  Bingham without = law;
  without.yield_stress = 0;
  const Newtonian same{.viscosity = 750, .bulk_modulus = 1e7, .density = 1000};
  for (const auto& gradient : velocity_gradients()) {
    EXPECT_EQ(stress(without, gradient, 1001.0).components, stress(same, gradient, 1001.0).components);
  }
}

TEST(Bingham, CreepsBelowYieldAtThePredictedRate) {  // Eq. (R9)
  for (const double tau : {0.1, 1.0, 10.0}) {
    const double rate = shear_rate_at(law, tau, 1000, 1);

    const double predicted = tau / (750 + 1000 * 100);
    EXPECT_NEAR(rate, predicted, (100 * rate + 10 * round_off) * predicted);  // (1 - e^-x)/x = 1 - x/2 + ..
  }
}

/// Speed [m/s] at the height y of the steady layer, 1 m on 18 degrees, by the midpoint rule.
[[nodiscard]] double layer_speed(const Bingham& fluid, double y, int num_parts) {
  const double drive = 1000 * 9.81 * std::sin(18 * std::numbers::pi / 180);  // [Pa/m]
  const double dy = y / num_parts;
  double speed = 0;
  for (int i = 0; i < num_parts; ++i) {
    speed += dy * shear_rate_at(fluid, drive * (1 - (i + 0.5) * dy), fluid.density, 100);
  }
  return speed;
}

/// The yield surface is at y = 0.6701255884 m, the plug above it moves at 0.9075540843 m/s.
TEST(Bingham, MakesThePlugOfTheInclinedLayer) {
  const double drive = 1000 * 9.81 * std::sin(18 * std::numbers::pi / 180);
  const double yield_surface = 0.6701255884;
  const int num_parts = 2000;
  for (const double time : {1e4, 1e5}) {
    Bingham stiff = law;
    stiff.regularisation_time = time;
    const double plug = 1 - yield_surface;
    const double creep = plug / time;  // [m/s]: integral of -ln(1 - tau/tau_y)/m over the plug
    // The shear rate is a convex function of the stress whose slope lies in (0, 1/K): midpoint rule.
    const double quadrature = std::pow(yield_surface / num_parts, 2) * drive / (8 * 750);

    const double at_yield_surface = layer_speed(stiff, yield_surface, num_parts);
    const double at_surface = layer_speed(stiff, 1, num_parts);

    // Below the plug tau_y exp(-m gdot) is missing from the stress, whose integral is at most `creep` again.
    EXPECT_NEAR(at_yield_surface, 0.9075540843, creep + quadrature);
    EXPECT_NEAR(at_surface, 0.9075540843, 2 * creep + quadrature / (yield_surface * yield_surface));
  }
}

/// What the regularisation costs: the viscosity of the creep bounds the step, here 134 times shorter.
TEST(Bingham, ExplicitStepsBlowUpAboveTheLimitOfTheCreep) {  // Eqs. (R7), (R9)
  const double dx = 0.02;                                    // [m]
  const double limit = law.density * dx * dx / (2 * law.stiffness(Deformation<double>{}, {}, {}).viscosity);
  const double speed = 1e-12;  // [m/s]
  // The viscosity is less by x/2, and with it each of the 100 factors by x at most; x <= m 2 v/dx at its end.
  const double x = 100 * 2 * speed / dx * std::pow(1.02, 100);
  const double tolerance = 100 * x + 1000 * round_off;

  EXPECT_NEAR(zigzag_after(law, 100, 0.99 * limit, dx, speed), std::pow(0.98, 100), tolerance);
  EXPECT_NEAR(zigzag_after(law, 100, 1.01 * limit, dx, speed), std::pow(1.02, 100),
              tolerance * std::pow(1.02, 100));
}

}  // namespace
}  // namespace scree::rheology
