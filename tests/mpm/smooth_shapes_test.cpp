// Orders of cubic splines and of uniform GIMP on a manufactured solution, and what the latter leaves.

#include "manufactured_run.hpp"
#include "schemes.hpp"

#include <gtest/gtest.h>

namespace scree::mpm {
namespace {

/// Waves run too slow by the square of the spacing: C h^2 (1 + c h), of the order a tenth may be missing.
constexpr double second_order = 1.9;

TEST(AxisAlignedSwing, ConvergesWithSecondOrderUnderCubicShapes) {  // Eq. (M110)
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const auto errors = manufactured_errors<3>(AxisAlignedSwing{0.01}, 8, Cubic{}, rule);

    for (std::size_t i = 1; i < 3; ++i) EXPECT_GT(std::log2(errors[i - 1] / errors[i]), second_order);
  }
}

TEST(TurningRing, ConvergesWithSecondOrderUnderCubicShapes) {  // Eq. (M110)
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const auto errors = manufactured_errors<2>(TurningRing{0.3}, 16, Cubic{}, rule);

    EXPECT_GT(std::log2(errors[0] / errors[1]), second_order);
  }
}

TEST(AxisAlignedSwing, GoesOnConvergingUnderGimpWherePointsCrossCellsButNotWithSecondOrder) {  // Eq. (M111)
  // Points cross cells of 1/32, and linear shapes stop there. But boxes keep their size where material has
  // stretched by the strain 2 pi A: an error of first order in it that no mesh removes comes to light.
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const auto errors = manufactured_errors<3>(AxisAlignedSwing{0.01}, 8, Gimp{2}, rule);

    EXPECT_LT(errors[1], errors[0]);
    EXPECT_LT(errors[2], errors[1]);
    EXPECT_LT(std::log2(errors[1] / errors[2]), second_order);
    EXPECT_LT(errors[2], manufactured_errors<1>(AxisAlignedSwing{0.01}, 32, Linear{}, rule)[0] / 5);
  }
}

}  // namespace
}  // namespace scree::mpm
