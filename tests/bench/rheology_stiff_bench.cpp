// Viscosity on a grid: what a step costs by each method, in steps of explicit Euler, and what the start-up of
// the paper's incline costs at equal error.

#include <scree/rheology_stiff/implicit_viscosity.hpp>
#include <scree/rheology_stiff/rkl2.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace scree::rheology {
namespace {

using Values = std::span<const double>;

/// A body of one material on its floor.
template <int D, int V>
struct Body {
  Body(Index n, double density, double viscosity_)
      : grid{make_grid(n)},
        viscous{grid},
        viscosity(static_cast<std::size_t>(viscous.num_cells()), viscosity_),
        weights(viscosity.size(), viscosity_ * grid.spacing().prod()),
        start(viscous.num_values(), 0.0),
        is_held(viscous.num_values(), 0) {
    const Lattice<D> nodes = grid.nodes();
    for (Index node = 0; node < nodes.num_sites(); ++node) {
      const Indices<D> site = nodes.site(node);
      mass.push_back(density * nodes.volume(site));
      for (Index k = 0; k < V; ++k) {
        const auto i = static_cast<std::size_t>(node * V + k);
        is_held[i] = site[D - 1] == 0 ? 1 : 0;
        if (is_held[i] == 0) start[i] = (k == 0 ? 1 : 0) + 0.1 * std::sin(7 * nodes.position(site).sum());
      }
    }
  }

  static CartesianGrid<D> make_grid(Index n) {
    Indices<D> num_cells;
    num_cells.fill(n);
    return {Vector<D>::Zero(), Vector<D>::Constant(1 / static_cast<double>(n)), num_cells, {}};
  }

  /// dv/dt by viscosity, and by `drive` along component `along` [m/s^2].
  void rate(Values v, std::span<double> out, double drive = 0, int along = 0) const {
    viscous.apply({}, weights, v, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double force = static_cast<int>(i % V) == along ? drive : 0;
      out[i] = is_held[i] != 0 ? 0 : force - out[i] / mass[i / V];
    }
  }

  CartesianGrid<D> grid;
  ViscousOperator<D, V> viscous;
  std::vector<double> viscosity;
  std::vector<double> weights;
  std::vector<double> start;
  std::vector<std::uint8_t> is_held;
  std::vector<double> mass;
};

template <int D, int V>
void explicit_step(benchmark::State& state) {
  const Body<D, V> body{state.range(0), 1, 1};
  auto v = body.start;
  std::vector<double> rate(v.size());
  const double dt = 1 / body.viscous.largest_rate(body.mass, body.weights);
  for ([[maybe_unused]] const auto _ : state) {
    body.rate(v, rate);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += dt * rate[i];
    benchmark::DoNotOptimize(v.data());
  }
}

/// @param range(1) step over the longest stable explicit one
template <int D, int V>
void rkl2_step(benchmark::State& state) {
  const Body<D, V> body{state.range(0), 1, 1};
  const double limit = 2 / body.viscous.largest_rate(body.mass, body.weights);
  const double dt = static_cast<double>(state.range(1)) * limit;
  const int stages = rkl2_stages(dt, limit);
  Rkl2 method{body.start.size()};
  auto v = body.start;
  for ([[maybe_unused]] const auto _ : state) {
    v = body.start;
    method.advance(v, dt, stages, [&](Values u, std::span<double> out) { body.rate(u, out); });
  }
  state.counters["stages"] = stages;
}

template <int D, int V>
void implicit_step(benchmark::State& state) {
  const Body<D, V> body{state.range(0), 1, 1};
  const double dt =
      static_cast<double>(state.range(1)) * 2 / body.viscous.largest_rate(body.mass, body.weights);
  ImplicitViscosity<D, V> solver{body.grid, {.tolerance = 1e-6}};
  ImplicitViscosityReport report;
  auto v = body.start;
  for ([[maybe_unused]] const auto _ : state) {
    v = body.start;
    report = solver.advance(v, {body.mass, body.is_held}, body.viscosity, dt);
  }
  state.counters["iterations"] = static_cast<double>(report.linear_iterations);
  state.counters["products"] = report.products;
}

#define SCREE_STEPS(D, V, ...)                                                               \
  BENCHMARK(explicit_step<D, V>)->ArgsProduct({{__VA_ARGS__}});                              \
  BENCHMARK(rkl2_step<D, V>)->ArgsProduct({{__VA_ARGS__}, {2, 4, 16, 64, 256, 1024, 4096}}); \
  BENCHMARK(implicit_step<D, V>)->ArgsProduct({{__VA_ARGS__}, {4, 16, 64, 256, 1024, 4096}})
SCREE_STEPS(1, 2, 50, 200);
SCREE_STEPS(2, 2, 64, 256);
SCREE_STEPS(3, 3, 16, 32);
#undef SCREE_STEPS

// The start-up of the paper's incline at 1e4 Pa s, from rest to 1 s: ten times its slowest motion.

constexpr double density = 1000;                              // [kg/m^3]
constexpr double mu = 1e4;                                    // [Pa s]
constexpr double duration = 1;                                // [s]
const double drive = 9.81 * std::sin(std::numbers::pi / 10);  // [m/s^2]

double exact(double y, double t) {
  double u = density * drive / mu * (y - y * y / 2);
  for (int m = 0; m < 60; ++m) {
    const double k = (m + 0.5) * std::numbers::pi;
    u -= 2 * density * drive / (mu * k * k * k) * std::sin(k * y) * std::exp(-mu * k * k * t / density);
  }
  return u;
}

double error_at(const std::vector<double>& v, double t) {
  const std::size_t n = v.size() / 2 - 1;
  double error = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    error =
        std::max(error, std::abs(v[2 * i + 1] - exact(static_cast<double>(i) / static_cast<double>(n), t)));
  }
  return error / (density * drive / (2 * mu));
}

