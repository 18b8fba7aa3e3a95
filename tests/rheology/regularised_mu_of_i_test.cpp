#include "growth.hpp"
#include "points.hpp"

#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/laws/regularised_mu_of_i.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

/// The parameters of Barker & Gray (2017).
constexpr RegularisedMuOfI law{.mu_s = 0.342,
                               .mu_2 = 0.557,
                               .mu_inf = 0.05,
                               .alpha = 1.9,
                               .I_0 = 0.069,
                               .I_1 = 0.00398,
                               .grain_density = 2500,
                               .shear_rate_floor = 1e-12,
                               .bulk_modulus = 1e6,
                               .density = 1500};

TEST(RegularisedMuOfI, FollowsTheTwoPublishedBranches) {  // Eqs. (R16), (R17)
  const double mu_1 =
      (law.mu_s * law.I_0 + law.mu_2 * law.I_1 + law.mu_inf * law.I_1 * law.I_1) / (law.I_0 + law.I_1);
  const double A = law.I_1 * std::exp(law.alpha / (mu_1 * mu_1));
  for (const double i : {1e-12, 1e-6, 0.003}) {
    EXPECT_NEAR(law.friction(i), std::sqrt(law.alpha / std::log(A / i)), 20 * round_off) << i;
  }
  for (const double i : {0.004, 0.1, 1.0, 10.0}) {
    const double expected = (law.mu_s * law.I_0 + law.mu_2 * i + law.mu_inf * i * i) / (law.I_0 + i);
    EXPECT_NEAR(law.friction(i), expected, 20 * round_off) << i;
  }
  // The branches meet: beside I_1 they differ by no more than their slopes, of less than 20, allow.
  const double below = law.friction(law.I_1);
  const double above = law.friction(law.I_1 * (1 + 4 * round_off));
  EXPECT_NEAR(below, above, 20 * 4 * round_off * law.I_1 + 20 * round_off);
}

TEST(RegularisedMuOfI, IsMuOfIBetweenItsChanges) {
  RegularisedMuOfI partial = law;
  partial.mu_inf = 0;
  const MuOfI plain{.mu_s = 0.342,
                    .mu_2 = 0.557,
                    .I_0 = 0.069,
                    .grain_density = 2500,
                    .shear_rate_floor = 1e-12,
                    .bulk_modulus = 1e6,
                    .density = 1500};
  for (const double rate : {3.0, 30.0, 300.0}) {  // I = 0.0047 and up
    const auto expected = stress(plain, simple_shear(rate), 1501.5);
    const auto actual = stress(partial, simple_shear(rate), 1501.5);
    EXPECT_LE(largest(actual - expected), 20 * round_off * largest(expected));
  }
}

TEST(RegularisedMuOfI, LetsGoAtRest) {  // Eq. (R16): no yield, friction falls to zero, as slowly as it may
  double faster = law.friction(1e-3);
  for (const double i : {1e-6, 1e-9, 1e-30, 1e-300}) {
    EXPECT_GT(law.friction(i), 0);
    EXPECT_LT(law.friction(i), faster);
    faster = law.friction(i);
  }
}

/// C <= 0, and no disturbance grows, from next to rest up to I = 16.99, over 13 decades.
TEST(RegularisedMuOfI, IsWellPosedUpToItsThreshold) {  // Eq. (R15)
  for (double i = 1e-12; i < 16.9; i *= 1.1) EXPECT_LE(stability_at(law, i), 0) << i;
  for (double i = 1e-9; i < 16.9; i *= 10) EXPECT_GT(least_resistance(law, i), 0) << i;
  // mu' I/mu tends to 1 and C to (mu/2)^2 > 0: there is an end to it. Half a unit in the last digit, from the
  // roots of C in closed form.
  EXPECT_NEAR(threshold_between(law, 1, 100), 16.992, 5e-4);
}

/// In so fast a flow C is on the safe side: the direction that it speaks of is none, and disturbances grow
/// only once mu - I mu'/2 exceeds 1, where pressure can no longer answer them.
TEST(RegularisedMuOfI, GrowsDisturbancesALittleBeyondItsThreshold) {  // Eq. (R15)
  EXPECT_GT(stability_at(law, 17.9), 0);
  EXPECT_GT(least_resistance(law, 17.9), 0);
  EXPECT_LT(least_resistance(law, 18.5), 0);
}

/// With mu_inf = 0 the slow side is mended alone; the fast one stays that of mu(I).
TEST(RegularisedMuOfI, StaysIllPosedInFastFlowIfPartial) {
  RegularisedMuOfI partial = law;
  partial.mu_inf = 0;
  for (double i = 1e-12; i < 0.28; i *= 1.1) EXPECT_LE(stability_at(partial, i), 0) << i;
  EXPECT_NEAR(threshold_between(partial, 0.1, 10), 0.28017, 5e-6);
  EXPECT_LT(least_resistance(partial, 0.285), 0);
}

/// The change must begin where mu(I) is still well posed, and alpha must lie below 2.
TEST(RegularisedMuOfI, IsIllPosedIfMendedTooLateOrTooMuch) {
  RegularisedMuOfI late = law;
  late.I_1 = 0.0035;  // mu(I), with this mu_inf, is ill-posed below 0.003963
  EXPECT_GT(stability_at(late, 0.0036), 0);
  EXPECT_LE(stability_at(late, 0.0040), 0);
  EXPECT_LE(stability_at(late, 0.0034), 0);
  for (const double i : {1e-12, 1e-6, 1e-3}) {  // C = (1 - 2/alpha) mu^2 + O(mu^4)
    RegularisedMuOfI steep = law;
    steep.alpha = 2.1;
    EXPECT_GT(stability_at(steep, i), 0) << i;
  }
}

}  // namespace
}  // namespace scree::rheology
