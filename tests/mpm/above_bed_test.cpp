#include "messages.hpp"

#include <scree/mpm/terrain/above_bed.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace scree::mpm {
namespace {

/// Points at heights 0.5, 1.5, 2.5 m.
[[nodiscard]] Particles<1> three_points() {
  Particles<1> particles;
  particles.resize(3);
  for (Index p = 0; p < 3; ++p) {
    particles.position.component(0)[p] = static_cast<double>(p) + 0.5;
    particles.mass.component(0)[p] = 1;
    particles.id.component(0)[p] = static_cast<double>(p) + 7;
  }
  return particles;
}

[[nodiscard]] PlaneSurface<1> ground(double height) {
  return {Vector<1>{height}, Vector<1>{1.0}};
}

/// Known from 1 m on only.
[[nodiscard]] FromSurface<1> half_known(const Vector<1>& x) {
  return {x[0] < 1 ? std::numeric_limits<double>::quiet_NaN() : x[0], Vector<1>{1.0}};
}

TEST(RequireAbove, TakesMaterialThatStandsOnItsBed) {
  EXPECT_NO_THROW((require_above<1, 1>(three_points(), ground(0.25))));
}

TEST(RequireAbove, NamesThePointThatIsDeepest) {
  EXPECT_EQ(message_of<InputError>([] { require_above<1, 1>(three_points(), ground(1.75)); }),
            "the bed cuts the material: material point 7 at (0.5) m is 1.25 m below it");
}

TEST(RequireAbove, NamesAPointWhereNothingIsKnown) {
  EXPECT_EQ(message_of<InputError>([] { require_above<1, 1>(three_points(), half_known); }),
            "nothing is known of the bed at material point 7 at (0.5) m");
}

TEST(KeepAbove, RemovesWhatIsInTheGround) {
  auto particles = three_points();
  const std::size_t extra = particles.add_column({"grain_size", "s_a", "m"}, 1);
  for (Index p = 0; p < 3; ++p) particles.column(extra).component(0)[p] = static_cast<double>(p);

  keep_above<1, 1>(particles, half_known);

  ASSERT_EQ(particles.size(), 2);
  EXPECT_EQ(particles.id.component(0)[0], 8);
  EXPECT_EQ(particles.column(extra).component(0)[1], 2);
  EXPECT_EQ(message_of<InputError>([&] { keep_above<1, 1>(particles, ground(9)); }),
            "all material lies below the bed");
}

}  // namespace
}  // namespace scree::mpm
