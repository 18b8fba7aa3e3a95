#include "problems.hpp"

#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport_stiff/stiff_solver.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace scree::transport {
namespace {

const PiecewiseLinear<Minmod> second_order{Minmod{2}};

TEST(StiffSolver, DampsASineModeAsItsMethodSays) {  // Eq. (T51): R(z) per step, z = dt times the eigenvalue
  constexpr Index n = 64;
  constexpr int num_steps = 10;
  constexpr double dt = 0.01;
  const Lattice<1> lattice = test::line(n, 0, 1);
  std::vector<double> mode;
  for (Index i = 0; i < n; ++i) mode.push_back(std::sin(2 * test::pi * lattice.position({i})[0]));
  std::vector<double> u = mode;
  StiffSolver solver{Cartesian<1>{lattice},
                     test::AdvectionDiffusion{0, 1},
                     second_order,
                     {.largest_step = dt, .relative_tolerance = 1e-11, .absolute_tolerance = 1e-11}};

  const ImexReport report = solver.advance(u, num_steps * dt);

  EXPECT_EQ(report.steps, num_steps);
  const double z = dt * 4 * n * n * std::pow(std::sin(test::pi / n), 2);
  const double g = test::gamma_ssp2;
  const double factor = (1 - z * (1 - 2 * g)) / std::pow(1 + g * z, 2);
  // Solves within 1e-12 (mean square) count h lambda times, lambda = 4 n^2, in two stages a step.  Eq. (T54)
  const double bound = num_steps * 2 * dt * 4 * n * n * std::sqrt(n) * 1e-12;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    EXPECT_NEAR(u[i], std::pow(factor, num_steps) * mode[i], bound);
  }
}

TEST(StiffSolver, DampsASineModeAsTheEquationSays) {
  constexpr double duration = 0.01;
  const double wave_number = 2 * test::pi;
  for (const Index n : {32, 64}) {
    const Lattice<1> lattice = test::line(n, 0, 1);
    std::vector<double> u;
    for (Index i = 0; i < n; ++i) u.push_back(std::sin(wave_number * lattice.position({i})[0]));
    const std::vector<double> mode = u;
    StiffSolver solver{Cartesian<1>{lattice},
                       test::AdvectionDiffusion{0, 1},
                       second_order,
                       {.method = ImexMethod::ark5, .largest_step = duration / 8}};
    solver.advance(u, duration);
    // The eigenvalue is k^2 (1 - (k dx)^2/12 + (k dx)^4/360 - ..): the excess is that of its second term.
    const double kx = wave_number * lattice.spacing[0];
    const double decay = std::exp(-wave_number * wave_number * duration);
    const double excess = decay * wave_number * wave_number * duration * kx * kx / 12;
    EXPECT_NEAR(u[3] / mode[3] - decay, excess, excess * kx * kx / 2) << n;
  }
}

TEST(StiffSolver, IsTheExplicitSolverWhereNothingIsStiff) {  // SSPRK2 is the explicit half of ssp2
  const Lattice<1> lattice = test::line(100, 0, 1);
  std::vector<double> u = test::square_and_bump(100);
  std::vector<double> expected = u;
  const test::NonlinearDiffusion law{0};

  const ImexReport report = StiffSolver{Cartesian<1>{lattice}, law, second_order}.advance(u, 0.4);
  const Advance advance = Solver{Cartesian<1>{lattice}, law, second_order}.advance(expected, 0.4);

  EXPECT_EQ(report.steps, advance.substeps);
  // Sums in another order: some ten roundings a step, which a nonlinear limiter passes on.
  EXPECT_LE(test::linf(u, expected), 10 * round_off * advance.substeps * 10);
}

/// Error of the wave 1 - tanh((x - t)/(2 nu)), nu = 0.05, on [-2, 3] at T = 1, with diffusion implicit or
/// not.
double wave_error(Index n, bool is_implicit, ImexMethod method = ImexMethod::ssp2) {
  struct ViscousBurgers : test::NonlinearDiffusion {
    State potential(const State& u) const noexcept { return {viscosity * u[0]}; }
    double max_diffusivity(const State&, const State&) const noexcept { return viscosity; }
  };
  constexpr double viscosity = 0.05;
  const Lattice<1> lattice = test::line(n, -2, 3, false);
  const auto wave = [&](double time) {
    return test::averages(lattice, [=](double x) {
      const double s = std::abs(x - time) / (2 * viscosity);  // log cosh without overflow
      return x - 2 * viscosity * (s + std::log1p(std::exp(-2 * s)));
    });
  };
  const BoxBoundaries<1, 1> ends{{{Prescribed<1>{{2.0}}, Outflow{}}}};
  auto u = wave(0);
  const Cartesian<1> grid{lattice};
  if (is_implicit) {
    StiffSolver{
        grid, ViscousBurgers{{viscosity}}, second_order, {.cfl = 0.5, .boundaries = ends, .method = method}}
        .advance(u, 1);
  } else {
    Solver{grid, ViscousBurgers{{viscosity}}, second_order, SspRk2{}, {.cfl = 0.5, .boundaries = ends}}
        .advance(u, 1);
  }
  return test::l1(u, wave(1), lattice.spacing[0]);
}

