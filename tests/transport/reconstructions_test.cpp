#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/reconstructions.hpp>

#include <array>
#include <cmath>
#include <random>

namespace scree::transport {
namespace {

using State = std::array<double, 3>;

/// Fractions of three classes that sum to one, to round-off.
State random_fractions(std::mt19937& random) {
  std::exponential_distribution<double> draw;
  State phi{draw(random), draw(random), draw(random)};
  const double sum = phi[0] + phi[1] + phi[2];
  for (double& part : phi) part /= sum;
  return phi;
}

template <class R>
class EveryReconstruction : public ::testing::Test {};
TYPED_TEST_SUITE(EveryReconstruction, test::Types<ReconstructionList>);

TYPED_TEST(EveryReconstruction, KeepsTheMeanAndTheBoundsUnlessItSaysThatItLeavesThem) {
  std::mt19937 random{7};
  bool stays_within = true;
  for (int trial = 0; trial < 1000; ++trial) {
    const State below = random_fractions(random);
    const State here = random_fractions(random);
    const State above = random_fractions(random);
    const auto edges = TypeParam{}(below, here, above);
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = std::min({below[k], here[k], above[k]});
      const double high = std::max({below[k], here[k], above[k]});
      for (const double edge : {edges.low[k], edges.high[k]}) {
        stays_within &= low - 8 * round_off <= edge && edge <= high + 8 * round_off;  // eight operations
      }
      if (leaves_bounds<TypeParam>) continue;  // a parabola's mean is not that
      EXPECT_NEAR((edges.low[k] + edges.high[k]) / 2, here[k], 2 * round_off);  // two roundings of values < 1
    }
  }
  EXPECT_EQ(stays_within, !leaves_bounds<TypeParam>);
}

TYPED_TEST(EveryReconstruction, LooksTheSameFromBothSides) {
  std::mt19937 random{5};
  const TypeParam reconstruction{};
  for (int trial = 0; trial < 1000; ++trial) {
    const State below = random_fractions(random);
    const State here = random_fractions(random);
    const State above = random_fractions(random);
    const auto edges = reconstruction(below, here, above);
    const auto mirrored = reconstruction(above, here, below);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(edges.low[k], mirrored.high[k], 8 * round_off);  // some eight operations on values < 1
      EXPECT_NEAR(edges.high[k], mirrored.low[k], 8 * round_off);
    }
  }
}

TYPED_TEST(EveryReconstruction, IsFlatAtAMissingNeighbour) {
  const State here{0.2, 0.5, 0.3};
  const auto edges = TypeParam{}(here, here, here);
  EXPECT_EQ(edges.low, here);
  EXPECT_EQ(edges.high, here);
}

TEST(PiecewiseConstant, IsFirstOrder) {
  const State here{0.2, 0.5, 0.3};
  EXPECT_EQ(PiecewiseConstant{}({1, 0, 0}, here, {0, 0, 1}).high, here);
}

TEST(PiecewiseLinear, KeepsLinearProfiles) {
  const auto edges = PiecewiseLinear{VanLeer{}}(State{0, 4, 1}, State{1, 3, 1}, State{2, 2, 1});
  EXPECT_EQ(edges.high, (State{1.5, 2.5, 1}));
  EXPECT_EQ(edges.low, (State{0.5, 3.5, 1}));
}

TEST(PiecewiseLinearCommon, KeepsLinearProfiles) {
  const auto edges = PiecewiseLinearCommon{Minmod{}}(State{0, 4, 1}, State{1, 3, 1}, State{2, 2, 1});
  EXPECT_EQ(edges.high, (State{1.5, 2.5, 1}));
  EXPECT_EQ(edges.low, (State{0.5, 3.5, 1}));
}

template <class L>
class EveryLimiterInCommon : public ::testing::Test {};
TYPED_TEST_SUITE(EveryLimiterInCommon, test::Types<LimiterList>);

TYPED_TEST(EveryLimiterInCommon, KeepsSumsAndLimitsEachComponent) {  // Eq. (T6)
  std::mt19937 random{11};
  const PiecewiseLinearCommon<TypeParam> reconstruction{};
  for (int trial = 0; trial < 1000; ++trial) {
    const State below = random_fractions(random);
    const State here = random_fractions(random);
    const State above = random_fractions(random);
    const auto edges = reconstruction(below, here, above);
    EXPECT_NEAR(edges.high[0] + edges.high[1] + edges.high[2], 1,
                16 * round_off);  // sums of three, 3 ops each
    for (std::size_t k = 0; k < 3; ++k) {
      const double slope = edges.high[k] - edges.low[k];
      const double allowed = reconstruction.limiter(here[k] - below[k], above[k] - here[k]);
      EXPECT_LE(std::abs(slope), std::abs(allowed) + 8 * round_off);
      EXPECT_GE(slope * allowed, -8 * round_off);
    }
  }
}

TEST(PiecewiseLinear, LosesSumsThatTheCommonFactorKeeps) {
  const State below{0.1, 0.2, 0.7};
  const State here{0.2, 0.5, 0.3};
  const State above{0.6, 0.3, 0.1};

  const auto apart = PiecewiseLinear{Minmod{}}(below, here, above);
  const auto common = PiecewiseLinearCommon{Minmod{}}(below, here, above);

  // Slopes 0.1, 0, -0.2: the sum at the high face is 1 - 0.05.
  EXPECT_NEAR(apart.high[0] + apart.high[1] + apart.high[2], 0.95, 4 * round_off);
  EXPECT_NEAR(common.high[0] + common.high[1] + common.high[2], 1, 4 * round_off);
}

TEST(PiecewiseLinearCommon, IsNotFlattenedByTheNoiseOfAConstantComponent) {
  const double third = 1.0 / 3;
  const double noisy = third * (1 + 2 * round_off);
  const auto edges = PiecewiseLinearCommon{Minmod{}}(
      State{0, 1 - third, third}, State{0.1, 0.9 - third, noisy}, State{0.2, 0.8 - third, third});
  EXPECT_NEAR(edges.high[0], 0.15, 4 * round_off);
}

TEST(PiecewiseLinearCommon, IgnoresPaddingThatIsZeroEverywhere) {
  const auto edges = PiecewiseLinearCommon{Minmod{}}(State{0, 1, 0}, State{0.1, 0.9, 0}, State{0.2, 0.8, 0});
  EXPECT_NEAR(edges.high[0], 0.15, 4 * round_off);
  EXPECT_EQ(edges.high[2], 0);
}

TEST(PiecewiseLinear, PromisesWhatItsSharpnessAllows) {  // Eq. (T9)
  EXPECT_DOUBLE_EQ(PiecewiseLinear{Minmod{1}}.promised_cfl(), 2.0 / 3);
  EXPECT_DOUBLE_EQ(PiecewiseLinear{Minmod{1.3}}.promised_cfl(), 1 / 1.65);
  EXPECT_DOUBLE_EQ(PiecewiseLinear{Superbee{}}.promised_cfl(), 0.5);
  EXPECT_DOUBLE_EQ(PiecewiseLinearCommon{Minmod{1}}.promised_cfl(), 0.5);
}

}  // namespace
}  // namespace scree::transport
