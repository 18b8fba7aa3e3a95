#include "message_of.hpp"

#include <scree/grainsize/distribution.hpp>
#include <scree/tensor.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace scree::grainsize {
namespace {

using test::message_of;
using testing::ElementsAre;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double sum(const Distribution& mixture) {
  return std::accumulate(mixture.fractions.begin(), mixture.fractions.end(), 0.0);
}

double moment_of(const Distribution& mixture, double order) {
  return moment(mixture.classes.diameters(), mixture.fractions, order);
}

/// |a - b| over b.
double relative_error(double a, double b) {
  return std::abs(a / b - 1);
}

TEST(Means, OfTwoSizesAreTheTextbookOnes) {  // Eq. (G1), (G2)
  const Distribution mixture = bidisperse(0.5e-3, 1e-3, 0.5);

  // Two products, a sum and a quotient: 4 roundings.
  EXPECT_NEAR(arithmetic_mean(mixture.classes.diameters(), mixture.fractions), 0.75e-3, 4 * round_off * 1e-3);
  EXPECT_NEAR(harmonic_mean(mixture.classes.diameters(), mixture.fractions), 1e-3 / 1.5,
              4 * round_off * 1e-3);
}

TEST(Means, HarmonicIsIndifferentToAnErrorInTheSum) {  // Eq. (G2): why it has the numerator
  const Distribution mixture = bidisperse(0.5e-3, 1e-3, 0.3);
  const std::vector<double> swollen{0.3 * 1.01, 0.7 * 1.01};

  const double size = harmonic_mean(mixture.classes.diameters(), mixture.fractions);
  const double size_swollen = harmonic_mean(mixture.classes.diameters(), swollen);

  EXPECT_LE(relative_error(size_swollen, size), 12 * round_off);  // 6 roundings each
}

TEST(Moments, OrderOneIsTheArithmeticAndMinusOneTheInverseHarmonicMean) {  // Eq. (G13)
  const Distribution mixture = polydisperse(0.2e-3, 1e-3, 5);
  const auto diameters = mixture.classes.diameters();

  EXPECT_LE(relative_error(moment_of(mixture, 1), arithmetic_mean(diameters, mixture.fractions)),
            20 * round_off);  // 10 products and sums each
  EXPECT_LE(relative_error(1 / moment_of(mixture, -1), harmonic_mean(diameters, mixture.fractions)),
            32 * round_off);  // and 5 powers and 6 sums more
}

TEST(Percentile, IsLinearBetweenEdges) {  // Eq. (G14)
  const Distribution mixture = histogram({1e-3, 2e-3, 4e-3}, {0.25, 0.75});

  EXPECT_EQ(percentile(mixture.classes, mixture.fractions, 0), 1e-3);
  EXPECT_EQ(percentile(mixture.classes, mixture.fractions, 0.125), 1.5e-3);
  EXPECT_EQ(percentile(mixture.classes, mixture.fractions, 0.25), 2e-3);
  EXPECT_EQ(percentile(mixture.classes, mixture.fractions, 0.625), 3e-3);
  EXPECT_EQ(percentile(mixture.classes, mixture.fractions, 1), 4e-3);
}

TEST(Percentile, OfClassesWithoutExtentIsOneOfTheirDiameters) {
  const Distribution mixture = bidisperse(0.5e-3, 1e-3, 0.25);

  EXPECT_EQ(percentile(mixture.classes, mixture.fractions, 0.2), 0.5e-3);
  EXPECT_EQ(percentile(mixture.classes, mixture.fractions, 0.3), 1e-3);
}

TEST(CoarseShares, AreWhatLiesAboveASize) {  // Eq. (G23)
  const Distribution sieved = bidisperse(0.5e-3, 1e-3, 0.25);
  const Distribution mixture = histogram({1, 2, 4}, {0.25, 0.75});

  EXPECT_EQ(coarse_shares(sieved.classes, 1e-3), (std::vector<double>{0, 1}));
  EXPECT_EQ(coarse_shares(sieved.classes, 0.5e-3), (std::vector<double>{1, 1}));
  EXPECT_EQ(coarse_shares(sieved.classes, 2e-3), (std::vector<double>{0, 0}));
  EXPECT_EQ(coarse_shares(mixture.classes, 2), (std::vector<double>{0, 1}));
  EXPECT_EQ(coarse_shares(mixture.classes, 2.5), (std::vector<double>{0, 0.75}));
}

TEST(CoarseShares, AreWhatAPercentileLeaves) {
  const Distribution mixture = histogram({1e-3, 1.5e-3, 4e-3, 5e-3}, {0.2, 0.5, 0.3});
  for (const double share : {0.0, 0.1, 0.2, 0.55, 0.93, 1.0}) {
    const double size = percentile(mixture.classes, mixture.fractions, share);

    double coarser = 0;
    const auto shares = coarse_shares(mixture.classes, size);
    for (std::size_t k = 0; k < shares.size(); ++k) coarser += mixture.fractions[k] * shares[k];

    EXPECT_NEAR(coarser, 1 - share, 40 * round_off);  // 10 operations, of sizes up to 4 times a class's width
  }
}

TEST(CoarseShares, RefuseASizeThatIsNone) {
  const SizeClasses classes{std::vector<double>{1e-3}};
  EXPECT_EQ(message_of([&] { static_cast<void>(coarse_shares(classes, 0)); }),
            "coarse_shares: the size is 0 m, but must be positive and finite");
}

TEST(Percentile, SkipsEmptyClasses) {
  const SizeClasses classes{{1e-3, 2e-3, 3e-3}};

  EXPECT_EQ(percentile(classes, std::vector<double>{0, 1, 0}, 0), 2e-3);
  EXPECT_EQ(percentile(classes, std::vector<double>{0, 1, 0}, 1), 2e-3);
}

TEST(Percentile, RefusesAShareOutsideItsRange) {
  const Distribution mixture = monodisperse(1e-3);

  EXPECT_EQ(message_of([&] { (void)percentile(mixture.classes, mixture.fractions, 1.5); }),
            "percentile: the share is 1.5, but must lie in [0, 1]");
  EXPECT_EQ(message_of([&] { (void)percentile(mixture.classes, mixture.fractions, nan); }),
            "percentile: the share is nan, but must lie in [0, 1]");
}

TEST(Fractions, AreRefusedWithTheReason) {
  const SizeClasses classes{{1e-3, 2e-3}};
  const auto fault = [&](const std::vector<double>& fractions) {
    return message_of([&] { require_fractions(classes, fractions, 1e-12); });
  };

  EXPECT_EQ(fault({1}), "fractions: 2 classes need as many fractions, but 1 are given");
  EXPECT_EQ(fault({-0.5, 1.5}), "fractions: fraction 1 is -0.5, but must lie in [0, 1]");
  EXPECT_EQ(fault({nan, 1}), "fractions: fraction 1 is nan, but must lie in [0, 1]");
  EXPECT_EQ(fault({0.5, 0.4}), "fractions: their sum is 0.9, but must be 1");
}

TEST(Histogram, KeepsTheMeanOfVolumeSpreadEvenlyInItsClasses) {
  const Distribution mixture = histogram({1e-3, 2e-3, 4e-3}, {0.25, 0.75});

  EXPECT_THAT(mixture.classes.diameters(), ElementsAre(1.5e-3, 3e-3));
  EXPECT_THAT(mixture.fractions, ElementsAre(0.25, 0.75));
}

TEST(Histogram, MendsASumThatLostItsLastDigitsInTyping) {
  const Distribution mixture =
      histogram({1e-3, 2e-3, 3e-3, 4e-3}, {0.3333333333, 0.3333333333, 0.3333333333});

  EXPECT_NEAR(sum(mixture), 1, 3 * round_off);
}

TEST(Histogram, RefusesBadInput) {
  EXPECT_EQ(message_of([] {
              (void)histogram({1e-3, 2e-3}, {0.5, 0.5});
            }),
            "histogram: 2 fractions need 3 edges, but 2 are given");
  EXPECT_EQ(message_of([] {
              (void)histogram({1e-3, 0.5e-3}, {1});
            }),
            "histogram: edge 2 is 0.0005 m, but must exceed the one before, 0.001 m");
  EXPECT_EQ(message_of([] {
              (void)histogram({1e-3, 2e-3, 3e-3}, {0.5, 0.4});
            }),
            "fractions: their sum is 0.9, but must be 1");
}

TEST(EqualClasses, HaveTheSizesAndSharesAskedFor) {
  EXPECT_THAT(monodisperse(1e-3).fractions, ElementsAre(1));
  EXPECT_THAT(bidisperse(0.5e-3, 1e-3, 0.25).fractions, ElementsAre(0.25, 0.75));
  EXPECT_THAT(polydisperse(1, 3, 3).classes.diameters(), ElementsAre(1, 2, 3));
  EXPECT_THAT(polydisperse(1, 4, 4).fractions, ElementsAre(0.25, 0.25, 0.25, 0.25));
}

TEST(EqualClasses, RefuseBadInput) {
  EXPECT_EQ(message_of([] { (void)bidisperse(0.5e-3, 1e-3, 1.5); }),
            "fractions: fraction 1 is 1.5, but must lie in [0, 1]");
  EXPECT_EQ(
      message_of([] { (void)polydisperse(2e-3, 1e-3, 3); }),
      "polydisperse: the cuts are 0.002 m and 0.001 m, but must satisfy 0 < diameter_min < diameter_max");
  EXPECT_EQ(message_of([] { (void)polydisperse(1e-3, 2e-3, 1); }),
            "polydisperse: there must be at least two classes");
}

constexpr LogNormal sand{.median = 1e-3, .spread = 0.6, .diameter_min = 0.2e-3, .diameter_max = 5e-3};
constexpr PowerLaw gouge{.fractal_dimension = 2.6, .diameter_min = 0.1e-3, .diameter_max = 10e-3};

TEST(LogNormal, WideCutsGiveTheUncutMoments) {  // Eq. (G15): E s^n = median^n exp(n^2 spread^2/2)
  const LogNormal wide{.median = 1e-3, .spread = 0.5, .diameter_min = 1e-7, .diameter_max = 10};

  // Beyond 18 standard deviations there is nothing. A logarithm near 9 over a spread of 0.5 is good to
  // 2 * 9 round-offs, and an exponential to as many as its argument, 7 n, times 4 operations.
  for (const double order : {-1.0, 1.0, 2.0, 3.0}) {
    EXPECT_LE(relative_error(moment(wide, order), std::pow(1e-3, order) * std::exp(order * order * 0.125)),
              128 * round_off);
  }
}

TEST(PowerLaw, MomentsAreTheClosedOnes) {  // Eq. (G16)
  const double a = gouge.diameter_min;
  const double b = gouge.diameter_max;
  const double mean =
      0.4 / 1.4 * (std::pow(b, 1.4) - std::pow(a, 1.4)) / (std::pow(b, 0.4) - std::pow(a, 0.4));

  // Powers of numbers near 1e-2 are good to 2 round-offs; the difference below loses a factor of 1.2.
  EXPECT_LE(relative_error(moment(gouge, 1), mean), 32 * round_off);
  EXPECT_EQ(moment(gouge, 0), 1);
}

TEST(PowerLaw, IsSmoothThroughItsLogarithmicCase) {  // fractal dimension 3: equal volume per octave
  PowerLaw law = gouge;
  law.fractal_dimension = 3;
  const double exact = (law.diameter_max - law.diameter_min) / std::log(law.diameter_max / law.diameter_min);
  EXPECT_LE(relative_error(moment(law, 1), exact), 16 * round_off);

  law.fractal_dimension = 3 + 1e-9;

  // The moment's logarithm changes by less than ln(b/a) per unit of the dimension.
  EXPECT_LE(relative_error(moment(law, 1), exact), 1e-9 * std::log(100));
}

template <class Law>
void expect_mean_is_exact_and_others_converge(const Law& law) {
  double previous_error = 0;
  for (const std::size_t num_classes : {8U, 16U, 32U}) {
    const Distribution mixture = binned(law, num_classes);
    const double error = relative_error(moment_of(mixture, -1), moment(law, -1));

    EXPECT_NEAR(sum(mixture), 1, static_cast<double>(num_classes) * round_off);
    // Each class's volume is a difference of values up to 1: num_classes differences, 16 roundings each.
    EXPECT_LE(relative_error(moment_of(mixture, 1), moment(law, 1)),
              16 * static_cast<double>(num_classes) * round_off);
    if (previous_error > 0) {  // second order; pre-asymptotic by a tenth with classes a factor 1.5 wide
      EXPECT_NEAR(std::log2(previous_error / error), 2, 0.2);
    }
    previous_error = error;
  }
}

TEST(Binned, LogNormalKeepsItsMeanAndConvergesInOthers) {
  expect_mean_is_exact_and_others_converge(sand);
}
TEST(Binned, PowerLawKeepsItsMeanAndConvergesInOthers) {
  expect_mean_is_exact_and_others_converge(gouge);
}

TEST(Binned, PercentileAtAnEdgeIsTheExactCdf) {
  const Distribution mixture = binned(sand, 7);
  double below = 0;
  for (std::size_t k = 0; k + 1 < mixture.classes.size(); ++k) {
    below += mixture.fractions[k];

    const double size = percentile(mixture.classes, mixture.fractions, below);

    // The share is summed with k roundings, and its error spread over a class 3 mm wide with 1 % of it.
    EXPECT_NEAR(size, mixture.classes.edges()[k + 1], 7 * round_off * 3e-3 / 0.01);
  }
}

TEST(Binned, RefusesBadInput) {
  const auto fault = [](LogNormal law) { return message_of([&] { (void)binned(law, 4); }); };

  EXPECT_EQ(fault({1e-3, 0.5, 2e-3, 1e-3}),
            "LogNormal: the cuts are 0.002 m and 0.001 m, but must satisfy 0 < diameter_min < diameter_max");
  EXPECT_EQ(fault({-1e-3, 0.5, 1e-3, 2e-3}), "LogNormal: the median must be positive and finite");
  EXPECT_EQ(fault({1e-3, nan, 1e-3, 2e-3}), "LogNormal: the spread must be positive and finite");
  EXPECT_EQ(message_of([] {
              (void)binned(PowerLaw{nan, 1e-3, 2e-3}, 4);
            }),
            "PowerLaw: the fractal dimension must be finite");
  EXPECT_EQ(message_of([] { (void)binned(sand, 0); }), "binned: there must be at least one class");
}

TEST(Binned, RefusesClassesTooFarFromTheMedianToHoldVolume) {  // erfc underflows beyond 38 deviations
  EXPECT_EQ(
      message_of([] {
        (void)binned(LogNormal{1e-3, 0.01, 1e-3, 4e-3}, 2);
      }),
      "binned: no volume lies in class 2, from 0.002 m to 0.004 m: bring the cuts nearer to the median");
}

}  // namespace
}  // namespace scree::grainsize
