// Failure mode 4, the remedy (the failure is in failure_modes_test.cpp): a cell that holds a thousandth of
// its neighbours' mass keeps their step.

#include "../lines.hpp"

#include <scree/transport/components.hpp>
#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

/// f = u (1 - u): nothing passes at 0 and 1, so these are bounds, as for fractions.
struct Exchange {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  State flux(const State& u, const Vector<1>& normal) const noexcept {
    return {normal[0] * u[0] * (1 - u[0])};
  }
  double max_speed(const State& left, const State& right, const Vector<1>& /*normal*/) const noexcept {
    return larger(std::abs(1 - 2 * left[0]), std::abs(1 - 2 * right[0]));
  }
};

template <class R>
void expect_bounded(const R& reconstruction) {
  const Lattice<1> lattice = test::line(40, 0, 40);
  std::vector<double> masses(40, 1.0);
  masses[20] = 1e-3;
  OccupiedCells<1> grid{lattice};
  grid.set_masses(masses);
  std::vector<double> u(40, 0.0);
  std::fill(u.begin() + 5, u.begin() + 15, 1.0);
  const auto total = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < 40; ++i) sum += masses[i] * u[i];
    return sum;
  };
  const double before = total();
  Solver solver{grid, Exchange{}, reconstruction, SspRk2{}, {.cfl = 0.4}};
  double largest = 0;

  EXPECT_DOUBLE_EQ(solver.stable_time_step(u), 0.4);  // that of the full cells
  for (int step = 0; step < 200; ++step) {
    solver.advance(u, 0.4);
    for (const double value : u) largest = std::max(largest, std::abs(value));
  }

  EXPECT_LE(largest, 1 + 1e-12);
  EXPECT_NEAR(total(), before, 200 * 40 * round_off * before);  // one rounding a cell and step
}

TEST(SmallCell, KeepsTheFullStepWhenOnlyItsMassIsSmall) {
  expect_bounded(PiecewiseConstant{});
  expect_bounded(PiecewiseLinear{Minmod{1}});
  expect_bounded(PiecewiseLinear{Minmod{2}});
}

}  // namespace
}  // namespace scree::transport
