#include "derivative.hpp"

#include <scree/tensor.hpp>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace scree {
namespace {

/// Tensors with components drawn from [-1, 1], always the same ones.
std::vector<Tensor<double>> samples() {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> component{-1, 1};
  std::vector<Tensor<double>> result(8);
  for (auto& tensor : result) {
    for (auto& entry : tensor.components) entry = component(random);
  }
  return result;
}

TEST(Tensor, StoresRowByRow) {
  Tensor<double> a;
  a(1, 2) = 7;

  EXPECT_EQ(a.components[5], 7);
}

TEST(Tensor, AddsAndScalesComponentByComponent) {
  for (const auto& a : samples()) {
    const auto b = 2.0 * a + isotropic(1.0) - a;
    for (std::size_t i = 0; i < 9; ++i) {
      const double expected = a.components[i] + (i % 4 == 0 ? 1 : 0);
      EXPECT_NEAR(b.components[i], expected, 2 * 3 * round_off);  // two roundings of at most 3
    }
  }
}

TEST(Tensor, IsTheSumOfItsSymmetricDeviatoricIsotropicAndAntisymmetricParts) {
  for (const auto& a : samples()) {
    const auto symmetric = symmetric_part(a);
    const auto sum = deviator(symmetric) + isotropic(trace(a) / 3) + (a - symmetric);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_NEAR(sum.components[i], a.components[i], 8 * round_off);  // eight operations on numbers up to 1
    }
  }
}

TEST(Tensor, SymmetricPartIsSymmetric) {
  for (const auto& a : samples()) {
    const auto symmetric = symmetric_part(a);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(symmetric(i, j), symmetric(j, i));
    }
  }
}

TEST(Tensor, DeviatorHasNoTraceAndIsItsOwnDeviator) {
  for (const auto& a : samples()) {
    const auto once = deviator(a);
    const auto twice = deviator(once);

    EXPECT_NEAR(trace(once), 0, 9 * round_off);  // a third of the trace, three differences, a sum
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_NEAR(once.components[i], twice.components[i], 4 * round_off);
    }
  }
}

TEST(Tensor, ContractionSplitsIntoDeviatorAndTrace) {
  for (const auto& a : samples()) {
    const double expected = contract(deviator(a), deviator(a)) + trace(a) * trace(a) / 3;

    EXPECT_NEAR(contract(a, a), expected, 40 * 9 * round_off);  // 40 operations on sums up to 9
  }
}

TEST(Tensor, ContractionOfSymmetricWithAntisymmetricVanishes) {
  for (const auto& a : samples()) {
    const auto symmetric = symmetric_part(a);

    EXPECT_NEAR(contract(symmetric, a - symmetric), 0, 18 * round_off);  // nine products, nine sums
  }
}

TEST(ShearRate, IsTheSlopeOfASimpleShear) {  // Eq. (G4)
  Tensor<double> gradient;
  gradient(0, 1) = -3;

  EXPECT_NEAR(shear_rate(gradient), 3, 4 * round_off * 3);  // two products, a sum, a root
}

TEST(ShearRate, FeelsNeitherSpinNorCompression) {  // Eq. (G4)
  Tensor<double> motion = isotropic(-2.0);
  motion(0, 1) = 5;
  motion(1, 0) = -5;

  EXPECT_NEAR(shear_rate(motion), 0, 8 * round_off * 5);
}

TEST(Select, ChoosesValueAndDerivativeTogether) {
  const testing::Dual a{1, 10};
  const testing::Dual b{2, 20};

  EXPECT_EQ(select(a < b, a, b).slope, 10);
  EXPECT_EQ(select(b < a, a, b).slope, 20);
}

TEST(Aliases, HaveOneLayoutWhateverTheInstructionSet) {
  EXPECT_EQ(alignof(Vector<2>), alignof(double));
  EXPECT_EQ(alignof(Vector<4>), alignof(double));
  EXPECT_EQ(alignof(Matrix<2>), alignof(double));
  EXPECT_EQ(sizeof(Matrix<3>), 9 * sizeof(double));
}

}  // namespace
}  // namespace scree
