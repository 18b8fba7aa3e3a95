#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/limiters.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace scree::transport {
namespace {

constexpr double slopes[] = {-3, -1, -0.4, -1e-3, 0, 1e-3, 0.3, 1, 2, 7};

template <class L>
class EveryLimiter : public ::testing::Test {};
TYPED_TEST_SUITE(EveryLimiter, test::Types<LimiterList>);

TYPED_TEST(EveryLimiter, IsZeroAtExtrema) {
  const TypeParam limiter{};
  for (const double backward : slopes) {
    for (const double forward : slopes) {
      if (backward * forward > 0) continue;
      EXPECT_EQ(limiter(backward, forward), 0) << backward << ' ' << forward;
    }
  }
}

TYPED_TEST(EveryLimiter, TreatsBothSidesAlike) {
  const TypeParam limiter{};
  for (const double backward : slopes) {
    for (const double forward : slopes) {
      EXPECT_DOUBLE_EQ(limiter(backward, forward), limiter(forward, backward));
      EXPECT_DOUBLE_EQ(limiter(-backward, -forward), -limiter(backward, forward));
    }
  }
}

TYPED_TEST(EveryLimiter, KeepsLinearProfiles) {
  const TypeParam limiter{};
  for (const double slope : slopes) EXPECT_DOUBLE_EQ(limiter(slope, slope), slope);
}

TYPED_TEST(EveryLimiter, StaysInsideTheTvdRegion) {  // Eq. (T5), Sweby (1984)
  const TypeParam limiter{};
  for (const double backward : slopes) {
    for (const double forward : slopes) {
      const double slope = limiter(backward, forward);
      const double bound = limiter.sharpness() * std::min(std::abs(backward), std::abs(forward));
      EXPECT_LE(std::abs(slope), bound * (1 + 8 * round_off));  // at most eight operations
      EXPECT_GE(slope * backward, 0);
    }
  }
  EXPECT_GE(limiter.sharpness(), 1);
  EXPECT_LE(limiter.sharpness(), 2);
}

TYPED_TEST(EveryLimiter, ReachesItsSharpness) {  // so that the promised CFL is no smaller than it need be
  const TypeParam limiter{};
  double sharpest = 0;
  for (int i = 0; i <= 1000; ++i) sharpest = std::max(sharpest, limiter(1, std::pow(10, 0.004 * i)));
  EXPECT_NEAR(sharpest, limiter.sharpness(), 1e-3);  // 2/(1 + 1/ratio) of van Leer: 2 - 2e-4 at 1e4
}

TYPED_TEST(EveryLimiter, DoesNotDependOnTheUnit) {
  const TypeParam limiter{};
  EXPECT_DOUBLE_EQ(limiter(0.3e6, 0.7e6), 1e6 * limiter(0.3, 0.7));
}

TEST(Limiters, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  int count = 0;
  for_each_entry(LimiterList{}, [&]<class L>() {
    names.insert(L::name);
    ++count;
  });
  EXPECT_EQ(names.size(), static_cast<std::size_t>(count));
}

TEST(Minmod, TakesTheGentlestOfThreeSlopes) {  // Eq. (T5a)
  EXPECT_DOUBLE_EQ(Minmod{1}(1, 3), 1);
  EXPECT_DOUBLE_EQ(Minmod{1.5}(1, 3), 1.5);
  EXPECT_DOUBLE_EQ(Minmod{2}(1, 3), 2);
  EXPECT_DOUBLE_EQ(Minmod{2}(1, 2), 1.5);
}

TEST(Minmod, RefusesOtherThetas) {
  for (const double theta : {0.99, 2.2, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(test::message_of<InputError>([&] { Minmod{theta}; }), "Minmod: theta must lie in [1, 2]");
  }
}

}  // namespace
}  // namespace scree::transport
