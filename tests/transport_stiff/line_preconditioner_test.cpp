#include "problems.hpp"

#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport_stiff/stiff_solver.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

/// Two components, each diffusing down the other's gradient too, with a source that exchanges them.
struct Coupled {
  static constexpr int num_components = 2;
  using State = std::array<double, 2>;
  State flux(const State& /*u*/, const Vector<1>& /*normal*/) const noexcept { return {0, 0}; }
  double max_speed(const State&, const State&, const Vector<1>&) const noexcept { return 0; }
  State potential(const State& u) const noexcept { return {2 * u[0] + u[1], 0.5 * u[0] + 3 * u[1]}; }
  double max_diffusivity(const State&, const State&) const noexcept { return 4; }
  State source(const State& u, const Vector<1>& /*x*/, double /*t*/) const noexcept {
    return {-1000 * (u[0] - u[1]), 700 * (u[0] - u[1])};
  }
};

void expect_a_direct_solve(bool is_periodic) {  // with an empty site
  const Lattice<1> lattice = test::line(30, 0, 1, is_periodic);
  OccupiedCells<1> grid{lattice};
  std::vector<double> masses(30, 0.02);
  masses[11] = 0;
  masses[20] = 0.001;
  grid.set_masses(masses);
  constexpr double gamma = 0.1;  // gamma J is of the order of 1000
  std::vector<double> u(60);
  std::vector<double> residual(60);
  for (std::size_t i = 0; i < 60; ++i) {
    u[i] = std::cos(static_cast<double>(i));
    residual[i] = std::sin(static_cast<double>(i * i));
  }
  LinePreconditioner<OccupiedCells<1>, Coupled> lines{lattice, {}};
  std::vector<double> z(60);

  lines.prepare(grid, Coupled{}, 0, u, gamma);
  lines.solve(residual, z);

  std::vector<double> rate(60);  // J z, as all is linear
  stiff_rate(grid, Coupled{}, Threads{}, 0, z, rate);
  double largest = 0;
  for (const double value : z) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < 60; ++i) {
    // The derivatives are differences, with half the digits: 1e-8 of gamma J z, times the four faces' terms.
    EXPECT_NEAR(z[i] - gamma * rate[i], residual[i], 4 * 3 * gamma * 900 * 20 * 1e-8 * largest) << i;
  }
}

TEST(LinePreconditioner, SolvesALineDirectly) {
  expect_a_direct_solve(false);
  expect_a_direct_solve(true);
}

/// Linear iterations per Newton iteration of a solver in D dimensions.
template <int D>
double iterations_per_solve(Index n, bool is_periodic, Preconditioner preconditioner, double diffusivity) {
  Lattice<D> lattice = test::cube<D>(n);
  lattice.is_periodic.fill(is_periodic);
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<D> x = lattice.position(lattice.site(site));
    u.push_back(std::tanh(3 * std::sin(2 * test::pi * x[0])) + (D > 1 ? std::cos(7 * x[D - 1]) : 0));
  }
  StiffSolver solver{Cartesian<D>{lattice},
                     test::AdvectionDiffusion{1, diffusivity},
                     PiecewiseLinear{Minmod{2}},
                     {.solver = Gmres{60}, .preconditioner = preconditioner}};
  const ImexReport report = solver.advance(u, 3.0 / static_cast<double>(n));
  return static_cast<double>(report.linear_iterations) / static_cast<double>(report.newton_iterations);
}

TEST(LinePreconditioner, MakesIterationsFewAndIndependentOfTheGrid) {
  for (const Index n : {50, 200, 800}) {
    // A direct solve, but for the derivatives' error of 1e-8: one iteration, or two.
    EXPECT_LE(iterations_per_solve<1>(n, false, Preconditioner::lines, 0.1), 2) << n;
    EXPECT_LE(iterations_per_solve<1>(n, true, Preconditioner::lines, 0.1), 2) << n;
  }
  // gamma J grows as n at a given CFL number, iterations without as its square root at least.
  const double coarse = iterations_per_solve<1>(50, false, Preconditioner::none, 0.1);
  EXPECT_GE(iterations_per_solve<1>(200, false, Preconditioner::none, 0.1), 1.5 * coarse);
}

TEST(LinePreconditioner, HelpsInTwoDimensionsToo) {
  for (const double diffusivity : {0.1, 1.0}) {  // gamma J = 1.3 and 13 along each axis
    EXPECT_LE(3 * iterations_per_solve<2>(48, true, Preconditioner::lines, diffusivity),
              iterations_per_solve<2>(48, true, Preconditioner::none, diffusivity));
  }
}

}  // namespace
}  // namespace scree::transport
