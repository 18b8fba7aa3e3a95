#include "fluidity_fields.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace scree::rheology {
namespace {

constexpr NonlocalFluidity beads = typical<NonlocalFluidity>();
constexpr double size = 1e-3;     // [m]
constexpr double pressure = 500;  // [Pa]

/// Uniform grains after `end` seconds in `num_steps`, from a uniform fluidity.
[[nodiscard]] double uniform_after(double friction, double start, double end, int num_steps) {
  const auto cells = cells_of<1>({2}, 1e-3);
  const OwnedFields fields{2, friction, pressure, size};
  auto grid = grid_of<1>(beads, cells, {});
  std::vector<double> g(2, start);
  for (int n = 0; n < num_steps; ++n) grid.step(fields.view(), end / num_steps, g);
  return g[0];
}

/// t_0 dg/dt = (mu - mu_s) g - B g^2 is the logistic equation.
TEST(DynamicFluidity, GrowsAndFadesAsTheExactSolution) {  // Eqs. (R177), (R179)
  for (const double excess : {-0.05, 0.05}) {
    const double friction = beads.mu_s + excess;
    const double rate = excess / beads.response_time;
    const double end = 1 / std::abs(rate);
    const double limit = excess / beads.saturation(friction, pressure, size);
    const double start = std::abs(limit) / 3;
    const double exact = limit / (1 + (limit / start - 1) * std::exp(-rate * end));

    const double coarse = std::abs(uniform_after(friction, start, end, 200) - exact);
    const double fine = std::abs(uniform_after(friction, start, end, 400) - exact);

    // First order: the error is below dt rate of the fluidity, the rate of convergence off by as much.
    EXPECT_LT(fine, 1.0 / 400 * std::max(start, exact));
    EXPECT_NEAR(std::log2(coarse / fine), 1, 2.0 / 200);
  }
}

TEST(DynamicFluidity, ComesToTheFluidityOfMuOfI) {  // Eq. (R174)
  const double friction = beads.mu_s + 0.05;

  const double g = uniform_after(friction, 1e-6, 200 * beads.response_time / 0.05, 2000);

  const double expected = beads.local_fluidity(friction, pressure, size);
  EXPECT_NEAR(g, expected, 20 * round_off / 0.05 * expected);  // mu - mu_s is a difference
}

/// No fluidity is negative, to the last bit, from a millionth of the response time to a million of them.
TEST(DynamicFluidity, StaysPositiveForAnyStep) {
  const auto cells = cells_of<2>({12, 9}, 1e-3);
  std::mt19937 random{5};
  std::uniform_real_distribution<double> draw{0, 1};
  for (const double dt : {1e-6, 1e-2, 1.0, 1e2, 1e6}) {
    OwnedFields fields{cells.num_sites(), 0};
    std::vector<double> g(fields.friction.size());
    for (std::size_t c = 0; c < g.size(); ++c) {
      fields.friction[c] = draw(random);
      fields.grain_size[c] = 1e-4 + 1e-2 * draw(random);
      g[c] = draw(random) < 0.5 ? 0 : 100 * draw(random);
    }
    auto grid = grid_of<2>(beads, cells, {{{0.0, std::nullopt}, {std::nullopt, 3.0}}});
    for (int n = 0; n < 10; ++n) {
      grid.step(fields.view(), dt * beads.response_time, g);

      for (const double value : g) EXPECT_TRUE(value >= 0 && std::isfinite(value)) << dt << ' ' << value;
    }
  }
}

TEST(DynamicFluidity, NeverStartsFromNothing) {  // a quiescent bed stays so: the other solution of (R177)
  EXPECT_EQ(uniform_after(beads.mu_s + 0.1, 0, 1, 10), 0);
}

/// Largest fluidity of a layer on a rough bed under a free surface, of `share` of the thickness at which it
/// stops, from 1e-3 1/s all over.
[[nodiscard]] double layer_after(double share, double friction, double dt, int num_steps) {
  constexpr Index n = 100;
  const double height = share * beads.stopping_thickness(friction, size);
  auto grid = grid_of<1>(beads, cells_of<1>({n}, height / static_cast<double>(n)), {{{0.0, std::nullopt}}});
  const OwnedFields fields{n, friction, pressure, size};
  std::vector<double> g(static_cast<std::size_t>(n), 1e-3);
  for (int step = 0; step < num_steps; ++step) grid.step(fields.view(), dt, g);
  return largest(g);
}

/// Linear in g, the slowest shape sin(pi y/(2 H)) grows at ((mu - mu_s) - (pi A s_a/(2 H))^2)/t_0: thinner
/// than H_c = (pi/2) xi a layer stops though its friction is above mu_s. A per cent on either side of H_c
/// leaves two per cent of mu - mu_s. Implicit steps keep the threshold whatever their length.
TEST(DynamicFluidity, StopsALayerBelowItsThicknessAndNotAbove) {  // Eqs. (R180), (R181)
  const double excess = 0.04;
  const double friction = beads.mu_s + excess;
  for (const double steps_per_response : {0.1, 0.001}) {
    const double dt = beads.response_time / steps_per_response;
    // A step multiplies the shape by (1 + excess n)/(1 + 1.0203 excess n), n = dt/t_0: 30 powers of e.
    const int num_steps = static_cast<int>(30 / 0.02 * (steps_per_response / excess + 1));

    const double thin = layer_after(0.99, friction, dt, num_steps);
    const double thick = layer_after(1.01, friction, dt, num_steps);

    EXPECT_LT(thin, 4 / std::numbers::pi * 1e-3 * std::exp(-30)) << dt;
    // Saturated: excess_left <sin^2> = B g <sin^3>, up to the next power of the share left, and (pi/200)^2/12
    // of mu - mu_s from the mesh.
    const double left = 1 - 1 / (1.01 * 1.01);
    const double expected =
        left * beads.local_fluidity(friction, pressure, size) * (std::numbers::pi / 4) / (2.0 / 3);
    EXPECT_NEAR(thick, expected, (2 * left + 2.1e-5 / left) * expected) << dt;
  }
}

/// The steady form has no such threshold: its source is there at once, however thin the layer.
TEST(DynamicFluidity, DiffersFromTheSteadyFormInThinLayers) {
  constexpr Index n = 100;
  const double friction = beads.mu_s + 0.04;
  const double height = 0.5 * beads.stopping_thickness(friction, size);

  const auto g = steady<1>(beads, cells_of<1>({n}, height / n), {{{0.0, std::nullopt}}},
                           OwnedFields{n, friction, pressure, size});

  // g_loc (1 - 1/cosh(H/xi)) at the surface, H/xi = pi/4; second order in h: (h/xi)^2/12.
  const double expected = 1 - 1 / std::cosh(std::numbers::pi / 4);
  EXPECT_NEAR(g.back() / beads.local_fluidity(friction, pressure, size), expected, 1e-4);
}

/// Factor by which steps change a zigzag of small fluidity about nothing in a periodic box, per step.
/// Explicit steps multiply it by 1 - dt (4 (A s/h)^2 + mu_s - mu)/t_0.
TEST(DynamicFluidity, BlowsUpByExplicitStepsAboveThePredictedLimit) {  // Eq. (R182)
  constexpr std::size_t n = 16;
  const double h = 0.5e-3;
  const double friction = beads.mu_s - 0.05;
  const double spread = beads.amplitude * size / h * (beads.amplitude * size / h);
  const double limit = 2 * beads.response_time / (4 * spread + 0.05);
  const auto growth = [&](double dt) {
    std::vector<double> g(n);
    for (std::size_t i = 0; i < n; ++i) g[i] = i % 2 == 0 ? 1e-9 : -1e-9;
    std::vector<double> next(n);
    for (int step = 0; step < 100; ++step) {
      for (std::size_t i = 0; i < n; ++i) {
        const double laplacian = g[(i + 1) % n] - 2 * g[i] + g[(i + n - 1) % n];
        const double rest =
            (friction - beads.mu_s) * g[i] - beads.saturation(friction, pressure, size) * g[i] * g[i];
        next[i] = g[i] + dt / beads.response_time * (spread * laplacian + rest);
      }
      g.swap(next);
    }
    return std::abs(g[0]) / 1e-9;
  };

  EXPECT_NEAR(growth(0.99 * limit), std::pow(0.98, 100), 1e-6);  // the square of g is 1e-9 of g
  EXPECT_NEAR(growth(1.01 * limit), std::pow(1.02, 100), 1e-5);

  // The remedy: implicit steps a thousand times as long only fade.
  const auto cells = cells_of<1>({static_cast<Index>(n)}, h, true);
  const OwnedFields fields{static_cast<Index>(n), friction, pressure, size};
  auto grid = grid_of<1>(beads, cells, {});
  std::vector<double> g(n);
  for (std::size_t i = 0; i < n; ++i) g[i] = i % 2 == 0 ? 1e-9 : 0;
  for (int step = 0; step < 10; ++step) {
    const double before = largest(g);
    grid.step(fields.view(), 1000 * limit, g);
    EXPECT_LT(largest(g), before);
  }
}

TEST(DynamicFluidity, NamesWhatCannotBeStepped) {
  const auto cells = cells_of<1>({2}, 1e-3);
  const OwnedFields fields{2, 0.3};
  auto grid = grid_of<1>(beads, cells, {});
  const auto refusal = [&](double dt, double fluidity) -> std::string {
    std::vector<double> g(2, fluidity);
    try {
      grid.step(fields.view(), dt, g);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };

  EXPECT_EQ(refusal(1e-3, 1), "");
  EXPECT_EQ(refusal(std::numeric_limits<double>::quiet_NaN(), 1),
            "FluidityGrid: a step must be finite and above 0 s");
  EXPECT_EQ(refusal(0, 1), "FluidityGrid: a step must be finite and above 0 s");
  EXPECT_EQ(refusal(1e-3, -1), "FluidityGrid: fluidity of cell 0 is -1, must be finite and at least 0 1/s");
}

}  // namespace
}  // namespace scree::rheology
