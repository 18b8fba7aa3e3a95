#include "lines.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/laws/buckley_leverett.hpp>
#include <scree/transport/laws/buckley_leverett_gravity.hpp>
#include <scree/transport/laws/capillary.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::transport {
namespace {

const BuckleyLeverettGravity<1> sinking{Vector<1>{5.0}};

/// Averages of the exact solution of a Riemann problem: the integral of u is -t G(x/t), where G(s) is the
/// least f(w) - s w between two states for a rise, the largest for a fall (Osher 1984).
std::vector<double> exact(const Lattice<1>& lattice, double left, double right, double time) {
  const double sign = left < right ? 1 : -1;
  return test::averages(lattice, [=](double x) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 20000; ++i) {
      const double w = left + (right - left) * i / 20000;
      least = std::min(least, sign * (sinking.flux({w}, Vector<1>{1.0})[0] - w * x / time));
    }
    return -time * sign * least;
  });
}

double error(Index n, double left, double right) {
  const Lattice<1> lattice = test::line(n, -1.5, 1.5, false);
  std::vector<double> u(static_cast<std::size_t>(n), right);
  std::fill(u.begin(), u.begin() + n / 2, left);
  Solver solver{Cartesian<1>{lattice}, sinking, {.boundaries = {{{Outflow{}, Outflow{}}}}}};
  solver.advance(u, 0.4);
  return test::l1(u, exact(lattice, left, right, 0.4), lattice.spacing[0]);
}

TEST(BuckleyLeverettGravity, ConvergesToTheCompositeWave) {  // first order, with shocks at the ends of fans
  EXPECT_GE(std::log2(error(60, 1, 0) / error(480, 1, 0)) / 3, 0.8);
  EXPECT_GE(std::log2(error(60, 0, 1) / error(480, 0, 1)) / 3, 0.8);
}

TEST(BuckleyLeverettGravity, SinksAgainstTheFlow) {  // f' < 0 above, for C = 5: the range has both signs
  const auto range = sinking.speed_range({0.0}, {1.0}, Vector<1>{1.0});
  EXPECT_LT(range.lowest, -0.1);
  EXPECT_GT(range.highest, 1);
}

TEST(BuckleyLeverettGravity, HasTheExactRangeAlongAnAxis) {  // from ten thousand samples
  constexpr int parts = 10000;
  for (const double gravity : {-3.0, 0.0, 1.0, 5.0, 40.0}) {
    for (const double ratio : {0.05, 1.0, 10.0}) {
      const BuckleyLeverettGravity<1> law{Vector<1>{gravity}, ratio};
      const auto f = [&](double u) { return law.flux({u}, Vector<1>{1.0})[0]; };
      double lowest = 0;
      double highest = 0;
      for (int i = 0; i < parts; ++i) {
        const double slope = (f((i + 1.0) / parts) - f(static_cast<double>(i) / parts)) * parts;
        lowest = std::min(lowest, slope);
        highest = std::max(highest, slope);
      }
      const auto range = law.speed_range({0.0}, {1.0}, Vector<1>{1.0});
      // A mean over a part differs from the extreme by half a part times f'', which grows like 1/ratio.
      const double sampling = 50 * (1 + std::abs(gravity)) * std::max(ratio, 1 / ratio) / parts;
      EXPECT_NEAR(range.lowest, lowest, sampling) << gravity << ' ' << ratio;
      EXPECT_NEAR(range.highest, highest, sampling) << gravity << ' ' << ratio;
      EXPECT_LE(range.lowest, lowest + 1e-11);  // a bound, but for quotients of rounded fluxes
      EXPECT_GE(range.highest, highest - 1e-11);
    }
  }
}

TEST(BuckleyLeverettGravity, IsBuckleyLeverettWithoutGravity) {
  const BuckleyLeverettGravity<2> law{Vector<2>::Zero(), 3};
  const BuckleyLeverett plain{3};
  const Vector<2> normal{0.6, 0.8};
  for (const double u : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(law.flux({u}, normal)[0], plain.flux({u}, normal)[0], 8 * round_off);
    EXPECT_NEAR(law.max_speed({u}, {0.3}, normal), plain.max_speed({u}, {0.3}, normal), 1e-13);
  }
}

TEST(BuckleyLeverettGravity, RefusesWhatCannotBe) {
  EXPECT_EQ(test::message_of<InputError>([] {
              BuckleyLeverettGravity<1>{Vector<1>{5.0}, 0};
            }),
            "BuckleyLeverettGravity: the viscosity ratio must be positive and finite");
  EXPECT_EQ(test::message_of<InputError>([] { BuckleyLeverettGravity<1>{Vector<1>{std::nan("")}}; }),
            "BuckleyLeverettGravity: gravity must be finite");
}

TEST(Capillary, HasThePotentialOfItsDiffusivity) {  // K' = 4 epsilon u (1 - u), Eq. (T20)
  const Capillary law{BuckleyLeverett{}, 0.25};
  constexpr double step = 1e-4;
  for (const double u : {0.1, 0.4, 0.5, 0.8}) {
    const double slope = (law.potential({u + step})[0] - law.potential({u - step})[0]) / (2 * step);
    EXPECT_NEAR(slope, u * (1 - u), step * step);  // a cubic: K''' = -2, times step^2/6, and rounding
    EXPECT_NEAR(law.max_diffusivity({u}, {u}), u * (1 - u), 4 * round_off);
  }
  EXPECT_EQ(law.max_diffusivity({0.2}, {0.9}), 0.25);
  EXPECT_TRUE(std::isnan(law.max_diffusivity({std::nan("")}, {0.9})));
}

TEST(Capillary, RefusesANegativeDiffusivity) {
  EXPECT_EQ(test::message_of<InputError>([] {
              Capillary{BuckleyLeverett{}, -1};
            }),
            "Capillary: the diffusivity must be zero or positive, and finite");
}

}  // namespace
}  // namespace scree::transport
