#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <random>

namespace scree::transport {
namespace {

template <class L>
class MaximumPrinciple : public ::testing::Test {};
TYPED_TEST_SUITE(MaximumPrinciple, test::Types<LimiterList>);

/// How far the bounds of random data are left, in steps of the promised CFL number.
template <int D>
double outside(const WithAnyLimiter<PiecewiseLinear<Minmod>>& reconstruction, Index n) {
  const Lattice<D> lattice = test::cube<D>(n);
  Solver solver{
      Cartesian<D>{lattice}, Burgers{}, reconstruction, SspRk2{}, {.cfl = reconstruction.promised_cfl()}};
  std::mt19937 random{23};
  std::uniform_real_distribution<double> draw{-1, 1};
  std::vector<double> u(static_cast<std::size_t>(lattice.num_sites()));
  for (double& value : u) value = draw(random);
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  const double floor = *low;
  const double ceiling = *high;
  double worst = 0;
  for (int step = 0; step < 50; ++step) {
    solver.advance(u, solver.stable_time_step(u));
    for (const double value : u) worst = std::max({worst, floor - value, value - ceiling});
  }
  return worst;
}

TYPED_TEST(MaximumPrinciple, HoldsInOneAndTwoDimensionsAtThePromisedCfl) {  // Eq. (T9)
  constexpr double rounding = 50 * 20 * round_off;  // steps x operations on values of at most 1
  EXPECT_LE((outside<1>({PiecewiseLinear<TypeParam>{}}, 200)), rounding);
  EXPECT_LE((outside<2>({PiecewiseLinear<TypeParam>{}}, 30)), rounding);
}

}  // namespace
}  // namespace scree::transport
