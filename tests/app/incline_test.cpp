// The paper's inclined-plane flow against its reference, end to end.

#include "incline.hpp"

#include "scree/run/summary.hpp"

#include <gtest/gtest.h>

namespace scree::app::testing {
namespace {

/// What a run at 51 cells may miss the reference by. The scheme is first order at the shocks that separate
/// the classes, so at each of them s_a is off by its jump (at most 0.5 mm) over about one of the 50 cells:
/// 0.010 mm; B feels its own velocity error too; D has no shock and is second order.
struct Case {
  char variant;
  double size_bound;  // mean |s_a - reference| at every time [mm]
};

class InclinedPlane : public ::testing::TestWithParam<Case> {};

TEST_P(InclinedPlane, ColumnAgreesWithTheReferenceAtEveryTime) {
  Simulation<1, 2> column{scene_of(column_scene(GetParam().variant)), {1}};

  const InclineErrors errors = errors_of(column, GetParam().variant);

  EXPECT_LE(errors.largest_size(), GetParam().size_bound);
  EXPECT_LE(errors.velocity, 0.015);  // of the surface speed
}

/// Whatever the length of the run: this one takes 1e5 steps.
TEST_P(InclinedPlane, KeepsEveryClassAndEveryBoundOver1e5Steps) {
  Simulation<1, 2> column{scene_of(column_scene(GetParam().variant)), {1}};

  advance_to_end(column);

  EXPECT_GE(column.clock.step, 100000);
  EXPECT_LE(class_mass_drift(column), 1e-12);
  EXPECT_GE(column.tally.fractions.lowest, -1e-14);
  EXPECT_LE(column.tally.fractions.highest, 1 + 1e-14);
  EXPECT_LE(column.tally.fractions.sum_error, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Variants, InclinedPlane,
                         ::testing::Values(Case{'A', 0.010}, Case{'B', 0.013}, Case{'D', 0.002}),
                         [](const auto& test) { return std::string{test.param.variant}; });

TEST(InclinedPlane2D, EqualsTheColumnWithinTheSameBounds) {
  Simulation<2, 2> slope{scene_of("inclined_plane"), {2}};

  const InclineErrors errors = errors_of(slope, 'B');

  EXPECT_LE(errors.largest_size(), 0.013);
  EXPECT_LE(errors.velocity, 0.015);
  EXPECT_LE(class_mass_drift(slope), 1e-12);
  EXPECT_GE(slope.tally.fractions.lowest, -1e-14);
  EXPECT_LE(slope.tally.fractions.highest, 1 + 1e-14);
  EXPECT_LE(slope.tally.fractions.sum_error, 1e-13);
}

/// The source paper's eq. (11), run beside: as conservative, but points leave [0, 1] as soon as they differ
/// from the mean of their control volume, by as much as they differ.
TEST(InclinedPlanePaperMap, BreaksTheBoundsThatTheExchangeMapKeeps) {
  const std::vector<std::string> nodes{"segregation.control_volumes=nodes", "time.end=4"};
  auto with_paper_map = nodes;
  with_paper_map.emplace_back("segregation.map=increments");
  Simulation<1, 2> exchange{scene_of("inclined_plane_column", nodes), {1}};
  Simulation<1, 2> increments{scene_of("inclined_plane_column", with_paper_map), {1}};

  for (auto* simulation : {&exchange, &increments}) advance_to_end(*simulation);

  EXPECT_LE(class_mass_drift(increments), 1e-12);
  EXPECT_LT(increments.tally.fractions.lowest, -1e-3);
  EXPECT_GE(exchange.tally.fractions.lowest, -1e-14);
  EXPECT_LE(exchange.tally.fractions.highest, 1 + 1e-14);
}

}  // namespace
}  // namespace scree::app::testing
