#include <scree/io/bounds.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace scree::io {
namespace {

TEST(Bounds, HoldTheirClosedEndsAndNotTheirOpenOnes) {
  EXPECT_TRUE(between(0, 1).contain(0) && between(0, 1).contain(1));
  EXPECT_TRUE(at_least(2).contain(2) && at_most(2).contain(2));

  EXPECT_FALSE(above(2).contain(2) || below(2).contain(2));
  EXPECT_TRUE(above(2).contain(std::nextafter(2.0, 3.0)));
  EXPECT_TRUE(below(2).contain(std::nextafter(2.0, 1.0)));
}

TEST(Bounds, NeverHoldNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();

  for (const Bounds& bounds : {any_value(), above(0), at_least(0), below(0), at_most(0), between(0, 1)}) {
    EXPECT_FALSE(bounds.contain(nan));
  }
}

TEST(Bounds, SayWhatAValueMustDo) {
  EXPECT_EQ(any_value().to_text(), "");
  EXPECT_EQ(above(0).to_text(), "must exceed 0");
  EXPECT_EQ(at_least(0.5).to_text(), "must be at least 0.5");
  EXPECT_EQ(below(1e-9).to_text(), "must be below 1e-09");
  EXPECT_EQ(at_most(-3).to_text(), "must be at most -3");
  EXPECT_EQ(between(0, 1).to_text(), "must lie in [0, 1]");
  EXPECT_EQ((Bounds{.lower = 0, .upper = 1, .is_lower_open = true}).to_text(), "must lie in (0, 1]");
}

TEST(ToText, IsTheShortestThatReadsBackAsTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3, 1e300, -0.0, 2.0, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(std::stod(to_text(value)), value);
  }

  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(std::numeric_limits<double>::infinity()), "inf");
}

}  // namespace
}  // namespace scree::io
