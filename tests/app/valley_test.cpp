// A collapse over a synthetic valley and a dam break of 1e5 points, both to their ends; minutes long.

#include "valley.hpp"

namespace scree::app::testing {
namespace {

TEST(ValleyCollapse, RunsOutOntoTheFanAndComesToRest) {
  const auto [start, end, fastest] = collapse_in_the_valley();

  EXPECT_GT(end.front(0.995), 110);  // onto the fan, which begins there
  EXPECT_GT(end.front(0.995) - start.front(0.995), 60);
  EXPECT_LT(end.velocity.norm(), 0.01 * fastest);
  // A block that slides down stops where it has fallen by friction times its way; what also shears within,
  // and has an inner friction of up to mu_2, sooner.
  const Vector<3> way = end.centre - start.centre;
  const double apparent_friction = -way[1] / std::hypot(way[0], way[2]);
  EXPECT_GT(apparent_friction, 0.4);
  EXPECT_LT(apparent_friction, 0.64);
}

TEST(DamBreak3d, RunsThroughTheTankToItsFarEnd) {
  const Simulation<3, 3> dam{scene_of("dam_break_3d"), {1}};
  ASSERT_NEAR(static_cast<double>(dam.num_points()), 1e5, 1e3);

  expect_arrival({}, {});
}

}  // namespace
}  // namespace scree::app::testing
