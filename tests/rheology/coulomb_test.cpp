#include <scree/rheology/walls/coulomb.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace scree::rheology {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // [m/s^2]

/// A block of one kilogramme on a square metre of a plane that dips by `angle`, after one step.
[[nodiscard]] Vector<3> step(const Coulomb& plane, const Vector<3>& velocity, double angle, double dt) {
  const Vector<3> pull = gravity * Vector<3>{std::sin(angle), -std::cos(angle), 0};
  return slide<3>(plane, velocity + dt * pull, Vector<3>::UnitY(), dt, {});
}

TEST(Coulomb, RubsInProportionToPressure) {  // Eq. (R163)
  const Coulomb plane{.friction = 0.25};

  EXPECT_EQ(plane.traction(800.0, 3.0, {}), 200);
  EXPECT_EQ(plane.traction(800.0, 0.0, {}), 200);
  EXPECT_EQ(plane.traction(0.0, 3.0, {}), 0);
}

TEST(Coulomb, LetsABlockSlideAtItsConstantAcceleration) {  // g (sin - mu cos)
  const Coulomb plane{.friction = 0.1};
  const double angle = 30 * degree;
  Vector<3> velocity = Vector<3>::Zero();

  constexpr int num_steps = 100;
  for (int n = 0; n < num_steps; ++n) velocity = step(plane, velocity, angle, 0.01);

  const double acceleration = gravity * (std::sin(angle) - 0.1 * std::cos(angle));
  EXPECT_NEAR(velocity[0], acceleration, 10 * num_steps * round_off * acceleration);
  EXPECT_NEAR(acceleration, 4.05543, 5e-6);  // as printed
  EXPECT_EQ(velocity[1], 0);
}

/// The block moves down a plane of 24 degrees with friction tan 15 by 19.86 m in 5 s; velocities are exact at
/// the ends of steps, so that the trapezoidal rule is exact.
TEST(Coulomb, LetsABlockSlideAsFarAsItShould) {
  const Coulomb plane{.friction = std::tan(15 * degree)};
  const double dt = 0.05;
  Vector<3> velocity = Vector<3>::Zero();
  double distance = 0;

  for (int n = 0; n < 100; ++n) {
    const double before = velocity[0];
    velocity = step(plane, velocity, 24 * degree, dt);
    distance += dt * (before + velocity[0]) / 2;
  }

  const double exact = gravity * (std::sin(24 * degree) - plane.friction * std::cos(24 * degree)) * 25 / 2;
  EXPECT_NEAR(distance, exact, 10 * 100 * round_off * exact);
  EXPECT_NEAR(distance, 19.86, 5e-3);  // as printed
}

TEST(Coulomb, HoldsABlockBelowItsAngleAndLetsItGoAbove) {
  const Coulomb plane{.friction = std::tan(24 * degree)};

  EXPECT_EQ(step(plane, Vector<3>::Zero(), 23.999 * degree, 0.1), Vector<3>::Zero());
  EXPECT_GT(step(plane, Vector<3>::Zero(), 24.001 * degree, 0.1)[0], 0);
}

TEST(Coulomb, StopsABlockWhereItMustAndKeepsItThere) {  // after v/(mu g) on level ground
  const Coulomb plane{.friction = 0.25};
  const double time = 2 / (0.25 * gravity);
  Vector<3> velocity{1.2, 0, 1.6};

  for (int n = 0; n < 99; ++n) velocity = step(plane, velocity, 0, time / 100);
  EXPECT_NEAR(velocity.norm(), 0.02, 10 * 100 * round_off * 2);
  EXPECT_NEAR(velocity[2] / velocity[0], 4.0 / 3, 1000 * round_off);
  for (int n = 0; n < 2; ++n) velocity = step(plane, velocity, 0, time / 100);

  EXPECT_EQ(velocity, Vector<3>::Zero());
}

TEST(Coulomb, DoesNoWorkWithoutFriction) {
  const Vector<3> along{3, 0, -4};

  EXPECT_EQ(slide<3>(Coulomb{.friction = 0}, along + Vector<3>{0, -2, 0}, Vector<3>::UnitY(), 1e-3, {}),
            along);
}

/// An explicit step that takes the whole of mu g dt reverses a block slower than that: it shakes for ever.
TEST(Coulomb, WouldShakeWithoutItsStop) {
  const Coulomb plane{.friction = 0.25};
  const double dt = 0.01;
  const double loss = dt * plane.traction(gravity, 0.0, {});
  const auto explicit_step = [&](double v) { return v - std::copysign(loss, v); };

  EXPECT_GT(explicit_step(1.01 * loss), 0);
  EXPECT_LT(explicit_step(0.99 * loss), 0);
  EXPECT_GT(explicit_step(explicit_step(0.99 * loss)), 0);
  EXPECT_EQ(plane.slowed(0.99 * loss, WallContact<double>{gravity, dt}, {}), 0);
}

}  // namespace
}  // namespace scree::rheology
