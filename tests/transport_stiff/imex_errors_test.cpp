#include "problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace scree::transport {
namespace {

using Values = ImexProblem::Values;

ImexProblem simple() {
  return test::decay(1, false);
}

std::string refusal(Index num_values, const ImexProblem& problem, const ImexOptions& options) {
  return test::message_of<InputError>([&] { ImexIntegrator{num_values, problem, options}; });
}

TEST(ImexIntegrator, RefusesOptionsOutOfRange) {
  EXPECT_EQ(refusal(0, simple(), {}), "ImexIntegrator: 0 values: must be 1 or more");
  EXPECT_EQ(refusal(1, simple(), {.relative_tolerance = 0}),
            "ImexIntegrator: relative_tolerance = 0: must be positive and finite");
  EXPECT_EQ(refusal(1, simple(), {.absolute_tolerance = std::nan("")}),
            "ImexIntegrator: absolute_tolerance = nan: must be positive and finite");
  EXPECT_EQ(refusal(1, simple(), {.largest_step = -1}),
            "ImexIntegrator: largest_step = -1 s: must be positive");
  EXPECT_EQ(refusal(1, simple(), {.stable_part = 1.5}),
            "ImexIntegrator: stable_part = 1.5: must lie in (0, 1]");
  EXPECT_EQ(refusal(1, simple(), {.solver = Gmres{0}}),
            "ImexIntegrator: Gmres keeps 0 vectors: must be 1 or more");
  EXPECT_EQ(refusal(1, simple(), {.solver = ConjugateGradients{0}}),
            "ImexIntegrator: ConjugateGradients may take 0 iterations: must be 1 or more");
  EXPECT_EQ(refusal(3, simple(), {.solver = Banded{1, 3}}),
            "ImexIntegrator: Banded has 1 diagonals below and 3 above: must lie in [0, 2]");
}

TEST(ImexIntegrator, RefusesPartsThatDoNotFit) {
  EXPECT_EQ(refusal(1, {}, {}), "ImexIntegrator: neither an explicit nor an implicit rate is given");
  ImexProblem problem = simple();
  problem.precondition = [](Values, std::span<double>) {};
  EXPECT_EQ(refusal(1, problem, {}),
            "ImexIntegrator: a preconditioner needs both precondition and prepare_preconditioner");
  problem.prepare_preconditioner = [](double, Values, double) {};
  EXPECT_EQ(refusal(1, problem, {.solver = Banded{0, 0}}),
            "ImexIntegrator: Banded is a direct solver: it takes no preconditioner");
}

TEST(ImexIntegrator, RefusesWrongSizesAndTimes) {
  ImexIntegrator integrator{2, simple()};
  std::vector<double> u(3, 1.0);
  const auto refusal_of = [&](double time, double duration) {
    return test::message_of<InputError>([&] { integrator.advance(u, time, duration); });
  };
  EXPECT_EQ(refusal_of(0, 1), "ImexIntegrator: 3 values where 2 are integrated");
  u.resize(2);
  EXPECT_EQ(refusal_of(std::nan(""), 1), "ImexIntegrator: the time is nan s: must be finite");
  EXPECT_EQ(refusal_of(0, -1), "ImexIntegrator: the duration is -1 s: must be zero or positive, and finite");
}

/// A problem of which one function throws, once: on its `fatal` call.
ImexProblem throwing(const std::string& which, int fatal) {
  const auto fail_at = [&which, fatal](const char* name) {
    return [is_it = which == name, fatal, calls = 0]() mutable {
      if (is_it && ++calls == fatal) throw std::runtime_error{"out of sand"};
    };
  };
  ImexProblem problem;
  problem.explicit_rate = [fail = fail_at("explicit")](double, Values, std::span<double> rate) mutable {
    fail();
    rate[0] = 0;
    return 0.1;
  };
  problem.implicit_rate = [fail = fail_at("implicit")](double, Values u, std::span<double> rate) mutable {
    fail();
    rate[0] = -u[0];
  };
  problem.jacobian_product = [fail = fail_at("product")](double, Values, Values v,
                                                         std::span<double> product) mutable {
    fail();
    product[0] = -v[0];
  };
  problem.prepare_preconditioner = [fail = fail_at("prepare")](double, Values, double) mutable { fail(); };
  problem.precondition = [fail = fail_at("precondition")](Values residual, std::span<double> z) mutable {
    fail();
    z[0] = residual[0];
  };
  return problem;
}

TEST(ImexIntegrator, LetsExceptionsOfItsFunctionsThrough) {
  for (const char* which : {"explicit", "implicit", "product", "prepare", "precondition"}) {
    for (const Steps steps : {Steps::longest, Steps::adaptive}) {
      ImexIntegrator integrator{
          1, throwing(which, std::string{"prepare"} == which ? 1 : 3), {.steps = steps}};
      std::vector<double> u{1};
      const auto message = test::message_of<std::runtime_error>([&] { integrator.advance(u, 0, 1); });
      EXPECT_EQ(message, "out of sand") << which;
      EXPECT_EQ(u[0], 1);

      integrator.advance(u, 0, 1);  // it threw once: the integrator is as good as new

      EXPECT_NEAR(u[0], std::exp(-1), 1e-4);  // h^3 of a step of 0.09 s
    }
  }
}

TEST(ImexIntegrator, NamesTheSolversWordWhenItFailsAndPrintsNothing) {
  ImexProblem problem;  // to which no Newton iteration leads
  problem.implicit_rate = [](double, Values u, std::span<double> rate) { rate[0] = u[0] > 0.5 ? -1e6 : 1e6; };
  ImexIntegrator integrator{
      1,
      problem,
      {.method = ImexMethod::ssp2, .steps = Steps::longest, .largest_step = 0.1, .solver = Banded{0, 0}}};
  std::vector<double> u{1};
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();

  const auto message = test::message_of<RunError>([&] { integrator.advance(u, 0, 1); });

  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(message,
            "ImexIntegrator: ARKStepEvolve failed with ARK_CONV_FAILURE: At t = 0.0292893 and h = 0.1, the "
            "solver convergence test failed repeatedly or with |h| = hmin.");
  EXPECT_EQ(u[0], 1);
}

TEST(ImexIntegrator, SaysWhichValueIsNotFinite) {
  ImexProblem problem;
  problem.explicit_rate = [](double, Values, std::span<double> rate) {
    rate[0] = 0;
    rate[1] = std::nan("");
    return test::no_bound;
  };
  ImexIntegrator integrator{2, problem, {.steps = Steps::longest}};
  std::vector<double> u{1, 2};
  EXPECT_EQ(test::message_of<RunError>([&] { integrator.advance(u, 0, 3); }),
            "ImexIntegrator: value 1 is nan at time 3 s");
  EXPECT_EQ(u, (std::vector<double>{1, 2}));
}

TEST(ImexIntegrator, SaysWhenAStableStepIsNoStep) {
  const auto message_of_bound = [](double bound) {
    ImexProblem problem;
    problem.explicit_rate = [=](double, Values, std::span<double> rate) {
      rate[0] = 0;
      return bound;
    };
    ImexIntegrator integrator{1, problem, {.steps = Steps::longest}};
    std::vector<double> u{1};
    return test::message_of<RunError>([&] { integrator.advance(u, 2, 1); });
  };
  EXPECT_EQ(message_of_bound(std::nan("")),
            "ImexIntegrator: the explicit rate's stable step is nan s at time 2 s: must be positive");
  EXPECT_EQ(message_of_bound(0),
            "ImexIntegrator: the explicit rate's stable step is 0 s at time 2 s: must be positive");
  EXPECT_EQ(message_of_bound(1e-17).substr(0, 42), "ImexIntegrator: the step fell to 9e-18 s a");
}

/// u' = 1, stable in steps of 0.1 s up to u = 1 and of 1e-6 s beyond.
ImexProblem collapsing() {
  ImexProblem problem;
  problem.explicit_rate = [](double, Values u, std::span<double> rate) {
    rate[0] = 1;
    return u[0] > 1 ? 1e-6 : 0.1;
  };
  return problem;
}

// 2/0.09 = 23 steps at first: 1000 (23 + 1) at most. A stage of the 12th is beyond u = 1.
TEST(ImexIntegrator, EndsARunWhoseStepsCollapse) {
  ImexIntegrator integrator{1, collapsing(), {.steps = Steps::longest}};
  std::vector<double> u{0};
  EXPECT_EQ(test::message_of<RunError>([&] { integrator.advance(u, 0, 2); }),
            "ImexIntegrator: the time step fell from 0.0869565 s to 8.99999e-07 s in 24000 steps, at time "
            "0.978112 s: "
            "more steps than a flow of such waves as at the start takes");
  EXPECT_EQ(u[0], 0);
}

TEST(ImexIntegrator, TakesNoMoreStepsThanItIsTold) {
  std::vector<double> u{0};
  ImexIntegrator longest{1, collapsing(), {.steps = Steps::longest, .max_steps = 5}};
  EXPECT_EQ(
      test::message_of<RunError>([&] { longest.advance(u, 0, 0.9); }),
      "ImexIntegrator: the time step fell from 0.09 s to 0.09 s in 5 steps, at time 0.45 s: more steps than "
      "max_steps");
  ImexIntegrator adaptive{1, collapsing(), {.steps = Steps::adaptive, .max_steps = 5}};
  EXPECT_EQ(
      test::message_of<RunError>([&] { adaptive.advance(u, 0, 0.9); }),
      "ImexIntegrator: ARKStepEvolve failed with ARK_TOO_MUCH_WORK: At t = 0.45, mxstep steps taken before "
      "reaching tout.");
  EXPECT_EQ(test::message_of<InputError>([&] { ImexIntegrator(1, collapsing(), {.max_steps = 0}); }),
            "ImexIntegrator: max_steps = 0: must be 1 or more");
}

}  // namespace
}  // namespace scree::transport
