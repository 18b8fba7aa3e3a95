#include "problems.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace scree::transport {
namespace {

/// A single value needs no iterations: its Jacobian is one number.
constexpr Banded scalar{0, 0};
constexpr std::array orders{2, 2, 3, 4, 5};  // of test::all_methods

ImexOptions steps_of(double length, ImexMethod method) {
  return {.method = method,
          .steps = Steps::longest,
          .relative_tolerance = 1e-12,
          .absolute_tolerance = 1e-12,
          .largest_step = length,
          .solver = scalar};
}

double logistic_error(ImexMethod method, test::Split split, int num_steps) {
  std::vector<double> u{0.25};
  ImexIntegrator{1, test::logistic(split), steps_of(1.0 / num_steps, method)}.advance(u, 0.3, 1);
  return std::abs(u[0] - test::logistic_at(1.3, 0.3, 0.25));
}

TEST(ImexIntegrator, HasTheOrderOfItsMethodInBothHalvesAndTogether) {
  // The ratio of two errors is 2^order (1 + O(h)): within 15 %, 0.2 in the order, at these h. The steps of
  // the higher orders are longer, so that their errors stay above those of the implicit solves, 1e-12.
  const std::array num_steps{64, 64, 64, 8, 8};
  for (std::size_t i = 0; i < test::all_methods.size(); ++i) {
    for (const auto split : {test::Split::linear_part, test::Split::all, test::Split::nothing}) {
      const double coarse = logistic_error(test::all_methods[i], split, num_steps[i]);
      const double fine = logistic_error(test::all_methods[i], split, 2 * num_steps[i]);
      EXPECT_NEAR(std::log2(coarse / fine), orders[i], 0.2)
          << "method " << i << ", split " << static_cast<int>(split) << ", errors " << coarse << ' ' << fine;
    }
  }
}

double stiff_error(ImexMethod method, double lambda, int num_steps) {
  std::vector<double> u{1};
  ImexIntegrator{1, test::prothero_robinson(lambda), steps_of(1.0 / num_steps, method)}.advance(u, 0, 1);
  return u[0] - std::cos(1.0);
}

TEST(ImexIntegrator, Ars2IsExactInTheStiffLimit) {  // its last stage is the step: error O(1/lambda)
  for (const int num_steps : {8, 16, 32}) {
    // |u''| <= 1, one over lambda; and the solves' 1e-13, lambda h times, Eq. (T54)
    EXPECT_LE(std::abs(stiff_error(ImexMethod::ars2, 1e6, num_steps)), 1e-6 + 1e6 / num_steps * 1e-13);
  }
}

TEST(ImexIntegrator, Ssp2FallsToFirstOrderInTheStiffLimitAsPredicted) {  // Eq. (T51): where it fails
  // The step is off by h E (1 - 2 gamma)/(2 gamma) and remembers nothing of the one before.
  const double factor = (1 - 2 * test::gamma_ssp2) / (2 * test::gamma_ssp2);
  double coarser = 0;
  for (const int num_steps : {64, 128, 256}) {
    const double h = 1.0 / num_steps;
    const double error = stiff_error(ImexMethod::ssp2, 1e6, num_steps);
    EXPECT_NEAR(std::abs(error), factor * h * std::sin(1.0), h * h + 1 / (1e6 * h)) << num_steps;
    if (coarser != 0) {
      EXPECT_NEAR(std::log2(coarser / error), 1, 0.1);
    }
    coarser = error;
  }
}

TEST(ImexIntegrator, ExplicitHalfBlowsUpAboveTwoOverLambdaAndImplicitDoesNot) {
  constexpr double h = 1.0 / 64;  // sums of it are exact
  constexpr int num_steps = 200;
  for (const double z : {1.9, 2.1}) {  // h lambda; SSPRK2 is stable up to 2
    const double lambda = z / h;
    const double growth = 1 - z + z * z / 2;
    std::vector<double> u{1};
    ImexIntegrator{1, test::decay(lambda, true), steps_of(h, ImexMethod::ssp2)}.advance(u, 0, num_steps * h);
    const double expected = std::pow(growth, num_steps);                 // 1.1^200 = 4e8 at 2.1
    EXPECT_NEAR(u[0], expected, 20 * num_steps * round_off * expected);  // some ten operations a step

    for (const ImexMethod method : test::all_methods) {
      u = {1};
      ImexIntegrator{1, test::decay(lambda, false), steps_of(h, method)}.advance(u, 0, num_steps * h);
      EXPECT_LE(std::abs(u[0]), 1e-10);  // |R| < 0.5 there: nothing is left but the tolerance of the solves
    }
  }
}

TEST(ImexIntegrator, ForgetsAStiffStartInOneStep) {  // R -> 0: L-stable
  constexpr double z = 1e4;
  for (const ImexMethod method : test::all_methods) {
    std::vector<double> u{1};
    ImexIntegrator{1, test::decay(z, false), steps_of(1, method)}.advance(u, 0, 1);
    // R of these methods falls as 1/z, with factors below 10; and z times the solves' 1e-13, Eq. (T54).
    EXPECT_LE(std::abs(u[0]), 10 / z + 10 * z * 1e-13);
  }
}

/// A chain of six reservoirs that empty into each other, with rates of 1e4, and an exchange that is explicit.
ImexProblem reservoirs() {
  using Values = ImexProblem::Values;
  ImexProblem problem;
  problem.implicit_rate = [](double /*t*/, Values u, std::span<double> rate) {
    std::ranges::fill(rate, 0);
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
      const double flow = 1e4 * (u[i] * u[i] - u[i + 1]);
      rate[i] -= flow;
      rate[i + 1] += flow;
    }
  };
  problem.explicit_rate = [](double t, Values u, std::span<double> rate) {
    std::ranges::fill(rate, 0);
    rate[0] = std::cos(t) * u[5];
    rate[5] = -rate[0];
    return test::no_bound;
  };
  return problem;
}