TEST(StiffSolver, CarriesAViscousWaveAtTheStepOfConvection) {
  // The errors of the explicit solver, which takes 2 to 8 times the steps, on 50 to 400 cells (to 3 %): those
  // of space. Implicit diffusion adds those of longer steps: together they stay second order.
  const std::array<Index, 4> cells{50, 100, 200, 400};
  const std::array explicit_errors{1.831e-2, 3.825e-3, 1.187e-3, 3.324e-4};
  double coarser = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_NEAR(wave_error(cells[i], false), explicit_errors[i], 0.03 * explicit_errors[i]);
    const double error = wave_error(cells[i], true);
    EXPECT_LE(error, 1.5 * explicit_errors[i]) << cells[i];
    if (i > 1) {
      EXPECT_GE(std::log2(coarser / error), 1.5) << cells[i];  // the scheme's, limited at the wave
    }
    coarser = error;
  }
}

TEST(StiffSolver, ConservesToRoundOffOnOccupiedCellsHoweverLooselyItSolves) {
  Lattice<2> lattice = test::cube<2>(16);
  lattice.is_periodic = {false, true};
  OccupiedCells<2> grid{lattice};
  std::vector<double> masses;
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site));
    const bool is_filled = x[0] + 0.3 * std::sin(2 * test::pi * x[1]) < 0.7;
    masses.push_back(is_filled ? 0.004 * (1 + x[1]) : 0.0);
    u.push_back(is_filled ? 2 + std::tanh(5 * std::sin(2 * test::pi * x[1])) : std::nan(""));
  }
  grid.set_masses(masses);
  const auto total = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += masses[i] > 0 ? masses[i] * u[i] : 0;
    return sum;
  };
  const double before = total();
  StiffSolver solver{grid,
                     test::NonlinearDiffusion{0.5},
                     second_order,
                     {.relative_tolerance = 1e-2, .absolute_tolerance = 1e-2}};

  const ImexReport report = solver.advance(u, 0.1);

  // Each step adds rates whose round-off is that of the fluxes, h lambda u = (0.9/6 dx) 4 * 0.5 * 28/dx^2 u.
  const double rounding = 0.15 * 56 * 16 * round_off * before;
  EXPECT_NEAR(total(), before, 4 * static_cast<double>(report.steps) * rounding);
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_EQ(std::isnan(u[i]), masses[i] == 0);
}

template <int D>
std::vector<double> mixed(Threads threads) {
  const Lattice<D> lattice = test::cube<D>(D == 2 ? 40 : 12);
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<D> x = lattice.position(lattice.site(site));
    u.push_back(std::tanh(3 * std::sin(2 * test::pi * x[0])) * std::cos(2 * test::pi * x[D - 1]));
  }
  StiffSolver solver{
      Cartesian<D>{lattice}, test::NonlinearDiffusion{0.1}, second_order, {.threads = threads}};
  solver.advance(u, 0.01);
  return u;
}

TEST(StiffSolver, HasTheSameBitsForAnyNumberOfThreads) {
  EXPECT_EQ(mixed<2>({1}), mixed<2>({2}));
  EXPECT_EQ(mixed<3>({1}), mixed<3>({2}));
}

TEST(StiffSolver, RefusesWhatItCannotPromise) {
  const auto make = [](StiffOptions<Cartesian<1>, 1> options) {
    return test::message_of<InputError>([&] {
      StiffSolver{Cartesian<1>{test::line(10, 0, 1)}, test::AdvectionDiffusion{1, 1}, second_order, options};
    });
  };
  EXPECT_EQ(make({.cfl = 0.56}),
            "Solver: the CFL number is 0.56: must lie in (0, 0.5], as the scheme promises no more");
  EXPECT_EQ(make({.relative_tolerance = -1}),
            "ImexIntegrator: relative_tolerance = -1: must be positive and finite");
  EXPECT_EQ(make({.solver = Banded{1, 1}}),
            "ImexIntegrator: Banded is a direct solver: it takes no preconditioner");
}

TEST(StiffSolver, RefusesWrongSizesAndTimes) {
  StiffSolver solver{Cartesian<1>{test::line(10, 0, 1)}, test::AdvectionDiffusion{1, 1}, second_order};
  std::vector<double> u(9, 1.0);
  EXPECT_EQ(test::message_of<InputError>([&] { solver.advance(u, 1); }),
            "Solver: 9 values for 10 sites x 1 components");
  u.resize(10, 1.0);
  EXPECT_EQ(test::message_of<InputError>([&] { solver.advance(u, -1); }),
            "Solver: the duration is -1 s: must be zero or positive, and finite");
}

TEST(StiffSolver, NamesTheSiteOfANaNAndLeavesTheStateAsItWas) {
  StiffSolver solver{Cartesian<1>{test::line(10, 0, 1)}, test::AdvectionDiffusion{1, 1}, second_order};
  std::vector<double> u(10, 1.0);
  u[4] = std::nan("");
  EXPECT_EQ(test::message_of<RunError>([&] { solver.advance(u, 1); }),
            "transport: the rate of change is not finite at site (3), position (0.35) m");
  EXPECT_EQ(u[3], 1);
  EXPECT_EQ(solver.time(), 0);
}

}  // namespace
}  // namespace scree::transport
