#include <scree/rest_density.hpp>
#include <scree/tensor.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scree {
namespace {

/// Pressure [Pa] of grains that touch at a density and bear nothing below.
[[nodiscard]] double grains(double density, double touching) {
  return std::max(1e6 * (density / touching - 1), 0.0);
}

TEST(RestDensity, OfALinearLawIsFoundAtOnce) {
  int num_asked = 0;
  const auto excess = [&](double density) {
    ++num_asked;
    return 1e6 * (density / 1500 - 1) - 3e3;
  };

  EXPECT_NEAR(rest_density(excess, 1500).value(), 1504.5, 8 * round_off * 1504.5);  // a few operations
  EXPECT_LE(num_asked, 4);  // two, the answer, and that it stays
}

/// From a density at which grains do not touch the secant rule goes nowhere: pressures are alike there.
TEST(RestDensity, IsFoundFromWhereNothingIsBorne) {
  for (const double touching : {1510.0, 2000.0, 4500.0}) {
    for (const double pressure : {0.0, 3e3}) {
      const auto excess = [&](double density) { return grains(density, touching) - pressure; };

      const double expected = touching * (1 + pressure / 1e6);
      EXPECT_NEAR(rest_density(excess, 1500).value(), expected, 8 * round_off * expected) << touching;
    }
  }
}

TEST(RestDensity, WithoutPressureIsThatAtWhichGrainsTouch) {
  for (const double touching : {1000.0, 1499.0, 1500.0, 1501.0, 1600.0}) {
    const auto excess = [&](double density) { return grains(density, touching); };

    EXPECT_NEAR(rest_density(excess, 1500).value(), touching, 8 * round_off * touching);
  }
}

TEST(RestDensity, IsNoneForDustAndForAGasWithoutWalls) {
  EXPECT_FALSE(rest_density([](double) { return -10.0; }, 1500).has_value());
  EXPECT_FALSE(rest_density([](double density) { return 1 + density; }, 1500).has_value());
  EXPECT_FALSE(rest_density([](double) { return std::nan(""); }, 1500).has_value());
}

/// Where it fails: grains that touch only beyond 1 + 2^11 1e-3 times the density it begins with, 3.048.
TEST(RestDensity, IsNotLookedForBeyondThreeTimesTheStart) {
  for (const double touching : {3.0, 3.1}) {
    const auto excess = [&](double density) { return grains(density, touching); };

    EXPECT_EQ(rest_density(excess, 1).has_value(), touching < 3.048) << touching;
  }
}

}  // namespace
}  // namespace scree
