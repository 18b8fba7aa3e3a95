#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/walls/material_friction.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

TEST(MaterialFriction, RubsByItsShareOfTheMaterial) {  // Eq. (R164)
  const MaterialFriction wall{.share = 0.5};

  EXPECT_EQ(wall.traction(800.0, 3.0, {.friction = 0.5}), 200);
  EXPECT_EQ(wall.slowed(1.0, WallContact<double>{800, 1e-3}, {.friction = 0.5}), 1 - 0.2);
}

/// A wall that is all the material's bears exactly what material in steady shear puts on it: grains flow over
/// it without sliding, and slide as soon as the wall is smoother.
TEST(MaterialFriction, HoldsMaterialThatFlowsOverIt) {
  const MuOfI grains = typical<MuOfI>();
  const double pressure = 1000;
  const double dt_per_mass = 1e-6;  // [m/s/Pa]
  for (const double i : {0.01, 0.1, 1.0}) {
    const double friction = grains.friction(i);
    const double push =
        dt_per_mass * friction * pressure;  // speed that the flow gives to what lies on the wall

    EXPECT_EQ(
        MaterialFriction{.share = 1}.slowed(push, WallContact<double>{pressure, dt_per_mass}, {friction}), 0);
    EXPECT_GT(
        MaterialFriction{.share = 0.999}.slowed(push, WallContact<double>{pressure, dt_per_mass}, {friction}),
        0);
  }
}

/// Where it fails: it follows the material, so a wall beside grains without a yield stress holds nothing at
/// rest, and whatever the material forgets the wall forgets. A dry friction beside it (`Coulomb`) does not.
TEST(MaterialFriction, HoldsNothingWhereTheMaterialHasNoFriction) {
  const WallContact<double> contact{1000, 1e-6};

  EXPECT_EQ(MaterialFriction{.share = 1}.slowed(1e-9, contact, {.friction = 0}), 1e-9);
}

}  // namespace
}  // namespace scree::rheology
