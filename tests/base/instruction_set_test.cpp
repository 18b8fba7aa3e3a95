#include <scree/instruction_set.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

TEST(InstructionSets, BeginWithWhatEveryMachineHasAndEndWithTheWidest) {
  const auto sets = instruction_sets();
  ASSERT_THAT(sets, testing::Not(testing::IsEmpty()));
  EXPECT_EQ(sets.front(), InstructionSet::baseline);
  EXPECT_EQ(sets.back(), widest_instruction_set());
  EXPECT_TRUE(std::ranges::is_sorted(sets));
}

TEST(InstructionSets, HaveTheNamesThatCompilersUse) {
  EXPECT_EQ(name_of(InstructionSet::baseline), "baseline");
  EXPECT_EQ(name_of(InstructionSet::x86_64_v3), "x86-64-v3");
  EXPECT_EQ(name_of(InstructionSet::x86_64_v4), "x86-64-v4");
}

}  // namespace
}  // namespace scree
