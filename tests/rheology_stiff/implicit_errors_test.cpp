#include "bodies.hpp"

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

const CartesianGrid<2> grid = test::cube<2>(2, false);
const std::vector<double> mass(9, 1.0);
const std::vector<double> viscosity(4, 1.0);

std::string refusal(const ImplicitViscosityOptions& options) {
  return test::message_of<InputError>([&] { ImplicitViscosity<2>{grid, options}; });
}

TEST(ImplicitViscosity, RefusesOptionsOutOfRange) {
  EXPECT_EQ(refusal({.tolerance = 0}), "ImplicitViscosity: tolerance = 0: must lie in (0, 1)");
  EXPECT_EQ(refusal({.tolerance = std::nan("")}), "ImplicitViscosity: tolerance = nan: must lie in (0, 1)");
  EXPECT_EQ(refusal({.largest_newton = 0}), "ImplicitViscosity: largest_newton = 0: must be 1 or more");
  EXPECT_EQ(refusal({.largest_linear = 0}), "ImplicitViscosity: largest_linear = 0: must be 1 or more");
  EXPECT_EQ(refusal({.preconditioner = ViscousPreconditioner::line}),
            "ImplicitViscosity: the line preconditioner is for one dimension that is not periodic");
}

struct Step {
  std::vector<double> velocity = std::vector<double>(18, 1.0);
  std::vector<double> node_mass = mass;
  std::vector<std::uint8_t> held = {};
  std::vector<double> filled = {};
  std::vector<double> mu = viscosity;
  double dt = 1;
};

std::string refusal(Step step) {
  return test::message_of<InputError>([&] {
    ImplicitViscosity<2>{grid}.advance(step.velocity, {step.node_mass, step.held, step.filled}, step.mu,
                                       step.dt);
  });
}

TEST(ImplicitViscosity, RefusesLengthsThatDoNotFit) {
  EXPECT_EQ(refusal({.velocity = std::vector<double>(9)}),
            "ImplicitViscosity: 9 values of velocity: must be 18");
  EXPECT_EQ(refusal({.node_mass = {1}}), "ImplicitViscosity: 1 values of mass: must be 9");
  EXPECT_EQ(refusal({.held = {1}}), "ImplicitViscosity: 1 values of is_held: must be 18");
  EXPECT_EQ(refusal({.filled = {1}}), "ImplicitViscosity: 1 values of filled: must be 4");
  EXPECT_EQ(refusal({.mu = {1}}), "ImplicitViscosity: 1 values of viscosity: must be 4");
}

TEST(ImplicitViscosity, RefusesValuesOutOfRange) {
  Step step;
  step.velocity[5] = std::nan("");
  EXPECT_EQ(refusal(step),
            "ImplicitViscosity: component 1 of the velocity of node 2 is nan m/s: must be finite");
  step = {};
  step.node_mass[4] = -1;
  EXPECT_EQ(refusal(step),
            "ImplicitViscosity: the mass of node 4 is -1 kg: must be zero or positive, and finite");
  EXPECT_EQ(refusal({.filled = {0, 0, 1.5, 0}}),
            "ImplicitViscosity: the filled share of cell 2 is 1.5: must lie in [0, 1]");
  EXPECT_EQ(refusal({.mu = {0, std::nan(""), 0, 0}}),
            "ImplicitViscosity: the viscosity of cell 1 is nan Pa s: must be zero or positive, and finite");
  EXPECT_EQ(refusal({.dt = -1}), "ImplicitViscosity: the step is -1 s: must be zero or positive, and finite");
}

TEST(ImplicitViscosity, SaysWhereItDidNotConverge) {
  const auto fine = test::cube<2>(32, false);
  auto v = test::values_at_nodes<2>(fine, [](const Vector<2>& x) {
    return Vector<2>{x[1] < 0.5 ? 0 : 1, 0};
  });
  const auto before = v;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto message = test::message_of<RunError>([&] {
    ImplicitViscosity<2>{
        fine, {.preconditioner = ViscousPreconditioner::jacobi, .largest_newton = 2, .largest_linear = 5}}
        .advance(v, {test::full(fine, 1)}, std::vector<double>(1024, 1.0), 1);
  });
  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(message.substr(0, message.find("furthest")),
            "ImplicitViscosity: KINSol failed with KIN_MAXITER_REACHED: The maximum number of iterations was "
            "reached before convergence. (the step is 1 s, ");
  EXPECT_NE(message.find("furthest from balance is component "), std::string::npos);
  EXPECT_EQ(v, before);
}

TEST(ImplicitViscosity, SaysWhichCellHasNoViscosityThatCanBeSolvedWith) {
  // Where it fails: a stress that falls with the rate has no single flow, and its matrix is not positive.
  const auto message_of = [](ViscosityAt answer) {
    std::vector<double> v(18, 0.0);
    v[0] = 1;
    return test::message_of<RunError>([&] {
      ImplicitViscosity<2>{grid}.advance(
          v, {mass}, [=](double, Index cell) { return cell == 0 ? answer : ViscosityAt{1}; }, 1);
    });
  };
  // v_x = 1 at one corner: 2 D':D' is on the average (4/3 + 1)/3 of (1/dx)^2 = 4.
  const std::string place = "ImplicitViscosity: at 1.76383 1/s the law's viscosity of cell 0 is ";
  const std::string rule = "must be finite, and the stress must not fall with the rate";
  EXPECT_EQ(
      message_of({std::nan(""), 0}).substr(0, (place + "nan Pa s and its slope 0 Pa s^2: " + rule).size()),
      place + "nan Pa s and its slope 0 Pa s^2: " + rule);
  EXPECT_EQ(message_of({1, -1}).substr(0, (place + "1 Pa s and its slope -1 Pa s^2: " + rule).size()),
            place + "1 Pa s and its slope -1 Pa s^2: " + rule);
}

}  // namespace
}  // namespace scree::rheology
