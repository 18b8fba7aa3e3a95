// The coupling's own arithmetic: closures on points, means, dimension by dimension.

#include "scenes.hpp"
#include "scree/run/simulation.hpp"
#include "scree/scene/axes.hpp"
#include "scree/scene/material_columns.hpp"

#include <gtest/gtest.h>

namespace scree::app::testing {
namespace {

TEST(Axes, AColumnIsNormalToTheBaseAndFlowsByItsSecondComponent) {
  EXPECT_EQ(axis_names(1), (std::vector<std::string_view>{"y"}));
  EXPECT_EQ(axis_names(3), (std::vector<std::string_view>{"x", "y", "z"}));
  EXPECT_EQ(flow_component(1, 2), 1);
  EXPECT_EQ(flow_component(1, 1), -1);
  EXPECT_EQ(flow_component(2, 2), 0);
  EXPECT_EQ(normal_component(1), 0);
  EXPECT_EQ(normal_component(3), 1);
}

TEST(Grains, MeanSizeOfAPointIsThatOfItsFractions) {
  Simulation<1, 2> column{scene_of("inclined_plane_column"), {1}};
  auto& particles = column.state.particles;
  auto& fractions = particles.column(particles.find_column(fraction_column, "the test"));
  fractions.component(0)[3] = 0.25;
  fractions.component(1)[3] = 0.75;

  Mixture{column.scene()}.update(particles);

  const auto& size = particles.column(particles.find_column(grain_size_column, "the test"));
  EXPECT_DOUBLE_EQ(size.component(0)[3], 0.25 * 0.5e-3 + 0.75 * 1e-3);
  EXPECT_DOUBLE_EQ(size.component(0)[4], 0.75e-3);
}

/// The mesh cell holds the balance, so the points of one cell share its change: where they were equal, they
/// stay equal, and the flow's three rows per cell keep one mixture.
TEST(Coupling, PointsOfOneCellStayEqual) {
  Simulation<1, 2> column{scene_of("inclined_plane_column", {"time.end=0.5"}), {1}};

  while (!column.is_finished()) column.step();

  const auto& particles = column.state.particles;
  const auto& fractions = particles.column(particles.find_column(fraction_column, "the test"));
  double largest_change = 0;
  for (Index p = 0; p < 150; p += 3) {
    EXPECT_NEAR(fractions.component(0)[p], fractions.component(0)[p + 1], 1e-13);
    EXPECT_NEAR(fractions.component(0)[p], fractions.component(0)[p + 2], 1e-13);
    largest_change = std::max(largest_change, std::abs(fractions.component(0)[p] - 0.5));
  }
  EXPECT_GT(largest_change, 0.4);  // the base is nearly all fines by then
}

}  // namespace
}  // namespace scree::app::testing
