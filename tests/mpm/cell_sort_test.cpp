#include "bodies.hpp"
#include "messages.hpp"

#include <scree/mpm/cell_sort.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};

/// Points anywhere in a periodic square, sorted for quadratic shapes.
struct Sorted {
  CartesianGrid<2> grid = cube<2>(20, 0.1, true);
  Particles<2> particles = scattered<2>(grid, 500, 0);
  ParticleBlocks<2> blocks = cell_sort(particles, grid, 0.5, one_thread);

  [[nodiscard]] bool is_real(Index p) const { return particles.mass.component(0)[p] > 0; }
};

TEST(CellSort, KeepsEveryPointOnce) {
  const Sorted sorted;

  std::multiset<double> ids;
  for (Index p = 0; p < sorted.particles.size(); ++p) {
    if (sorted.is_real(p)) ids.insert(sorted.particles.id.component(0)[p]);
  }

  ASSERT_EQ(ids.size(), 500);
  for (int id = 0; id < 500; ++id) EXPECT_EQ(ids.count(id), 1);
}

TEST(CellSort, MovesEveryColumnAlike) {
  const auto grid = cube<2>(20, 0.1, true);
  auto particles = scattered<2>(grid, 500, 0);
  const std::size_t extra = particles.add_column({"copy_of_id", "i", "-"}, 2);
  for (Index p = 0; p < particles.size(); ++p)
    particles.column(extra).component(1)[p] = static_cast<double>(p);

  static_cast<void>(cell_sort(particles, grid, 0.5, one_thread));

  for (Index p = 0; p < particles.size(); ++p) {
    EXPECT_EQ(particles.column(extra).component(1)[p], particles.id.component(0)[p]);
  }
}

TEST(CellSort, FillsBlocksToWholePacksWithPointsThatWeighNothing) {
  const Sorted sorted;

  Index end = 0;
  for (const auto& block : sorted.blocks.blocks) {
    EXPECT_EQ(block.begin, end);  // no gap
    EXPECT_GT(block.end, block.begin);
    EXPECT_EQ((block.end - block.begin) % pack_size, 0);
    EXPECT_TRUE(sorted.is_real(block.begin));
    end = block.end;
    for (Index p = block.begin + 1; p < block.end; ++p) {
      if (sorted.is_real(p)) continue;
      EXPECT_GE(p, block.end - pack_size + 1);
      EXPECT_EQ(sorted.particles.id.component(0)[p], sorted.particles.id.component(0)[p - 1]);
    }
  }
  EXPECT_EQ(end, sorted.particles.size());
}

// Nothing but the columns, and a share of 1/32 for padding that comes and goes.
TEST(CellSort, HoldsNoMoreMemoryThanItsPointsNeed) {
  Sorted sorted;
  Index most = sorted.particles.size();
  for (int n = 0; n < 5; ++n) {
    for (Index p = 0; p < sorted.particles.size(); ++p) sorted.particles.position.component(0)[p] *= 1.1;

    static_cast<void>(cell_sort(sorted.particles, sorted.grid, 0.5, one_thread));

    most = std::max(most, sorted.particles.size());
    const std::size_t needed = sorted.particles.bytes_per_particle() * static_cast<std::size_t>(most);
    EXPECT_LE(sorted.particles.held_bytes(), needed + needed / 32);
  }
}

TEST(CellSort, PutsEachPointIntoTheBlockWhereItsStencilBegins) {
  const Sorted sorted;

  for (const auto& block : sorted.blocks.blocks) {
    for (Index p = block.begin; p < block.end; ++p) {
      for (int axis = 0; axis < 2; ++axis) {
        const double base = std::floor(sorted.particles.position.component(axis)[p] / 0.1 - 0.5);
        const auto first = static_cast<double>(block.first_cell[static_cast<std::size_t>(axis)]);
        EXPECT_GE(base, first);
        EXPECT_LT(base, first + block_edge<2>);
      }
    }
  }
}

TEST(CellSort, KeepsTheOrderOfPointsInOneCell) {
  Sorted sorted;
  const std::vector<double> order{sorted.particles.id.values().begin(), sorted.particles.id.values().end()};

  const auto again = cell_sort(sorted.particles, sorted.grid, 0.5, one_thread);

  ASSERT_EQ(sorted.particles.id.values().size(), order.size());
  EXPECT_TRUE(std::equal(order.begin(), order.end(), sorted.particles.id.values().begin()));
  EXPECT_EQ(again.blocks.size(), sorted.blocks.blocks.size());
}

