#include "../mpm/bodies.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace scree;
using namespace scree::mpm;

/// Whole steps of about 1e5 points, 2^D in each cell of a periodic mesh, that drift through the cells as they
/// swirl: stress, both transfers, nodes, and now and then a sort. Rate in point updates.
template <int D, class ShapeType, class Rule>
void step_of_points(benchmark::State& state) {
  constexpr double spacing = 0.01;  // [m]
  constexpr Index num_cells = D == 2 ? 160 : 24;
  const Threads threads{static_cast<int>(state.range(0))};
  const auto grid = cube<D>(num_cells, spacing, true);
  auto particles = filled<D>(grid, 2);
  const double wave_number = 2 * 3.141592653589793 / grid.length(0);
  for (Index p = 0; p < particles.size(); ++p) {
    for (int i = 0; i < D; ++i) {
      const double across = particles.position.component((i + 1) % D)[p];
      particles.velocity.component(i)[p] = 0.5 + 0.1 * std::sin(wave_number * across);
    }
  }
  const Fluid fluid{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0.1};
  const auto stages = stages_of<D, D>(particles, ShapeType{}, Rule{}, fluid);
  auto body = start(std::move(particles), grid, stages, threads);
  const auto num_points = body.particles.size();

  for (auto _ : state) step(body, stages, stable_time_step(grid, body.rates, {}).dt, threads);

  state.SetItemsProcessed(state.iterations() * num_points);
}

#define SCREE_STEP(D, SHAPE, RULE)                   \
  BENCHMARK_TEMPLATE(step_of_points, D, SHAPE, RULE) \
      ->Arg(1)                                       \
      ->Arg(2)                                       \
      ->UseRealTime()                                \
      ->Unit(benchmark::kMillisecond)
SCREE_STEP(2, Linear, Apic);
SCREE_STEP(2, Linear, PicFlip);
SCREE_STEP(2, Quadratic, Apic);
SCREE_STEP(2, Quadratic, PicFlip);
SCREE_STEP(3, Linear, Apic);
SCREE_STEP(3, Linear, PicFlip);
SCREE_STEP(3, Quadratic, Apic);
SCREE_STEP(3, Quadratic, PicFlip);

}  // namespace
