#include <scree/rheology/walls/pouliquen_forterre.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace scree::rheology {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double grain_size = 0.5e-3;  // [m]

/// The glass beads of Forterre & Pouliquen (2003).
[[nodiscard]] PouliquenForterre beads() {
  return {.mu_1 = std::tan(20.9 * degree),
          .mu_2 = std::tan(32.76 * degree),
          .mu_3 = std::tan(22.2 * degree),
          .beta = 0.136,
          .length_per_size = 1.65,
          .weakening = 1e-3,
          .gravity = 9.81};
}

/// A uniform layer on a rough bed.
struct Layer {
  PouliquenForterre law = beads();
  double tangent = std::tan(25 * degree);  // of the slope
  double depth;                            // [m]
  double speed = 0;                        // [m/s]

  void run(int num_steps, double dt) {
    const double fall = law.gravity / std::hypot(1, tangent);  // g cos: pressure over density and depth
    for (int n = 0; n < num_steps; ++n) {
      speed = law.slowed(speed + dt * tangent * fall, WallContact<double>{fall, dt}, {depth, grain_size});
    }
  }
};

TEST(PouliquenForterre, StopsThinLayersOnSteeperSlopes) {  // Eqs. (R167), (R168)
  const PouliquenForterre law = beads();
  for (const double angle : {21.0, 25.0, 30.0, 32.0}) {
    const double depth = law.stopping_depth(std::tan(angle * degree), grain_size);

    EXPECT_NEAR(law.friction_at_stop<double>({depth, grain_size}), std::tan(angle * degree), 20 * round_off);
  }
  EXPECT_EQ(law.friction_at_stop<double>({0, grain_size}), law.mu_2);
}

/// Steady uniform flow has Fr = beta h/h_stop, whatever the grain size.
TEST(PouliquenForterre, FlowsSteadilyAtTheFroudeNumberOfItsDepth) {  // Eq. (R170)
  const PouliquenForterre law = beads();
  for (const double angle : {23.0, 25.0, 28.0}) {
    Layer layer{.tangent = std::tan(angle * degree),
                .depth = 3 * law.stopping_depth(std::tan(angle * degree), grain_size)};

    layer.run(200, 10);  // each step is far longer than the start-up: backward Euler falls to the steady flow

    const double froude = layer.speed / std::sqrt(law.gravity * layer.depth);
    // Some 40 operations make the friction, which changes with ln(Fr) by (tan - mu_1)(mu_2 - tan)/(mu_2 -
    // mu_1) > 0.03. What is left of the approach after 200 steps, each more than its time, is below 2^-200.
    EXPECT_NEAR(froude, law.beta * 3, 40 * round_off / 0.03) << angle;
  }
}

TEST(PouliquenForterre, FlowsAboveItsStoppingDepthAndStopsBelow) {  // Eq. (R168)
  const double h_stop = beads().stopping_depth(std::tan(25 * degree), grain_size);
  Layer thick{.depth = 1.02 * h_stop, .speed = 0.1};
  Layer thin{.depth = 0.98 * h_stop, .speed = 0.1};

  thick.run(10000, 1e-3);
  thin.run(10000, 1e-3);

  // As above; a disturbance decays at 28/s, by exp(-280).
  EXPECT_NEAR(thick.speed / std::sqrt(9.81 * thick.depth), 0.136 * 1.02, 40 * round_off / 0.03);
  EXPECT_EQ(thin.speed, 0);
}

/// Between the angles of stop and start a layer does what it did before.
TEST(PouliquenForterre, StaysAtRestWhereAMovingLayerFlows) {  // Eq. (R169)
  const PouliquenForterre law = beads();
  const PouliquenForterre::Input<double> input{5e-3, grain_size};
  const double between = (law.friction_at_stop(input) + law.friction_at_start(input)) / 2;
  Layer resting{.tangent = between, .depth = 5e-3};
  Layer moving{.tangent = between, .depth = 5e-3, .speed = 0.1};
  Layer started{.tangent = law.friction_at_start(input) * 1.001, .depth = 5e-3};
  Layer held{.tangent = law.friction_at_start(input) * 0.999, .depth = 5e-3};

  for (Layer* layer : {&resting, &moving, &started, &held}) layer->run(5000, 1e-3);

  EXPECT_EQ(resting.speed, 0);
  EXPECT_GT(moving.speed, law.beta * std::sqrt(law.gravity * moving.depth));
  EXPECT_GT(started.speed, law.beta * std::sqrt(law.gravity * started.depth));
  EXPECT_EQ(held.speed, 0);
}

TEST(PouliquenForterre, JoinsItsBranchesAtTheSlowestSteadyFlow) {  // Eqs. (R170), (R171)
  const PouliquenForterre law = beads();
  for (const double depth : {1e-3, 5e-3, 0.1}) {
    const PouliquenForterre::Input<double> input{depth, grain_size};
    const double slowest = law.beta * std::sqrt(law.gravity * depth);

    const double below = law.traction(1.0, slowest * (1 - 4 * round_off), input);
    const double above = law.traction(1.0, slowest * (1 + 4 * round_off), input);

    EXPECT_NEAR(below, law.friction_at_stop(input), 40 * round_off);
    EXPECT_NEAR(above, law.friction_at_stop(input), 40 * round_off);
  }
}

/// L = 1.65 s_a: coarser grains stop in proportion deeper. Sizes and depths of twice the length feel the
/// same.
TEST(PouliquenForterre, ScalesWithTheGrainSize) {
  const PouliquenForterre law = beads();
  const double tangent = std::tan(25 * degree);

  EXPECT_EQ(law.stopping_depth(tangent, 2 * grain_size), 2 * law.stopping_depth(tangent, grain_size));
  EXPECT_EQ(law.friction_at_stop<double>({2e-3, 2 * grain_size}),
            law.friction_at_stop<double>({1e-3, grain_size}));
}

TEST(PouliquenForterre, IsFiniteForALayerWithoutDepth) {
  const PouliquenForterre law = beads();
  const PouliquenForterre::Input<double> film{0, grain_size};

  EXPECT_EQ(law.traction(1.0, 0.0, film), law.friction_at_start(film));
  EXPECT_EQ(law.traction(1.0, 1.0, film), law.mu_2);
  EXPECT_EQ(law.slowed(0.1, WallContact<double>{1, 0.1}, film), 0.1 - 0.1 * law.mu_2);
  EXPECT_EQ(law.slowed(0.01, WallContact<double>{1, 0.1}, film), 0);
}

/// Friction that falls with speed has more than one answer to a step; the law takes the moving one as soon as
/// the start is passed, which is a jump of the speed by as much as the step gains on the friction of the
/// stop. Shorter steps make it small: this is where a step is too long for a layer that is about to start.
TEST(PouliquenForterre, StartsWithAJumpInProportionToTheStep) {
  const PouliquenForterre law = beads();
  const PouliquenForterre::Input<double> input{5e-3, grain_size};
  for (const double dt : {1e-2, 1e-3, 1e-4}) {
    const double held = dt * law.friction_at_start(input);
    const WallContact<double> contact{1, dt};

    EXPECT_EQ(law.slowed(held, contact, input), 0);
    const double jump = law.slowed(held * (1 + 1e-9), contact, input);

    // With exponent 1e-3 all but 1e-3 ln(slowest/jump) < 2 % of the fall is done at the smallest speed here.
    EXPECT_NEAR(jump, dt * (law.mu_3 - law.mu_1), 0.02 * dt * (law.mu_3 - law.mu_1)) << dt;
  }
}

}  // namespace
}  // namespace scree::rheology
