// Walls that rub by a share of the material's friction: how far a slide runs out, what a silo bears.

#include <scree/rheology/walls/material_friction.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scree::rheology {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;           // [m/s^2]
constexpr double material_friction = 0.6;  // at yield [-]

/// A slab of 300 kg/m^2 that slides without deforming.
struct Slab {
  MaterialFriction wall;
  double speed = 0;     // [m/s]
  double distance = 0;  // along the ground [m]

  /// One step on ground that dips by `angle`. The speed is exact at the end of a step, and so is the
  /// distance by the trapezoidal rule, but in the step in which it stops.
  void step(double angle, double dt) {
    constexpr double mass = 300;  // per area [kg/m^2]
    const WallContact<double> contact{mass * gravity * std::cos(angle), dt / mass};
    const double before = speed;
    speed = wall.slowed(speed + dt * gravity * std::sin(angle), contact, {material_friction});
    distance += dt * (before + speed) / 2;
  }
};

/// Heim's energy line: from where it starts to where it stops, on level ground, a slab falls by the share of
/// its friction of what it goes along, whatever the slope between.
TEST(MaterialFriction, StopsASlideAtItsEnergyLine) {  // Eq. (R32)
  const double drop = 100;                            // [m]
  for (const double share : {0.4, 0.7, 1.0}) {
    const double friction = share * material_friction;
    for (const double angle : {35 * degree, 45 * degree, 60 * degree}) {
      Slab slab{.wall = {.share = share}};
      const double slope = drop / std::sin(angle);
      const double down = gravity * (std::sin(angle) - friction * std::cos(angle));  // [m/s^2]
      constexpr int num_steps = 500;
      const double dt = std::sqrt(2 * slope / down) / num_steps;

      for (int n = 0; n < num_steps; ++n) slab.step(angle, dt);
      const double on_slope = slab.distance;
      int num_level = 0;
      for (; slab.speed > 0; ++num_level) slab.step(0, dt);

      const double reach = on_slope * std::cos(angle) + slab.distance - on_slope;
      // Stopping from v in a part of a step the slab goes v^2/(2 a), not v dt/2: by a dt^2/8 at most. The
      // rest is rounding, ten operations a step.
      const double of_stop = friction * gravity * dt * dt / 8;
      const double of_rounding = 10 * (num_steps + num_level) * round_off * reach;
      EXPECT_NEAR(reach, drop / friction, of_stop + of_rounding) << share << ' ' << angle;
    }
  }
}

/// Where that fails: ground that dips less than the friction holds the slab, and there is no slide.
TEST(MaterialFriction, HoldsASlideBelowItsAngle) {  // Eq. (R32)
  for (const double share : {0.5, 1.0}) {
    const double critical = std::atan(share * material_friction);
    for (const double part : {0.999, 1.001}) {
      Slab slab{.wall = {.share = share}};

      for (int n = 0; n < 10; ++n) slab.step(part * critical, 0.1);

      EXPECT_EQ(slab.distance > 0, part > 1);
    }
  }
}

/// Vertical stress [Pa] at a depth in a silo of one metre across: its walls bear the share of the material's
/// friction of the horizontal stress, `lateral` times the vertical one. By Heun's method.
[[nodiscard]] double stress_in_silo(const MaterialFriction& wall, double lateral, double depth,
                                    int num_steps) {
  constexpr double weight = 1500 * gravity;  // [N/m^3]
  const double dz = depth / num_steps;
  const auto slope = [&](double vertical) {
    return weight - 4 * wall.traction(lateral * vertical, 0.0, {material_friction});
  };
  double vertical = 0;
  for (int n = 0; n < num_steps; ++n) {
    const double predicted = vertical + dz * slope(vertical);
    vertical += dz * (slope(vertical) + slope(predicted)) / 2;
  }
  return vertical;
}

/// Janssen's silo: the walls bear ever more of what is filled in.
TEST(MaterialFriction, BearsASiloAsJanssenFound) {  // Eq. (R33)
  const double lateral = 0.5;
  const double depth = 3;  // [m]
  for (const double share : {0.5, 1.0}) {
    const MaterialFriction wall{.share = share};
    const double rate = 4 * share * material_friction * lateral;  // [1/m]
    const double most = 1500 * gravity / rate;
    const double exact = most * (1 - std::exp(-rate * depth));
    const auto error = [&](int num_steps) { return stress_in_silo(wall, lateral, depth, num_steps) - exact; };

    // A step of Heun's leaves x^3/6 of e^-x, x = rate dz: over the depth exp(-rate depth) rate depth x^2/6.
    const double x = rate * depth / 100;
    EXPECT_NEAR(error(100), -most * std::exp(-rate * depth) * rate * depth * x * x / 6,
                2 * x * std::abs(error(100)));
    EXPECT_NEAR(std::log2(error(100) / error(200)), 2, 2 * x);  // the next term is of the order x of it
    EXPECT_LT(stress_in_silo(wall, lateral, 30, 1000), most);
  }
}

/// Where the walls are of no use: up to a depth of a tenth of the one that saturates, a tenth of D/(4 mu K),
/// they bear less than a twentieth of the weight.
TEST(MaterialFriction, BearsNextToNothingInAShallowSilo) {  // Eq. (R33)
  const MaterialFriction wall{.share = 1};
  const double depth = 0.1 / (4 * material_friction * 0.5);

  const double share = 1 - stress_in_silo(wall, 0.5, depth, 1000) / (1500 * gravity * depth);

  EXPECT_NEAR(share, 1 - (1 - std::exp(-0.1)) / 0.1, 1e-6);  // of the steps, x^2/6 with x = 1e-4
  EXPECT_LT(share, 0.05);
}

}  // namespace
}  // namespace scree::rheology
