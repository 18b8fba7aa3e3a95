// A reflecting wall on cells of any form stands for the other half of a symmetric flow.

#include "lines.hpp"
#include "meshes.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/euler.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace scree::transport {
namespace {

using Walls = NamedBoundaries<2, 4>;
const Walls walls{
    {"left", Reflecting{}}, {"right", Reflecting{}}, {"bottom", Reflecting{}}, {"top", Reflecting{}}};
const Euler<2> gas;

/// A blast round the origin, symmetric in x, in a box [low, 1] x [0, 1] of squares or what it is cut into.
struct Blast {
  Polygonal grid;
  std::vector<double> u;

  Blast(double low, Index count, Cut cut, double perturbation)
      : grid{make_mesh({.low = {low, 0},
                        .high = {1, 1},
                        .count = {static_cast<Index>((1 - low) * static_cast<double>(count)), count},
                        .cut = cut,
                        .perturbation = perturbation})} {
    for (Index cell = 0; cell < grid.num_cells(); ++cell) {
      const bool is_inside = grid.centre(cell).norm() < 0.4;
      const auto state = gas.state(is_inside ? 2 : 1, Vector<2>{0, 0}, is_inside ? 5 : 1);
      u.insert(u.end(), state.begin(), state.end());
    }
  }

  template <class R>
  Advance advance(const R& reconstruction, double duration) {
    return Solver{grid, gas, reconstruction, {.cfl = 0.4, .boundaries = walls}}.advance(u, duration);
  }
  [[nodiscard]] double total(std::size_t component) const {
    double sum = 0;
    for (Index cell = 0; cell < grid.num_cells(); ++cell) {
      sum += grid.volume(cell) * u[4 * static_cast<std::size_t>(cell) + component];
    }
    return sum;
  }
};

TEST(ReflectingPolygons, StandForTheOtherHalfOfASymmetricFlow) {  // without slopes: the same to rounding
  constexpr Index n = 16;
  Blast half{0, n, Cut::quadrilaterals, 0};
  Blast whole{-1, n, Cut::quadrilaterals, 0};

  half.advance(PiecewiseConstant{}, 0.3);
  const Advance done = whole.advance(PiecewiseConstant{}, 0.3);

  // Each step adds some hundred roundings of values of at most 20, which waves carry but do not amplify.
  const double tolerance = done.substeps * 100 * 20 * round_off;
  for (Index cell = 0; cell < half.grid.num_cells(); ++cell) {
    Index twin = 0;
    while ((whole.grid.centre(twin) - half.grid.centre(cell)).norm() > 0.1 / n) ++twin;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(half.u[4 * static_cast<std::size_t>(cell) + k],
                  whole.u[4 * static_cast<std::size_t>(twin) + k], tolerance);
    }
  }
}

TEST(ReflectingPolygons, LetNoMassAndNoEnergyPass) {  // on bad triangles, with slopes
  Blast blast{0, 16, Cut::triangles, 0.3};
  const double mass = blast.total(0);
  const double energy = blast.total(3);

  const Advance done = blast.advance(CellGradient{SmoothCubic{}}, 0.5);

  // Each step rounds the state of each cell twice: relative to the totals, two roundings.
  EXPECT_GE(done.substeps, 50);
  EXPECT_NEAR(blast.total(0), mass, done.substeps * 2 * 2 * round_off * mass);
  EXPECT_NEAR(blast.total(3), energy, done.substeps * 2 * 2 * round_off * energy);
}

}  // namespace
}  // namespace scree::transport
