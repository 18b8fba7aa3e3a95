#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/nonlocal_fluidity.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

constexpr NonlocalFluidity beads = typical<NonlocalFluidity>();

TEST(NonlocalFluidity, IsMuOfIWhereItIsLocal) {  // Eqs. (R173), (R174): mu = mu_s + b I
  const double pressure = 500;
  const double size = 1e-3;
  for (const double rate : {0.1, 3.0, 40.0}) {
    const double friction =
        beads.mu_s + beads.slope * inertial_number(rate, size, pressure, beads.grain_density);

    const double g = beads.local_fluidity(friction, pressure, size);

    // The excess over mu_s is a difference: its rounding is that of the friction.
    EXPECT_NEAR(g * friction, rate, 20 * round_off * rate * friction / (friction - beads.mu_s));
  }
}

/// Where mu(I) of Jop et al. is straight, far below I_0, the two agree: b = (mu_2 - mu_s)/I_0.
TEST(NonlocalFluidity, FollowsTheCurvedLawInSlowFlow) {
  MuOfI law = typical<MuOfI>();
  law.mu_s = beads.mu_s;
  NonlocalFluidity straight = beads;
  straight.slope = (law.mu_2 - law.mu_s) / law.I_0;
  const double i = 1e-3;
  const double size = 1e-3;
  const double pressure = 500;

  const double rate = i / size * std::sqrt(pressure / beads.grain_density);
  const double friction = law.friction(i);

  // I/(I_0 + I) falls short of I/I_0 by the relative I/I_0.
  EXPECT_NEAR(straight.local_fluidity(friction, pressure, size) * friction, rate, 1.01 * i / law.I_0 * rate);
}

TEST(NonlocalFluidity, DoesNotFlowLocallyUpToMuS) {  // Eq. (R174)
  EXPECT_EQ(beads.local_fluidity(beads.mu_s, 500.0, 1e-3), 0);
  EXPECT_EQ(beads.local_fluidity(0.9 * beads.mu_s, 500.0, 1e-3), 0);
}

TEST(NonlocalFluidity, SpreadsOverSomeGrainSizes) {  // Eq. (R175)
  const double below = beads.cooperativity_length(beads.mu_s - 0.01, 1e-3);
  const double above = beads.cooperativity_length(beads.mu_s + 0.01, 1e-3);

  EXPECT_NEAR(below, 4.8e-3, 4.8e-3 * 40 * round_off / 0.01);  // 0.48/0.1 grains; mu - mu_s is a difference
  EXPECT_NEAR(above, below, below * 40 * round_off / 0.01);
  EXPECT_EQ(beads.cooperativity_length(beads.mu_s - 0.01, 2e-3), 2 * below);
}

TEST(NonlocalFluidity, RefusesParametersOutOfTheirBounds) {
  NonlocalFluidity model = beads;
  model.amplitude = 0;
  std::string message;
  try {
    validate(model);
  } catch (const InputError& error) {
    message = error.what();
  }

  EXPECT_EQ(message, "nonlocal_fluidity: amplitude = 0: must be finite and above 0");
}

}  // namespace
}  // namespace scree::rheology
