#include "message_of.hpp"

#include <scree/grainsize/maximum_packing.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scree::grainsize {
namespace {

constexpr double packing = 0.64;
constexpr double poured = 4.1;
constexpr double infinite = 1e9;  // compaction at which the densest arrangement is reached, up to 1e-9

[[nodiscard]] double packed(const std::vector<double>& diameters, const std::vector<double>& fractions,
                            double compaction = poured, double of_one_size = packing) {
  return CompressiblePacking{SizeClasses{diameters}, of_one_size, compaction}.maximum_fraction(fractions);
}

TEST(CompressiblePacking, IsThatOfOneSizeWhereThereIsOneSize) {  // Eq. (G31)
  for (const double compaction : {1.8, 4.1, 9.0, infinite}) {
    EXPECT_NEAR(packed({1e-3}, {1}, compaction), packing, 10 * round_off);
    for (const auto& alone : {std::vector<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      EXPECT_NEAR(packed({1e-4, 1e-3, 1e-2}, alone, compaction), packing, 10 * round_off);
    }
  }
}

/// Sizes that differ by nothing are one, for the interactions tend to 1.
TEST(CompressiblePacking, DoesNotTellEqualSizesApart) {  // Eq. (G32)
  for (const double difference : {1e-3, 1e-6, 1e-9}) {
    const double mixed = packed({1e-3, 1e-3 * (1 + difference)}, {0.3, 0.7});
    // 1 - a = difference^1.02/2 and 1 - b = difference^1.5, whose weights are less than one.
    EXPECT_NEAR(mixed, packing, std::pow(difference, 1.02));
    EXPECT_GE(mixed, packing * (1 - 10 * round_off));
  }
}

/// Furnas (1931), Farris (1968): grains so fine that they fill the pores, or so coarse that they are islands.
/// The densest mix of N sizes is 1 - (1 - beta)^N, in shares that fall by 1 - beta each.
TEST(CompressiblePacking, FillsPoresWithPackingsInPores) {  // Eqs. (G30), (G31)
  // Sizes a factor of 1e12 apart: a = sqrt(1.02e-12). At the densest mix all N classes share K: N/K of room.
  const double tolerance = 2e-6 + 3 / infinite;
  const double void_share = 1 - packing;
  for (const double coarse : {0.1, 0.5, 0.7, 0.8, 0.9}) {
    const double pores = packing / coarse;
    const double islands = packing / (1 - void_share * coarse);
    EXPECT_NEAR(packed({1e-12, 1}, {1 - coarse, coarse}, infinite), std::min(pores, islands), tolerance);
  }
  const double sum_2 = 1 + void_share;
  EXPECT_NEAR(packed({1e-12, 1}, {void_share / sum_2, 1 / sum_2}, infinite), 1 - std::pow(void_share, 2),
              tolerance);
  const double sum_3 = 1 + void_share + void_share * void_share;
  const std::vector<double> shares{void_share * void_share / sum_3, void_share / sum_3, 1 / sum_3};
  EXPECT_NEAR(packed({1e-12, 1, 1e12}, shares, infinite), 1 - std::pow(void_share, 3), tolerance);
}

/// What two sizes add at their best, by the formula of Shauly, Wachs & Nir (1998) for suspensions,
/// phi_1 (1 + 3/2 b^1.5 phi_l^1.5 phi_s), b = (r - 1)/(r + 1): the poured mixture, between ratios of 2
/// and 6.5, to 0.012, where the measurements behind the two differ by as much.
TEST(CompressiblePacking, GainsFromTwoSizesWhatSuspensionsDo) {
  for (const double ratio : {2.0, 3.44, 4.0, 6.5}) {
    const double b = (ratio - 1) / (ratio + 1);
    double best = 0;
    double formula = 0;
    for (double coarse = 0; coarse <= 1; coarse += 0.01) {
      best = std::max(best, packed({1, ratio}, {1 - coarse, coarse}, poured, 0.625));
      formula =
          std::max(formula, 0.625 * (1 + 1.5 * std::pow(b, 1.5) * std::pow(coarse, 1.5) * (1 - coarse)));
    }
    EXPECT_NEAR(best, formula, 0.012) << ratio;
  }
}

/// Of any mixture: no looser than one size, no denser than its densest arrangement, and the sum of (G31) is
/// K.
TEST(CompressiblePacking, LiesBetweenOneSizeAndTheDensestArrangement) {
  const SizeClasses classes{{1, 2, 4, 8, 16}};
  const CompressiblePacking model{classes, packing, poured};
  const double densest = packing * (1 + 1 / poured);
  const CompressiblePacking rigid{classes, densest / (1 + 1 / infinite), infinite};
  for (int n = 0; n < 625; ++n) {
    std::vector<double> fractions{0.1 + n % 5, 0.1 + n / 5 % 5, 0.1 + n / 25 % 5,
                                  0.1 + static_cast<double>(n / 125), 0.1};
    double sum = 0;
    for (const double phi : fractions) sum += phi;
    for (double& phi : fractions) phi /= sum;

    const double here = model.maximum_fraction(fractions);

    EXPECT_GE(here, packing * (1 - 20 * round_off));
    EXPECT_LT(here, rigid.maximum_fraction(fractions));
  }
}

/// A class without grains says nothing, wherever it lies between the others.
TEST(CompressiblePacking, DoesNotFeelAnEmptyClass) {
  for (const double ratio : {2.0, 10.0, 100.0}) {
    for (const double share : {0.2, 0.5, 0.8}) {
      const double without = packed({1, ratio}, {share, 1 - share});
      for (const double between : {0.1, 0.5, 0.9}) {
        EXPECT_EQ(packed({1, std::pow(ratio, between), ratio}, {share, 0, 1 - share}), without) << between;
      }
      EXPECT_EQ(packed({0.1, 1, ratio}, {0, share, 1 - share}), without);
      EXPECT_EQ(packed({1, ratio, 10 * ratio}, {share, 1 - share, 0}), without);
    }
  }
}

/// Where it fails: below a compaction of packing/(1 - packing) the densest arrangement would have no pores.
/// It is refused there, and not just above.
TEST(CompressiblePacking, RefusesACompactionThatLeavesNoPores) {
  const double threshold = packing / (1 - packing);
  EXPECT_NO_THROW((void)packed({1, 10}, {0.3, 0.7}, threshold * (1 + 1e-9)));
  EXPECT_THROW((void)packed({1, 10}, {0.3, 0.7}, threshold * (1 - 1e-9)), InputError);
}

TEST(CompressiblePacking, NamesWhatIsNoPacking) {
  const SizeClasses classes{{1e-3}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto complaint = [&](double of_one_size, double compaction) {
    return test::message_of([&] { CompressiblePacking(classes, of_one_size, compaction); });
  };
  EXPECT_EQ(complaint(1, 4.1),
            "CompressiblePacking: the packing of one size is 1, but must lie between 0 and 1");
  EXPECT_EQ(complaint(nan, 4.1),
            "CompressiblePacking: the packing of one size is nan, but must lie between 0 and 1");
  EXPECT_EQ(
      complaint(0.5, 0.9),
      "CompressiblePacking: the compaction is 0.9, but must be finite and exceed 1, where one size would "
      "fill all space");
  EXPECT_EQ(
      complaint(0.5, nan),
      "CompressiblePacking: the compaction is nan, but must be finite and exceed 1, where one size would "
      "fill all space");
}

}  // namespace
}  // namespace scree::grainsize
