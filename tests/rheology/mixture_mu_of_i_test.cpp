#include "growth.hpp"
#include "points.hpp"

#include <scree/rheology/laws/mixture_mu_of_i.hpp>
#include <scree/rheology/laws/mu_of_i.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace scree::rheology {
namespace {

using Mixture = MixtureMuOfI;
constexpr Mixture law = typical<Mixture>();
constexpr double dense = 1.001 * law.density;  // [kg/m^3]

/// The law of one kind of grains that a mix is equal to.
[[nodiscard]] MuOfI equal_to(const Mixture& mixture, double coarse) {
  const auto between = [&](double fine, double rough) { return fine + coarse * (rough - fine); };
  return {.mu_s = between(mixture.mu_s_fine, mixture.mu_s_coarse),
          .mu_2 = between(mixture.mu_2_fine, mixture.mu_2_coarse),
          .I_0 = between(mixture.I_0_fine, mixture.I_0_coarse),
          .grain_density = mixture.grain_density,
          .shear_rate_floor = mixture.shear_rate_floor,
          .bulk_modulus = mixture.bulk_modulus,
          .density = mixture.density};
}

TEST(MixtureMuOfI, IsTheLawOfItsGrainsWhereTheyAreOfOneKind) {  // Eq. (R76)
  for (const double coarse : {0.0, 0.3, 1.0}) {
    const MuOfI same = equal_to(law, coarse);
    for (const auto& gradient : velocity_gradients()) {
      const auto mixed = law.update({gradient, dense}, {2e-3, coarse}, {}, 0.0).stress;
      const auto alone = same.update({gradient, dense}, {2e-3}, {}, 0.0).stress;
      EXPECT_LE(largest(mixed - alone), 20 * round_off * largest(alone)) << coarse;
    }
  }
}

/// With one I_0 the frictions themselves are mixed, mu = (1 - c) mu_fine(I) + c mu_coarse(I): what Baker,
/// Johnson & Gray (2016) take for fingers of coarse grains.
TEST(MixtureMuOfI, MixesTheFrictionsIfTheyHaveOneScale) {  // Eq. (R76)
  const double p = pressure(dense, law.density, law.bulk_modulus);
  for (const double i : {1e-3, 0.1, 1.0, 10.0}) {
    const double rate = rate_of(equal_to(law, 0), i, dense);
    for (const double coarse : {0.0, 0.2, 0.7, 1.0}) {
      const double tau = law.update({simple_shear(rate), dense}, {1e-3, coarse}, {}, 0.0).stress(0, 1);
      const double mixed =
          (1 - coarse) * equal_to(law, 0).friction(i) + coarse * equal_to(law, 1).friction(i);
      // The floor of the shear rate, and the pressure, a difference of density ratios.
      const double tolerance =
          std::pow(law.shear_rate_floor / rate, 2) * tau + 20 * round_off * law.bulk_modulus;
      EXPECT_NEAR(tau, mixed * p, tolerance) << i;
    }
  }
}

/// Rognon et al. (2007): at one rate and pressure, twice the mean size is twice the inertial number.
TEST(MixtureMuOfI, FeelsTheMeanSizeTimesTheRate) {  // Eq. (R12)
  Mixture no_floor = law;
  no_floor.shear_rate_floor = 1e-12;
  const double at_once = no_floor.update({simple_shear(8), dense}, {1e-3, 0.4}, {}, 0.0).stress(0, 1);
  const double by_size = no_floor.update({simple_shear(4), dense}, {2e-3, 0.4}, {}, 0.0).stress(0, 1);
  EXPECT_NEAR(at_once, by_size, 10 * round_off * at_once);
}

/// Coarse grains that have risen onto fines, or both mixed, 25 degrees steep: each layer has its own inertial
/// number, and Bagnold's profile u' = (I/s_a) sqrt(nu g cos(theta) (H - y)), nu = rho/rho_s, on what is
/// beneath.
TEST(MixtureMuOfI, MakesBagnoldsProfileOfTwoLayers) {
  const double slope = std::tan(25 * std::numbers::pi / 180);
  const double p_slope = 9.81 * std::cos(25 * std::numbers::pi / 180);  // p over rho and depth
  const auto mix_at = [](double depth) {                                // mean size [m], coarse share
    return depth < 0.03 ? std::pair{2e-3, 0.8} : std::pair{1.2e-3, 0.1};
  };
  const auto inertial_at = [&](double coarse) {
    const MuOfI same = equal_to(law, coarse);
    return same.I_0 * (slope - same.mu_s) / (same.mu_2 - slope);
  };
  for (const double depth : {0.01, 0.02, 0.05, 0.09}) {
    const auto [size, coarse] = mix_at(depth);
    const double p = law.density * p_slope * depth;
    const double density = law.density * (1 + p / law.bulk_modulus);
    const double rate = inertial_at(coarse) / size * std::sqrt(p / law.grain_density);
    Mixture no_floor = law;
    no_floor.shear_rate_floor = 1e-9;

    const auto sigma = no_floor.update({simple_shear(rate), density}, {size, coarse}, {}, 0.0).stress;

    EXPECT_NEAR(sigma(0, 1) / -sigma(1, 1), slope, 20 * round_off * law.bulk_modulus / p) << depth;
  }
  // At equal pressure the fines shear twenty times as fast: the coarse ride on them.
  EXPECT_GT(inertial_at(0.1) / 1.2e-3, 20 * inertial_at(0.8) / 2e-3);
}

/// Where it fails: as mu(I) does, outside the range of its own mix. Flow that is well posed for fines is not
/// for the coarse: it becomes ill-posed at the share at which C of the mixed parameters vanishes.
TEST(MixtureMuOfI, IsIllPosedFromAPredictedShareOn) {  // Eq. (R15)
  const double i = 0.022;
  const double rate = rate_of(equal_to(law, 0), i, dense);
  const auto number_at = [&](double coarse) {
    return law.stability_number({simple_shear(rate), dense}, {1e-3, coarse}, {});
  };
  double low = 0;
  double high = 1;
  for (int n = 0; n < 60; ++n) {  // by the law of one kind of grains
    const double middle = (low + high) / 2;
    (stability_at(equal_to(law, middle), i) > 0 ? high : low) = middle;
  }
  EXPECT_GT(low, 0.01);
  EXPECT_LT(low, 0.99);
  EXPECT_LT(number_at(low - 1e-6), 0);
  EXPECT_GT(number_at(low + 1e-6), 0);
  EXPECT_EQ(number_at(0) > 0, least_resistance(equal_to(law, 0), i) < 0);
  EXPECT_EQ(number_at(1) > 0, least_resistance(equal_to(law, 1), i) < 0);
}

}  // namespace
}  // namespace scree::rheology
