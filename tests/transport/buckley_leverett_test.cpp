#include "lines.hpp"

#include <scree/transport/laws/buckley_leverett.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::transport {
namespace {

/// 1 | 0 on [-1, 2] at T = 1: a fan up to u* = 1/sqrt 2 and a shock of speed (1 + sqrt 2)/2.  Eq. (T14)
std::vector<double> exact(const Lattice<1>& lattice) {
  return test::averages(lattice, [](double x) {
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double w = i / 20000.0;
      largest = std::max(largest, w * w / (w * w + (1 - w) * (1 - w)) - w * x);
    }
    return -largest;
  });
}

template <class L>
double error(Index n, const L& limiter) {
  const Lattice<1> lattice = test::line(n, -1, 2, false);
  std::vector<double> u(static_cast<std::size_t>(n), 0.0);
  std::fill(u.begin(), u.begin() + n / 3, 1.0);
  Solver solver{Cartesian<1>{lattice},
                BuckleyLeverett{},
                PiecewiseLinear{limiter},
                SspRk2{},
                {.cfl = 0.4, .boundaries = {{{Outflow{}, Outflow{}}}}}};
  solver.advance(u, 1);
  return test::l1(u, exact(lattice), lattice.spacing[0]);
}

// Tables of another code, three digits; where the shock sits in its cell at the end depends on the rule for
// the last step: 10 %.
TEST(BuckleyLeverett, HasTheErrorsOfTheTable) {
  EXPECT_NEAR(error(120, Minmod{1}), 2.087e-2, 0.1 * 2.087e-2);
  EXPECT_NEAR(error(240, Minmod{1}), 1.060e-2, 0.1 * 1.060e-2);
  EXPECT_NEAR(error(120, Minmod{2}), 8.028e-3, 0.1 * 8.028e-3);
  EXPECT_NEAR(error(240, Minmod{2}), 3.338e-3, 0.1 * 3.338e-3);
}

TEST(BuckleyLeverett, ConvergesSlowlyWithSuperbee) {  // fluxes that are not convex: compression keeps errors
  const double order = std::log2(error(120, Superbee{}) / error(480, Superbee{})) / 2;
  EXPECT_LE(order, 0.6);
  EXPECT_GE(std::log2(error(120, Minmod{1}) / error(480, Minmod{1})) / 2, 0.8);
}

TEST(BuckleyLeverett, RefusesRatiosThatCannotBe) {
  for (const double ratio : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(test::message_of<InputError>([&] { BuckleyLeverett{ratio}; }),
              "BuckleyLeverett: the viscosity ratio must be positive and finite");
  }
}

}  // namespace
}  // namespace scree::transport