/// Runs step(v, dt) from rest, timed; then again, for the largest error at any of 500 times.
template <class Step>
void start_up(benchmark::State& state, std::size_t num_values, long steps, Step&& step) {
  const double dt = duration / static_cast<double>(steps);
  std::vector<double> v(num_values);
  for ([[maybe_unused]] const auto _ : state) {
    std::ranges::fill(v, 0.0);
    for (long n = 0; n < steps; ++n) step(v, dt);
  }
  std::ranges::fill(v, 0.0);
  double error = 0;
  for (long n = 1; n <= steps; ++n) {
    step(v, dt);
    if (n % std::max(1L, steps / 500) == 0) error = std::max(error, error_at(v, static_cast<double>(n) * dt));
  }
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["error_percent"] = 100 * error;
}

void start_up_explicit(benchmark::State& state) {
  const Body<1, 2> body{state.range(0), density, mu};
  const double h = body.grid.spacing()[0];
  std::vector<double> rate(body.start.size());
  const long steps = std::lround(duration / (0.9 * density * h * h / (2 * mu)));
  start_up(state, rate.size(), steps, [&](std::vector<double>& v, double dt) {
    body.rate(v, rate, drive, 1);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += dt * rate[i];
  });
}

void start_up_rkl2(benchmark::State& state) {
  const Body<1, 2> body{state.range(0), density, mu};
  const double limit = 2 / body.viscous.largest_rate(body.mass, body.weights);
  Rkl2 method{body.start.size()};
  const Rkl2::Rate rate = [&](Values u, std::span<double> out) { body.rate(u, out, drive, 1); };
  start_up(state, body.start.size(), state.range(1),
           [&](std::vector<double>& v, double dt) { method.advance(v, dt, rkl2_stages(dt, limit), rate); });
}

/// Backward Euler; range(2) = 2: two of them make a step of second order.  Eq. (R146)
void start_up_implicit(benchmark::State& state) {
  const Body<1, 2> body{state.range(0), density, mu};
  ImplicitViscosity<1, 2> solver{body.grid};
  const auto solve = [&](std::vector<double>& v, double dt) {
    for (std::size_t i = 3; i < v.size(); i += 2) v[i] += dt * drive;
    solver.advance(v, {body.mass, body.is_held}, body.viscosity, dt);
  };
  const double gamma = 1 - std::numbers::sqrt2 / 2;
  std::vector<double> before;
  start_up(state, body.start.size(), state.range(1), [&](std::vector<double>& v, double dt) {
    if (state.range(2) == 1) return solve(v, dt);
    before = v;
    solve(v, gamma * dt);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = before[i] + (1 / gamma - 1) * (v[i] - before[i]);
    solve(v, gamma * dt);
  });
}

BENCHMARK(start_up_explicit)->ArgsProduct({{50, 100, 200}})->Unit(benchmark::kMillisecond);
BENCHMARK(start_up_rkl2)->ArgsProduct({{50, 100, 200}, {20, 50, 100, 200}})->Unit(benchmark::kMillisecond);
BENCHMARK(start_up_implicit)
    ->ArgsProduct({{50, 100, 200}, {20, 50, 100, 200, 500}, {1, 2}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scree::rheology
