// Flows down the paper's incline, one column of nodes: exact solutions.

#include "bodies.hpp"

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

constexpr double density = 1000;                      // [kg/m^3]
const double drive = 9.81 * std::sin(test::pi / 10);  // along the slope of 18 degrees [m/s^2]

/// A layer 1 m deep on a rough base: y from the base, velocity along the slope.
struct Layer {
  explicit Layer(Index n)
      : grid{Vector<1>{0.0}, Vector<1>{1 / static_cast<double>(n)}, {n}, {false}},
        mass{test::full(grid, density)},
        held{test::held_floor<2>(grid)},
        velocity(2 * mass.size(), 0.0) {}

  void pull(double dt) {
    for (std::size_t i = 1; i < velocity.size(); i += 2) {
      if (held[i] == 0) velocity[i] += dt * drive;
    }
  }
  [[nodiscard]] double surface() const { return velocity.back(); }

  CartesianGrid<1> grid;
  std::vector<double> mass;
  std::vector<std::uint8_t> held;
  std::vector<double> velocity;
};

/// Velocity of the start-up from rest, by its Fourier series.
double exact_start_up(double mu, double y, double t) {
  double u = density * drive / mu * (y - y * y / 2);
  for (int m = 0; m < 200; ++m) {
    const double k = (m + 0.5) * test::pi;
    u -= 2 * density * drive / (mu * k * k * k) * std::sin(k * y) * std::exp(-mu * k * k * t / density);
  }
  return u;
}

/// Largest error of a start-up over all nodes at time t.
double start_up_error(double mu, Index n, double t, int num_steps) {
  Layer layer{n};
  ImplicitViscosity<1, 2> solver{layer.grid, {.tolerance = 1e-12}};
  const std::vector<double> viscosity(test::at(n), mu);
  const double dt = t / num_steps;
  for (int step = 0; step < num_steps; ++step) {
    layer.pull(dt);
    solver.advance(layer.velocity, {layer.mass, layer.held}, viscosity, dt);
  }
  double error = 0;
  for (Index i = 0; i <= n; ++i) {
    const double exact = exact_start_up(mu, static_cast<double>(i) / static_cast<double>(n), t);
    error = std::max(error, std::abs(layer.velocity[test::at(2 * i + 1)] - exact));
  }
  return error;
}

TEST(ImplicitViscosity, StartsUpThePapersInclineWithFirstOrderInTime) {
  constexpr double mu = 1e4;
  const double t = 0.4 * density / mu;  // [s], about the time of the slowest mode
  const double coarse = start_up_error(mu, 200, t, 50);
  const double fine = start_up_error(mu, 200, t, 100);
  // Backward Euler's amplitudes are off by z^2/2 per step, z = rate dt: relative by rate^2 t dt/2. What
  // is off by more than first order is some 2 z: 2 * 2.47 * 0.4/50 = 0.04; cells add (h k)^2/24 = 3e-6.
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.04 / std::log(2));
  const double rate = mu / density * test::pi * test::pi / 4;
  const double amplitude = 2 * density * drive / (mu * std::pow(test::pi / 2, 3));
  EXPECT_NEAR(fine, amplitude * std::exp(-rate * t) * rate * rate * t * t / 100 / 2, 0.05 * fine);
}

TEST(ImplicitViscosity, IsOfSecondOrderInTwoSolvesAStep) {  // Eq. (R146)
  const double gamma = 1 - 1 / std::numbers::sqrt2;
  constexpr double mu = 1e4;
  const double t = 0.4 * density / mu;
  const auto run = [&](int num_steps) {
    Layer layer{20};
    ImplicitViscosity<1, 2> solver{layer.grid, {.tolerance = 1e-12}};
    const double dt = t / num_steps;
    for (int step = 0; step < num_steps; ++step) {
      const auto before = layer.velocity;
      for (int solve = 0; solve < 2; ++solve) {
        if (solve == 1) {
          for (std::size_t i = 0; i < before.size(); ++i) {
            layer.velocity[i] = before[i] + (1 / gamma - 1) * (layer.velocity[i] - before[i]);
          }
        }
        layer.pull(gamma * dt);
        solver.advance(layer.velocity, {layer.mass, layer.held}, std::vector<double>(20, mu), gamma * dt);
      }
    }
    return layer.surface();
  };
  // Each halving takes 3/4 of what is left, were nothing of third order: rate dt = 0.05 of it.
  const double ratio = (run(20) - run(40)) / (run(40) - run(80));
  EXPECT_NEAR(std::log2(ratio), 2, 0.1);
}

