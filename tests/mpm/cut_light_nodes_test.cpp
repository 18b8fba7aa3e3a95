// Points close to a wall with friction, which cuts shape functions off: the node inside is light.

#include "cut_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace scree::mpm {
namespace {

/// The excess of density, times h/dt, of a point at rest beside a wall whose node is held, after `num_steps`;
/// 1 at first. With u of the node inside: u = v + (C^2/s) eta, eta falls by u, v = s u; under apic v is u.
[[nodiscard]] double predicted_excess(bool is_apic, double place, double courant, int num_steps) {
  double velocity = 0;
  double excess = 1;
  for (int n = 0; n < num_steps; ++n) {
    const double inside = velocity + courant * courant / place * excess;
    excess -= inside;
    velocity = is_apic ? inside : place * inside;
  }
  return excess;
}

/// The shear rate [1/s] that a step leaves a lone layer `place` spacings from the wall, of 1/s and `speed`
/// [m/s], where nodes lighter than `floor` of it take no part.
[[nodiscard]] double shear_left(double place, double floor, double speed) {
  Layers layer{{place}, Quadratic{}, Apic{}, false};
  layer.state.mass_floor = floor;
  layer.state.particles.velocity.component(1)[0] = speed;
  layer.shear_rate(0) = 1;
  layer.advance(1);
  return layer.shear_rate(0);
}

/// The node inside has the share s of the layer's mass, as the difference of two that are not small: its
/// velocity is rounded by 1/s, and the gradient alike: n/s roundings, n <= 12 from above, and found to be
/// 0.2.
TEST(CutShapes, RoundTheVelocityOfALightNodeByItsMass) {  // Eq. (M196)
  constexpr double speed = 1 / Layers::h;                 // [m/s], beside which that of the shear is small
  std::mt19937 random{7};
  std::uniform_real_distribution<double> draw{1, 2};
  for (const double place : {1e-6, 1e-9, 1e-12}) {
    double most = 0;  // [roundings]
    for (int trial = 0; trial < 50; ++trial) {
      const double s = place * draw(random);
      const double error = std::abs(shear_left(s, 0, speed) - 1) * Layers::h / speed;
      most = std::max(most, error * s / round_off);
    }
    EXPECT_LE(most, 12);
    EXPECT_GE(most, 0.01);
  }
}

/// Where the floor fails: the node inside of a lone layer that close to the wall is dropped, and stands
/// still.
TEST(CutShapes, ShearALayerBySpeedOverSpacingIfItsLightNodeIsDropped) {  // Eqs. (M20), (M196)
  constexpr double floor = 1e-10;
  constexpr double speed = 2;  // [m/s]
  const auto rounding = [](double place) { return 12 * round_off / place * speed / Layers::h; };

  EXPECT_NEAR(shear_left(0.95 * floor, floor, speed), -speed / Layers::h, 4 * floor * speed / Layers::h);
  EXPECT_NEAR(shear_left(1.05 * floor, floor, speed), 1, rounding(1.05 * floor));
  EXPECT_NEAR(shear_left(0.95 * floor, floor / 10, speed), 1, rounding(0.95 * floor));  // the remedy
}

/// Where it fails: cut off, quadratic shapes are hats, and the node inside is light beside the wall.
TEST(CutShapes, OverturnAPointBesideTheWall) {  // Eq. (M186)
  constexpr Fluid air{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};
  constexpr double courant = 0.5;
  constexpr double disturbance = 1e-9;
  constexpr int num_steps = 25;
  const double dt = courant * Layers::h / 10;  // 10 m/s is the speed of sound
  for (const bool is_apic : {true, false}) {
    const double threshold = is_apic ? courant * courant / 4 : (std::sqrt(1 + 2 * courant * courant) - 1) / 2;
    for (const double share : {0.95, 1.05}) {
      const AnyTransfer rule = is_apic ? AnyTransfer{Apic{}} : AnyTransfer{PicFlip{1}};
      Layers layer{{share * threshold}, Quadratic{}, rule, false, air, Hold::pushes_and_pulls};
      double& density = layer.state.particles.density.component(0)[0];
      density *= 1 + disturbance;

      for (int n = 0; n < num_steps; ++n) step(layer.state, layer.stages, dt, {1});

      // The disturbance is rounded to round_off/1e-9 in each step, and linear to its size.
      const double expected = predicted_excess(is_apic, share * threshold, courant, num_steps);
      EXPECT_NEAR((density / 1000 - 1) / disturbance, expected,
                  (num_steps * 1e-6 + disturbance * std::abs(expected)) * (1 + std::abs(expected)));
      const double bound = 1 / std::sqrt(1 - 1 / 1.05);  // a swing between the limits, 1.05 of one away
      EXPECT_EQ(std::abs(expected) > bound, share < 1) << expected;
    }
  }
}

/// The remedy: where C = 0.5 overturns a point, a smaller share of (M17) does not, C < 2 s^(1/2) under apic
/// and (2 s (1 + s))^(1/2) under FLIP.
TEST(CutShapes, LeaveAPointBesideTheWallInPlaceInShorterSteps) {  // Eq. (M186)
  constexpr Fluid air{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};
  constexpr double disturbance = 1e-9;
  constexpr double place = 0.03;
  constexpr int num_steps = 15;
  for (const bool is_apic : {true, false}) {
    const double limit = is_apic ? 2 * std::sqrt(place) : std::sqrt(2 * place * (1 + place));
    ASSERT_LT(1.05 * limit, 0.5);
    for (const double share : {0.95, 1.05}) {
      const AnyTransfer rule = is_apic ? AnyTransfer{Apic{}} : AnyTransfer{PicFlip{1}};
      Layers layer{{place}, Quadratic{}, rule, false, air, Hold::pushes_and_pulls};
      double& density = layer.state.particles.density.component(0)[0];
      density *= 1 + disturbance;
      const double courant = share * limit;
      const double dt = courant * Layers::h / 10;  // 10 m/s is the speed of sound

      for (int n = 0; n < num_steps; ++n) step(layer.state, layer.stages, dt, {1});

      const double expected = predicted_excess(is_apic, place, courant, num_steps);
      EXPECT_NEAR((density / 1000 - 1) / disturbance, expected,
                  (num_steps * 1e-6 + disturbance * std::abs(expected)) * (1 + std::abs(expected)));
      const double bound = 1 / std::sqrt(1 - 0.95 * 0.95);  // a swing between the limits, 0.95 of one
      EXPECT_EQ(std::abs(expected) > bound, share > 1) << expected;
    }
  }
}

}  // namespace
}  // namespace scree::mpm
