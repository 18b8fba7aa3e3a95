// A lake at rest in a basin full of islands: walls push back just as hard as the water does.

#include "lines.hpp"

#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/laws/shallow_water.hpp>

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace scree::transport {
namespace {

constexpr double gravity = 9.81;
constexpr double depth = 0.7;
constexpr double pressure = gravity * depth * depth / 2;  // over the density [m^3/s^2]

/// Cells that are there or not, at random: an island in every third place.
std::vector<double> islands(Index num_sites, unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> draw;
  std::vector<double> shares;
  for (Index site = 0; site < num_sites; ++site) shares.push_back(draw(random) < 1.0 / 3 ? 0 : 1);
  return shares;
}

struct Basin {
  Lattice<2> cells = test::cube<2>(24);
  std::vector<double> shares = islands(cells.num_sites(), 7);
  OccupiedCells<2> grid{cells};
  std::vector<double> u;  // (h, h v_x, h v_y) of each cell

  Basin() {
    cells.is_periodic.fill(false);
    grid = OccupiedCells<2>{cells};
    grid.set_fill(shares);
    for (const double share : shares) u.insert(u.end(), {share * depth, 0, 0});
  }

  Advance advance(double duration) {
    return Solver{grid, ShallowWater<2>{gravity}, {.boundaries = everywhere(Reflecting{})}}.advance(u,
                                                                                                    duration);
  }
  [[nodiscard]] double water() const {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); i += 3) sum += u[i];
    return sum;
  }
};

TEST(MaskedLake, StaysAtRest) {
  Basin basin;

  const Advance done = basin.advance(1);

  // Two stages of two axes, each with two fluxes of eight roundings of the pressure times dt/dx <= 1/(2 c).
  const double wave = std::sqrt(gravity * depth);
  const double tolerance = done.substeps * 2 * 2 * 2 * 8 * round_off * pressure / (2 * wave);
  EXPECT_GE(done.substeps, 100);
  for (std::size_t i = 0; i < basin.u.size(); i += 3) {
    EXPECT_NEAR(basin.u[i], basin.shares[i / 3] * depth,
                tolerance / wave);  // what a momentum makes of a depth
    EXPECT_NEAR(basin.u[i + 1], 0, tolerance);
    EXPECT_NEAR(basin.u[i + 2], 0, tolerance);
  }
}

TEST(MaskedLake, KeepsItsWaterWhenItIsStirred) {
  Basin basin;
  for (std::size_t i = 0; i < basin.u.size() / 2; i += 3) basin.u[i] *= 2;  // the lower half is twice as deep
  const double before = basin.water();
  const auto start = basin.u;

  const Advance done = basin.advance(0.5);

  // Each step rounds each depth twice; depths are 2 x 0.7 at most.
  const double tolerance =
      done.substeps * 2 * round_off * 2 * depth * static_cast<double>(basin.shares.size());
  EXPECT_NEAR(basin.water(), before, tolerance);
  EXPECT_NE(basin.u, start);
}

}  // namespace
}  // namespace scree::transport
