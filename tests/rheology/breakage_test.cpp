#include "points.hpp"

#include <scree/rheology/laws/breakage.hpp>
#include <scree/rheology/stress_measures.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace scree::rheology {
namespace {

constexpr Breakage law = typical<Breakage>();

[[nodiscard]] double yield_strain() {  // e_cr, volumetric
  return law.crushing_pressure() / law.bulk_modulus;
}

[[nodiscard]] double tangent_squared() {  // of the coupling angle
  const double tangent = std::tan(law.coupling_angle * std::numbers::pi / 180);
  return tangent * tangent;
}

[[nodiscard]] double density_at(double compression) {  // logarithmic
  return law.density * std::exp(compression);
}

/// Mean and deviatoric stress of Kirchhoff, in which the law is written [Pa].
[[nodiscard]] double pressure_of(const Point<Breakage>& point, double compression) {
  return mean_pressure(point.stress) * std::exp(-compression);
}
[[nodiscard]] double shear_of(const Point<Breakage>& point, double compression) {
  return deviatoric_stress(point.stress) * std::exp(-compression);
}

/// Compressed alike from all sides, or pulled, from one compression to another.
void compress(Point<Breakage>& point, double from, double to, int num_steps) {
  for (int n = 1; n <= num_steps; ++n)
    point.step({}, density_at(std::lerp(from, to, 1.0 * n / num_steps)), 1);
}

/// Compression at which breakage has come to B.  Eq. (R118)
[[nodiscard]] double compression_of(double B) {
  const double theta = law.grading;
  const double e = yield_strain();
  return e / (1 - B) + theta * e / 2 * tangent_squared() / (1 - theta) * std::log((1 - theta * B) / (1 - B));
}

/// Rounding of a pressure made from the logarithm of a density, ten operations [Pa].
[[nodiscard]] double rounding() {
  return 10 * round_off * law.bulk_modulus;
}

TEST(Breakage, IsElasticBelowItsCrushingPressure) {  // Eqs. (R110), (R112)
  Point<Breakage> point{law};
  for (const double share : {0.5, 0.999}) {
    const double compression = share * yield_strain();
    point.step({}, density_at(compression), 1);

    EXPECT_NEAR(pressure_of(point, compression), share * law.crushing_pressure(), rounding());
    EXPECT_EQ(point.state.breakage, 0);
    EXPECT_EQ(point.state.compaction, 0);
  }
  point.step({}, density_at(1.001 * yield_strain()), 1);
  EXPECT_GT(point.state.breakage, 0);
  point.step({}, law.density, 1);
  EXPECT_EQ(largest(point.stress), 0);  // it has been compacted, and lets go before
}

/// Beyond, breakage, pressure and compaction are known in closed form: first order in the step.
TEST(Breakage, FollowsItsIsotropicCompression) {  // Eq. (R118)
  for (const double B : {0.1, 0.5, 0.9}) {
    const double compression = compression_of(B);
    const double p = law.crushing_pressure() * (1 - law.grading * B) / (1 - B);
    const auto errors = [&](int num_steps) {
      Point<Breakage> point{law};
      compress(point, 0, compression, num_steps);
      return std::array{std::abs(point.state.breakage - B), std::abs(pressure_of(point, compression) / p - 1),
                        std::abs(point.state.compaction - (compression - yield_strain() / (1 - B)))};
    };
    const auto coarse = errors(200);
    const auto middle = errors(400);
    const auto fine = errors(800);

    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(fine[i], 0.01) << B;
      // Errors halve with the step, up to a few over the number of coarse steps in which it yields.
      const double num_yielding = 200 * (1 - yield_strain() / compression);
      EXPECT_NEAR((coarse[i] - middle[i]) / (middle[i] - fine[i]), 2, 4 / num_yielding) << B << ", " << i;
    }
  }
}

