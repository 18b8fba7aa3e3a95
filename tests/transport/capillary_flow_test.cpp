// Buckley-Leverett's flow with capillary diffusion, against the tables of another code: dt = 0.5/(a/dx +
// 2 K'/dx^2), reference N = 1600.

#include "lines.hpp"

#include <scree/transport/laws/buckley_leverett.hpp>
#include <scree/transport/laws/buckley_leverett_gravity.hpp>
#include <scree/transport/laws/capillary.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace scree::transport {
namespace {

/// u = 1 - 3 x up to 1/3, fed with 1 at x = 0; at T = 0.2.
std::vector<double> flooded(Index n, double theta) {
  const Lattice<1> lattice = test::line(n, 0, 1, false);
  auto u = test::averages(lattice, [](double x) {
    const double wet = std::min(x, 1.0 / 3);
    return wet - 1.5 * wet * wet;
  });
  Solver solver{Cartesian<1>{lattice},
                Capillary{BuckleyLeverett{}, 0.01},
                PiecewiseLinear{Minmod{theta}},
                SspRk2{},
                {.cfl = 0.5, .boundaries = {{{Prescribed<1>{{1.0}}, Outflow{}}}}}};
  solver.advance(u, 0.2);
  return u;
}

double error(const std::vector<double>& fine, Index n, double theta) {
  const auto coarse = flooded(n, theta);
  const std::size_t parts = fine.size() / coarse.size();
  std::vector<double> averages(coarse.size());
  for (std::size_t i = 0; i < fine.size(); ++i) averages[i / parts] += fine[i] / static_cast<double>(parts);
  return test::l1(coarse, averages, 1.0 / static_cast<double>(n));
}

TEST(Capillary, HasTheProfileOfTheTable) {  // five digits, of a run on as many cells: 5e-5 for both errors
  const auto fine = flooded(1600, 2);
  for (const auto& [x, value] :
       {std::pair{0.1, 0.88060}, {0.2, 0.80037}, {0.3, 0.73032}, {0.4, 0.65923}, {0.45, 0.57140}}) {
    const auto i = static_cast<std::size_t>(x * 1600 + 0.5);
    EXPECT_NEAR(0.5 * (fine[i - 1] + fine[i]), value, 5e-5) << x;  // at a face
  }
  EXPECT_EQ(fine[800], 0);  // ahead of the front, where there is no diffusion, nothing
}

TEST(Capillary, IsStableOnEveryGridOfAScan) {  // where two limits instead of their sum fail at N = 200 alone
  const auto fine = flooded(1600, 2);
  for (const double theta : {1.0, 2.0}) {
    double coarser = error(fine, 50, theta);
    for (const Index n : {100, 200, 400}) {  // a front with a corner: first order at least
      const double finer = error(fine, n, theta);
      EXPECT_LE(finer, coarser / 2) << n;
      coarser = finer;
    }
  }
}

}  // namespace
}  // namespace scree::transport
