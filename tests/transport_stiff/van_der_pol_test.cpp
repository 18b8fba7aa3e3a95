// Van der Pol's oscillator: u' = v is explicit, v' = ((1 - u^2) v - u)/epsilon is stiff and not linear.

#include "problems.hpp"

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

constexpr double epsilon = 1e-6;  // [s^2]
constexpr double duration = 0.5;  // [s], short of the jump at u = 1, t = 0.807

ImexProblem van_der_pol() {
  using Values = ImexProblem::Values;
  ImexProblem problem;
  problem.explicit_rate = [](double, Values u, std::span<double> rate) {
    rate[0] = u[1];
    rate[1] = 0;
    return test::no_bound;
  };
  problem.implicit_rate = [](double, Values u, std::span<double> rate) {
    rate[0] = 0;
    rate[1] = ((1 - u[0] * u[0]) * u[1] - u[0]) / epsilon;
  };
  return problem;
}

/// Where v settles, up to O(epsilon).
double slow(double u) {
  return u / (1 - u * u);
}

struct State {
  double u;
  double v;
};

/// At the end of n steps from u = 2.
State computed(ImexMethod method, int n) {
  ImexIntegrator integrator{2,
                            van_der_pol(),
                            {.method = method,
                             .steps = Steps::longest,
                             .relative_tolerance = 1e-11,
                             .absolute_tolerance = 1e-11,
                             .largest_step = duration / n,
                             .solver = Banded{1, 1}}};
  std::vector<double> u{2, slow(2)};
  integrator.advance(u, 0, duration);
  return {u[0], u[1]};
}

/// u at the end without epsilon: log u - u^2/2 = t + c.
double slow_motion() {
  double u = 2;
  const double target = std::log(2.0) - 2 + duration;
  for (int i = 0; i < 50; ++i) u -= (std::log(u) - u * u / 2 - target) / (1 / u - u);
  return u;
}

// Steps are ten thousands of epsilon: the stiff limit. Its error, O(epsilon), and that of the solves, (T54),
// are 1e-6.
TEST(VanDerPol, IsOfSecondOrderByArs2) {
  const double exact = slow_motion();
  const double coarse = std::abs(computed(ImexMethod::ars2, 10).u - exact);
  const double fine = std::abs(computed(ImexMethod::ars2, 20).u - exact);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.15);  // the next order, dt v'/v = 0.05
}

// Where it fails: v runs after a value that moves, at dv/dt, by dt (1 - 2 gamma)/(2 gamma) of that.
TEST(VanDerPol, HasAnErrorOfFirstOrderInItsFastPartBySsp2) {
  const double u = slow_motion();
  const double rate = slow(u) * (1 + u * u) / ((1 - u * u) * (1 - u * u));
  for (const int n : {40, 80}) {
    const double predicted = duration / n * rate * (1 - 2 * test::gamma_ssp2) / (2 * test::gamma_ssp2);
    EXPECT_NEAR(std::abs(computed(ImexMethod::ssp2, n).v - slow(u)), std::abs(predicted),
                0.1 * std::abs(predicted));
    EXPECT_LE(std::abs(computed(ImexMethod::ars2, n).v - slow(u)), 0.01 * std::abs(predicted))
        << n;  // the remedy
  }
}

// L-stable: of a distance from where v settles one step leaves R(z), z = 3 dt/epsilon = 15000.
TEST(VanDerPol, SettlesInOneStepHoweverFarItStarts) {
  constexpr double dt = 0.005;
  ImexIntegrator integrator{2,
                            van_der_pol(),
                            {.method = ImexMethod::ars2,
                             .steps = Steps::longest,
                             .relative_tolerance = 1e-11,
                             .absolute_tolerance = 1e-11,
                             .largest_step = dt,
                             .solver = Banded{1, 1}}};
  std::vector<double> u{2, 5};

  integrator.advance(u, 0, dt);

  const double z = 3 * dt / epsilon;
  const double gamma = test::gamma_ssp2;
  const double left = (1 - (1 - 2 * gamma) * z) / std::pow(1 + gamma * z, 2) * (5 - slow(2));
  EXPECT_NEAR(u[1] - slow(u[0]), left, 0.1 * std::abs(left));  // u, and z with it, change by 4 %
}

}  // namespace
}  // namespace scree::transport