/// The yield surface for shear at a given pressure, and not before.
TEST(Breakage, YieldsOnItsSurface) {  // Eq. (R112)
  for (const double share : {0.01, 0.3, 0.7, 0.95}) {
    const double compression = share * yield_strain();
    const double p = share * law.crushing_pressure();
    const double k = law.bulk_modulus / (3 * law.shear_modulus);
    // y = 0 for q, with E_B/E_c = (p^2 + k q^2)/p_cr^2.
    const double M_p = law.critical_stress_ratio * p;
    const double p_cr = law.crushing_pressure();
    const double q = std::sqrt((1 - share * share) / (1 / (M_p * M_p) + k / (p_cr * p_cr)));
    const double strain = q / (std::sqrt(3.0) * law.shear_modulus);  // engineering, of pure shear
    for (const double part : {0.999, 1.001}) {
      Point<Breakage> point{law};
      point.step({}, density_at(compression), 1);
      Tensor<double> gradient;
      gradient(0, 1) = gradient(1, 0) = part * strain / 2;
      point.step(gradient, density_at(compression), 1);

      EXPECT_EQ(point.state.breakage > 0, part > 1) << share;
      if (part < 1) {
        EXPECT_NEAR(shear_of(point, compression), part * q, rounding_of_strain(law));
      }
    }
  }
}

/// Sheared without end at constant volume: as grains break, E_B has less to release, and the strength tends
/// to friction alone, q = M p, where breaking ends.  Einav (2007)
TEST(Breakage, TendsToFrictionAloneInLongShear) {
  const double compression = 0.9 * yield_strain();
  Point<Breakage> point{law};
  point.step({}, density_at(compression), 1);
  double previous = 0;
  for (int n = 0; n < 2000; ++n) {
    point.step(simple_shear(1), density_at(compression), 0.01);
    EXPECT_GE(point.state.breakage, previous);
    previous = point.state.breakage;
  }

  const double p = pressure_of(point, compression);
  const double q = shear_of(point, compression);
  const double rest = 1 - point.state.breakage;
  const double k = law.bulk_modulus / (3 * law.shear_modulus);
  const double softened = 1 - law.grading * point.state.breakage;
  const double energy = (p * p + k * q * q) / std::pow(softened * law.crushing_pressure(), 2);
  const double mobilised = q / (law.critical_stress_ratio * p);
  EXPECT_NEAR(mobilised * mobilised, 1 - rest * rest * energy, 1e-9);  // on the surface
  EXPECT_GT(mobilised, 0.99);
  EXPECT_LT(p, 0.3 * law.crushing_pressure());  // breaking has compacted it: less is left to press
}

/// Compressed without a change of width, unbroken grains yield at the pressure that their ratio of stresses,
/// nu/(1 - nu), sets.
TEST(Breakage, YieldsInOedometricCompression) {
  const double K = law.bulk_modulus;
  const double G = law.shear_modulus;
  // A strain e: p = K e, q = 2 G e, so y = (1 + 4 G/(3 K)) (p/p_cr)^2 + (2 G/(K M))^2 - 1.
  const double mobilised = 2 * G / (K * law.critical_stress_ratio);
  ASSERT_LT(mobilised, 1);
  const double share = std::sqrt((1 - mobilised * mobilised) / (1 + 4 * G / (3 * K)));
  for (const double part : {0.995, 1.005}) {
    const double strain = part * share * yield_strain();
    const int num_steps = 10;
    Point<Breakage> point{law};
    Tensor<double> gradient;
    gradient(0, 0) = -strain / num_steps;
    for (int n = 1; n <= num_steps; ++n) point.step(gradient, density_at(strain * n / num_steps), 1);

    EXPECT_EQ(point.state.breakage > 0, part > 1);
    const double ratio = point.stress(1, 1) / point.stress(0, 0);
    const double nu = (3 * K - 2 * G) / (2 * (3 * K + G));
    if (part < 1) {
      EXPECT_NEAR(ratio, nu / (1 - nu), 100 * num_steps * round_off / strain);
    }
  }
}

/// What is put in and not stored is dissipated: never negative, and it breaks only where that is positive.
TEST(Breakage, DissipatesAndNeverHeals) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> share{0, 1};
  const double k = law.bulk_modulus / (3 * law.shear_modulus);
  const auto stored = [&](const Point<Breakage>& point, double compression) {
    const double p = pressure_of(point, compression);
    const double q = shear_of(point, compression);
    return (p * p + k * q * q) / (2 * law.bulk_modulus * (1 - law.grading * point.state.breakage));
  };
  Point<Breakage> point{law};
  double compression = 0.5 * yield_strain();
  point.step({}, density_at(compression), 1);
  for (int n = 0; n < 500; ++n) {
    const auto before = point;
    const double from = compression;
    const double shear = 0.02 * (share(random) - 0.3);
    compression += 0.01 * (share(random) - 0.45);
    Tensor<double> gradient;
    gradient(0, 1) = gradient(1, 0) = shear / 2;

    point.step(gradient, density_at(compression), 1);

    EXPECT_GE(point.state.breakage, before.state.breakage);
    EXPECT_LT(point.state.breakage, 1);
    // Backward in time the work of the stress at the end exceeds what is stored of it by what is dissipated.
    const double work = pressure_of(point, compression) * (compression - from) +
                        std::exp(-compression) * contract(deviator(point.stress), gradient);
    const double gain = stored(point, compression) - stored(before, from);
    const double bend = shear * shear * std::abs(shear) * law.shear_modulus;  // of the logarithm of b
    EXPECT_GE(work - gain, -bend - 100 * rounding() * yield_strain()) << n;
  }
}

