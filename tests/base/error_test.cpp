#include <scree/error.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace scree {
namespace {

TEST(Require, ThrowsTheWholeMessageUnlessTheConditionHolds) {
  EXPECT_NO_THROW(require(true, "never said"));
  try {
    require(false, "theta must lie in [1, 2]");
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "theta must lie in [1, 2]");
  }
}

TEST(Require, LetsNoNanPass) {
  const double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_THROW(require(nan > 0, "must be positive"), InputError);
}

TEST(Error, IsTheBaseOfBothKinds) {
  EXPECT_THROW(throw InputError{"input"}, Error);
  EXPECT_THROW(throw RunError{"run"}, Error);
}

#ifndef NDEBUG
TEST(ScreeAssertDeathTest, NamesTheBrokenRule) {
  EXPECT_DEATH(SCREE_ASSERT(1 + 1 == 3),
               "error_test.cpp:[0-9]+: scree is broken, this must hold: 1 \\+ 1 == 3");
}
#endif

}  // namespace
}  // namespace scree
