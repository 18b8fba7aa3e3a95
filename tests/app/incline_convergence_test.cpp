// The order in which the paper's flow approaches its reference; minutes long.

#include "incline.hpp"

#include <gtest/gtest.h>

namespace scree::app::testing {
namespace {

class InclinedPlaneConvergence : public ::testing::TestWithParam<char> {};

/// First order at the shocks is a factor of 2 for each doubling; 1.7 leaves room for where a shock happens to
/// stand in its cell at the eight times.
TEST_P(InclinedPlaneConvergence, ErrorFallsBy1Point7PerDoublingTo204Cells) {
  std::vector<double> errors;
  for (const char* cells : {"51", "102", "204"}) {
    Simulation<1, 2> column{scene_of(column_scene(GetParam()), {std::string{"mesh.cells="} + cells}), {1}};
    errors.push_back(errors_of(column, GetParam()).mean_size());
  }

  EXPECT_GE(errors[0] / errors[1], 1.7);
  EXPECT_GE(errors[1] / errors[2], 1.7);
}

INSTANTIATE_TEST_SUITE_P(Variants, InclinedPlaneConvergence, ::testing::Values('A', 'B', 'D'),
                         [](const auto& test) { return std::string{test.param}; });

}  // namespace
}  // namespace scree::app::testing
