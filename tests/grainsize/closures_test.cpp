#include "every_closure.hpp"
#include "message_of.hpp"

#include <scree/grainsize/closures.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace scree::grainsize {
namespace {

using test::message_of;

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(ShearRate, DrivesCoarseGrainsTowardsLowerShear) {  // Eq. (G6)
  const ShearRate closure{0.05};

  EXPECT_EQ(closure.drive(4, 1e-3), 4);
  EXPECT_EQ(closure.velocity({.left = 4, .right = 2, .distance = 0.5, .gravity = 1}), 0.05 * 4);
}

TEST(ShearRate, NegativeConstantTurnsTheDirectionRound) {
  const FaceDrive face{.left = 4, .right = 2, .distance = 0.5, .gravity = 0};

  EXPECT_EQ(ShearRate{-0.05}.velocity(face), -ShearRate{0.05}.velocity(face));
}

TEST(SizeWeightedShearRate, WeighsTheShearRateOnThePoint) {  // Eq. (G7)
  const SizeWeightedShearRate closure{0.05, 0.5e-3};

  EXPECT_EQ(closure.drive(4, 1e-3), 8);
  EXPECT_EQ(closure.velocity({.left = 8, .right = 4, .distance = 0.5, .gravity = 1}), 0.05 * 8);
}

TEST(SizeWeightedShearRate, IsShearRateAtTheReferenceSize) {
  EXPECT_EQ((SizeWeightedShearRate{0.05, 1e-3}.drive(4, 1e-3)), ShearRate{0.05}.drive(4, 1e-3));
}

TEST(SizeWeightedShearRate,
     DoesNotDependOnSizeAtGivenStress) {  // gdot = tau/(M s_a): the drive is tau/(M s_ref)
  const SizeWeightedShearRate closure{0.05, 1e-3};
  const double stress_over_modulus = 4e-3;

  EXPECT_DOUBLE_EQ(closure.drive(stress_over_modulus / 0.5e-3, 0.5e-3),
                   closure.drive(stress_over_modulus / 1e-3, 1e-3));
}

TEST(Gravity, LiftsCoarseGrainsWhereTheMaterialShears) {  // Eq. (G8)
  const Gravity closure{0.01};
  const FaceDrive downward{.left = 4, .right = 2, .distance = 0.5, .gravity = 1};
  const FaceDrive level{.left = 4, .right = 2, .distance = 0.5, .gravity = 0};
  const FaceDrive at_rest{.left = 0, .right = 0, .distance = 0.5, .gravity = 1};

  EXPECT_EQ(closure.velocity(downward), -0.01 * 3);
  EXPECT_EQ(closure.velocity(level), 0);
  EXPECT_EQ(closure.velocity(at_rest), 0);
}

TEST(Closures, TurnWithTheFace) {  // the same face seen from its other side: B is a vector
  const FaceDrive face{.left = 4, .right = 2, .distance = 0.5, .gravity = 0.3};
  const FaceDrive reversed{.left = 2, .right = 4, .distance = 0.5, .gravity = -0.3};

  for (const AnyClosure& any : test::every_closure()) {
    std::visit([&](const auto& c) { EXPECT_EQ(c.velocity(reversed), -c.velocity(face)) << c.name; }, any);
  }
}

TEST(Closures, RefuseBadConstants) {
  EXPECT_EQ(message_of([] { ShearRate{infinite}; }), "ShearRate: c must be finite");
  EXPECT_EQ(message_of([] { Gravity{infinite}; }), "Gravity: c must be finite");
  EXPECT_EQ(message_of([] { SizeWeightedShearRate(infinite, 1e-3); }),
            "SizeWeightedShearRate: c must be finite");
  EXPECT_EQ(message_of([] { SizeWeightedShearRate(0.05, 0); }),
            "SizeWeightedShearRate: the reference size must be positive and finite");
}

}  // namespace
}  // namespace scree::grainsize
