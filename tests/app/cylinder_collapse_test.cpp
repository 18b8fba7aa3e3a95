// Cylinders of grains that collapse round their axis, against the law of experiments.

#include "cylinder.hpp"

#include <gtest/gtest.h>

namespace scree::app::testing {
namespace {

TEST(CylinderCollapse, RunsOutAsFarAsInExperimentsUpToTwiceItsRadiusInHeight) {  // Eq. (M179)
  for (const double aspect : {0.5, 1.0, 2.0}) {
    EXPECT_NEAR(Heap(aspect, 16).runout(), of_cylinders(aspect), tolerance_of(aspect, 16)) << aspect;
  }
}

}  // namespace
}  // namespace scree::app::testing
