#include "derivative.hpp"
#include "points.hpp"

#include <scree/rheology/elementary.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <limits>

namespace scree::rheology {
namespace {

/// Both sides of where the powers end, near one down to its neighbours, and far from it.
template <class Body>
void for_each_number(Body&& body) {
  for (int i = -200; i <= 200; ++i) body(1 + 0.0005 * i);
  for (double from_one = 0.5; from_one > 1e-17; from_one /= 3) {
    body(1 + from_one);
    body(1 - from_one);
  }
  for (const double x : {1.0, 39.0 / 41, 41.0 / 39, 1e-300, 1e-3, 0.3, 2.0, 7e5, 1e300}) body(x);
}

/// x - 1 is exact up to a factor of two. One rounding each for x + 1, the quotient, the leading sum twice and
/// the product; what the next power is short by, 2 z^11/11 of 2 z, is 1e-17. The common function errs by less
/// than that.
TEST(LogNearOne, KeepsItsDigitsNearOneAndFarFromIt) {
  for_each_number([](double x) {
    const auto exact = static_cast<double>(std::log(static_cast<long double>(x)));
    EXPECT_NEAR(elementary::log_near_one(x), exact, (5 + 1) * round_off * std::abs(exact)) << x;
  });
}

/// The powers' own slope is short by z^10 of 1/x, less than one rounding. Some twenty roundings go into it.
TEST(LogNearOne, HasTheSlopeOfTheLogarithm) {
  for_each_number([](double x) {
    const auto dual = elementary::log_near_one(testing::Dual{x, 1});
    EXPECT_NEAR(dual.slope * x, 1, 21 * round_off) << x;
  });
}

TEST(LogNearOne, GoesLaneByLane) {
  using Pack = std::experimental::native_simd<double>;
  const Pack x{[](std::size_t lane) { return lane % 2 == 0 ? 1.02 : 1.3; }};

  const Pack logarithm = elementary::log_near_one(x);

  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    EXPECT_NEAR(logarithm[lane], std::log(x[lane]), 2 * 6 * round_off * std::log(x[lane])) << lane;
  }
}

TEST(LogNearOne, AnswersUnsoundNumbersLikeTheLogarithm) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(elementary::log_near_one(0.0), -infinity);
  EXPECT_EQ(elementary::log_near_one(infinity), infinity);
  EXPECT_TRUE(std::isnan(elementary::log_near_one(-1.0)));
  EXPECT_TRUE(std::isnan(elementary::log_near_one(-3.0)));
  EXPECT_TRUE(std::isnan(elementary::log_near_one(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace scree::rheology
