// Columns, the valley and the dam break in space on coarse meshes, seconds long.

#include "column.hpp"
#include "valley.hpp"

#include <gtest/gtest.h>

#include <string>

namespace scree::app::testing {
namespace {

TEST(CoarseColumnCollapse, RunsOutAsFarAsTheContinuum) {  // Eq. (M198)
  for (const double aspect : {0.5, 1.0}) {
    EXPECT_NEAR(Column(aspect, 32).runout(), of_the_continuum(aspect), tolerance_of_columns(aspect, 32))
        << "aspect ratio " << aspect;
  }
}

/// Larger and denser ones have a larger I at the same shear, so more friction.
TEST(CoarseColumnCollapse, RunsOutFartherTheFinerTheGrains) {
  const double of_3_mm = Column(0.5, 32, {3e-3, 2500}).runout();
  const double of_the_chosen = Column(0.5, 32).runout();
  const double of_1_mm = Column(0.5, 32, {1e-3, 1500}).runout();

  EXPECT_LT(of_3_mm, of_the_chosen);
  EXPECT_LT(of_the_chosen, of_1_mm);
}

TEST(CoarseValleyCollapse, RunsOutOntoTheFan) {
  const auto [start, end, fastest] = collapse_in_the_valley({"mesh.cells=18"});

  EXPECT_GT(end.front(0.995), 110);  // onto the fan, which begins there
  EXPECT_GT(fastest, 0);
  EXPECT_LT(end.velocity.norm(), 0.01 * fastest);
}

/// A slice of the tank, two cells thick.
TEST(CoarseDamBreak3d, RunsThroughTheTankToItsFarEnd) {
  const std::string coarse = "mesh.cells=20";

  expect_arrival({coarse, "mesh.size=[2.0, 1.0, 0.1]", "material.high=[0.5, 0.65, 0.1]"}, {coarse});
}

}  // namespace
}  // namespace scree::app::testing
