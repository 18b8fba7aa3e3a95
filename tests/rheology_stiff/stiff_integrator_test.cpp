#include "bodies.hpp"

#include <scree/rheology_stiff/stiff_integrator.hpp>

#include <gtest/gtest.h>

#include <stdexcept>

namespace scree::rheology {
namespace {

using Values = RateForm::Values;

/// u' = -lambda (u - cos t) - sin t, so u = cos t from 1, however stiff.
RateForm relaxing(double lambda, bool has_jacobian) {
  RateForm form;
  form.law = "relaxing";
  form.rate = [=](double t, Values u, std::span<double> rate) {
    rate[0] = -lambda * (u[0] - std::cos(t)) - std::sin(t);
  };
  if (has_jacobian) {
    form.jacobian = [=](double /*t*/, Values /*u*/, std::span<double> jacobian) { jacobian[0] = -lambda; };
  }
  return form;
}

TEST(StiffIntegrator, FollowsASlowSolutionHoweverFastTheRelaxation) {
  for (const bool has_jacobian : {false, true}) {
    for (const double lambda : {1.0, 1e3, 1e6}) {
      StiffIntegrator integrator{1, relaxing(lambda, has_jacobian), {1e-8, 1e-8}};
      std::vector<double> u{1};
      const auto report = integrator.advance(u, 0, 1);
      // The tolerance of each step, adding up over all of them where nothing is damped.
      EXPECT_NEAR(u[0], std::cos(1), 2e-8 * static_cast<double>(report.steps)) << lambda;
      EXPECT_LE(report.steps, 300) << lambda;  // an explicit method takes lambda/2
    }
  }
}

TEST(StiffIntegrator, DependsOnItsArgumentsOnly) {
  StiffIntegrator integrator{1, relaxing(1e3, true)};
  std::vector<double> first{1};
  integrator.advance(first, 0, 1);
  std::vector<double> other{5};
  integrator.advance(other, 3, 0.1);
  std::vector<double> again{1};
  integrator.advance(again, 0, 1);
  EXPECT_EQ(first, again);
}

TEST(StiffIntegrator, RefusesWhatDoesNotFit) {
  const auto refusal = [](std::size_t num_values, RateForm form, StiffIntegratorOptions options) {
    return test::message_of<InputError>([&] { StiffIntegrator{num_values, std::move(form), options}; });
  };
  EXPECT_EQ(refusal(0, relaxing(1, true), {}), "StiffIntegrator: 0 values: must be 1 or more");
  EXPECT_EQ(refusal(1, {.law = "sand", .rate = {}}, {}), "StiffIntegrator: the law 'sand' has no rate");
  EXPECT_EQ(refusal(1, relaxing(1, true), {.relative_tolerance = 0}),
            "StiffIntegrator: relative_tolerance = 0: must be positive and finite");
  EXPECT_EQ(refusal(1, relaxing(1, true), {.absolute_tolerance = std::nan("")}),
            "StiffIntegrator: absolute_tolerance = nan: must be positive and finite");
  EXPECT_EQ(refusal(1, relaxing(1, true), {.largest_count = 0}),
            "StiffIntegrator: largest_count = 0: must be 1 or more");
  StiffIntegrator integrator{1, relaxing(1, true)};
  std::vector<double> u(2, 1.0);
  const auto refusal_of = [&](double time, double duration) {
    return test::message_of<InputError>([&] { integrator.advance(u, time, duration); });
  };
  EXPECT_EQ(refusal_of(0, 1), "StiffIntegrator: 2 values where 1 are integrated");
  u.resize(1);
  EXPECT_EQ(refusal_of(std::nan(""), 1), "StiffIntegrator: the time is nan s: must be finite");
  EXPECT_EQ(refusal_of(0, -1), "StiffIntegrator: the duration is -1 s: must be zero or positive, and finite");
}

TEST(StiffIntegrator, LetsExceptionsOfTheLawThrough) {
  RateForm form;
  form.law = "sand";
  form.rate = [](double t, Values u, std::span<double> rate) {
    if (t > 0.1) throw std::runtime_error{"out of sand"};
    rate[0] = -u[0];
  };
  StiffIntegrator integrator{1, form};
  std::vector<double> u{1};
  EXPECT_EQ(test::message_of<std::runtime_error>([&] { integrator.advance(u, 0, 1); }), "out of sand");
  EXPECT_EQ(u[0], 1);
  integrator.advance(u, 0, 0.01);  // as good as new
  EXPECT_NEAR(u[0], std::exp(-0.01), 1e-5);
}

TEST(StiffIntegrator, NamesTheLawTheTimeAndTheWordWhenItFails) {  // u' = u^2 is infinite at t = 1
  RateForm form;
  form.law = "collapse";
  form.rate = [](double /*t*/, Values u, std::span<double> rate) { rate[0] = u[0] * u[0]; };
  StiffIntegrator integrator{1, form, {.largest_count = 200}};
  std::vector<double> u{1};
  testing::internal::CaptureStderr();
  const auto message = test::message_of<RunError>([&] { integrator.advance(u, 0, 2); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(message.substr(0, 47), "StiffIntegrator: the law 'collapse' at time 0.9");
  EXPECT_NE(message.find("CVode failed with CV_"), std::string::npos);
  EXPECT_EQ(u[0], 1);
}

}  // namespace
}  // namespace scree::rheology
