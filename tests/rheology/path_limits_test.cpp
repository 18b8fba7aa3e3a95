// Element tests with closed forms: what a laboratory would find of each law.

#include "path_points.hpp"
#include "points.hpp"

#include <scree/rheology/laws/drucker_prager.hpp>
#include <scree/rheology/laws/granular_elastoviscoplastic.hpp>
#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/laws/newtonian.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scree::rheology {
namespace {

constexpr DruckerPrager sand = typical<DruckerPrager>();
constexpr double G = sand.shear_modulus;
constexpr double K = sand.bulk_modulus;

/// Never yields.
[[nodiscard]] DruckerPrager rock() {
  DruckerPrager result = sand;
  result.friction = 1e6;
  return result;
}

/// At rest under a pressure.
template <class Law>
[[nodiscard]] PathPointOf<Law> pressed(const Law& law, double pressure,
                                       const typename PathPointOf<Law>::Input& input = {}) {
  const PathPointOf<Law> loose{law, law.density, input};
  return {law, density_at_pressure(loose, pressure), input};
}

TEST(IsotropicPath, FollowsTheLogarithmOfTheDensity) {  // Eq. (R22)
  auto point = pressed(sand, 0);

  const auto records = drive(point, isotropic_compression(1e5), 1, 10);

  for (const PathRecord& record : records) {
    const double compression = record.at.density / sand.density;
    EXPECT_NEAR(record.pressure, 1e5 * record.at.time, tolerance_of_stress(point, 1e5));
    EXPECT_NEAR(record.pressure, K * std::log(compression) * compression, 10 * round_off * K);
    EXPECT_NEAR(record.deviatoric_stress, 0, std::sqrt(6.0) * tolerance_of_stress(point, 1e5));
  }
}

/// Between walls sigma_yy = (K + 4/3 G) e and sigma_xx = K0 sigma_yy, K0 = (K - 2/3 G)/(K + 4/3 G), with the
/// logarithmic strain: to round-off if the volume of each step is counted as it is made.
TEST(OedometricPath, HasTheModulusAndK0OfItsElasticity) {  // Eqs. (R22), (R23)
  const int num_steps = 100;
  const double strain = 0.1;
  PathPointOf<DruckerPrager> point{rock(), sand.density};

  drive(point, oedometric(strain), 1, num_steps);

  const double volume = num_steps * std::log(1 - strain / num_steps);  // Eq. (R27)
  const double axial = -strain;
  const double scale = std::exp(-volume);
  const double tolerance = num_steps * rounding_of_strain(sand);
  EXPECT_NEAR(point.now.stress(1, 1), scale * (K * volume + 4 * G / 3 * axial), tolerance);
  EXPECT_NEAR(point.now.stress(0, 0), scale * (K * volume - 2 * G / 3 * axial), tolerance);
  // Volume and axial strain are the same up to half the strain of a step.
  const double k_0 = (K - 2 * G / 3) / (K + 4 * G / 3);
  EXPECT_NEAR(point.now.stress(0, 0) / point.now.stress(1, 1), k_0, strain / num_steps / 2);
}

/// Where friction cannot hold the walls' share, K0 = (3 - M)/(3 + 2 M), M = sqrt(3) mu: q/p = M.
TEST(OedometricPath, HasTheK0OfItsFrictionOnceItYields) {  // Eq. (R24)
  DruckerPrager smooth = sand;
  smooth.friction = 0.3;  // q/p of elastic sand is 2 G/K = 1
  PathPointOf<DruckerPrager> point{smooth, sand.density};

  drive(point, oedometric(0.1), 1, 100);

  const double M = std::sqrt(3.0) * smooth.friction;
  EXPECT_NEAR(point.now.stress(0, 0) / point.now.stress(1, 1), (3 - M) / (3 + 2 * M),
              10 * rounding_of_strain(sand) / mean_pressure(point.now.stress));
}

TEST(TriaxialDrainedPath, BeginsWithYoungsModulus) {
  const double pressure = 100;
  const double strain =
      1e-6;  // p/K and the strain are the relative errors of small strain; each enters twice
  auto point = pressed(rock(), pressure);

  drive(point, triaxial_drained(strain), 1, 10);

  const double young = 9 * K * G / (3 * K + G);
  const double tolerance = tolerance_of_stress(point, pressure) / strain + 4 * young * pressure / K;
  EXPECT_NEAR(deviatoric_stress(point.now.stress) / strain, young, tolerance);
}

/// Under a held radial stress q = M p and p = p_0 + q/3: q = 3 M p_0/(3 - M).
TEST(TriaxialDrainedPath, EndsAtTheStrengthOfSand) {  // Eqs. (R24), (R25)
  for (const double degrees : {20.0, 30.0, 40.0}) {
    const double sine = std::sin(degrees * std::numbers::pi / 180);
    DruckerPrager dry = sand;
    dry.friction = 2 * std::sqrt(3.0) * sine / (3 - sine);
    auto point = pressed(dry, 1e3);

    const auto records = drive(point, triaxial_drained(0.1), 1, 100);

    const double M = std::sqrt(3.0) * dry.friction;
    const double q = 3 * M * 1e3 / (3 - M);
    const double amplification = 3 / (3 - M);  // of an error of the radial stress
    const double tolerance =
        amplification * (tolerance_of_stress(point, 3e3 + q) + 10 * rounding_of_strain(sand));
    EXPECT_NEAR(records.back().deviatoric_stress, q, tolerance) << degrees;
    EXPECT_NEAR(records.back().lode_angle, 0, 1e-6) << degrees;  // the root of what rounding leaves of cos
  }
}

/// At constant volume the pressure stays; q grows by 3 G times the strain up to M p.
TEST(TriaxialUndrainedPath, RisesAtConstantPressureToItsStrength) {
  const int num_steps = 400;
  auto point = pressed(sand, 1e3);
  const double scale = point.now.density / sand.density;
  const double strength = std::sqrt(3.0) * sand.friction * 1e3;

  const auto records = drive(point, triaxial_undrained(0.004), 1, num_steps);

  for (int n = 0; n <= num_steps; ++n) {
    const double axial = 0.004 * n / num_steps;
    const double radial = 0.002 * n / num_steps;
    const double elastic = scale * 2 * G * (axial + radial);
    const double tolerance = (n + 1) * rounding_of_strain(sand);
    EXPECT_NEAR(records[static_cast<std::size_t>(n)].pressure, 1e3, tolerance);
    EXPECT_NEAR(records[static_cast<std::size_t>(n)].deviatoric_stress, std::min(elastic, strength),
                tolerance);
  }
}

/// Grains sheared under a held normal stress bear mu(I) times it.
TEST(SimpleShearAtConstantPressure, HasTheFrictionOfItsInertialNumber) {  // Eqs. (R11) to (R14)
  constexpr MuOfI law = typical<MuOfI>();
  for (const double rate : {0.1, 10.0, 1000.0}) {
    auto point = pressed(law, 1e3, {1e-3});

    const PathRecord end = drive(point, simple_shear_at_constant_pressure(rate), 1, 10).back();

    const double number = rate * 1e-3 * std::sqrt(law.grain_density / 1e3);
    const double floor = law.shear_rate_floor / rate;
    const double tolerance = floor * floor / 2 * 1e3 + tolerance_of_stress(point, 1e3);
    EXPECT_NEAR(end.inertial_number, number,
                (8 * round_off + tolerance_of_stress(point, 1e3) / 1e3) * number);
    EXPECT_NEAR(end.at.stress(0, 1), law.friction(number) * 1e3, tolerance) << rate;
    EXPECT_GT(end.stability_number, -1);  // a number
  }
}

/// With elasticity the stress lags behind the turning rate by the angle tau/G + gdot dt: normal stresses
/// differ by it times tau, the friction itself by its square.
TEST(SimpleShearAtConstantPressure, TakesElasticGrainsToTheSameFriction) {  // Eqs. (R19), (R20)
  constexpr GranularElastoviscoplastic law = typical<GranularElastoviscoplastic>();
  const double rate = 10;
  auto point = pressed(law, 1e3, {1e-3});

  const PathRecord end = drive(point, simple_shear_at_constant_pressure(rate), 1, 2000).back();

  const double number = rate * 1e-3 * std::sqrt(law.grain_density / end.pressure);
  const double tau = (law.mu_s + (law.mu_2 - law.mu_s) * number / (law.I_0 + number)) * end.pressure;
  const double angle = tau / law.shear_modulus + rate / 2000;
  EXPECT_NEAR(end.at.stress(0, 1), tau, angle * angle * tau + tolerance_of_stress(point, 1e3));
  EXPECT_NEAR(end.at.stress(1, 1), -1e3, tolerance_of_stress(point, 1e3));
  EXPECT_NEAR(end.pressure, 1e3, angle * tau);
}

/// A fluid that starts to be sheared has its stress at once.
TEST(SimpleShearAtConstantVolume, FindsNewtonsViscosity) {  // Eq. (R3)
  constexpr Newtonian law = typical<Newtonian>();
  auto point = pressed(law, 1e3);

  const auto records = drive(point, simple_shear_at_constant_volume(2), 1, 5);

  EXPECT_EQ(records.front().at.stress(0, 1), 0);
  for (std::size_t n = 1; n < records.size(); ++n) {
    EXPECT_DOUBLE_EQ(records[n].at.stress(0, 1), 2 * law.viscosity);
    EXPECT_DOUBLE_EQ(records[n].dissipation, 4 * law.viscosity);  // Eq. (R6)
    EXPECT_EQ(records[n].at.density, records[0].at.density);
    EXPECT_TRUE(std::isnan(records[n].stability_number));  // the law has none
  }
}

TEST(RotationPath, TurnsTheStressOfSand) {  // Eq. (R18)
  const int num_steps = 100;
  auto point = pressed(sand, 1e3);
  drive(point, triaxial_drained(1e-3), 1, 10);
  const Tensor<double> before = point.now.stress;

  drive(point, rotation(1), 1, num_steps);

  const double angle = num_steps * 2 * std::atan(0.5 / num_steps);  // of the midpoint rule
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double tolerance = num_steps * (60 * round_off * largest(before) + rounding_of_strain(sand));
  EXPECT_NEAR(point.now.stress(0, 0), c * c * before(0, 0) + s * s * before(1, 1), tolerance);
  EXPECT_NEAR(point.now.stress(1, 1), s * s * before(0, 0) + c * c * before(1, 1), tolerance);
  EXPECT_NEAR(point.now.stress(0, 1), c * s * (before(0, 0) - before(1, 1)), tolerance);
  EXPECT_GT(largest(point.now.stress - before), 1);  // [Pa]: it was not isotropic
}

}  // namespace
}  // namespace scree::rheology
