#include "derivative.hpp"
#include "messages.hpp"
#include "typed_lists.hpp"

#include <scree/mpm/shapes.hpp>
#include <scree/mpm/shapes/top_hat.hpp>
#include <scree/tensor.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace scree::mpm {
namespace {

using testing::Dual;

template <class S>
class EveryShape : public ::testing::Test {
 protected:
  /// Distances from the first node of the stencil: from one end of its range to the other.
  static std::vector<double> places() {
    std::vector<double> result;
    for (int i = 0; i <= 16; ++i) result.push_back(S::shift + i / 16.0);
    return result;
  }
  /// sum_i values_i (i - xi)^n
  static double moment(const std::array<double, S::support>& values, double xi, int n) {
    double sum = 0;
    for (std::size_t i = 0; i < S::support; ++i) sum += values[i] * std::pow(static_cast<double>(i) - xi, n);
    return sum;
  }
  /// Each of the support terms carries some ten roundings of numbers up to four.
  static constexpr double tolerance = 4 * 10 * static_cast<double>(S::support) * round_off;
};
TYPED_TEST_SUITE(EveryShape, testing::Each<AnyShape>, testing::EntryName);

TYPED_TEST(EveryShape, IsAPartitionOfUnity) {
  for (const double xi : this->places()) {
    EXPECT_NEAR(this->moment(TypeParam{}.weights(xi), xi, 0), 1, this->tolerance);
    EXPECT_NEAR(this->moment(TypeParam{}.gradients(xi), xi, 0), 0, this->tolerance);
  }
}

TYPED_TEST(EveryShape, IsNeverNegativeOverItsSupport) {
  for (const double xi : this->places()) {
    for (const double weight : TypeParam{}.weights(xi)) EXPECT_GE(weight, 0);
  }
}

TYPED_TEST(EveryShape, ReproducesLinearFields) {
  for (const double xi : this->places()) {
    EXPECT_NEAR(this->moment(TypeParam{}.weights(xi), xi, 1), 0, this->tolerance);
    EXPECT_NEAR(this->moment(TypeParam{}.gradients(xi), xi, 1), 1, this->tolerance);
  }
}

TYPED_TEST(EveryShape, HasTheGradientThatItsDualNumbersCarry) {
  for (const double xi : this->places()) {
    const auto exact = TypeParam{}.weights(Dual{xi, 1});

    const auto gradients = TypeParam{}.gradients(xi);

    for (std::size_t i = 0; i < TypeParam::support; ++i) {
      EXPECT_NEAR(gradients[i], exact[i].slope, this->tolerance);
    }
  }
}

TYPED_TEST(EveryShape, IsContinuousFromCellToCell) {
  const auto leaving = TypeParam{}.weights(1 + TypeParam::shift);
  const auto entering = TypeParam{}.weights(TypeParam::shift);

  EXPECT_NEAR(leaving.front(), 0, this->tolerance);
  EXPECT_NEAR(entering.back(), 0, this->tolerance);
  for (std::size_t i = 1; i < TypeParam::support; ++i) {
    EXPECT_NEAR(leaving[i], entering[i - 1], this->tolerance);
  }
}

TYPED_TEST(EveryShape, HasTheSecondMomentOfItsWeights) {
  for (const double xi : this->places()) {
    EXPECT_NEAR(this->moment(TypeParam{}.weights(xi), xi, 2), TypeParam{}.second_moment(xi), this->tolerance);
  }
}

TYPED_TEST(EveryShape, HasAffineWeightsOverItsSecondMoment) {  // Eq. (M8)
  for (const double xi : this->places()) {
    const auto weights = TypeParam{}.weights(xi);

    const auto affine = TypeParam{}.affine(xi);

    for (std::size_t i = 0; i < TypeParam::support; ++i) {
      const double expected = weights[i] * (static_cast<double>(i) - xi);
      EXPECT_NEAR(affine[i] * TypeParam{}.second_moment(xi), expected, this->tolerance);
    }
  }
}

/// The largest change of a node's gradient as a point goes from one stencil to the next [1/spacing].
template <class S>
double gradient_jump() {
  const auto leaving = S{}.gradients(1 + S::shift);
  const auto entering = S{}.gradients(S::shift);
  double jump = std::max(std::abs(leaving.front()), std::abs(entering.back()));
  for (std::size_t i = 1; i < S::support; ++i) jump = std::max(jump, std::abs(leaving[i] - entering[i - 1]));
  return jump;
}

TEST(Linear, GradientJumpsByTwoOverTheSpacingAtANode) {  // Eq. (M4): what kicks the nodes
  EXPECT_EQ(gradient_jump<Linear>(), 2);
}

TEST(Quadratic, GradientIsContinuous) {  // Eq. (M5)
  EXPECT_EQ(gradient_jump<Quadratic>(), 0);
}

TEST(Cubic, GradientIsContinuous) {  // Eq. (M110)
  EXPECT_EQ(gradient_jump<Cubic>(), 0);
}

TEST(Cubic, SlopeOfItsGradientIsContinuous) {  // Eq. (M110): quadratic splines jump by up to 3 here
  const auto leaving = Cubic::gradients(Dual{2, 1});
  const auto entering = Cubic::gradients(Dual{1, 1});

  EXPECT_EQ(leaving.front().slope, 0);
  EXPECT_EQ(entering.back().slope, 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(leaving[i].slope, entering[i - 1].slope);
}

TEST(Gimp, GradientIsContinuous) {  // Eq. (M111)
  EXPECT_EQ(gradient_jump<Gimp>(), 0);
}

TEST(Gimp, IsQuadraticWithOnePointPerCell) {  // Eqs. (M5), (M111)
  for (const double xi : {0.5, 0.7, 1.0, 1.1, 1.5}) {
    const auto weights = Gimp{1}.weights(xi);
    const auto quadratic = Quadratic::weights(xi);

    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(weights[i], quadratic[i], 10 * round_off);
  }
}

TEST(Gimp, IsLinearAsBoxesVanish) {  // Eqs. (M4), (M111): a hat averaged over 2 l round its tip loses l/2
  const Gimp many{1000};

  EXPECT_NEAR(many.weights(1.0)[1], 1 - many.half_width() / 2, 1000 * 10 * round_off);  // of 1/l
  EXPECT_NEAR(many.weights(1.25)[1], 0.75, 1000 * 10 * round_off);
  EXPECT_NEAR(many.weights(1.25)[2], 0.25, 1000 * 10 * round_off);
}

/// What a node at 0 feels of points at some places under one stress [stress x volume/spacing].
double force_of_uniform_stress(const Gimp& shape, const std::vector<double>& places) {
  double force = 0;
  for (const double x : places) {
    const double base = std::floor(x - Gimp::shift);
    const auto node = static_cast<int>(-base);
    if (0 <= node && node < 3) force -= shape.gradients(x - base)[static_cast<std::size_t>(node)];
  }
  return force;
}

TEST(Gimp, LeavesAForceInStretchedMaterialWhoseBoxesHaveNotGrown) {  // Eq. (M111)
  // Two points a cell, then stretched to 3/4 of a spacing from each other; by hand, with l = 1/4 the
  // gradients are 0, 1, -1/2, -3/4. Boxes that have grown to l = 3/8 fill space: 0, 1, -1/3, -2/3.
  const std::vector<double> stretched{-1.375, -0.625, 0.125, 0.875};

  EXPECT_NEAR(force_of_uniform_stress(Gimp{2}, stretched), 0.25, 10 * round_off);
  EXPECT_NEAR(force_of_uniform_stress(Gimp{4.0 / 3}, stretched), 0, 10 * round_off);
  EXPECT_NEAR(force_of_uniform_stress(Gimp{2}, {-1.125, -0.625, -0.125, 0.375, 0.875}), 0, 10 * round_off);
}

TEST(Gimp, RefusesLessThanOnePointPerCell) {
  for (const double points :
       {0.0, 0.5, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(message_of<InputError>([&] { const Gimp shape{points}; }),
              "Gimp: points_per_axis must be at least 1 and finite");
  }
}

TEST(TopHat, GivesAllToTheCellThatHoldsThePoint) {  // Eq. (M6)
  for (const double xi : {0.0, 0.25, 0.999}) EXPECT_EQ(TopHat::weights(xi)[0], 1);
}

}  // namespace
}  // namespace scree::mpm
