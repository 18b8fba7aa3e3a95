#include <scree/rheology/walls/voellmy.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace scree::rheology {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Two metres of snow on a slope of 35 degrees.
struct Slab {
  Voellmy law = typical<Voellmy>();
  double depth = 2;  // [m]
  double angle = 35 * degree;

  [[nodiscard]] double pull() const { return law.gravity * std::sin(angle); }
  [[nodiscard]] double pressure() const { return law.density * law.gravity * depth * std::cos(angle); }
  [[nodiscard]] double net_pull() const { return pull() - law.gravity * law.friction * std::cos(angle); }
  /// sqrt(xi h (sin - mu cos)) [m/s]
  [[nodiscard]] double terminal_speed() const {
    return std::sqrt(law.turbulence * depth * net_pull() / law.gravity);
  }
  /// v_t/(g (sin - mu cos)) [s]
  [[nodiscard]] double time() const { return terminal_speed() / net_pull(); }
  [[nodiscard]] double mobility(double dt) const { return dt / (law.density * depth); }

  [[nodiscard]] double step(double speed, double dt) const {
    return law.slowed(speed + dt * pull(), WallContact<double>{pressure(), mobility(dt)}, {});
  }
  [[nodiscard]] double explicit_step(double speed, double dt) const {
    return speed + dt * pull() - mobility(dt) * law.traction(pressure(), speed, {});
  }
};

TEST(Voellmy, AddsAFrictionAndADrag) {  // Eq. (R165)
  const Voellmy law{.friction = 0.2, .turbulence = 1000, .density = 500, .gravity = 10};

  EXPECT_EQ(law.traction(3000.0, 0.0, {}), 600);
  EXPECT_EQ(law.traction(0.0, 20.0, {}), 2000);
  EXPECT_EQ(law.traction(3000.0, 20.0, {}), 2600);
}

TEST(Voellmy, KeepsTheTerminalSpeedWhateverTheStep) {
  const Slab slab;
  const double exact = slab.terminal_speed();
  for (const double dt : {1e-3, 1.0, 1e3}) {
    // The speed after the pull is larger by dt pull, and rounded in proportion to it.
    const double rounding = 20 * round_off * (exact + dt * slab.pull());
    EXPECT_NEAR(slab.step(exact, dt), exact, rounding) << dt;
  }
}

/// From rest, v = v_t tanh(t/T). Halving the step halves the error: the first order of backward Euler.
TEST(Voellmy, SpeedsUpAsTheExactSolution) {  // Eq. (R166)
  const Slab slab;
  const double end = slab.time();
  const auto error_of = [&](int num_steps) {
    double speed = 0;
    for (int n = 0; n < num_steps; ++n) speed = slab.step(speed, end / num_steps);
    return std::abs(speed - slab.terminal_speed() * std::tanh(1.0));
  };

  const double coarse = error_of(500);
  const double fine = error_of(1000);

  // dt/T of the speed is the size of a first-order error; the rate is off by as much.
  EXPECT_LT(fine, slab.terminal_speed() / 1000);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 2.0 / 500);
}

TEST(Voellmy, RunsOutToAStopOnLevelGround) {
  Slab slab;
  slab.angle = 0;
  double speed = 30;
  // dv/dt = -mu g - g v^2/(xi h) stops after sqrt(xi h/mu)/g atan(v_0/sqrt(mu xi h)).
  const double root = std::sqrt(slab.law.friction * slab.law.turbulence * slab.depth);
  const double exact = root / (slab.law.friction * slab.law.gravity) * std::atan(speed / root);
  const double dt = exact / 1000;

  int num_steps = 0;
  while (speed > 0) {
    speed = slab.step(speed, dt);
    ++num_steps;
  }

  // A step counts its time by the slower slowing f at its end: in all by ln(f_first/f_last)/2 steps too much,
  // 0.44 here; and the last step is not used whole.
  EXPECT_NEAR(num_steps, 1000, 0.5 * std::log1p(30 * 30 / (root * root)) + 1);
}

/// Explicit steps: drag alone reverses what is faster than 1/(dt k), k = g/(xi h), and about the terminal
/// speed a disturbance is multiplied by 1 - 2 dt/T: it grows from dt = T on.
TEST(Voellmy, OvershootsByExplicitStepsAboveThePredictedLimit) {
  Slab slab;
  slab.law.friction = 0;
  slab.angle = 0;
  const double speed = 50;
  const double limit = slab.law.turbulence * slab.depth / (slab.law.gravity * speed);

  EXPECT_GT(slab.explicit_step(speed, 0.99 * limit), 0);
  EXPECT_LT(slab.explicit_step(speed, 1.01 * limit), 0);
  EXPECT_GT(slab.step(speed, 1000 * limit), 0);  // the remedy
}

TEST(Voellmy, SwingsByExplicitStepsLongerThanItsTime) {
  const Slab slab;
  const double terminal = slab.terminal_speed();
  const double disturbance = 1e-6 * terminal;
  const auto growth = [&](double dt) {
    return (slab.explicit_step(terminal + disturbance, dt) - terminal) / disturbance;
  };

  // Second order in the disturbance, and rounding of some ten operations on the speed over it.
  const double tolerance = 2e-6 + 20 * round_off / 1e-6;
  EXPECT_NEAR(growth(0.99 * slab.time()), 1 - 2 * 0.99, tolerance);
  EXPECT_NEAR(growth(1.01 * slab.time()), 1 - 2 * 1.01, tolerance);
  const double remedy = slab.step(terminal + disturbance, 1000 * slab.time());
  EXPECT_LE(std::abs(remedy - terminal), disturbance);
}

}  // namespace
}  // namespace scree::rheology
