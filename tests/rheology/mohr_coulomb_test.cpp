#include "derivative.hpp"
#include "path_points.hpp"
#include "samples.hpp"

#include <scree/rheology/laws/mohr_coulomb.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <numbers>
#include <string>

namespace scree::rheology {
namespace {

using testing::Dual;

constexpr double degree = std::numbers::pi / 180;

/// Angles in degrees, cohesion in Pa; no cut in tension.
[[nodiscard]] MohrCoulomb soil(double phi, double psi, double cohesion) {
  MohrCoulomb law = typical<MohrCoulomb>();
  law.friction = std::tan(phi * degree);
  law.dilatancy = std::tan(psi * degree);
  law.cohesion = cohesion;
  law.tension_strength = 1e12;
  return law;
}

/// What rounding does to stresses [Pa] in some steps: that of strains of order one, met by 2 G + K.
[[nodiscard]] double rounding(const MohrCoulomb& law, int num_steps) {
  return num_steps * 60 * round_off * (2 * law.shear_modulus + law.bulk_modulus);
}

TEST(MohrCoulomb, PressesSidewaysByPoissonsRatioInAnElasticOedometer) {  // Eq. (R50)
  Sample<MohrCoulomb> sample{{soil(89, 0, 1e9)}};
  const auto& law = sample.point.law;
  for (int n = 0; n < 10; ++n) sample.step(-1e-3, 0, 0);

  // K_0 = nu/(1 - nu) with nu = lambda/(2 (lambda + G))
  const double lame = law.bulk_modulus - 2 * law.shear_modulus / 3;
  EXPECT_NEAR(sample.stress(1), lame / (lame + 2 * law.shear_modulus) * sample.stress(0), rounding(law, 10));
}

/// Sand whose elastic K_0 is less than it can bear yields from the start: then the stress ratio is Rankine's,
/// and with dilation beta and shear strain rate r per axial rate, M (K (1 + beta r)) = 3 G (2/3 - r).
TEST(MohrCoulomb, YieldsInTheOedometer) {  // Eqs. (R52), (R53)
  for (const double psi : {0.0, 10.0, 20.0}) {
    Sample<MohrCoulomb> sample{{soil(20, psi, 0)}};
    MohrCoulomb& law = sample.point.law;
    law.shear_modulus = 0.75 * law.bulk_modulus;  // nu = 0.2
    for (int n = 0; n < 10; ++n) sample.step(-1e-3, 0, 0);

    const double sine = std::sin(20 * degree);
    const double M = 6 * sine / (3 - sine);
    const double beta = 6 * std::sin(psi * degree) / (3 - std::sin(psi * degree));
    const double r = (2 * law.shear_modulus - M * law.bulk_modulus) /
                     (3 * law.shear_modulus + M * law.bulk_modulus * beta);
    const double p = law.bulk_modulus * (1 + beta * r) * 1e-2 * std::exp(1e-2);  // Cauchy
    EXPECT_NEAR(sample.stress(0), -p * (1 + 2 * M / 3), rounding(law, 10)) << psi;
    EXPECT_NEAR(sample.stress(1), (1 - sine) / (1 + sine) * sample.stress(0), rounding(law, 10)) << psi;
  }
}

TEST(MohrCoulomb, HasItsTriaxialStrengths) {  // Eq. (R58)
  for (const double phi : {10.0, 30.0, 45.0}) {
    for (const double direction : {-1.0, 1.0}) {
      Sample<MohrCoulomb> sample{{soil(phi, 5, 2000)}};
      sample.step(-2e-3, -2e-3, -2e-3);
      for (int n = 0; n < 100; ++n) sample.step(direction * 1e-3, -direction * 5e-4, -direction * 5e-4);

      const double sine = std::sin(phi * degree);
      const double M = 6 * sine / (3 + direction * sine);
      const double q = std::abs(sample.stress(0) - sample.stress(1));
      EXPECT_NEAR(q, M * (sample.pressure() + 2000 / std::tan(phi * degree)),
                  3 * rounding(sample.point.law, 100));  // M is up to 1.9, q a difference
    }
  }
}

/// In plane strain the flow leaves the middle axis alone, whose stress stays elastic.
TEST(MohrCoulomb, HasItsStrengthInPlaneStrain) {  // Eqs. (R51), (R52)
  Sample<MohrCoulomb> sample{{soil(30, 10, 2000)}};
  const auto& law = sample.point.law;
  for (int n = 0; n < 100; ++n) sample.step(-1e-3, 5e-4, 0);

  const double sum = sample.stress(0) + sample.stress(1);
  const double nu =
      (3 * law.bulk_modulus - 2 * law.shear_modulus) / (2 * (3 * law.bulk_modulus + law.shear_modulus));
  EXPECT_NEAR((sample.stress(1) - sample.stress(0)) / 2,
              2000 * std::cos(30 * degree) - sum / 2 * std::sin(30 * degree), rounding(law, 100));
  EXPECT_NEAR(sample.stress(2), nu * sum, rounding(law, 100));
}

TEST(MohrCoulomb, DilatesByItsAngle) {  // Eq. (R57)
  for (const double psi : {0.0, 5.0, 20.0}) {
    Sample<MohrCoulomb> sample{{soil(30, psi, 2000)}};
    const auto& law = sample.point.law;
    for (int n = 0; n < 100; ++n) sample.step(-1e-3, 5e-4, 0);

    const double shear = sample.strain[1] - sample.strain[0];
    const double elastic =
        (sample.stress(1) - sample.stress(0)) / (2 * law.shear_modulus) * std::exp(sample.volume());
    EXPECT_NEAR(sample.point.state.dilation, std::sin(psi * degree) * (shear - elastic),
                rounding(law, 100) / law.bulk_modulus);
  }
}

TEST(MohrCoulomb, BearsTensionUpToItsApexOrItsCut) {  // Eqs. (R55), (R56)
  const double apex = 2000 / std::tan(30 * degree);
  for (const double strength : {0.0, 500.0, apex, 1e12}) {
    Sample<MohrCoulomb> sample{{soil(30, 10, 2000)}};
    sample.point.law.tension_strength = strength;
    sample.step(0.02, 0.01, 0.03);

    const double expected = std::min(strength, apex);
    const double tolerance = 20 * round_off * apex;
    EXPECT_LE(largest(sample.point.stress - isotropic(expected)), tolerance) << strength;
    EXPECT_EQ(sample.point.state.dilation, 0);
    // What is left of strain, rounding itself, is of trace 0 too, or it would be refused as memory: three
    // differences of two roundings each, and some ten where they are turned.
    const auto& e = sample.point.state;
    const double most = std::max({std::abs(e.xx), std::abs(e.yy), std::abs(e.zz)});
    EXPECT_LE(std::abs(e.xx + e.yy + e.zz), 3 * (2 + 10) * round_off * most) << strength;
  }
}

/// A cut of tension needs no friction.
TEST(MohrCoulomb, IsTrescasWithoutFriction) {  // Eqs. (R51), (R56)
  Sample<MohrCoulomb> sample{{soil(0, 0, 2000)}};
  sample.point.law.tension_strength = 1000;
  for (int n = 0; n < 100; ++n) sample.step(-1e-3, 1e-3, 0);
  EXPECT_NEAR(sample.stress(1), 1000, rounding(sample.point.law, 100));
  EXPECT_NEAR(sample.stress(1) - sample.stress(0), 4000, rounding(sample.point.law, 100));
}

/// Sheared under pressure, sand becomes looser for good, by `dilation`. Pulled apart from there and pushed
/// back, it presses at that density again, in every cycle, where a law that forgets how far it was apart
/// would press at once: DruckerPrager.GainsNoVolumeInACycle.
TEST(MohrCoulomb, BearsLoadAgainAtTheDensityWhereItLetGo) {  // Eq. (R57)
  Sample<MohrCoulomb> sample{{soil(35, 10, 0)}};
  const auto& law = sample.point.law;
  sample.step(-2e-3, -2e-3, -2e-3);
  for (int n = 0; n < 50; ++n) sample.step(-1e-3, 1e-3, 0);
  const double dilation = sample.point.state.dilation;
  EXPECT_GT(dilation, 0.01);

  for (int cycle = 0; cycle < 3; ++cycle) {
    const double back_to = (dilation - sample.volume()) / 3;
    sample.step(back_to + 0.01, back_to + 0.01, back_to + 0.01);
    EXPECT_EQ(largest(sample.point.stress), 0);
    for (int n = 0; n < 9; ++n) {
      sample.step(-1e-3, -1e-3, -1e-3);
      EXPECT_EQ(largest(sample.point.stress), 0);
    }
    sample.step(-2e-3, -2e-3, -2e-3);
    EXPECT_EQ(sample.point.state.dilation, dilation);
    EXPECT_NEAR(sample.pressure(), law.bulk_modulus * 3e-3 * std::exp(-sample.volume()), rounding(law, 100));
  }
}

/// A crack across one axis alone, from no stress: the others bear none either, but for rounding.
TEST(MohrCoulomb, RemembersNoCrackAcrossOneAxis) {  // Eq. (R57)
  Sample<MohrCoulomb> sample{{typical<MohrCoulomb>()}};
  const Tensor<double> crack = symmetric_part(rotated(diagonal(1, 0, 0)));
  for (int n = 0; n < 15; ++n) {  // half closed
    sample.strain[0] += n < 10 ? 1e-3 : -1e-3;
    sample.point.step((n < 10 ? 1e-3 : -1e-3) * crack, sample.density(), 1);
    EXPECT_LE(largest(sample.point.stress), rounding(sample.point.law, 20));
    EXPECT_EQ(sample.point.state.dilation, 0);
  }
}

/// In simple shear under a normal stress that is held, the axes of flow become those of stress, and the
/// friction on the planes that slide is that of Davis (1968), less than tan(phi).
TEST(MohrCoulomb, HasTheFrictionOfDavisInSimpleShear) {  // Eq. (R59)
  for (const double psi : {0.0, 10.0, 30.0}) {
    const MohrCoulomb law = soil(30, psi, 0);
    const double pressure = 1e-4 * law.bulk_modulus;
    PathPointOf<MohrCoulomb> point{law, law.density * std::exp(1e-4)};
    const double strain = pressure / law.shear_modulus;

    drive(point, simple_shear_at_constant_pressure(1), 40 * strain, 200);

    const double sine = std::sin(30 * degree);
    const double expected = sine * std::cos(psi * degree) / (1 - sine * std::sin(psi * degree));
    // The stored strain is turned all the while: its axes lag by tau/(2 G) at most, the friction by twice
    // that.
    EXPECT_NEAR(-point.now.stress(0, 1) / point.now.stress(1, 1), expected, strain) << psi;
  }
}

/// The tangent of a step, d sigma/d(L dt) with the density following, in one direction.
[[nodiscard]] Tensor<double> tangent(const Sample<MohrCoulomb>& sample, const Tensor<double>& gradient,
                                     const Tensor<double>& direction) {
  Deformation<Dual> deformation{};
  for (std::size_t i = 0; i < 9; ++i) {
    deformation.velocity_gradient.components[i] = {gradient.components[i], direction.components[i]};
  }
  const double density = sample.density() * std::exp(-trace(gradient));
  deformation.density = {density, -density * trace(direction)};
  const auto& b = sample.point.state;
  const MohrCoulomb::State<Dual> old{b.xx, b.yy, b.zz, b.xy, b.xz, b.yz, b.dilation};
  const auto response = sample.point.law.update(deformation, {}, old, Dual(1));
  Tensor<double> result;
  for (std::size_t i = 0; i < 9; ++i) result.components[i] = response.stress.components[i].slope;
  return result;
}

/// Determinant of the acoustic tensor of a step of plane compression along x that is short beside the elastic
/// strain, for a band whose normal is at
/// an angle from x in the plane of x and y, over that of the elastic material.
[[nodiscard]] double acoustic_determinant(const Sample<MohrCoulomb>& sample, double angle) {
  const std::array n{std::cos(angle), std::sin(angle)};
  Matrix<2> acoustic;
  for (std::size_t k = 0; k < 2; ++k) {
    Tensor<double> jump;
    for (std::size_t l = 0; l < 2; ++l) jump(k, l) = n[l];
    const auto rate = tangent(sample, diagonal(-1e-11, 1e-11, 0), jump);
    for (std::size_t i = 0; i < 2; ++i) {
      acoustic(static_cast<int>(i), static_cast<int>(k)) = rate(i, 0) * n[0] + rate(i, 1) * n[1];
    }
  }
  const auto& law = sample.point.law;
  return acoustic.determinant() / (law.shear_modulus * (law.bulk_modulus + 4 * law.shear_modulus / 3));
}

/// Without hardening, flow with less dilatancy than friction is unstable: shear localises in any band between
/// the angles of Roscoe, 45 + psi/2, and of Coulomb, 45 + phi/2 degrees, where the determinant of the
/// acoustic tensor is negative, by Eq. (R60); and that in a run is as wide as the mesh. The remedy within
/// this law is associated flow, where it reaches zero at the one angle that is left.
TEST(MohrCoulomb, LocalisesBetweenTheAnglesOfRoscoeAndCoulomb) {
  for (const double psi : {0.0, 10.0, 30.0}) {
    Sample<MohrCoulomb> sample{{soil(30, psi, 0)}};
    const auto& law = sample.point.law;
    const double strain = 1e-6;
    sample.step(-strain, -strain, -strain);
    for (int n = 0; n < 20; ++n) sample.step(-strain, strain, 0);

    const double G = law.shear_modulus;
    const double kappa = law.bulk_modulus + G / 3;
    const double sin_phi = std::sin(30 * degree);
    const double sin_psi = std::sin(psi * degree);
    const double scale = G * kappa / ((kappa + G) * (G + kappa * sin_phi * sin_psi));
    // Stress turns with the band and bears on its area: terms of stress/G, which is below 10 K/G strain.
    const double tolerance = 10 * 10 * law.bulk_modulus / G * strain;
    for (double angle = 0; angle <= 90; angle += 5) {
      const double c = std::cos(2 * angle * degree);
      EXPECT_NEAR(acoustic_determinant(sample, angle * degree), scale * (c + sin_phi) * (c + sin_psi),
                  tolerance);
    }
    const double worst = acoustic_determinant(sample, (45 + (30 + psi) / 4) * degree);
    if (psi < 30) {
      EXPECT_LT(worst, -tolerance) << psi;
    } else {
      EXPECT_GT(worst, -tolerance) << psi;
    }
  }
}

/// At constant volume dilatancy raises the pressure and that the strength, at the constant rate (R61), for
/// ever: an undrained slope that never fails. The remedy is psi = 0: then the strength is c cos(phi) and
/// sin(phi) times the pressure in the plane that it began with.
TEST(MohrCoulomb, HasNoUndrainedStrengthIfItDilates) {
  for (const double psi : {0.0, 10.0}) {
    Sample<MohrCoulomb> sample{{soil(30, psi, 2000)}};
    const auto& law = sample.point.law;
    sample.step(-1e-3, -1e-3, -1e-3);
    const auto mean = [&] { return -(sample.stress(0) + sample.stress(1)) / 2; };
    const auto strength = [&] { return (sample.stress(1) - sample.stress(0)) / 2; };
    const double at_start = mean();
    for (int n = 0; n < 20; ++n) sample.step(-1e-3, 1e-3, 0);
    const double halfway = mean();
    for (int n = 0; n < 20; ++n) sample.step(-1e-3, 1e-3, 0);

    const double sin_phi = std::sin(30 * degree);
    const double sin_psi = std::sin(psi * degree);
    const double kappa = law.bulk_modulus + law.shear_modulus / 3;
    const double slope = kappa * sin_psi / (1 + kappa / law.shear_modulus * sin_phi * sin_psi);
    const double compression = std::exp(-sample.volume());
    EXPECT_NEAR(mean() - halfway, compression * slope * 20 * 2e-3, rounding(law, 40));
    EXPECT_NEAR(strength(), 2000 * std::cos(30 * degree) + sin_phi * mean(), rounding(law, 40));
    if (psi == 0) {
      EXPECT_NEAR(mean(), at_start, rounding(law, 40));
    }
  }
}

/// In each region of the surface, in every direction.
TEST(MohrCoulomb, HasTheTangentThatItsDualNumbersCarry) {
  MohrCoulomb law = typical<MohrCoulomb>();
  law.cohesion = 1e5;
  const Sample<MohrCoulomb> sample{{law}};
  const auto stress_at = [&](const Tensor<double>& gradient) {
    return law.update({gradient, sample.density() * std::exp(-trace(gradient))}, {}, sample.point.state, 1.0)
        .stress;
  };
  const double gap = 0.1;    // [-], between the strains that follow
  const double step = 5e-4;  // balances what follows
  // Truncation of fourth order by the curvature that turning axes have, 60 roundings of strains of order one.
  const double tolerance = (std::pow(step / gap, 4) + 60 * round_off / step) * 2 * law.bulk_modulus;
  ASSERT_LT(tolerance, 1e-8 * 2 * law.bulk_modulus);
  for (const auto& strain : {diagonal(-0.3, -0.4, -0.5), diagonal(0.2, -0.2, -0.5), diagonal(0.2, 0.1, -0.5),
                             diagonal(0.5, -0.3, -0.5), diagonal(0.3, -0.1, -0.2), diagonal(0.3, 0.2, -0.1),
                             diagonal(0.3, 0.2, 0.1), diagonal(0.5, -0.1, -0.5), diagonal(0.5, 0.1, -0.5)}) {
    const auto at = symmetric_part(rotated(strain));
    for (auto direction : velocity_gradients()) {
      direction *= 1 / std::sqrt(contract(direction, direction));
      const auto exact = tangent(sample, at, direction);

      const auto near = stress_at(at + step * direction) - stress_at(at - step * direction);
      const auto far = stress_at(at + 2 * step * direction) - stress_at(at - 2 * step * direction);

      const auto difference = 1 / (12 * step) * (8.0 * near - far);
      EXPECT_LE(largest(exact - difference), tolerance);
    }
  }
}

[[nodiscard]] std::string complaint(const MohrCoulomb& law) {
  return message_of<InputError>([&] { validate(law); });
}

TEST(MohrCoulomb, RefusesToDilateMoreThanItRubs) {
  MohrCoulomb law = typical<MohrCoulomb>();
  law.dilatancy = law.friction;
  EXPECT_EQ(complaint(law), "no error");
  law.friction = 0.1;
  law.dilatancy = 0.2;
  EXPECT_EQ(complaint(law), "mohr_coulomb: friction = 0.1: must be at least dilatancy = 0.2");
  law.dilatancy = -0.1;
  EXPECT_EQ(complaint(law), "mohr_coulomb: dilatancy = -0.1: must be finite and at least 0");
  law.dilatancy = 0;
  law.cohesion = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint(law), "mohr_coulomb: cohesion = nan Pa: must be finite and at least 0");
}

}  // namespace
}  // namespace scree::rheology
