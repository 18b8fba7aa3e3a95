#include "lists.hpp"

#include <scree/error.hpp>
#include <scree/transport/cell_limiters.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

template <class L>
class EveryCellLimiter : public ::testing::Test {};
TYPED_TEST_SUITE(EveryCellLimiter, test::Types<CellLimiterList>);

const std::vector<double> sizes{0, 1e-12, 1e-3, 0.3, 0.5, 0.75, 1, 1.5, 2, 7, 1e4};

TYPED_TEST(EveryCellLimiter, StaysWithinItsBounds) {  // Eq. (T33)
  const TypeParam limiter{};
  for (const double allowed : sizes) {
    for (const double wanted : sizes) {
      const double factor = limiter(allowed, wanted, 0.1);
      EXPECT_GE(factor, 0);
      EXPECT_LE(factor, 1);
      if (TypeParam::keeps_bounds) {
        EXPECT_LE(factor * wanted, allowed * (1 + 8 * round_off));  // eight operations
      }
    }
  }
}

TYPED_TEST(EveryCellLimiter,
           IsMonotone) {  // more room, no smaller a factor; a wish for more, no larger a one
  const TypeParam limiter{};
  for (const double a : sizes) {
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i) {
      EXPECT_LE(limiter(sizes[i], a, 0.1), limiter(sizes[i + 1], a, 0.1) * (1 + 8 * round_off));
      EXPECT_GE(limiter(a, sizes[i], 0.1) * (1 + 8 * round_off), limiter(a, sizes[i + 1], 0.1));
    }
  }
}

TYPED_TEST(EveryCellLimiter, LeavesALinearProfileOnALineAlone) {  // its faces are half way to the neighbours
  const TypeParam limiter{};
  EXPECT_EQ(limiter(1, 0.5, 0.1), 1);
  EXPECT_EQ(limiter(0, 0, 0.1), 1);
}

TYPED_TEST(EveryCellLimiter, HasNoUnit) {
  const TypeParam limiter{};
  for (const double wanted : sizes)
    EXPECT_EQ(limiter(0.75, wanted, 0.1), limiter(0.75 * 4096, wanted * 4096, 0.1));
}

TEST(BarthJespersen, TakesAllThatIsAllowed) {
  EXPECT_DOUBLE_EQ(BarthJespersen{}(0.3, 0.5, 1), 0.6);
  EXPECT_EQ(BarthJespersen{}(0.5, 0.5, 1), 1);
}

TEST(SmoothCubic, IsSmooth) {  // value 1 and slope 0 at the ratio 3/2, slope 1 at 0
  const SmoothCubic limiter;
  EXPECT_NEAR(limiter(1.5 - 1e-9, 1, 1), 1, 1e-15);  // (1e-9)^2, and rounding
  EXPECT_NEAR(limiter(1e-6, 1, 1), 1e-6, 1e-18);
}

TEST(Venkatakrishnan, IsSmallerThanBarthJespersen) {
  EXPECT_DOUBLE_EQ(Venkatakrishnan{}(1, 1, 1), 0.75);  // (1 + 2)/(1 + 1 + 2)
}

TEST(Venkatakrishnan, BreaksBoundsByEpsilonOverTwoRootTwo) {  // Eq. (T33b), where nothing is allowed
  const Venkatakrishnan limiter{2, 3, 10};
  const double epsilon = limiter.epsilon(0.5);
  EXPECT_DOUBLE_EQ(epsilon, 3 * std::pow(2 * 0.5 / 10, 1.5));

  double worst = 0;
  for (const double allowed : {0.0, 0.1 * epsilon, epsilon}) {
    for (double wanted = 1e-3 * epsilon; wanted < 100 * epsilon; wanted *= 1.01) {
      worst = std::max(worst, limiter(allowed, wanted, 0.5) * wanted - allowed);
    }
  }
  const double predicted = epsilon / (2 * std::sqrt(2));
  EXPECT_LE(worst, predicted * (1 + 16 * round_off));
  EXPECT_GE(worst, 0.9999 * predicted);  // steps of 1 % round a flat maximum: (0.5 %)^2
}

TEST(Venkatakrishnan, RefusesNumbersOutOfRange) {
  const auto message = [](double K, double scale, double length) {
    try {
      const Venkatakrishnan limiter{K, scale, length};
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  EXPECT_EQ(message(-1, 1, 1), "Venkatakrishnan: K must be zero or positive, and finite");
  EXPECT_EQ(message(std::nan(""), 1, 1), "Venkatakrishnan: K must be zero or positive, and finite");
  EXPECT_EQ(message(1, 0, 1), "Venkatakrishnan: the scale must be positive and finite");
  EXPECT_EQ(message(1, 1, 0), "Venkatakrishnan: the length must be positive and finite");
}

}  // namespace
}  // namespace scree::transport
