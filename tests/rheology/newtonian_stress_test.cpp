#include "derivative.hpp"
#include "points.hpp"

#include <scree/rheology/newtonian_stress.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

constexpr double reference_density = 1000;  // [kg/m^3]
constexpr double bulk_modulus = 2e6;        // [Pa]

TEST(Pressure, IsLinearInDensity) {  // Eq. (R1)
  EXPECT_EQ(pressure(1000.0, reference_density, bulk_modulus), 0);
  // rho/rho_0 is rounded three times, and 1 is taken from it: three roundings of K.
  const double tolerance = 3 * round_off * bulk_modulus;
  EXPECT_NEAR(pressure(1001.0, reference_density, bulk_modulus), 2000, tolerance);
  EXPECT_NEAR(pressure(999.0, reference_density, bulk_modulus), -2000, tolerance);
}

TEST(WaveSpeed, IsTheRootOfThePressuresDerivative) {  // Eq. (R2)
  const testing::Dual p = pressure(testing::Dual{1200, 1}, reference_density, bulk_modulus);

  const double speed = wave_speed(reference_density, bulk_modulus);

  EXPECT_NEAR(speed * speed, p.slope, 5 * round_off * p.slope);  // five operations
}

TEST(NewtonianStress, IsMinusThePressureAtRest) {  // Eq. (R3)
  EXPECT_EQ(newtonian_stress(Tensor<double>{}, 750.0, 300.0).components, isotropic(-300.0).components);
}

TEST(NewtonianStress, HasNoBulkViscosity) {  // Eq. (R3): the trace of D makes no stress
  EXPECT_EQ(newtonian_stress(isotropic(2.0), 750.0, 300.0).components, isotropic(-300.0).components);
}

TEST(NewtonianStress,
     VanishesAtTheFirstTension) {  // Eq. (R5): the threshold is p = 0, material at p = 0 holds
  Tensor<double> shear;
  shear(0, 1) = 4;

  EXPECT_EQ(newtonian_stress(shear, 750.0, 0.0)(0, 1), 3000);
  EXPECT_EQ(largest(newtonian_stress(shear, 750.0, -std::numeric_limits<double>::min())), 0);
}

}  // namespace
}  // namespace scree::rheology
