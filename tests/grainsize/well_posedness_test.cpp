#include "table.hpp"

#include <scree/grainsize/distribution.hpp>
#include <scree/grainsize/well_posedness.hpp>
#include <scree/tensor.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scree::grainsize {
namespace {

/// The paper's mixture, viscosity and closure about a uniform shear rate.
CoupledFlow paper_flow(double shear_rate, double fraction_small) {
  const Distribution mixture = bidisperse(0.5e-3, 1e-3, fraction_small);
  const auto diameters = mixture.classes.diameters();
  const double mean = arithmetic_mean(diameters, mixture.fractions);
  constexpr double modulus = 1e6;  // [Pa s/m]
  return {.c = 0.05,
          .shear_rate = shear_rate,
          .density = 1000,
          .viscosity = modulus * mean,
          .viscosity_slope = modulus,
          .arithmetic_mean = mean,
          .harmonic_mean = harmonic_mean(diameters, mixture.fractions)};
}

TEST(WellPosedness, GrowthAndCriticalRemixingAreThoseOfTheReference) {  // Eq. (G11), (G12)
  for (const auto& row : test::read_table("segregation/illposed_growth.csv")) {
    const CoupledFlow flow = paper_flow(std::stod(row[0]), std::stod(row[1]));
    const double wave_number = 2 * std::numbers::pi / std::stod(row[2]);

    // The table has eight digits of the rate and six of D_crit.
    EXPECT_NEAR(growth_rate(flow, wave_number) / std::stod(row[4]), 1, 1e-7);
    EXPECT_NEAR(critical_remixing(flow) / std::stod(row[5]), 1, 5e-6);
  }
}

TEST(WellPosedness, SizeContrastIsTheBidispersePrefactor) {  // Eq. (G9): (s_a - s_h) = A (s_large - s_small)
  for (const double phi : {0.1, 0.5, 0.9}) {
    const CoupledFlow flow = paper_flow(1, phi);

    const double contrast = (flow.arithmetic_mean - flow.harmonic_mean) / 0.5e-3;

    // Means near 1e-3 with 4 roundings each, over half of it.
    EXPECT_NEAR(contrast, bidisperse_flux(phi, 2), 16 * round_off);
  }
}

TEST(WellPosedness, CriticalRemixingStopsTheGrowthAtEveryWavelength) {
  const CoupledFlow flow = paper_flow(4.042, 0.5);
  const double critical = critical_remixing(flow);

  for (const double wavelength : {1e-3, 0.04, 0.2, 10.0}) {
    const double wave_number = 2 * std::numbers::pi / wavelength;
    EXPECT_GT(growth_rate(flow, wave_number, 0.99 * critical), 0);
    EXPECT_LT(growth_rate(flow, wave_number, 1.01 * critical), 0);
  }
}

TEST(WellPosedness, GrowthIsARootOfItsEquation) {  // Eq. (G11)
  const CoupledFlow flow = paper_flow(2.02, 0.3);
  const double k2 = 900;
  const double D = 0.3 * critical_remixing(flow);

  const double omega = growth_rate(flow, 30, D);

  const double left = (omega + D * k2) * (flow.density * omega + flow.viscosity * k2);
  const double right = critical_remixing(flow) * flow.viscosity * k2 * k2;
  EXPECT_NEAR(left / right, 1, 32 * round_off);  // some twenty operations, no cancellation
}

TEST(WellPosedness, GrowsAsTheSquareOfTheWaveNumber) {  // Hadamard: the finer the faster, without bound
  const CoupledFlow flow = paper_flow(4.042, 0.5);

  EXPECT_NEAR(growth_rate(flow, 2e3) / growth_rate(flow, 1e3), 4, 32 * round_off);
}

TEST(WellPosedness, FlowThatThinsWithSizeDecays) {
  CoupledFlow flow = paper_flow(4.042, 0.5);
  flow.viscosity_slope = -flow.viscosity_slope;

  EXPECT_LT(critical_remixing(flow), 0);
  EXPECT_LT(growth_rate(flow, 30), 0);
}

}  // namespace
}  // namespace scree::grainsize
