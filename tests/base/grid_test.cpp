#include <scree/grid.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace scree {
namespace {

/// What the constructor says of a plane grid, empty if it accepts.
std::string complaint(const Vector<2>& origin, const Vector<2>& spacing, const Indices<2>& num_cells) {
  try {
    const CartesianGrid<2> grid{origin, spacing, num_cells, {false, false}};
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

const CartesianGrid<2> slope{Vector<2>{-1, 0}, Vector<2>{0.5, 0.25}, {2, 51}, {true, false}};

TEST(CartesianGrid, HasOneMoreNodeThanCellsWhereItEnds) {
  const Indices<2> cells{2, 51};
  const Indices<2> nodes{2, 52};  // the first axis is periodic

  EXPECT_EQ(slope.cells().count, cells);
  EXPECT_EQ(slope.nodes().count, nodes);
}

TEST(CartesianGrid, CentresCellsBetweenTheirNodes) {
  EXPECT_EQ(slope.nodes().position({0, 0}), slope.origin());
  EXPECT_EQ(slope.cells().position({1, 3}),
            (slope.nodes().position({1, 3}) + slope.nodes().position({2, 4})) / 2);
}

TEST(CartesianGrid, CellsAndNodeVolumesFillTheSameBox) {
  const auto total = [](const Lattice<2>& lattice) {
    double sum = 0;
    for (Index i = 0; i < lattice.num_sites(); ++i) sum += lattice.volume(lattice.site(i));
    return sum;
  };

  const double box = slope.length(0) * slope.length(1);
  EXPECT_EQ(total(slope.cells()), box);  // powers of two: no rounding
  EXPECT_EQ(total(slope.nodes()), box);
}

TEST(CartesianGrid, RefusesWhatIsNoGrid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::string edges = "CartesianGrid: a cell's edges must be positive and finite";

  EXPECT_EQ(complaint({0, 0}, {1, 1}, {1, 1}), "");
  EXPECT_EQ(complaint({0, 0}, {1, 0}, {1, 1}), edges);
  EXPECT_EQ(complaint({0, 0}, {1, -1}, {1, 1}), edges);
  EXPECT_EQ(complaint({0, 0}, {nan, 1}, {1, 1}), edges);
  EXPECT_EQ(complaint({0, 0}, {infinity, 1}, {1, 1}), edges);
  EXPECT_EQ(complaint({0, 0}, {1, 1}, {1, 0}), "CartesianGrid: each axis must have at least one cell");
}

TEST(CartesianGrid, RefusesAnOriginThatIsNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_EQ(complaint({nan, 0}, {1, 1}, {1, 1}), "CartesianGrid: the origin must be finite");
}

}  // namespace
}  // namespace scree
