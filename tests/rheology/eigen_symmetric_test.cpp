#include "derivative.hpp"
#include "points.hpp"

#include <scree/rheology/eigen_symmetric.hpp>
#include <scree/rheology/kinematics.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

/// Fifteen rotations of some eight roundings each, of components that are at most three times the largest.
constexpr double tolerance = 3 * 15 * 8 * round_off;

void expect_eigen_system(const Tensor<double>& a) {
  const auto system = eigen_symmetric(a);

  const auto identity = product(transposed(system.vectors), system.vectors);
  EXPECT_LE(largest(identity - isotropic(1.0)), tolerance);
  EXPECT_LE(largest(composed(system.values, system.vectors) - a), tolerance * largest(a));
}

TEST(EigenSymmetric, ComposesTheTensorAgain) {
  for (const auto& gradient : velocity_gradients()) {
    const auto a = symmetric_part(gradient);
    for (const double scale : {1.0, 1e-150, 1e150}) expect_eigen_system(scale * a);
  }
}

/// Coinciding and nearly coinciding eigenvalues, in axes of any direction: where closed forms fail.
TEST(EigenSymmetric, KeepsItsVectorsWhereEigenvaluesCoincide) {
  for (const double gap : {0.0, 1e-16, 1e-12, 1e-8, 1e-4}) {
    Tensor<double> two = isotropic(1.0);
    two(0, 0) += gap;
    expect_eigen_system(two);
    expect_eigen_system(symmetric_part(rotated(two)));
    Tensor<double> split = isotropic(1.0);
    split(0, 0) = 3;
    split(1, 1) += gap;
    expect_eigen_system(symmetric_part(rotated(split)));
  }
  expect_eigen_system({});
}

TEST(EigenSymmetric, FindsKnownEigenvalues) {
  Tensor<double> known;
  known(0, 0) = -2;
  known(1, 1) = 0.5;
  known(2, 2) = 7;
  auto values = eigen_symmetric(symmetric_part(rotated(known))).values;
  std::ranges::sort(values);

  EXPECT_NEAR(values[0], -2, 7 * tolerance);
  EXPECT_NEAR(values[1], 0.5, 7 * tolerance);
  EXPECT_NEAR(values[2], 7, 7 * tolerance);
}

/// Axes that are principal already turn by a'(0, 1)/(a(0, 0) - a(1, 1)) as a shear sets in.
TEST(EigenSymmetric, TurnsADualNumberWhoseShearBegins) {
  using testing::Dual;
  Tensor<Dual> a;
  a(0, 0) = 1;
  a(1, 1) = 2;
  a(2, 2) = 3;
  a(0, 1) = a(1, 0) = Dual{0, 1};

  const auto vectors = eigen_symmetric(a).vectors;

  EXPECT_EQ(vectors(1, 0).slope, -1);
  EXPECT_EQ(vectors(0, 1).slope, 1);
}

}  // namespace
}  // namespace scree::rheology
