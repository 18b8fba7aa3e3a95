#include "messages.hpp"

#include <scree/mpm/transfers.hpp>

#include <limits>

namespace scree::mpm {
namespace {

TEST(Apic, PassesOnTheNodalVelocityAndItsGradient) {  // Eq. (M8)
  EXPECT_TRUE(Apic::has_affine);
  EXPECT_FALSE(Apic::has_increment);
  EXPECT_EQ(Apic::increment_share(), 0);
}

TEST(PicFlip, TakesAnyShareFromPicToFlip) {  // Eq. (M9)
  for (const double share : {0.0, 0.5, 1.0}) EXPECT_EQ(PicFlip{share}.increment_share(), share);
}

TEST(PicFlip, RefusesAShareOutsideZeroToOne) {
  for (const double share : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(message_of<InputError>([&] { PicFlip{share}; }), "PicFlip: increment_share must lie in [0, 1]");
  }
}

TEST(Aflip, TakesAnyShareFromApicToAffineFlip) {  // Eq. (M31)
  for (const double share : {0.0, 0.5, 1.0}) EXPECT_EQ(Aflip{share}.increment_share(), share);
}

TEST(Aflip, RefusesAShareOutsideZeroToOne) {
  for (const double share : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(message_of<InputError>([&] { Aflip{share}; }), "Aflip: increment_share must lie in [0, 1]");
  }
}

}  // namespace
}  // namespace scree::mpm
