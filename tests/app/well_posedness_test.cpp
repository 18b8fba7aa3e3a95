#include "scree/run/well_posedness.hpp"

#include "scenes.hpp"

#include <gtest/gtest.h>

namespace scree::app::testing {
namespace {

/// References: 0.0224556 m^2/s at gdot = 4.042; the base of this flow has 4.0419. Central differences of the
/// viscosity leave a relative 1e-8.
TEST(WellPosedness, CriticalRemixingIsThatOfTheClosedForm) {
  const auto critical = critical_remixing(scene_of("inclined_plane_column_c"));

  ASSERT_TRUE(critical.has_value());
  EXPECT_NEAR(*critical, 0.0224556 * 4.041942286 / 4.042, 5e-7);
}

TEST(WellPosedness, LiteralCouplingIsWarnedOfAndItsRemediesAreNot) {
  EXPECT_EQ(ill_posedness_warning(scene_of("inclined_plane_column_c")),
            "this two-way coupling is ill-posed: remixing D = 0 m^2/s is below D_crit = 0.0225 m^2/s (at the "
            "base, steady flow); layers grow at the scale of the mesh, faster the finer it is");
  for (const char* remedy : {"inclined_plane_column_a", "inclined_plane_column", "inclined_plane_column_d"}) {
    EXPECT_EQ(ill_posedness_warning(scene_of(remedy)), "") << remedy;
  }
}

}  // namespace
}  // namespace scree::app::testing
