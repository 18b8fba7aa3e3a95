#include <scree/error.hpp>
#include <scree/input_column.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace scree {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What require_in_range() says, empty if it accepts.
[[nodiscard]] std::string complaint(const InputColumn& column, double value, std::string_view of_whom = {}) {
  try {
    require_in_range("sand", column, value, of_whom);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Interval, HasItsEndsOnlyIfItIsClosed) {
  constexpr Interval open{.lower = 0, .upper = 1};
  constexpr Interval closed{.lower = 0, .upper = 1, .is_open = false};
  for (const double end : {0.0, 1.0}) {
    EXPECT_FALSE(open.contains(end)) << end;
    EXPECT_TRUE(closed.contains(end)) << end;
  }
  EXPECT_TRUE(open.contains(0.5) && closed.contains(0.5));
}

TEST(Interval, HasNeitherInfinityNorNan) {
  constexpr Interval all{.lower = -infinity, .upper = infinity, .is_open = false};
  for (const double value : {infinity, -infinity, nan}) EXPECT_FALSE(all.contains(value)) << value;
  EXPECT_TRUE(all.contains(-1e300));
}

TEST(InputColumn, IsPositiveIfNothingElseIsSaid) {
  constexpr InputColumn size{"grain_size", "m", 1e-3};

  EXPECT_EQ(complaint(size, 1e-9), "");
  EXPECT_EQ(complaint(size, 0), "the law 'sand' reads grain_size = 0 m: must be finite and above 0");
  EXPECT_EQ(complaint(size, -1e-3), "the law 'sand' reads grain_size = -0.001 m: must be finite and above 0");
  EXPECT_EQ(complaint(size, nan), "the law 'sand' reads grain_size = nan m: must be finite and above 0");
  EXPECT_EQ(complaint(size, infinity, "material point 12 at (0.5, 1) m"),
            "the law 'sand' reads grain_size = inf m of material point 12 at (0.5, 1) m: "
            "must be finite and above 0");
}

TEST(InputColumn, NamesTheRangeThatItIsGiven) {
  constexpr InputColumn share{"share", "-", 0.5, {.lower = 0, .upper = 1, .is_open = false}};
  constexpr InputColumn packing{"packing", "-", 0.6, {.lower = 0, .upper = 1}};
  constexpr InputColumn depth{"depth", "m", 1, {.is_open = false}};
  constexpr InputColumn rate{"rate", "1/s", 0, {-infinity, infinity}};

  EXPECT_EQ(complaint(share, 1.5), "the law 'sand' reads share = 1.5: must lie in [0, 1]");
  EXPECT_EQ(complaint(packing, 1), "the law 'sand' reads packing = 1: must lie in (0, 1)");
  EXPECT_EQ(complaint(depth, -1), "the law 'sand' reads depth = -1 m: must be finite and at least 0");
  EXPECT_EQ(complaint(rate, -1e300), "");
  EXPECT_EQ(complaint(rate, nan), "the law 'sand' reads rate = nan 1/s: must be finite");
  EXPECT_EQ(complaint(share, 0) + complaint(share, 1) + complaint(depth, 0), "");
}

}  // namespace
}  // namespace scree
