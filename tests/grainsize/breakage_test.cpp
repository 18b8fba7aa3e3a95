#include "message_of.hpp"

#include <scree/grainsize/breakage.hpp>
#include <scree/grainsize/distribution.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace scree::grainsize {
namespace {

using test::message_of;

constexpr std::size_t num_classes = 8;

[[nodiscard]] Distribution fragments(double diameter_max = 1e-3) {
  return binned(PowerLaw{.fractal_dimension = 2.6, .diameter_min = 1e-6, .diameter_max = diameter_max},
                num_classes);
}

/// All in the three coarsest classes.
[[nodiscard]] std::vector<double> sand() {
  std::vector<double> fractions(num_classes);
  fractions[5] = 0.1;
  fractions[6] = 0.3;
  fractions[7] = 0.6;
  return fractions;
}

[[nodiscard]] double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

[[nodiscard]] std::vector<double> broken(std::vector<double> fractions, const std::vector<double>& ultimate,
                                         double before, double after) {
  break_grains(fractions, ultimate, broken_share(before, after));
  return fractions;
}

TEST(UltimateFractions, AreThoseOfThePowerLaw) {  // Eq. (G20)
  const Distribution exact = fragments();

  const auto ultimate = ultimate_fractions(exact.classes, sand());

  for (std::size_t k = 0; k < num_classes; ++k) {
    EXPECT_NEAR(ultimate[k], exact.fractions[k], 30 * round_off);  // two ratios of powers and logarithms
  }
}

TEST(UltimateFractions, HoldNoGrainLargerThanAtFirst) {  // Eq. (G20)
  auto initial = sand();
  initial[6] = 0.9;
  initial[7] = 0;
  const auto classes = fragments().classes;

  const auto ultimate = ultimate_fractions(classes, initial);

  EXPECT_EQ(ultimate[7], 0);
  EXPECT_NEAR(sum(ultimate), 1, 30 * round_off);
}

TEST(BreakGrains, KeepsTheSumAndTheBounds) {  // Eq. (G21)
  const auto ultimate = ultimate_fractions(fragments().classes, sand());
  auto fractions = sand();
  constexpr int num_steps = 100000;
  for (int n = 0; n < num_steps; ++n) {
    fractions = broken(fractions, ultimate, 1.0 * n / num_steps, (n + 1.0) / num_steps);

    ASSERT_TRUE(std::ranges::all_of(fractions, [](double phi) { return 0 <= phi && phi <= 1; })) << n;
    // A combination rounds each fraction thrice, and passes on the errors that were.
    ASSERT_NEAR(sum(fractions), 1, 3 * (n + 1) * round_off + 30 * round_off) << n;
  }
}

TEST(BreakGrains, GivesTheUltimateFractionsWhenAllIsBroken) {
  const auto ultimate = ultimate_fractions(fragments().classes, sand());
  for (const double before : {0.0, 0.3, 0.999}) {
    EXPECT_EQ(broken(sand(), ultimate, before, 1), ultimate);
  }
}

/// However a change of B is split, the same mixture.
TEST(BreakGrains, DoesNotFeelTheStep) {  // Eq. (G21)
  const auto ultimate = ultimate_fractions(fragments().classes, sand());
  const auto once = broken(sand(), ultimate, 0.1, 0.7);

  const auto twice = broken(broken(sand(), ultimate, 0.1, 0.4), ultimate, 0.4, 0.7);

  for (std::size_t k = 0; k < num_classes; ++k) EXPECT_NEAR(twice[k], once[k], 16 * round_off);
}

TEST(BreakGrains, MakesTheMeansFinerAndFiner) {
  const auto classes = fragments().classes;
  const auto ultimate = ultimate_fractions(classes, sand());
  double arithmetic = arithmetic_mean(classes.diameters(), sand());
  double harmonic = harmonic_mean(classes.diameters(), sand());
  for (const double B : {0.01, 0.2, 0.5, 0.9, 1.0}) {
    const auto fractions = broken(sand(), ultimate, 0, B);

    EXPECT_LT(arithmetic_mean(classes.diameters(), fractions), arithmetic);
    EXPECT_LT(harmonic_mean(classes.diameters(), fractions), harmonic);
    arithmetic = arithmetic_mean(classes.diameters(), fractions);
    harmonic = harmonic_mean(classes.diameters(), fractions);
  }
}

/// B is the area between the present and the first curve of shares over that between the last and the first:
/// Einav's definition, at every size.
TEST(BreakGrains, MovesEveryShareByB) {  // Eq. (G21)
  const auto ultimate = ultimate_fractions(fragments().classes, sand());
  const auto fractions = broken(sand(), ultimate, 0, 0.35);
  for (std::size_t k = 0; k < num_classes; ++k) {
    EXPECT_NEAR(fractions[k] - sand()[k], 0.35 * (ultimate[k] - sand()[k]), 4 * round_off);
  }
}

TEST(BrokenShare, IsNothingWhereBreakageDoesNotGrow) {
  EXPECT_EQ(broken_share(0.5, 0.5), 0);
  EXPECT_EQ(broken_share(0.5, 0.4), 0);
  EXPECT_EQ(broken_share(1, 1), 0);
  EXPECT_EQ(broken_share(0.5, 0.75), 0.5);
}

/// Grains of one size s and a power law up to s: 1 - (3 - a)/(5 - a) in the limit of no least size.
TEST(GradingIndex, IsKnownForGrainsOfOneSize) {  // Eq. (G22)
  double previous = 0;
  for (const std::size_t n : {50U, 100U}) {
    const auto mixture = binned(PowerLaw{2.6, 1e-12, 1e-3}, n);
    std::vector<double> initial(n);
    initial.back() = 1;

    const double error = grading_index(mixture.classes.diameters(), initial, mixture.fractions) - 5.0 / 6;

    // The coarsest class stands for sizes down to a ratio of its edges: of first order in its width.
    if (previous != 0) {
      EXPECT_NEAR(previous / error, 2, 0.3);
    }
    previous = error;
  }
}

/// Where it fails: a mixture that is finer than the ultimate one somewhere. Its finest grains would have to
/// join. The remedy is a finer last class, or a larger fractal dimension.
TEST(UltimateFractions, RefusesToJoinGrains) {
  const auto classes = fragments().classes;
  const std::vector<double> fine(num_classes, 1.0 / num_classes);

  EXPECT_EQ(
      message_of([&] { (void)ultimate_fractions(classes, fine); }),
      "ultimate_fractions: a share of 0.125 is finer than 2.37137e-06 m at first, but only 0.0277823 in "
      "the end: breaking would join grains");
  EXPECT_NO_THROW((void)ultimate_fractions(classes, fine, 3));
}

TEST(UltimateFractions, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto classes = fragments().classes;

  EXPECT_EQ(message_of([] {
              (void)ultimate_fractions(SizeClasses{{1e-3, 2e-3}}, std::array{0.5, 0.5});
            }),
            "ultimate_fractions: the size classes must have edges");
  EXPECT_EQ(message_of([&] { (void)ultimate_fractions(classes, sand(), nan); }),
            "ultimate_fractions: the fractal dimension must be finite");
  EXPECT_EQ(message_of([&] { (void)ultimate_fractions(classes, std::array{1.0}); }),
            "fractions: 8 classes need as many fractions, but 1 are given");
}

}  // namespace
}  // namespace scree::grainsize
