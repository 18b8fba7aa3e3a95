#include <scree/box.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace scree {
namespace {

/// What box() says, empty if it accepts.
std::string complaint(const std::array<double, 2>& low, const std::array<double, 2>& high,
                      const Indices<2>& num_cells) {
  try {
    static_cast<void>(box<2>(low, high, num_cells));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Box, ReachesFromCornerToCorner) {
  const CartesianGrid<2> grid = box<2>({-1, 0}, {2, 0.5}, {6, 2}, {true, false});

  EXPECT_EQ(grid.origin(), (Vector<2>{-1, 0}));
  EXPECT_EQ(grid.spacing(), (Vector<2>{0.5, 0.25}));
  EXPECT_EQ(grid.num_cells(), (Indices<2>{6, 2}));
  EXPECT_EQ(grid.is_periodic(), (std::array{true, false}));
}

TEST(Box, IsNotPeriodicUnlessToldSo) {
  EXPECT_EQ(box<1>({0}, {1}, {10}).is_periodic(), std::array{false});
}

TEST(Box, RefusesCornersAndCountsThatMakeNone) {
  const char* corners = "box: the high corner must lie above the low one along each axis";
  EXPECT_EQ(complaint({0, 0}, {1, 0}, {2, 2}), corners);
  EXPECT_EQ(complaint({0, 2}, {1, 1}, {2, 2}), corners);
  EXPECT_EQ(complaint({0, 0}, {1, std::nan("")}, {2, 2}), corners);
  EXPECT_EQ(complaint({0, 0}, {1, HUGE_VAL}, {2, 2}),
            "CartesianGrid: a cell's edges must be positive and finite");
  EXPECT_EQ(complaint({0, 0}, {1, 1}, {2, 0}), "box: each axis must have at least one cell");
  EXPECT_EQ(complaint({0, 0}, {1, 1}, {2, 2}), "");
}

}  // namespace
}  // namespace scree
