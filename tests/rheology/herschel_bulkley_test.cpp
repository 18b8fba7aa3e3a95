#include "inclined_layer.hpp"
#include "pipe_flow.hpp"
#include "points.hpp"
#include "zigzag.hpp"

#include <scree/rheology/laws/bingham.hpp>
#include <scree/rheology/laws/herschel_bulkley.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

/// Mud: thinning, with a yield stress.
[[nodiscard]] HerschelBulkley mud(double exponent, double regularisation_time = 100) {
  return {.consistency = 100,
          .exponent = exponent,
          .yield_stress = 50,
          .regularisation_time = regularisation_time,
          .bulk_modulus = 1e7,
          .density = 1000};
}

TEST(HerschelBulkley, IsBinghamWithExponentOne) {  // Eq. (R10)
  const Bingham same{
      .viscosity = 100, .yield_stress = 50, .regularisation_time = 100, .bulk_modulus = 1e7, .density = 1000};
  for (const auto& gradient : velocity_gradients()) {
    EXPECT_EQ(stress(mud(1), gradient, 1001.0).components, stress(same, gradient, 1001.0).components);
  }
}

TEST(HerschelBulkley, IsAPowerLawOnceYielded) {  // Eq. (R10)
  for (const double n : {0.3, 0.5, 1.0, 2.0}) {
    for (const double rate : {1.0, 10.0, 1000.0}) {
      const double expected = 50 + 100 * std::pow(rate, n);

      const double actual = stress(mud(n), simple_shear(rate), 1000.0)(0, 1);

      // (1 + 1/(m gdot)^2)^((n-1)/2), and some ten roundings.
      const double regularisation = std::abs(n - 1) / 2 / std::pow(100 * rate, 2);
      EXPECT_NEAR(actual, expected, (regularisation + 10 * round_off) * expected);
    }
  }
}

/// Through a pipe, with the share phi = tau_y/tau_w of its radius that is a plug, flows n gdot_w (1 - phi)
/// ((1 - phi)^2/(3 n + 1) + 2 phi (1 - phi)/(2 n + 1) + phi^2/(n + 1)) pi R^3. Chhabra & Richardson (2008)
TEST(HerschelBulkley, FlowsThroughAPipeAroundItsPlug) {  // Eq. (R10)
  const int num_parts = 400;
  for (const double n : {0.5, 1.0, 1.5}) {
    const HerschelBulkley fluid = mud(n, 1e9);  // yielded at each rate that is looked at but zero
    for (const double wall_rate : {0.1, 1.0, 100.0}) {
      const double plug = 50 / (50 + 100 * std::pow(wall_rate, n));
      const double sheared = 1 - plug;
      const double exact =
          n * wall_rate * sheared *
          (sheared * sheared / (3 * n + 1) + 2 * plug * sheared / (2 * n + 1) + plug * plug / (n + 1));

      EXPECT_NEAR(pipe_flow(fluid, wall_rate, num_parts), exact, error_of_pipe_flow(num_parts) * wall_rate)
          << n;
    }
  }
}

/// The sheet of a power-law fluid (no yield stress) down an incline: u = n/(n+1) (G/K)^(1/n) H^(1+1/n) at the
/// surface. \cite bird1987
TEST(HerschelBulkley, FlowsDownAnInclineAsAPowerLawFluidDoes) {
  const double drive = 3000;  // [Pa/m], layer of 1 m
  for (const double n : {0.5, 1.0, 2.0}) {
    HerschelBulkley fluid = mud(n, 1e6);
    fluid.yield_stress = 0;
    const double exact = n / (n + 1) * std::pow(drive / fluid.consistency, 1 / n);
    const int num_parts = 1000;
    double speed = 0;
    for (int i = 0; i < num_parts; ++i) {
      speed += shear_rate_at(fluid, drive * (i + 0.5) / num_parts, 1000, 1e5) / num_parts;
    }

    // Midpoint rule for depth^(1/n): its slope at the base over 24 N^2, or the first part of a root, which is
    // off by less than N^-1.5. The regularisation, 1/(m gdot)^2 where the rate is lowest, is less than that.
    const double quadrature =
        n <= 1 ? (1 / n) * (1 + 1 / n) / 24 * std::pow(num_parts, -2.0) : std::pow(num_parts, -1.5);
    EXPECT_NEAR(speed, exact, quadrature * exact) << n;
  }
}

/// A thinning fluid has no finite viscosity at rest; the regularised one has, and pays with its step.
TEST(HerschelBulkley, ExplicitStepsBlowUpAboveTheLimitAtRest) {  // Eqs. (R7), (R10)
  const HerschelBulkley fluid = mud(0.5);
  const double at_rest = 100 * std::sqrt(100.0) + 50 * 100;  // K m^(1-n) + tau_y m
  EXPECT_NEAR(fluid.stiffness(Deformation<double>{}, {}, {}).viscosity, at_rest, 10 * round_off * at_rest);
  const double dx = 0.02;  // [m]
  const double limit = fluid.density * dx * dx / (2 * at_rest);
  const double speed = 1e-12;  // [m/s]
  const double x = 100 * 2 * speed / dx * std::pow(1.02, 100);
  const double tolerance = 100 * x + 1000 * round_off;  // as of Bingham

  EXPECT_NEAR(zigzag_after(fluid, 100, 0.99 * limit, dx, speed), std::pow(0.98, 100), tolerance);
  EXPECT_NEAR(zigzag_after(fluid, 100, 1.01 * limit, dx, speed), std::pow(1.02, 100),
              tolerance * std::pow(1.02, 100));
}

}  // namespace
}  // namespace scree::rheology