TEST(ImplicitViscosity, ConvergesWithSecondOrderInSpace) {
  constexpr double mu = 1e4;
  const double t = 0.4 * density / mu;
  // The error of time, taken away: it is the same to first order.
  const auto error = [&](Index n) { return start_up_error(mu, n, t, 100) - start_up_error(mu, 160, t, 100); };
  EXPECT_NEAR(std::log2(std::abs(error(8) / error(16))), 2, 0.1);
}

TEST(ImplicitViscosity, DecaysEachModeOfTheMeshByItsRate) {
  constexpr Index n = 20;
  constexpr double mu = 750;
  const double h = 1.0 / n;
  for (const double dt : {1e-3, 1.0, 1e3}) {
    for (const int m : {0, 7, 19}) {
      Layer layer{n};
      const double k = (m + 0.5) * test::pi;
      for (Index i = 0; i <= n; ++i) {
        layer.velocity[test::at(2 * i + 1)] = std::sin(k * h * static_cast<double>(i));
      }
      const auto before = layer.velocity;
      ImplicitViscosity<1, 2>{layer.grid, {.tolerance = 1e-12}}.advance(
          layer.velocity, {layer.mass, layer.held}, std::vector<double>(n, mu), dt);
      const double z = dt * mu / density * 4 / (h * h) * std::pow(std::sin(k * h / 2), 2);
      // Round-off of the residual, 16 * 2e-16 z at least, over 1 + z.
      for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(layer.velocity[i], before[i] / (1 + z), 1e-11);
      }
    }
  }
}

/// Surface velocity after `num_steps` long steps.
double steady_surface(Index n, const std::vector<double>& viscosity) {
  Layer layer{n};
  ImplicitViscosity<1, 2> solver{layer.grid, {.tolerance = 1e-12}};
  for (int step = 0; step < 12; ++step) {
    layer.pull(10);
    solver.advance(layer.velocity, {layer.mass, layer.held}, viscosity, 10);
  }
  return layer.surface();
}

TEST(ImplicitViscosity, HasTheExactSteadyFlowsOfOneAndTwoLayers) {
  // A cell's stress is exact at its middle, and so is the velocity's jump over it. What is left of the start
  // after 12 steps is below (1 + 1.2 * 10)^-12, 4e-14; the tolerance is 1e-12 of 30 m/s.
  std::vector<double> viscosity(20, 750);
  EXPECT_NEAR(steady_surface(20, viscosity), 2.020971143, 1e-9);
  for (std::size_t cell = 0; cell < 20; ++cell) viscosity[cell] = cell < 10 ? 500 : 1000;
  EXPECT_NEAR(steady_surface(20, viscosity), 2.652524625, 1e-9);
}

/// The shortest wave's amplification by a step of z = rate dt.
double amplification(double z, bool is_crank_nicolson) {
  const auto grid = test::cube<1>(8, true);
  const auto mass = test::full(grid, 1);
  const double rate = 4.0 * 8 * 8;  // of shear, 4 mu/(rho dx^2)
  std::vector<double> v;
  for (int i = 0; i < 8; ++i) v.insert(v.end(), {0.0, i % 2 == 0 ? 1.0 : -1.0});
  double dt = z / rate;
  if (is_crank_nicolson) {  // half a step explicit, half implicit
    dt /= 2;
    const ViscousOperator<1, 2> viscous{grid};
    std::vector<double> force(v.size());
    viscous.apply({}, std::vector<double>(8, 1.0 / 8), v, force);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] -= dt * force[i] / mass[i / 2];
  }
  const auto largest = test::largest(v);
  ImplicitViscosity<1, 2>{grid, {.tolerance = 1e-12}}.advance(v, {mass}, std::vector<double>(8, 1.0), dt);
  EXPECT_LE(test::largest(v), largest);
  return v[1];
}

TEST(ImplicitViscosity, DampsWhereCrankNicolsonRings) {  // Eq. (R133)
  for (const double z : {1.0, 10.0, 1e3, 1e5}) {
    EXPECT_NEAR(amplification(z, false), 1 / (1 + z), 1e-10);
    EXPECT_NEAR(amplification(z, true), (1 - z / 2) / (1 + z / 2), 1e-6);  // to -1
  }
  EXPECT_LT(amplification(1e5, true), -0.9999);
}

}  // namespace
}  // namespace scree::rheology
