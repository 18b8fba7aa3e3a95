#include "bodies.hpp"

#include <scree/mpm/geostatic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace scree::mpm {
namespace {

constexpr double gravity = 9.81;  // [m/s^2]
constexpr Fluid soft{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};

/// A column of 10 cells of 0.1 m, filled up to 0.8 m, at rest under its own weight.
struct Column10 {
  explicit Column10(double surface_pressure = 0) {
    const auto grid = cube<1>(10, 0.1, false);
    particles = filled<1>(grid, 3);
    const StressUpdateBy<1, 1, Fluid> stress{soft, particles};
    before = particles;
    set_geostatic(particles, stress, 0, surface, gravity, surface_pressure);
    pressure.resize(static_cast<std::size_t>(particles.size()));
    stress.pressure(particles, pressure);
  }
  static constexpr double surface = 0.8;  // [m]
  Particles<1> particles;
  Particles<1> before;
  std::vector<double> pressure;
};

/// Eq. (M24): dp/dz = rho(p) g has K + p = (K + p_0) exp(rho_0 g z/K).
void expect_balance(double surface_pressure) {
  const Column10 column{surface_pressure};

  for (Index p = 0; p < column.particles.size(); ++p) {
    const double depth = Column10::surface - column.particles.position.component(0)[p];
    if (depth <= 0) continue;
    const double K = soft.bulk_modulus;
    const double exponent = soft.reference_density * gravity * depth / K;
    const double expected = K * std::expm1(exponent) + surface_pressure * std::exp(exponent);
    // Four steps of a fourth-order rule, exponent^5/(5! 4^4) of K, which grow with the solution; the
    // pressure's rounding is K round_off.
    const double truncation = std::pow(exponent, 5) / (120 * 256) * std::exp(exponent);
    const double tolerance = (K + surface_pressure) * (truncation + 16 * round_off);
    EXPECT_NEAR(column.pressure[static_cast<std::size_t>(p)], expected, tolerance);
  }
}

TEST(SetGeostatic, BalancesTheWeightAbove) {
  expect_balance(0);
}

TEST(SetGeostatic, BalancesAPressureOnTheSurfaceToo) {
  expect_balance(2e4);
}

TEST(SetGeostatic, KeepsTheVolumeOfEachPoint) {
  const Column10 column;

  for (Index p = 0; p < column.particles.size(); ++p) {
    const double volume = column.particles.mass.component(0)[p] / column.particles.density.component(0)[p];
    const double before = column.before.mass.component(0)[p] / column.before.density.component(0)[p];
    EXPECT_NEAR(volume, before, 4 * round_off * before);
  }
}

TEST(SetGeostatic, LeavesPointsAboveTheSurfaceAlone) {
  const Column10 column;

  for (Index p = 0; p < column.particles.size(); ++p) {
    if (column.particles.position.component(0)[p] < Column10::surface) continue;
    EXPECT_EQ(column.particles.density.component(0)[p], column.before.density.component(0)[p]);
    EXPECT_EQ(column.particles.mass.component(0)[p], column.before.mass.component(0)[p]);
  }
}

}  // namespace
}  // namespace scree::mpm
