#include "problems.hpp"

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

/// u' = 0, with a stable step of 0.1 s.
ImexProblem still() {
  ImexProblem problem;
  problem.explicit_rate = [](double /*t*/, ImexProblem::Values /*u*/, std::span<double> rate) {
    rate[0] = 0;
    return 0.1;
  };
  return problem;
}

TEST(ImexIntegrator, TakesFewestEqualStepsThatAreStable) {
  std::vector<double> u{1};
  ImexIntegrator integrator{1, still(), {.steps = Steps::longest}};

  const ImexReport report = integrator.advance(u, 0, 1);

  EXPECT_EQ(report.steps, 12);  // 1/(0.9 * 0.1) = 11.1
  EXPECT_EQ(report.rejected, 0);
  EXPECT_DOUBLE_EQ(report.last_step, 1.0 / 12);
  EXPECT_EQ(report.explicit_evaluations, 1 + 12 * (1 + 4));  // ARKODE's first; bound and stages of each
}

TEST(ImexIntegrator, KeepsAdaptiveStepsStable) {  // the error is zero, so that nothing else bounds them
  std::vector<double> u{1};
  ImexIntegrator integrator{1, still(), {.steps = Steps::adaptive}};

  const ImexReport report = integrator.advance(u, 0, 1);

  EXPECT_GE(report.steps, 12);
  EXPECT_LE(report.steps, 13);  // the last may be cut short
}

TEST(ImexIntegrator, NeverExceedsTheLargestStep) {
  for (const Steps steps : {Steps::longest, Steps::adaptive}) {
    std::vector<double> u{1};
    ImexIntegrator integrator{1, still(), {.steps = steps, .largest_step = 0.01}};
    const long taken = integrator.advance(u, 0, 1).steps;
    EXPECT_GE(taken, 100);
    EXPECT_LE(taken, 101);
  }
}

TEST(ImexIntegrator, ShortensAStepThatItsOwnStagesShowToBeTooLong) {
  // u' = u^2 from 1, stable up to 0.5/u. A step of 0.4 has a stage at 1.4, which allows 0.357: it is taken
  // again as two of 0.2, the first of which ends at 1.244, the second with a stage at 1.55, which allows
  // 0.32.
  ImexProblem problem;
  problem.explicit_rate = [](double /*t*/, ImexProblem::Values u, std::span<double> rate) {
    rate[0] = u[0] * u[0];
    return 0.5 / u[0];
  };
  ImexIntegrator integrator{1, problem, {.method = ImexMethod::ssp2, .steps = Steps::longest}};
  std::vector<double> u{1};

  const ImexReport report = integrator.advance(u, 0, 0.4);

  EXPECT_EQ(report.steps, 2);
  EXPECT_EQ(report.rejected, 1);
  const auto heun = [](double v) { return v + 0.1 * (v * v + (v + 0.2 * v * v) * (v + 0.2 * v * v)); };
  EXPECT_NEAR(u[0], heun(heun(1)), 20 * round_off);
}

TEST(ImexIntegrator, AdaptsItsStepsToTheTolerance) {
  // The error of a step is below the tolerance, its growth until the end below e, as d(rate)/du <= 1.
  for (const ImexMethod method : test::all_methods) {
    for (const double tolerance : {1e-4, 1e-6}) {
      std::vector<double> u{0.25};
      ImexIntegrator integrator{1,
                                test::logistic(test::Split::linear_part),
                                {.method = method,
                                 .relative_tolerance = tolerance,
                                 .absolute_tolerance = tolerance,
                                 .solver = Banded{0, 0}}};
      const ImexReport report = integrator.advance(u, 0.3, 1);
      EXPECT_LE(std::abs(u[0] - test::logistic_at(1.3, 0.3, 0.25)),
                static_cast<double>(report.steps) * 2 * tolerance * std::exp(1.0));
    }
  }
}

TEST(ImexIntegrator, TakesStepsInProportionToARootOfTheTolerance) {  // third, of the embedded second order
  std::array<double, 2> steps{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double tolerance = i == 0 ? 1e-6 : 1e-9;
    std::vector<double> u{0.25};
    ImexIntegrator integrator{
        1,
        test::logistic(test::Split::linear_part),
        {.relative_tolerance = tolerance, .absolute_tolerance = tolerance, .solver = Banded{0, 0}}};
    steps[i] = static_cast<double>(integrator.advance(u, 0.3, 1).steps);
  }
  EXPECT_NEAR(std::log10(steps[1] / steps[0]), 1, 0.2);  // the few steps of the start and the end count
}

TEST(ImexIntegrator, DependsOnItsArgumentsOnly) {
  for (const Steps steps : {Steps::longest, Steps::adaptive}) {
    ImexIntegrator integrator{
        1, test::logistic(test::Split::linear_part), {.steps = steps, .largest_step = 0.1}};
    std::vector<double> first{0.25};
    std::vector<double> between{0.9};
    std::vector<double> second{0.25};
    const ImexReport report = integrator.advance(first, 0.3, 1);
    integrator.advance(between, 5, 0.7);
    const ImexReport again = integrator.advance(second, 0.3, 1);
    EXPECT_EQ(first, second);
    EXPECT_EQ(report.steps, again.steps);
    EXPECT_EQ(report.newton_iterations, again.newton_iterations);
    EXPECT_EQ(report.linear_iterations, again.linear_iterations);
  }
}

TEST(ImexIntegrator, DoesNothingInNoTime) {
  std::vector<double> u{1};
  ImexIntegrator integrator{1, still()};
  EXPECT_EQ(integrator.advance(u, 3, 0).steps, 0);
  EXPECT_EQ(u[0], 1);
}

TEST(ImexIntegrator, CanBeMoved) {
  ImexIntegrator integrator{1, still()};
  ImexIntegrator other = std::move(integrator);
  std::vector<double> u{1};
  EXPECT_GE(other.advance(u, 0, 1).steps, 12);
}

}  // namespace
}  // namespace scree::transport
