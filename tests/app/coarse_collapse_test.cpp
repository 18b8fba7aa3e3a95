// The valley and the dam break in space on coarse meshes, seconds long.

#include "valley.hpp"

namespace scree::app::testing {
namespace {

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