/// One step of any size ends on the surface, with B below 1.
TEST(Breakage, SolvesAnyStep) {  // Eqs. (R113) to (R116)
  std::mt19937 random{3};
  std::uniform_real_distribution<double> share{0, 1};
  int num_flowing = 0;
  for (int n = 0; n < 20000; ++n) {
    const double omega = (1 + 87 * share(random)) * std::numbers::pi / 180;
    const BreakageReturn flow{0.05 + 0.93 * share(random), std::pow(std::cos(omega), 2),
                              0.5 * std::pow(10, share(random))};
    const double broken = share(random) < 0.5 ? 0 : 0.999 * share(random);
    const double volume = std::pow(10, 6.5 * share(random) - 4);
    const double steepness = share(random) < 0.1 ? 0 : std::pow(10, 9 * share(random) - 6);
    const BreakageState<double> trial{volume, steepness * volume, broken};
    if (!(flow.yield(trial) > 0)) continue;
    ++num_flowing;

    const auto end = flow(trial);

    EXPECT_EQ(end.unsolved, 0) << n;
    EXPECT_GE(end.breakage, broken) << n;
    EXPECT_LT(end.breakage, 1) << n;
    EXPECT_LE(end.volume, volume) << n;
    EXPECT_LE(end.shape, trial.shape) << n;
    EXPECT_NEAR(flow.yield(end), 0, 1e-11) << n;  // ten times the tolerance of u, which y depends on less
  }
  EXPECT_GT(num_flowing, 10000);
}

/// Where an explicit rule fails: from the yield surface at breakage B it passes B = 1, where nothing is left
/// to break, in a compression beyond 1/(1-B) + theta tan^2 omega/(2 (1 - theta B)) strains of first yield.
TEST(Breakage, BreaksNoMoreThanAllWhereAnExplicitRuleOvershoots) {  // Eq. (R119)
  for (const double B : {0.0, 0.4, 0.9}) {
    const double theta = law.grading;
    const double per_breakage =
        1 / std::pow(1 - B, 2) + theta / 2 * tangent_squared() / ((1 - B) * (1 - theta * B));  // of x
    const double limit = 1 / (1 - B) + theta * tangent_squared() / (2 * (1 - theta * B));
    for (const double share : {0.999, 1.001, 100.0}) {
      const double increment = share * limit;  // in yield strains
      const double explicit_rule = B + increment / per_breakage;
      EXPECT_EQ(explicit_rule > 1, share > 1) << B;

      Point<Breakage> point{law};
      point.state.breakage = B;
      const double yield = yield_strain() / (1 - B);
      point.step({}, density_at(yield), 1);
      point.step({}, density_at(yield + increment * yield_strain()), 1);
      EXPECT_GT(point.state.breakage, B);
      EXPECT_LT(point.state.breakage, 1);
    }
  }
}

/// Where it fails otherwise: once all is broken to a dust (B towards 1) its compliance 1/(1 - theta B) is
/// that of the model, K (1 - theta); grains that are pressed closer stiffen, and this one does not.
TEST(Breakage, DoesNotStiffenWhenAllIsBroken) {
  Point<Breakage> point{law};
  compress(point, 0, 2, 200);
  const double before = pressure_of(point, 2);

  point.step({}, density_at(2 - 1e-6), 1);

  const double slope = (before - pressure_of(point, 2 - 1e-6)) / 1e-6;
  EXPECT_NEAR(slope, law.bulk_modulus * (1 - law.grading * point.state.breakage), 4 * rounding() / 1e-6);
  EXPECT_GT(point.state.breakage, 0.95);
}

}  // namespace
}  // namespace scree::rheology
