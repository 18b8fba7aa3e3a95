#include "bodies.hpp"

#include <scree/rheology_stiff/step_choice.hpp>

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace scree::rheology {
namespace {

TEST(ChooseViscousMethod, TakesTheCheapestByTheRatioOfSteps) {  // Eq. (R144)
  const auto method = [](double ratio, int dimension) {
    return choose_viscous_method(ratio * 1e-3, 1e-3, dimension).method;
  };
  for (const int dimension : {1, 2, 3}) {
    EXPECT_EQ(method(0, dimension), ViscousMethod::explicit_steps);
  }
  EXPECT_EQ(method(4.99, 1), ViscousMethod::explicit_steps);
  EXPECT_EQ(method(5.01, 1), ViscousMethod::implicit);
  for (const int dimension : {2, 3}) {
    EXPECT_EQ(method(2.99, dimension), ViscousMethod::explicit_steps);
    EXPECT_EQ(method(3.01, dimension), ViscousMethod::rkl2);
    const double threshold = dimension == 2 ? 5000 : 10000;
    EXPECT_EQ(method(0.99 * threshold, dimension), ViscousMethod::rkl2);
    EXPECT_EQ(method(1.01 * threshold, dimension), ViscousMethod::implicit);
  }
}

/// A solve that costs as much as n linear ones is worth n times as many stages, so a ratio of n^2 times.
TEST(ChooseViscousMethod, CountsTheSolvesOfNewtonsMethod) {  // Eqs. (R142), (R144)
  const auto method = [](double ratio, int dimension) {
    return choose_viscous_method(ratio * 1e-3, 1e-3, dimension, ViscosityIs::of_velocity).method;
  };
  const std::array<double, 3> threshold{5 * 36, 5000 * 9, 10000 * 4};
  for (const int dimension : {1, 2, 3}) {
    const double at = threshold[static_cast<std::size_t>(dimension - 1)];
    EXPECT_EQ(method(2.99, dimension), ViscousMethod::explicit_steps);
    EXPECT_EQ(method(5.01, dimension), ViscousMethod::rkl2);
    EXPECT_EQ(method(0.99 * at, dimension), ViscousMethod::rkl2);
    EXPECT_EQ(method(1.01 * at, dimension), ViscousMethod::implicit);
  }
}

TEST(ChooseViscousMethod, CountsStepsThatAreStable) {
  EXPECT_EQ(choose_viscous_method(1, 1, 1).count, 1);
  EXPECT_EQ(choose_viscous_method(1.01, 1, 1).count, 2);
  EXPECT_EQ(choose_viscous_method(2.5, 1, 1).count, 3);
  EXPECT_EQ(choose_viscous_method(50, 1, 2).count, 15);  // (225 + 15 - 2)/4 = 59.5; 13 give 45
  EXPECT_EQ(choose_viscous_method(1, std::numeric_limits<double>::infinity(), 3).count, 1);
}

TEST(ChooseViscousMethod, SaysWhy) {
  EXPECT_EQ(
      choose_viscous_method(1e-3, 2e-3, 2).reason,
      "viscosity is explicit, 1 step: the step of 0.001 s is 0.5 times the viscous limit of 0.002 s, not "
      "above 3");
  EXPECT_EQ(
      choose_viscous_method(1e-3, 2e-5, 2).reason,
      "viscosity takes a super-time-step of 15 stages: the step of 0.001 s is 50 times the viscous limit "
      "of 2e-05 s, not above 5e+03 in 2D");
  EXPECT_EQ(choose_viscous_method(1e-3, 2e-6, 1).reason,
            "viscosity is implicit: the step of 0.001 s is 500 times the viscous limit of 2e-06 s, above 5 "
            "in 1D");
}

TEST(ChooseViscousMethod, RefusesWhatIsOutOfRange) {
  const auto refusal = [](double step, double explicit_step, int dimension) {
    return test::message_of<InputError>(
        [&] { static_cast<void>(choose_viscous_method(step, explicit_step, dimension)); });
  };
  EXPECT_EQ(refusal(std::nan(""), 1, 1),
            "choose_viscous_method: the step is nan s: must be zero or positive, and finite");
  EXPECT_EQ(refusal(1, 0, 1), "choose_viscous_method: the explicit step is 0 s: must be positive");
  EXPECT_EQ(refusal(1, 1, 4), "choose_viscous_method: 4 dimensions: must be 1, 2 or 3");
}

}  // namespace
}  // namespace scree::rheology
