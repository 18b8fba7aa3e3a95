#include "problems.hpp"

#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport_stiff/stiff_solver.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace scree::transport {
namespace {

const PiecewiseLinear<Minmod> second_order{Minmod{2}};

/// Advection towards an equilibrium sin(2 pi (x - 2 t)) that itself moves: u_t + u_x = -(u - u_eq)/epsilon.
struct Relaxing {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  double epsilon;  // [s]

  static double equilibrium(double x, double t) noexcept { return std::sin(2 * test::pi * (x - 2 * t)); }
  State flux(const State& u, const Vector<1>& normal) const noexcept { return {normal[0] * u[0]}; }
  double max_speed(const State&, const State&, const Vector<1>&) const noexcept { return 1; }
  State source(const State& u, const Vector<1>& x, double t) const noexcept {
    return {-(u[0] - equilibrium(x[0], t)) / epsilon};
  }
};

struct Relaxed {
  double error;  ///< largest |u - u_eq|
  long steps;
};

Relaxed relax(double epsilon, ImexMethod method, Index n) {
  const Lattice<1> lattice = test::line(n, 0, 1);
  std::vector<double> u(static_cast<std::size_t>(n), 0.0);
  StiffOptions<Cartesian<1>, 1> options;
  options.method = method;
  StiffSolver solver{Cartesian<1>{lattice}, Relaxing{epsilon}, second_order, options};
  const ImexReport report = solver.advance(u, 0.5);
  double error = 0;
  for (Index i = 0; i < n; ++i) {
    const double exact = Relaxing::equilibrium(lattice.position({i})[0], 0.5);
    error = std::max(error, std::abs(u[static_cast<std::size_t>(i)] - exact));
  }
  return {error, report.steps};
}

TEST(StiffSolver, RelaxesAtTheStepOfConvectionHoweverFastTheSource) {
  for (const double epsilon : {1e-3, 1e-5, 1e-7}) {
    const Relaxed relaxed = relax(epsilon, ImexMethod::ars2, 100);
    EXPECT_EQ(relaxed.steps, 112);  // 0.5/(0.45 * 0.01) = 111.1: epsilon has no say
    // u = u_eq - epsilon (d/dt + d/dx) u_eq: |..| = 2 pi epsilon, to 20 % for slopes and epsilon/dt. And the
    // solves' 1e-10 in the mean square of 100 values, h/epsilon times, Eq. (T54).
    EXPECT_LE(relaxed.error, 1.2 * 2 * test::pi * epsilon + 0.0045 / epsilon * std::sqrt(100.0) * 1e-10)
        << epsilon;
  }
}

TEST(StiffSolver, LosesAnOrderWithSsp2WhereTheEquilibriumMoves) {  // where it fails, and the remedy: ars2
  // Off by dt E (1 - 2 gamma)/(2 gamma), E the explicit rate, -du_eq/dx: first order.
  const double factor = (1 - 2 * test::gamma_ssp2) / (2 * test::gamma_ssp2);
  for (const Index n : {100, 200}) {
    const double dt = 0.5 / std::ceil(0.5 * static_cast<double>(n) / 0.45);
    const double predicted = factor * dt * 2 * test::pi;
    const double error = relax(1e-6, ImexMethod::ssp2, n).error;
    EXPECT_NEAR(error, predicted, 0.1 * predicted) << n;  // the next order: 2 pi dt
    EXPECT_LE(relax(1e-6, ImexMethod::ars2, n).error, 0.01 * predicted) << n;
  }
}

/// The smallest value after one step from a single cell that is full, with a diffusion number nu dt/dx^2.
double smallest_after_spike(double number, double largest_step) {
  constexpr Index n = 64;
  std::vector<double> u(n, 0.0);
  u[n / 2] = 1;
  StiffSolver solver{
      Cartesian<1>{test::line(n, 0, n)},
      test::AdvectionDiffusion{0, number},
      second_order,
      {.largest_step = largest_step, .relative_tolerance = 1e-11, .absolute_tolerance = 1e-11}};
  solver.advance(u, 1);
  return *std::min_element(u.begin(), u.end());
}

TEST(StiffSolver, LosesBoundsInLongStepsOfDiffusionAndKeepsThemUpToTheThreshold) {  // Eq. (T57)
  const double threshold = (1 + std::sqrt(2.0)) / 2;                                // of nu dt/dx^2
  const auto tolerance = [](double number) { return 2 * 4 * number * 1e-12; };      // Eq. (T54)
  EXPECT_GE(smallest_after_spike(0.99 * threshold, 1), -tolerance(threshold));

  // What is left in the full cell is the mean of R over all modes.
  const double number = 10;
  double expected = 0;
  for (int mode = 0; mode < 64; ++mode) {
    const double z = 4 * number * std::pow(std::sin(test::pi * mode / 64), 2);
    expected += (1 - z * (1 - 2 * test::gamma_ssp2)) / std::pow(1 + test::gamma_ssp2 * z, 2) / 64;
  }
  EXPECT_LE(expected, -0.03);
  EXPECT_NEAR(smallest_after_spike(number, 1), expected, tolerance(number));

  // The remedy: steps within the threshold.
  EXPECT_GE(smallest_after_spike(number, 0.99 * threshold / number), -9 * tolerance(threshold));
}

TEST(StiffSolver, FailsWithoutAPreconditionerAndSaysSo) {
  // h lambda = 0.45 dx * 4/dx^2 = 1440: GMRES needs some sqrt(0.3 * 1440) = 20 vectors per two digits.
  const Lattice<1> lattice = test::line(800, 0, 1, false);
  const auto run = [&](Preconditioner preconditioner) {
    std::vector<double> u = test::square_and_bump(800);
    StiffSolver solver{Cartesian<1>{lattice},
                       test::AdvectionDiffusion{1, 1},
                       second_order,
                       {.preconditioner = preconditioner}};
    solver.advance(u, 0.01);
  };
  const auto message = test::message_of<RunError>([&] { run(Preconditioner::none); });
  EXPECT_EQ(message.substr(0, 62), "ImexIntegrator: ARKStepEvolve failed with ARK_CONV_FAILURE: At");
  EXPECT_NO_THROW(run(Preconditioner::lines));
}

TEST(StiffSolver, NeedsTheTighterTolerancesTheStifferTheProblem) {  // Eq. (T54): where it fails
  // A single site relaxing to 0.5 with rate lambda, solved to `tolerance`/10: the step is off by up to
  // h lambda times that, and by more than the tolerance as soon as h lambda is well above 10.
  const Lattice<1> lattice = test::line(200, 0, 1);
  const auto error = [&](double tolerance) {
    std::vector<double> u(200);
    for (std::size_t i = 0; i < 200; ++i) u[i] = std::sin(2 * test::pi * static_cast<double>(i) / 200);
    std::vector<double> exact = u;
    const auto advance = [&](std::vector<double>& v, double within) {
      StiffSolver{Cartesian<1>{lattice},
                  test::NonlinearDiffusion{10},
                  second_order,
                  {.largest_step = 1e-3, .relative_tolerance = within, .absolute_tolerance = within}}
          .advance(v, 1e-3);
    };
    advance(u, tolerance);
    advance(exact, 1e-11);
    return test::linf(u, exact);
  };
  const double amplification = 1e-3 * 4 * 10 * 4 * 200 * 200;  // h lambda, K' <= 4 nu
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) EXPECT_LE(error(tolerance), amplification * tolerance);
}

}  // namespace
}  // namespace scree::transport
