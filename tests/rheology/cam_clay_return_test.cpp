#include "derivative.hpp"

#include <scree/rheology/cam_clay_return.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace scree::rheology {
namespace {

using testing::Dual;

/// A step that yields, with p_c = 1 before it.
struct Step {
  CamClayFlow flow;
  double u;
  double q;
  double shear_modulus;
};

/// Clays of all kinds, on both sides of the critical state, pressed or sheared a little or far too much.
[[nodiscard]] Step random_step(std::mt19937& random) {
  std::uniform_real_distribution<double> share{0, 1};
  Step step{};
  step.flow.M = 0.5 + 1.5 * share(random);
  step.flow.kappa = 0.002 * std::pow(50, share(random));
  step.flow.lambda = step.flow.kappa * (1.05 + 10 * share(random));
  step.shear_modulus = std::pow(10, -1 + 5 * share(random));
  step.u = share(random) < 0.5 ? 6 * share(random) - 3 : 20.7 - 100 * share(random);
  const double at_yield = step.u > 0 ? step.flow.M * std::exp(-step.u) * std::sqrt(std::expm1(step.u)) : 0;
  step.q = at_yield + 3 * step.shear_modulus * std::pow(10, -8 + 8 * share(random));
  return step;
}

constexpr int num_steps = 20000;

/// From the equations as they are, not from the state boundary surface.
TEST(CamClayReturn, SolvesBackwardEuler) {  // Eqs. (R62) to (R66)
  std::mt19937 random{1};
  for (int n = 0; n < num_steps; ++n) {
    const Step s = random_step(random);
    const auto [M, lambda, kappa] = s.flow;

    const auto end = cam_clay_return(s.flow, s.u, s.q, 1.0, s.shear_modulus);

    ASSERT_EQ(end.unsolved, 0) << n;
    const double p_c = end.p * std::exp(end.u);
    const double compaction = (lambda - kappa) * std::log(p_c);
    const double shearing = (s.q - end.q) / (3 * s.shear_modulus);
    // Each within rounding of the largest of its terms, of which u is up to 80, 20 times.
    const double rounding = 20 * 80 * round_off;
    EXPECT_NEAR(end.q * end.q, M * M * end.p * (p_c - end.p), rounding * M * M * end.p * p_c) << n;
    EXPECT_NEAR(kappa * std::log(end.p), -kappa * s.u - compaction, rounding * lambda) << n;
    // Flow by the normal, dp : dq = 2 p - p_c : 2 q/M^2; what is left of it is left of Eq. (R66).
    const double terms = std::abs(compaction) * 2 * end.q / (M * M) + std::abs(shearing * (2 * end.p - p_c));
    const double left = 1e-10 * (kappa * (1 + std::abs(s.u)) * end.q / (M * M) +
                                 (s.q + end.q) / s.shear_modulus * (end.p + p_c));
    EXPECT_NEAR(compaction * 2 * end.q / (M * M), shearing * (2 * end.p - p_c), rounding * terms + left) << n;
    EXPECT_GE(shearing, -rounding * s.q / s.shear_modulus) << n;
  }
}

/// To 1e-8, by a central difference of fourth order.
TEST(CamClayReturn, HasTheDerivativeThatItsDualNumbersCarry) {
  const CamClayFlow flow{1, 0.1, 0.02};
  for (const double u : {-5.0, -0.5, 0.3, 1.0, 3.0}) {
    for (const double q : {1.0, 2.0, 5.0}) {
      const auto at = [&](double x) { return cam_clay_return(flow, u + x, q - 2 * x, 1.0, 20.0); };
      const auto exact = cam_clay_return<Dual>(flow, {u, 1}, {q, -2}, 1.0, 20.0);

      // Numbers of order one change over strains u of order one: truncation step^4, rounding of 60.
      const double step = 1e-3;
      const double tolerance = 100 * (std::pow(step, 4) + 60 * round_off / step);
      EXPECT_LT(tolerance, 1e-8);
      const auto slope = [&](auto number) {
        return (8 * (number(at(step)) - number(at(-step))) - number(at(2 * step)) + number(at(-2 * step))) /
               (12 * step);
      };
      EXPECT_NEAR(exact.p.slope, slope([](const auto& s) { return s.p; }), tolerance) << u << ' ' << q;
      EXPECT_NEAR(exact.q.slope, slope([](const auto& s) { return s.q; }), tolerance) << u << ' ' << q;
    }
  }
}

}  // namespace
}  // namespace scree::rheology
