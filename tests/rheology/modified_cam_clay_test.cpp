#include "path_points.hpp"
#include "samples.hpp"

#include <scree/rheology/laws/modified_cam_clay.hpp>
#include <scree/rheology/stress_measures.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace scree::rheology {
namespace {

using Clay = Sample<ModifiedCamClay>;

constexpr ModifiedCamClay law = typical<ModifiedCamClay>();
constexpr double plastic = 1 - law.kappa / law.lambda;  // Lambda

/// Rounding of a pressure [-]: 60 of strains of order one, met by 1/kappa of it.
constexpr double rounding = 60 * round_off / law.kappa;

[[nodiscard]] double shear(const Clay& clay) {
  return clay.stress(1) - clay.stress(0);
}  // q of compression

/// How far outside its yield surface a stress is, over M^2 p_c^2.  Eq. (R63)
[[nodiscard]] double excess(const Clay& clay) {
  const double p = clay.pressure();
  const double p_c = law.preconsolidation_pressure * clay.point.state.preconsolidation;
  const double ratio = shear(clay) / law.critical_ratio;
  return (ratio * ratio + p * (p - p_c)) / (p_c * p_c);
}

/// Pressed alike in all directions to a pressure on the line of normal compression, and let off to a part of
/// it.
[[nodiscard]] Clay pressed(double pressure, double overconsolidation = 1) {
  Clay clay{{law}};
  const double to_yield = law.kappa * std::log(law.preconsolidation_pressure / law.reference_pressure);
  const double strain = to_yield + law.lambda * std::log(pressure / law.preconsolidation_pressure);
  clay.step(-strain / 3, -strain / 3, -strain / 3);
  const double back = law.kappa * std::log(overconsolidation) / 3;
  clay.step(back, back, back);
  return clay;
}

TEST(ModifiedCamClay, IsCompressedAlongItsLines) {  // Eq. (R64)
  Clay clay{{law}};
  // Reloading with slope kappa up to p_c = 2 p_r, then normal compression with slope lambda.
  for (int n = 0; n < 20; ++n) {
    clay.step(-1e-3, -1e-3, -1e-3);

    const double strain = -clay.volume();
    const double to_yield = law.kappa * std::log(2.0);
    const double expected = strain < to_yield
                                ? law.reference_pressure * std::exp(strain / law.kappa)
                                : law.preconsolidation_pressure * std::exp((strain - to_yield) / law.lambda);
    EXPECT_NEAR(clay.pressure(), expected, 20 * rounding * expected);
    EXPECT_LE(largest(deviator(clay.point.stress)), 20 * rounding_of_strain(law));
  }
  const double turning = clay.pressure();
  const double volume = clay.volume();
  EXPECT_NEAR(law.preconsolidation_pressure * clay.point.state.preconsolidation, turning,
              20 * rounding * turning);
  for (int n = 0; n < 10; ++n) {
    clay.step(1e-3, 1e-3, 1e-3);
    const double expected = turning * std::exp(-(clay.volume() - volume) / law.kappa);
    EXPECT_NEAR(clay.pressure(), expected, 30 * rounding * expected);
  }
}

TEST(ModifiedCamClay, ReachesTheSameNormalCompressionInOneStepOrMany) {  // Eq. (R65)
  Clay many{{law}};
  for (int n = 0; n < 100; ++n) many.step(-1e-3, -1e-3, -1e-3);
  Clay one{{law}};
  one.step(-0.1, -0.1, -0.1);

  EXPECT_NEAR(one.pressure(), many.pressure(), 100 * rounding * one.pressure());
}

/// The path does not depend on the steps: the state boundary surface is met exactly.
TEST(ModifiedCamClay, FollowsTheUndrainedPathOfNormallyConsolidatedClay) {  // Eq. (R68)
  for (const double step : {1e-4, 1e-3, 1e-2}) {
    Clay clay = pressed(2e5);
    const double start = clay.pressure();
    for (int n = 0; n < 20; ++n) {
      clay.step(-step, step / 2, step / 2);

      const double eta = shear(clay) / clay.pressure() / law.critical_ratio;
      const double expected = start * std::pow(1 + eta * eta, -plastic);
      EXPECT_NEAR(clay.pressure(), expected, 40 * rounding * expected) << step << ' ' << eta;
      EXPECT_NEAR(excess(clay), 0, 40 * rounding);
    }
  }
}

/// Strength at constant volume follows from the volume alone, whatever the way: M/2 p_c 2^-Lambda OCR^-(1 -
/// Lambda).
TEST(ModifiedCamClay, HasItsUndrainedStrength) {  // Eq. (R69)
  for (const double overconsolidation : {1.0, 2.0, 8.0, 30.0}) {
    Clay clay = pressed(2e5, overconsolidation);
    const double start = clay.pressure();
    // r = q/(M p) approaches 1 as exp(-M e/(2 kappa Lambda)): round-off after 40 of these strains.
    const double scale = 2 * law.kappa * plastic / law.critical_ratio;
    for (int n = 0; n < 100; ++n) clay.step(-0.4 * scale, 0.2 * scale, 0.2 * scale);

    const double expected = law.critical_ratio * start * std::pow(overconsolidation / 2, plastic);
    EXPECT_NEAR(shear(clay), expected, 200 * rounding * expected) << overconsolidation;
    EXPECT_NEAR(shear(clay), law.critical_ratio * clay.pressure(), 200 * rounding * expected);
  }
}

/// Backward Euler is of first order in the strain that goes with the stress, known in closed form for
/// constant volume: e_q = q/(3 G) + kappa Lambda/M (ln((1 + r)/(1 - r)) - 2 atan(r)), r = q/(M p).
TEST(ModifiedCamClay, IsOfFirstOrderInItsSteps) {
  const auto error = [](int num_steps) {
    Clay clay = pressed(2e5);
    const double strain = 0.01;
    for (int n = 0; n < num_steps; ++n) {
      clay.step(-strain / num_steps, strain / 2 / num_steps, strain / 2 / num_steps);
    }
    const double G = law.shear_modulus * std::exp(-clay.volume());
    const double r = shear(clay) / (law.critical_ratio * clay.pressure());
    const double flow =
        law.kappa * plastic / law.critical_ratio * (std::log((1 + r) / (1 - r)) - 2 * std::atan(r));
    return shear(clay) / (3 * G) + flow - strain;
  };

  // C/n + O(1/n^2): the order is off by what is left of the second term, a 64th of it.
  EXPECT_NEAR(std::log2(error(64) / error(128)), 1, 1.0 / 64);
  EXPECT_LT(std::abs(error(128)), 0.01 / 128);
}

/// Sheared under a held lateral stress, clay ends at q = M p on the line dq = 3 dp that leads there.
TEST(ModifiedCamClay, EndsInItsDrainedCriticalState) {  // Eq. (R63)
  const Clay start = pressed(2e5);
  PathPointOf<ModifiedCamClay> point{law, start.density(), {}, start.point.state};
  const double lateral = -point.now.stress(0, 0);
  const int num_steps = 400;
  const double strain = 2;

  const auto records = drive(point, triaxial_drained(1), strain, num_steps);

  const double M = law.critical_ratio;
  const double expected = 3 * M * lateral / (3 - M);
  // M - q/p falls at least by this rate per strain of plastic shear, in backward Euler's steps, of which
  // those that the first 0.1 take are left out: elastic shear and compression.
  const double rate = M * (3 - M) / (3 * (law.lambda - law.kappa));
  const double step = strain / num_steps;
  const double left = 3 / (3 - M) * std::pow(1 + rate * step, -(strain - 0.1) / step);
  EXPECT_LT(left, 1e-6);
  EXPECT_NEAR(records.back().deviatoric_stress, expected, left * expected);
  EXPECT_NEAR(records.back().pressure, expected / M, left * expected);
}

/// Normal compression without lateral strain keeps the stress ratio where flow and strain agree if elastic
/// shear is nothing beside flow: eta^2 + 3 Lambda eta = M^2.
TEST(ModifiedCamClay, IsCompressedAtItsEarthPressureAtRest) {
  Clay clay{{law}};
  clay.point.law.shear_modulus = 1e12;
  for (int n = 0; n < 200; ++n) clay.step(-2e-3, 0, 0);

  const double M = law.critical_ratio;
  const double expected = (std::sqrt(9 * plastic * plastic + 4 * M * M) - 3 * plastic) / 2;
  // Elastic shear takes the share eta p/(2 G lambda) of the strain, and rounding 60 of strains, met by 3 G.
  const double elastic = clay.pressure() / (2 * 1e12 * law.lambda);
  const double tolerance = elastic + 3 * 60 * round_off * 1e12 / clay.pressure();
  EXPECT_NEAR(shear(clay) / clay.pressure(), expected, tolerance);
}

/// On the dry side clay is elastic until its yield surface, is weaker thereafter, and ends at the critical
/// state far below. In a run the softening gathers in bands as narrow as the mesh.
TEST(ModifiedCamClay, SoftensOnTheDrySide) {
  const Clay start = pressed(2e5, 10);
  PathPointOf<ModifiedCamClay> point{law, start.density(), {}, start.point.state};
  const double p_0 = mean_pressure(point.now.stress);
  const double strain = 0.06;
  const int num_steps = 600;

  const auto records = drive(point, triaxial_drained(1), strain, num_steps);

  // The peak is where q = 3 (p - p_0) meets q^2 = M^2 p (p_c - p): a quadratic equation in p.
  const double M = law.critical_ratio;
  const double a = 9 + M * M;
  const double b = 18 * p_0 + M * M * 2e5;
  const double peak = 3 * ((b + std::sqrt(b * b - 36 * a * p_0 * p_0)) / (2 * a) - p_0);
  double largest_shear = 0;
  for (const PathRecord& record : records) {
    largest_shear = std::max(largest_shear, record.deviatoric_stress);
  }
  // A step meets it, or misses it by what it would add: Young's modulus, at most 3 G, times its strain.
  EXPECT_LE(largest_shear, peak);
  EXPECT_GE(largest_shear, peak - 3 * law.shear_modulus * strain / num_steps);
  EXPECT_GT(peak, 2 * 3 * M * p_0 / (3 - M));
  EXPECT_LT(records.back().deviatoric_stress, 0.9 * peak);
  EXPECT_GT(records.back().volumetric_strain, 0);
}

/// Forward Euler leaves the yield surface: f is of second degree, so that each step adds exactly
/// dq^2/M^2 + dp^2 - dp dp_c, the sum of which is of first order in the step. The remedy is this law's
/// return: FollowsTheUndrainedPathOfNormallyConsolidatedClay.
TEST(ModifiedCamClay, WouldLeaveItsYieldSurfaceByExplicitSteps) {
  const auto drift = [](int num_steps, double& predicted) {
    const double M = law.critical_ratio;
    const double G = law.shear_modulus;
    const double strain = 0.01 / num_steps;
    double p = 2e5;
    double q = 0;
    double p_c = 2e5;
    predicted = 0;
    for (int n = 0; n < num_steps; ++n) {
      const double n_p = 2 * p - p_c;
      const double n_q = 2 * q / (M * M);
      const double K = p / law.kappa;
      const double hardening = p * p_c / (law.lambda - law.kappa) * n_p;
      const double flow = n_q * 3 * G * strain / (K * n_p * n_p + 3 * G * n_q * n_q + hardening);
      const double dp = -K * flow * n_p;
      const double dq = 3 * G * (strain - flow * n_q);
      const double dp_c = p_c / (law.lambda - law.kappa) * flow * n_p;
      predicted += dq * dq / (M * M) + dp * dp - dp * dp_c;
      p += dp;
      q += dq;
      p_c += dp_c;
    }
    return q * q / (M * M) + p * (p - p_c);
  };

  double coarse_predicted = 0;
  double fine_predicted = 0;
  const double coarse = drift(100, coarse_predicted);
  const double fine = drift(200, fine_predicted);
  EXPECT_NEAR(coarse, coarse_predicted, 100 * 20 * round_off * 4e10);
  EXPECT_NEAR(fine, fine_predicted, 200 * 20 * round_off * 4e10);
  EXPECT_NEAR(coarse / fine, 2, 0.1);  // C/n + O(1/n^2): 1/n of it times some ten
  EXPECT_GT(fine, 1e-4 * 4e10);        // of p_c^2, where the return has rounding
}

/// Compressed, sheared, let off and sheared back without flow: what was put in has come back. With a constant
/// Poisson's ratio the second shearing would be against another modulus, and cycles would make work.
TEST(ModifiedCamClay, GainsNoWorkFromElasticCycles) {  // Eq. (R62)
  Clay clay = pressed(4e5, 4);
  const double size = 1e-3;
  double work = 0;
  double exchanged = 0;
  const auto lead = [&](const std::array<double, 3>& strain) {
    const auto power = [&] {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += clay.stress(i) * strain[i];
      return sum * std::exp(clay.volume());
    };
    const double before = power();
    clay.step(strain[0], strain[1], strain[2]);
    work += (before + power()) / 2;  // each leg and the one back are met at the same strains
    exchanged += std::abs(before);
  };
  lead({-size, -size, -size});
  lead({-size, size / 2, size / 2});
  lead({size, size, size});
  lead({size, -size / 2, -size / 2});

  EXPECT_EQ(clay.point.state.preconsolidation, pressed(4e5, 4).point.state.preconsolidation);
  EXPECT_NEAR(work, 0, 20 * rounding * exchanged);
}

/// Far below its density clay is apart, and keeps what it has been pressed to.
TEST(ModifiedCamClay, BearsNothingOnceItIsApart) {  // Eq. (R67)
  Clay clay = pressed(2e5);
  const double preconsolidation = clay.point.state.preconsolidation;
  const double apart = law.kappa * 9 * std::log(10.0);
  clay.step(0.99 * apart / 3, 0.99 * apart / 3, 0.99 * apart / 3);
  EXPECT_GT(clay.pressure(), 0);
  clay.step(0.02 * apart / 3, 0.02 * apart / 3, 0.02 * apart / 3);
  EXPECT_EQ(largest(clay.point.stress), 0);
  clay.step(0.1, -0.1, 0);
  EXPECT_EQ(largest(clay.point.stress), 0);
  EXPECT_EQ(clay.point.state.preconsolidation, preconsolidation);

  const double back = clay.volume() - pressed(2e5).volume();
  clay.step(-back / 3, -back / 3, -back / 3);
  EXPECT_NEAR(clay.pressure(), 2e5, 20 * rounding * 2e5);
}

[[nodiscard]] std::string complaint(const ModifiedCamClay& clay) {
  return message_of<InputError>([&] { validate(clay); });
}

TEST(ModifiedCamClay, RefusesWhatIsNoClay) {
  ModifiedCamClay clay = law;
  clay.kappa = 0.1;
  EXPECT_EQ(complaint(clay), "modified_cam_clay: lambda = 0.1: must exceed kappa = 0.1");
  clay = law;
  clay.reference_pressure = clay.preconsolidation_pressure;
  EXPECT_EQ(complaint(clay), "no error");
  clay.reference_pressure = 2e5;
  EXPECT_EQ(complaint(clay),
            "modified_cam_clay: preconsolidation_pressure = 100000 Pa: must be at least reference_pressure = "
            "200000");
  clay = law;
  clay.critical_ratio = 0;
  EXPECT_EQ(complaint(clay), "modified_cam_clay: critical_ratio = 0: must be finite and above 0");
  clay.critical_ratio = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint(clay), "modified_cam_clay: critical_ratio = nan: must be finite and above 0");
}

}  // namespace
}  // namespace scree::rheology