TEST(CellSort, BringsPointsBackIntoAPeriodicAxis) {
  const auto grid = cube<1>(10, 0.1, true);
  Particles<1> particles;
  particles.resize(3);
  const std::vector<double> places{-0.05, 1.25, 3.5};
  for (Index p = 0; p < 3; ++p) {
    particles.mass.component(0)[p] = 1;
    particles.id.component(0)[p] = static_cast<double>(p);
    particles.position.component(0)[p] = places[static_cast<std::size_t>(p)];
  }

  static_cast<void>(cell_sort(particles, grid, 0, one_thread));

  const std::vector<double> expected{0.95, 0.25, 0.5};
  for (Index p = 0; p < 3; ++p) {
    const auto id = static_cast<std::size_t>(particles.id.component(0)[p]);
    EXPECT_NEAR(particles.position.component(0)[p], expected[id], 8 * round_off);  // of numbers up to four
  }
}

/// Where a point at x lies after a sort on a periodic axis of four cells.
[[nodiscard]] double place_in_period(double origin, double length, double x) {
  const CartesianGrid<1> grid{Vector<1>{origin}, Vector<1>{length / 4}, {4}, {true}};
  Particles<1> particles;
  particles.resize(1);
  particles.mass.component(0)[0] = 1;
  particles.position.component(0)[0] = x;
  static_cast<void>(cell_sort(particles, grid, 0, one_thread));
  return particles.position.component(0)[0];
}

/// A rounding below the end, (x - origin)/length rounds to 1.
TEST(CellSort, LeavesAPointThatLiesInThePeriodWhereItIs) {
  EXPECT_EQ(place_in_period(-1, 3, 1.9999999999999998), 1.9999999999999998);
  EXPECT_EQ(place_in_period(-0.3, 0.7, 0.3999999999999999), 0.3999999999999999);
  EXPECT_EQ(place_in_period(-0.3, 0.7, -0.3), -0.3);
}

TEST(CellSort, TakesWhatRoundingTakesPastAnEndToTheOrigin) {
  EXPECT_EQ(place_in_period(0, 1, -1e-17), 0);               // a period on it is 1
  EXPECT_EQ(place_in_period(-1, 3, 7.999999999999999), -1);  // three back: 9 roundings before -1
  EXPECT_EQ(place_in_period(-0.3, 0.7, -1.0), -0.3);         // one on: a rounding before -0.3
  EXPECT_EQ(message_of<RunError>([] { static_cast<void>(place_in_period(0, 1, std::nan(""))); }),
            "material point 0 at (nan) m has no finite position");
}

/// The message when point 1 of three stands at (x, 0.05).
std::string message_with_point_at(double x) {
  const auto grid = cube<2>(20, 0.1, false);
  auto particles = scattered<2>(grid, 3, 0);
  particles.position.component(0)[1] = x;
  particles.position.component(1)[1] = 0.05;
  return message_of<RunError>([&] { static_cast<void>(cell_sort(particles, grid, 0.5, one_thread)); });
}

TEST(CellSort, NamesAPointOutsideTheMesh) {
  EXPECT_EQ(message_with_point_at(2.5),
            "material point 1 at (2.5, 0.05) m is outside the mesh [0, 2] x [0, 2] m");
  EXPECT_EQ(message_with_point_at(-0.125),
            "material point 1 at (-0.125, 0.05) m is outside the mesh [0, 2] x [0, 2] m");
}

TEST(CellSort, NamesAPointThatIsNowhere) {
  EXPECT_EQ(message_with_point_at(std::numeric_limits<double>::quiet_NaN()),
            "material point 1 at (nan, 0.05) m has no finite position");
  EXPECT_EQ(message_with_point_at(std::numeric_limits<double>::infinity()),
            "material point 1 at (inf, 0.05) m has no finite position");
}

TEST(CellSort, TakesAPointThatLiesOnTheLastWall) {
  const auto grid = cube<1>(10, 0.1, false);
  Particles<1> particles;
  particles.resize(1);
  particles.mass.component(0)[0] = 1;
  particles.position.component(0)[0] = 1.0;

  const auto blocks = cell_sort(particles, grid, 0, one_thread);

  EXPECT_EQ(blocks.blocks.size(), 1);
}

}  // namespace
}  // namespace scree::mpm
