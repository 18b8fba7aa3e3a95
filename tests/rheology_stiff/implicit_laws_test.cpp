// Viscosities that depend on the flow: Newton's method against exact solutions.

#include "bodies.hpp"

#include <scree/rheology/yield_stress.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

/// A Bingham fluid as Papanastasiou regularises it.  Eqs. (R8), (R9)
struct Bingham {
  double viscosity;
  double yield_stress;
  double m;

  ViscosityAt operator()(double rate, Index /*cell*/) const {
    const double mu_y = papanastasiou_viscosity(rate, yield_stress, m);
    const double slope = rate > 0 ? (yield_stress * m * std::exp(-m * rate) - mu_y) / rate : 0;
    return {viscosity + mu_y, slope};
  }
};

/// A steady layer of height H under gravity g along the slope.
template <class Law>
std::vector<double> steady_layer(Index n, double height, double density, double gravity, const Law& law,
                                 double dt, int num_steps) {
  const CartesianGrid<1> grid{Vector<1>{0.0}, Vector<1>{height / static_cast<double>(n)}, {n}, {false}};
  const auto mass = test::full(grid, density);
  const auto held = test::held_floor<2>(grid);
  std::vector<double> v(2 * mass.size(), 0.0);
  ImplicitViscosity<1, 2> solver{grid, {.tolerance = 1e-11}};
  for (int step = 0; step < num_steps; ++step) {
    for (std::size_t i = 3; i < v.size(); i += 2) v[i] += dt * gravity;
    solver.advance(v, {mass, held}, ViscosityLaw{law}, dt);
  }
  return v;
}

TEST(ImplicitViscosity, MakesBinghamsPlugOnTheIncline) {
  constexpr Index n = 100;
  constexpr double m = 1e3;                                     // [s]
  const double weight = 1000 * 9.81 * std::sin(test::pi / 10);  // [Pa/m]
  const double yield_surface = 0.6701255884;                    // [m]
  const double plug = 0.9075540843;                             // [m/s]

  const auto v = steady_layer(n, 1, 1000, weight / 1000, Bingham{750, 1000, m}, 1, 40);

  // Regularised, the plug creeps: its surface gains (H - y_y)/m, what is missing from the yield stress below
  // adds as much at most. And of the cell that the yield surface cuts h^2 G/(8 K).
  const double creep = 2 * (1 - yield_surface) / m;
  const double cut = weight / 750 / (8.0 * n * n);
  EXPECT_NEAR(v.back(), plug, creep + cut);
  for (Index i = 0; i <= n; ++i) {
    const double y = static_cast<double>(i) / n;
    const double exact =
        y < yield_surface ? plug - weight / (2 * 750) * std::pow(yield_surface - y, 2) : plug;
    EXPECT_NEAR(v[test::at(2 * i + 1)], exact, creep + cut) << y;
  }
}

TEST(ImplicitViscosity, MakesBagnoldsProfile) {
  constexpr Index n = 50;
  constexpr double height = 0.1;
  constexpr double grain_density = 2500;
  constexpr double density = 0.6 * grain_density;
  constexpr double d = 1.65e-3;
  const double angle = 24 * test::pi / 180;
  const double mu_s = std::tan(20.9 * test::pi / 180);
  const double mu_2 = std::tan(32.76 * test::pi / 180);
  constexpr double I_0 = 0.279;
  const double h = height / n;
  const auto law = [&](double rate, Index cell) -> ViscosityAt {
    const double p = density * 9.81 * std::cos(angle) * (height - (static_cast<double>(cell) + 0.5) * h);
    constexpr double floor = 1e-3;  // [1/s] of the rate
    const double r = std::hypot(rate, floor);
    const double I = r * d * std::sqrt(grain_density / p);
    const double mu = mu_s + (mu_2 - mu_s) * I / (I_0 + I);
    const double slope = (mu_2 - mu_s) * I_0 / ((I_0 + I) * (I_0 + I)) * I / r;  // d mu/dr
    return {mu * p / r, (slope - mu / r) * p / r * rate / r};
  };

  const auto v = steady_layer(n, height, density, 9.81 * std::sin(angle), law, 10, 40);

  // The stress of each cell is exact at its middle, so is its rate, off by the floor's (1e-3/rate)^2/2 over
  // the slope of the law (mu_2 > mu_s: some 4), and the surface is their sum by the midpoint rule.
  const double factor = 0.089180236 / d * std::sqrt(0.6 * 9.81 * std::cos(angle));
  double sum = 0;
  for (Index cell = 0; cell < n; ++cell) {
    sum += h * factor * std::sqrt(height - (static_cast<double>(cell) + 0.5) * h);
  }
  EXPECT_NEAR(v.back(), sum, 1e-5 * sum);
  // The midpoint rule for a square root that ends at 0 is off by Hurwitz's zeta(-1/2, 1/2) = 0.0609 of h^1.5.
  EXPECT_NEAR(v.back(), 2.642217862, 0.061 * factor * std::pow(h, 1.5) + 1e-5 * sum);
}

TEST(ImplicitViscosity, BalancesANonlinearFlowInTwoDimensions) {
  const auto grid = test::cube<2>(12, false);
  const auto mass = test::full(grid, 1000);
  const auto held = test::held_floor<2>(grid);
  const Bingham law{10, 100, 10};
  auto v = test::random_values(2 * mass.size(), -1, 1);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = held[i] != 0 ? 0 : v[i];
  const auto before = v;
  constexpr double dt = 0.5;
  ImplicitViscosity<2> solver{grid};
  const auto report = solver.advance(v, {mass, held}, ViscosityLaw{law}, dt);
  EXPECT_LE(report.newton_iterations, 20);

  const ViscousOperator<2> viscous{grid};
  std::vector<double> weights(test::at(viscous.num_cells()));
  std::vector<double> force(v.size());
  viscous.products(v, v, weights);
  for (double& weight : weights) weight = dt / 144 * law(std::sqrt(weight), 0).viscosity;
  viscous.apply({}, weights, v, force);
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (held[i] != 0) continue;
    EXPECT_NEAR(mass[i / 2] * (v[i] - before[i]) + force[i], 0, 1e-8 * 1000 / 144);  // tolerance, heaviest
  }
}

TEST(ImplicitViscosity, TakesLessThanAStepOfNewtonsMethodPerDecadeOfTheYieldStress) {
  // From full flow to nearly none: the line search and the exact Jacobian hold in both.
  const auto grid = test::cube<2>(16, false);
  const auto mass = test::full(grid, 1000);
  const auto held = test::held_floor<2>(grid);
  for (const double yield_stress : {1.0, 1e2, 1e4}) {
    auto v = test::values_at_nodes<2>(grid, [](const Vector<2>& x) { return Vector<2>{x[1] * x[1], 0.0}; });
    const double before = test::largest(v);
    const auto report = ImplicitViscosity<2>{grid}.advance(v, {mass, held},
                                                           ViscosityLaw{Bingham{10, yield_stress, 100}}, 0.1);
    EXPECT_LE(report.newton_iterations, 60) << yield_stress;
    EXPECT_LE(test::largest(v), before);
  }
}

}  // namespace
}  // namespace scree::rheology
