#include <scree/blocks.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace scree {
namespace {

constexpr std::array thread_counts{0, 1, 2, 3, 4, 130};  // the last: more than have a share of their own
constexpr std::array<Index, 5> block_counts{0, 1, 2, 7, 1000};

TEST(ForEachBlock, VisitsEachBlockOnce) {
  for (const int threads : thread_counts) {
    for (const Index num_blocks : block_counts) {
      std::vector<int> visits(static_cast<std::size_t>(num_blocks), 0);

      for_each_block(num_blocks, {threads}, [&](Index block) { ++visits[static_cast<std::size_t>(block)]; });

      EXPECT_EQ(visits, std::vector<int>(visits.size(), 1)) << threads << " threads";
    }
  }
}

TEST(ForEachBlock, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto sum_of_roots = [](int threads) {
    std::vector<double> sums(257);
    for_each_block(257, {threads}, [&](Index block) {
      double& sum = sums[static_cast<std::size_t>(block)];
      for (int i = 1; i < 100; ++i) sum += std::sqrt(static_cast<double>(100 * block + i));
    });
    return ordered_sum(sums);
  };

  for (const int threads : thread_counts) EXPECT_EQ(sum_of_roots(threads), sum_of_roots(1));
}

TEST(OrderedSum, AddsFromTheFrontWhateverTheSizes) {
  const std::array<double, 3> small_last{1, round_off, round_off};
  const std::array<double, 3> small_first{round_off, round_off, 1};

  EXPECT_EQ(ordered_sum(small_last), 1);  // each small term alone is rounded away
  EXPECT_EQ(ordered_sum(small_first), 1 + 2 * round_off);
  EXPECT_EQ(ordered_sum({}), 0);
}

}  // namespace
}  // namespace scree
