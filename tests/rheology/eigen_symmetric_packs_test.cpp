// The eigen-system of packs of doubles: each lane has the bits of that in double.

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
TEST(EigenSymmetricInPacks, HasTheBitsOfDoubleInEachLaneWhateverItsNeighbours) {
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
