#include "growth.hpp"
#include "inclined_layer.hpp"
#include "points.hpp"

#include <scree/rheology/laws/mu_of_i.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace scree::rheology {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// The glass beads of Jop et al. (2006), of 60 % solid, all but incompressible.
[[nodiscard]] MuOfI beads() {
  return {.mu_s = std::tan(20.9 * degree),
          .mu_2 = std::tan(32.76 * degree),
          .I_0 = 0.279,
          .grain_density = 2500,
          .shear_rate_floor = 1e-8,
          .bulk_modulus = 1e6,
          .density = 1500};
}

TEST(MuOfI, RubsBetweenItsTwoFrictions) {  // Eq. (R11)
  const MuOfI law = beads();
  const double p = 1000;
  const double density = law.density * (1 + p / law.bulk_modulus);
  for (const double i : {1e-4, 0.01, 0.279, 1.0, 1e4}) {
    const auto sigma = stress(law, simple_shear(rate_of(law, i, density)), density);

    // The pressure is the difference of density ratios: some ten roundings of K. Its root is in I.
    const double tolerance = 10 * round_off * law.bulk_modulus;
    EXPECT_NEAR(sigma(0, 1), law.friction(i) * p, tolerance) << i;
    EXPECT_NEAR(sigma(1, 1), -p, tolerance);
  }
  EXPECT_EQ(law.friction(0), law.mu_s);
  EXPECT_NEAR(law.friction(law.I_0), (law.mu_s + law.mu_2) / 2, 4 * round_off);
}

/// Grains of twice the size at half the rate feel the same.
TEST(MuOfI, FeelsGrainSizeTimesRate) {  // Eq. (R12)
  const MuOfI law = beads();
  EXPECT_EQ(stress(law, simple_shear(8), 1501.0, 1e-3)(0, 1),
            stress(law, simple_shear(4), 1501.0, 2e-3)(0, 1));
}

/// Bagnold's profile: I is 0.089180236 all over the depth, the surface moves at 2.642217862 m/s; 24 degrees,
/// 0.1 m deep, grains of 1.65 mm.
TEST(MuOfI, MakesBagnoldsProfile) {
  const MuOfI law = beads();
  const double size = 1.65e-3;
  const double height = 0.1;
  const int num_parts = 10000;
  double speed = 0;
  double lowest = 1;
  double highest = 0;
  for (int n = 0; n < num_parts; ++n) {
    const double w = std::sqrt(height) * (n + 0.5) / num_parts;  // depth is w^2: the integrand is smooth in w
    const double weight = law.density * 9.81 * w * w;
    const double p = weight * std::cos(24 * degree);
    const double rate = shear_rate_at(law, weight * std::sin(24 * degree),
                                      law.density * (1 + p / law.bulk_modulus), 1e3, size);
    speed += rate * 2 * w * std::sqrt(height) / num_parts;
    if (n < num_parts / 2) continue;  // the lower three quarters, where p is known to 1e-12
    const double i = inertial_number(rate, size, p, law.grain_density);
    lowest = std::min(lowest, i);
    highest = std::max(highest, i);
  }

  // Half a unit in the last digit that is given; rounding of p by 1e-12, over dmu/dI p/mu = 0.3.
  EXPECT_NEAR(lowest, 0.089180236, 1e-9);
  EXPECT_NEAR(highest, 0.089180236, 1e-9);
  // The integrand is w^2: the midpoint rule is off by 1/(4 N^2) of the whole.
  EXPECT_NEAR(speed, 2.642217862, 2.642217862 * (0.25 / num_parts / num_parts) + 1e-9);
}

TEST(MuOfI, HasNoStressAndNoNanWithoutContact) {  // Eqs. (R5), (R13)
  const MuOfI law = beads();
  for (const double density : {0.0, 1000.0, 1499.999, 1500.0}) {
    EXPECT_EQ(largest(stress(law, simple_shear(10), density)), 0) << density;
    EXPECT_EQ(largest(stress(law, {}, density)), 0) << density;
    EXPECT_EQ(law.stability_number({simple_shear(10), density}, {1e-3}, {}), 0) << density;
  }
  const double barely = 1500 * (1 + 4 * round_off);
  const auto sigma = stress(law, simple_shear(10), barely);
  EXPECT_LE(sigma(0, 1), -law.mu_2 * sigma(1, 1) * (1 + 10 * round_off));
  EXPECT_GE(sigma(0, 1), -law.mu_s * sigma(1, 1) * (1 - 10 * round_off));
}

/// The floor of the shear rate costs less than (floor/gdot)^2/2, and makes rest a creep of a known viscosity.
TEST(MuOfI, PaysForItsFloorWhatIsSaid) {  // Eq. (R14)
  MuOfI law = beads();
  const double density = 1501;
  for (const double rate : {1e-2, 0.1, 1.0, 10.0}) {
    law.shear_rate_floor = 1e-8;
    const double exact = stress(law, simple_shear(rate), density)(0, 1);
    for (const double floor : {1e-4, 1e-3, 1e-2}) {
      law.shear_rate_floor = floor;
      const double lost = 1 - stress(law, simple_shear(rate), density)(0, 1) / exact;

      EXPECT_GE(lost, -20 * round_off);
      EXPECT_LE(lost, std::pow(floor / rate, 2) / 2 + 20 * round_off);
    }
  }
  const double p = pressure(density, law.density, law.bulk_modulus);
  const double i = inertial_number(law.shear_rate_floor, 1e-3, p, law.grain_density);
  const double at_rest = law.friction(i) * p / law.shear_rate_floor;
  EXPECT_NEAR(law.stiffness(Deformation<double>{{}, density}, {1e-3}, {}).viscosity, at_rest,
              20 * round_off * at_rest);
}

/// The published ranges: 0.01935 < I < 0.8523, and from 0.00397 with the other set of parameters.
TEST(MuOfI, IsIllPosedOutsideItsThresholds) {  // Eq. (R15)
  const MuOfI law = beads();
  EXPECT_NEAR(threshold_between(law, 1e-3, 0.1), 0.01935, 5e-6);  // half a unit in the last digit
  EXPECT_NEAR(threshold_between(law, 0.1, 10), 0.8523, 5e-5);
  MuOfI other = beads();
  other.mu_s = 0.342;
  other.mu_2 = 0.557;
  other.I_0 = 0.069;
  EXPECT_NEAR(threshold_between(other, 1e-4, 0.1), 0.00397, 5e-6);
}

/// C, derived anew: disturbances of the law itself grow on one side of each threshold and die on the other.
TEST(MuOfI, GrowsDisturbancesWhereItsNumberSaysSo) {  // Eq. (R15)
  const MuOfI law = beads();
  for (const double threshold : {threshold_between(law, 1e-3, 0.1), threshold_between(law, 0.1, 10)}) {
    for (const double i : {0.5 * threshold, 0.98 * threshold, 1.02 * threshold, 2 * threshold}) {
      EXPECT_EQ(stability_at(law, i) > 0, least_resistance(law, i) < 0) << i;
    }
  }
}

}  // namespace
}  // namespace scree::rheology
