#include "points.hpp"

#include <scree/rheology/stress_measures.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace scree::rheology {
namespace {

[[nodiscard]] Tensor<double> principal(double xx, double yy, double zz) {
  return {{xx, 0, 0, 0, yy, 0, 0, 0, zz}};
}

TEST(StressMeasures, AreThoseOfTheTriaxialTest) {  // Eq. (R26)
  const Tensor<double> compression = principal(-100, -400, -100);

  EXPECT_DOUBLE_EQ(mean_pressure(compression), 200);
  EXPECT_DOUBLE_EQ(deviatoric_stress(compression), 300);
}

TEST(StressMeasures, ShearStressIsDeviatoricStressOverTheRootOfThree) {
  Tensor<double> shear = isotropic(-50.0);
  shear(0, 1) = shear(1, 0) = 20;

  EXPECT_NEAR(deviatoric_stress(shear), 20 * std::sqrt(3.0), 100 * round_off);  // some ten operations on 20
}

TEST(StressMeasures, LodeAngleTellsCompressionShearAndExtension) {
  // cos(3 theta) is within some 40 operations of +-1, where the angle is the root of twice that, over 3.
  const double at_the_ends = std::sqrt(2 * 40 * round_off) / 3;

  EXPECT_NEAR(lode_angle(principal(-1, -4, -1)), 0, at_the_ends);
  EXPECT_NEAR(lode_angle(principal(-1, -2, -3)), std::numbers::pi / 6, 40 * round_off);
  EXPECT_NEAR(lode_angle(principal(-4, -1, -4)), std::numbers::pi / 3, at_the_ends);
}

TEST(StressMeasures, DoNotDependOnTheAxes) {
  const Tensor<double> stress = principal(-1, -2, -5);

  const Tensor<double> turned = rotated(stress);

  EXPECT_NEAR(mean_pressure(turned), mean_pressure(stress), 5 * 60 * round_off);  // as in IsObjective
  EXPECT_NEAR(deviatoric_stress(turned), deviatoric_stress(stress), 5 * 60 * round_off);
  EXPECT_NEAR(lode_angle(turned), lode_angle(stress), 5 * 60 * round_off);
}

TEST(StressMeasures, PressureAloneHasNoLodeAngle) {
  EXPECT_EQ(lode_angle(isotropic(-3.0)), 0);
}

TEST(StressMeasures, DoNotHideANan) {
  const Tensor<double> broken = principal(std::numeric_limits<double>::quiet_NaN(), 0, 0);

  EXPECT_TRUE(std::isnan(mean_pressure(broken)));
  EXPECT_TRUE(std::isnan(deviatoric_stress(broken)));
  EXPECT_TRUE(std::isnan(lode_angle(broken)));
}

}  // namespace
}  // namespace scree::rheology
