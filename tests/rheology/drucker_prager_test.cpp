#include "points.hpp"

#include <scree/rheology/laws/drucker_prager.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace scree::rheology {
namespace {

constexpr DruckerPrager law = typical<DruckerPrager>();
constexpr double dense = 1.001 * law.density;  // [kg/m^3]

[[nodiscard]] double shear_stress(const Tensor<double>& sigma) {
  return std::sqrt(contract(deviator(sigma), deviator(sigma)) / 2);
}

/// Never yields.
[[nodiscard]] DruckerPrager rock() {
  DruckerPrager result = law;
  result.friction = 1e6;
  return result;
}

[[nodiscard]] Tensor<double> diagonal(double xx, double yy, double zz) {
  return {{xx, 0, 0, 0, yy, 0, 0, 0, zz}};
}

TEST(DruckerPrager, PressesByTheLogarithmOfItsDensity) {  // Eq. (R22)
  for (const double compression : {1.0, 1.001, 1.5}) {
    const auto sigma = stress(law, {}, compression * law.density);

    const double expected = law.bulk_modulus * std::log(compression) * compression;
    EXPECT_NEAR(sigma(0, 0), -expected, 10 * round_off * law.bulk_modulus);
  }
}

/// Stretched to any size at constant volume, rock bears 2 G times the logarithm of the stretch, whatever the
/// steps.
TEST(DruckerPrager, IsElasticInLogarithmicStrain) {  // Eq. (R23)
  for (const int num_steps : {1, 100}) {
    const double stretch = 2;  // [-], logarithmic
    Point<DruckerPrager> point{rock()};
    for (int n = 0; n < num_steps; ++n) point.step(diagonal(1, -1, 0), dense, stretch / num_steps);

    const double expected = 1.001 * 2 * law.shear_modulus * stretch;
    const double tolerance = num_steps * 60 * round_off * expected;  // some sixty operations a step
    EXPECT_NEAR(deviator(point.stress)(0, 0), expected, tolerance);
    EXPECT_NEAR(deviator(point.stress)(2, 2), 0, tolerance);
  }
}

/// With Eq. (R25) the cone touches that of Mohr and Coulomb in triaxial compression: q/p = 6 sin/(3 - sin).
TEST(DruckerPrager, HasTheStrengthOfTriaxialCompression) {
  for (const double degrees : {20.0, 30.0, 40.0}) {
    const double sine = std::sin(degrees * std::numbers::pi / 180);
    DruckerPrager sand = law;
    sand.friction = 2 * std::sqrt(3.0) * sine / (3 - sine);
    Point<DruckerPrager> point{sand};
    for (int n = 0; n < 10; ++n) point.step(diagonal(-1, 0.5, 0.5), dense, 1e-3);

    const double q = point.stress(1, 1) - point.stress(0, 0);
    const double p = -trace(point.stress) / 3;
    EXPECT_NEAR(q, 6 * sine / (3 - sine) * p, 10 * rounding_of_strain(law)) << degrees;
    // The largest principal stress over the smallest is that of Rankine.
    EXPECT_NEAR(point.stress(0, 0) / point.stress(1, 1), (1 + sine) / (1 - sine),
                30 * rounding_of_strain(law) / p);
  }
}

TEST(DruckerPrager, StaysWithinItsCone) {  // Eq. (R24)
  for (const double density : densities(law)) {
    Point<DruckerPrager> point{law};
    for (const auto& gradient : velocity_gradients()) {
      point.step(gradient, density, 0.01);

      const double p = -trace(point.stress) / 3;
      EXPECT_LE(shear_stress(point.stress), law.friction * p + 2 * rounding_of_strain(law));
    }
  }
}

TEST(DruckerPrager, DoesNotFeelTheRate) {
  Point<DruckerPrager> slow{law};
  Point<DruckerPrager> fast{law};
  for (const auto& gradient : velocity_gradients()) {
    slow.step(gradient, dense, 0.0078125);
    fast.step(1024.0 * gradient, dense, 0.0078125 / 1024);  // a power of two: the same bits
  }

  EXPECT_EQ(slow.stress.components, fast.stress.components);
}

/// Where a law that turns a stress with the spin swings back, G sin(strain), this one does not: to second
/// order in the step.
TEST(DruckerPrager, BearsLargeElasticShearTheRightWay) {
  // F = 1 + 4 e_x e_y: sigma_xy = 2 G e_xy/J, and the logarithm of b = F F^T is known: with its eigenvalue
  // l = (2 + g^2 + g sqrt(4 + g^2))/2, e_xy = ln(l)/sqrt(4 + g^2).
  const double strain = 4;
  const double root = std::sqrt(4 + strain * strain);
  const double eigenvalue = (2 + strain * strain + strain * root) / 2;
  const double expected = 1.001 * 2 * law.shear_modulus * std::log(eigenvalue) / root;
  const auto error = [&](int num_steps) {
    Point<DruckerPrager> point{rock()};
    for (int n = 0; n < num_steps; ++n) point.step(simple_shear(1), dense, strain / num_steps);
    return point.stress(0, 1) - expected;
  };

  const double coarse = error(200);
  const double fine = error(400);

  const double step = strain / 200;
  EXPECT_NEAR(coarse / fine, 4, 4 * step);  // the next order is less by that
  EXPECT_LE(std::abs(coarse), step * step * expected);
}

/// Pulled apart by 1 % and pushed back, sand of Klar et al. (2016) without volume correction has forgotten
/// that it was apart: it presses at once, K times 1 %, and under a given pressure it is larger by 1 % with
/// every cycle. This law reads its volume from the density, and gains nothing.
TEST(DruckerPrager, GainsNoVolumeInACycle) {  // Eq. (R22)
  const double opening = 0.01;                // [-], logarithmic
  const int num_steps = 10;
  Point<DruckerPrager> corrected{law};
  Point<DruckerPrager> uncorrected{law};
  double volume = 0;   // logarithm of the true one over that without pressure
  double elastic = 0;  // what is left of it if the apex forgets
  for (int cycle = 1; cycle <= 3; ++cycle) {
    for (int n = 0; n < 2 * num_steps; ++n) {
      const double increment = (n < num_steps ? opening : -opening) / num_steps;
      volume += increment;
      elastic = std::min(elastic + increment, 0.0);  // at the apex no strain is stored
      corrected.step(isotropic(increment / 3), law.density * std::exp(-volume), 1);
      uncorrected.step(isotropic(increment / 3), law.density * std::exp(-elastic), 1);
    }

    const double tolerance = 100 * round_off * law.bulk_modulus;
    EXPECT_NEAR(-trace(corrected.stress) / 3, 0, tolerance);
    const double spurious = law.bulk_modulus * opening * std::exp(opening);
    EXPECT_NEAR(-trace(uncorrected.stress) / 3, spurious, tolerance);
    elastic = 0;  // the pressure is let off: it has grown for good
    EXPECT_NEAR(volume, 0, 100 * round_off);
  }
}

}  // namespace
}  // namespace scree::rheology
