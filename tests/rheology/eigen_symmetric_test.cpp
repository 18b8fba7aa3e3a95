#include "derivative.hpp"
#include "packs.hpp"
#include "points.hpp"

#include <scree/rheology/eigen_symmetric.hpp>
#include <scree/rheology/kinematics.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

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

[[nodiscard]] Tensor<double> symmetric(double xx, double yy, double zz, double yz, double xz, double xy) {
  Tensor<double> a;
  a(0, 0) = xx;
  a(1, 1) = yy;
  a(2, 2) = zz;
  a(1, 2) = a(2, 1) = yz;
  a(0, 2) = a(2, 0) = xz;
  a(0, 1) = a(1, 0) = xy;
  return a;
}

/// Whole ones, of strain in a plane, of one shear only, of none; with zeros of both signs, and so small that
/// squares of their components are none.
[[nodiscard]] std::vector<Tensor<double>> tensors_of_many_kinds() {
  std::vector<Tensor<double>> tensors;
  for (const auto& gradient : velocity_gradients()) tensors.push_back(symmetric_part(gradient));
  for (const double zero : {0.0, -0.0}) {
    for (const double size : {0.0, -0.0, 1e-170, -3.0, 2.0}) {
      tensors.push_back(symmetric(zero, zero, zero, size, zero, zero));
      tensors.push_back(symmetric(zero, size, zero, zero, size, zero));
      tensors.push_back(symmetric(size, size, zero, zero, zero, size));
      tensors.push_back(symmetric(size, 2 * size, zero, zero, size, -size));
      tensors.push_back(symmetric(-size, zero, 3 * size, zero, zero, zero));
    }
  }
  return tensors;
}

/// Rotations are left out where no lane needs them: with one neighbour that does, and with many.
TEST(EigenSymmetric, HasTheBitsOfDoubleInEachLaneWhateverItsNeighbours) {
  using Pack = scree::testing::Pack<8>;
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  const auto tensors = tensors_of_many_kinds();
  for (std::size_t first = 0; first < tensors.size(); ++first) {
    for (std::size_t stride = 0; stride < tensors.size(); ++stride) {
      const auto of_lane = [&](std::size_t lane) {
        return tensors[(first + lane * stride) % tensors.size()];
      };
      Tensor<Pack> pack{};
      for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
        for (std::size_t i = 0; i < 9; ++i) pack.components[i][lane] = of_lane(lane).components[i];
      }

      const auto system = eigen_symmetric(pack);

      for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
        const auto alone = eigen_symmetric(of_lane(lane));
        for (std::size_t i = 0; i < 3; ++i) {
          ASSERT_EQ(bits(system.values[i][lane]), bits(alone.values[i])) << first << ", " << stride;
        }
        for (std::size_t i = 0; i < 9; ++i) {
          ASSERT_EQ(bits(system.vectors.components[i][lane]), bits(alone.vectors.components[i]))
              << first << ", " << stride;
        }
      }
    }
  }
}

}  // namespace
}  // namespace scree::rheology