TEST(ImexIntegrator, KeepsALinearInvariantHoweverLooselyItSolves) {
  for (const ImexMethod method : test::all_methods) {
    const auto run = [&](double tolerance, std::vector<double>& u) {
      ImexIntegrator integrator{6,
                                reservoirs(),
                                {.method = method,
                                 .steps = Steps::longest,
                                 .relative_tolerance = tolerance,
                                 .absolute_tolerance = tolerance,
                                 .largest_step = 1e-3}};
      integrator.advance(u, 0, 0.02);
    };
    std::vector<double> loose{1, 0.5, 0.25, 0.5, 0.75, 1};
    std::vector<double> tight = loose;
    run(1e-2, loose);
    run(1e-9, tight);
    // 20 steps of up to 8 stages, each adding twelve flows of up to 1e4 h = 10 with their round-off
    const double bound = 20 * 8 * 12 * 10 * round_off;
    EXPECT_GE(test::linf(loose, tight), 100 * bound);  // or nothing would be shown
    EXPECT_NEAR(std::accumulate(loose.begin(), loose.end(), 0.0), 4, bound);
    EXPECT_NEAR(std::accumulate(tight.begin(), tight.end(), 0.0), 4, bound);
  }
}

/// The heat equation on n cells between walls, u' = (u_{i-1} - 2 u_i + u_{i+1})/dx^2.
ImexProblem heat(Index n) {
  using Values = ImexProblem::Values;
  ImexProblem problem;
  problem.implicit_rate = [n](double /*t*/, Values u, std::span<double> rate) {
    const auto per_square = static_cast<double>(n * n);
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double below = i > 0 ? u[i - 1] - u[i] : 0;
      const double above = i + 1 < u.size() ? u[i + 1] - u[i] : 0;
      rate[i] = per_square * (below + above);
    }
  };
  return problem;
}

TEST(ImexIntegrator, GivesTheSameWithEverySolverOfTheLinearSystems) {
  constexpr Index n = 40;
  std::vector<std::vector<double>> results;
  for (const ImplicitSolver& solver :
       {ImplicitSolver{Banded{1, 1}}, ImplicitSolver{Gmres{40}}, ImplicitSolver{ConjugateGradients{200}}}) {
    std::vector<double> u(n);
    for (std::size_t i = 0; i < n; ++i) u[i] = i < n / 2 ? 1 : 0;
    ImexIntegrator integrator{n,
                              heat(n),
                              {.steps = Steps::longest,
                               .relative_tolerance = 1e-10,
                               .absolute_tolerance = 1e-10,
                               .largest_step = 0.01,
                               .solver = solver}};
    const ImexReport report = integrator.advance(u, 0, 0.02);
    EXPECT_EQ(report.linear_iterations > 0, !std::holds_alternative<Banded>(solver));
    results.push_back(u);
  }
  // Two steps of four stages whose solves are within 1e-11, times h lambda = 0.01 * 4 * 40^2, Eq. (T54)
  const double bound = 2 * 4 * 64 * 1e-11;
  EXPECT_LE(test::linf(results[0], results[1]), bound);
  EXPECT_LE(test::linf(results[0], results[2]), bound);
}

}  // namespace
}  // namespace scree::transport
