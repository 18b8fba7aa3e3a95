// What the stress costs in a step of material points: all blocks of a sheared layer, as `mpm::step` visits
// them, by the kernel of each instruction set and point by point. Rate in point updates.

#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/seed.hpp>
#include <scree/mpm/stress_update.hpp>
#include <scree/rheology/laws.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

namespace {

using namespace scree;

/// A law without its kernels.
template <class Law>
struct PointByPoint : Law {
  [[nodiscard]] friend BlockKernel<PointByPoint> block_kernel(const PointByPoint& /*law*/,
                                                              InstructionSet /*set*/) noexcept {
    return nullptr;
  }
};

template <int D, class Law>
void stress_of_points(benchmark::State& state, const Law& law, InstructionSet set) {
  constexpr double spacing = 0.01;  // [m]
  constexpr Index num_cells = D == 2 ? 80 : 20;
  Vector<D> end = Vector<D>::Constant(spacing * num_cells);
  Indices<D> cells;
  cells.fill(num_cells);
  std::array<bool, D> is_periodic;
  is_periodic.fill(true);
  const CartesianGrid<D> grid{Vector<D>::Zero(), Vector<D>::Constant(spacing), cells, is_periodic};
  Indices<D> per_cell;
  per_cell.fill(2);
  auto particles = mpm::seed_box<D, D>(grid, Vector<D>::Zero(), end, per_cell, law.density);
  for (const InputColumn& input : Law::inputs) {
    const std::size_t column =
        particles.add_column({std::string{input.name}, "", std::string{input.unit}}, 1);
    for (double& value : particles.column(column).values()) value = input.typical;
  }
  const mpm::StressUpdateBy<D, D, Law> stress{law, particles, set};
  const auto blocks = mpm::cell_sort(particles, grid, 0.5, {1});
  for (Index p = 0; p < particles.size(); ++p) {
    particles.density.component(0)[p] = law.density * (1 + 1e-3 * static_cast<double>(p % 7));
    for (int c = 0; c < D * D; ++c) {
      particles.velocity_gradient.component(c)[p] = std::sin(0.7 * static_cast<double>(p + 3 * c));
    }
  }

  for (auto _ : state) {
    blocks.for_each_coloured({1}, [&](Index b) {
      benchmark::DoNotOptimize(stress.apply(particles, blocks.blocks[static_cast<std::size_t>(b)], 1e-5));
    });
  }

  const auto num_updates = state.iterations() * particles.size();
  state.SetItemsProcessed(num_updates);
  state.counters["ns_per_point"] = benchmark::Counter(
      1e-9 * static_cast<double>(num_updates), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <int D, class Law>
void register_law() {
  const std::string name = std::string{Law::name} + '/' + std::to_string(D) + "D/";
  const Law law = rheology::typical<Law>();
  benchmark::RegisterBenchmark((name + "points").c_str(), [law](benchmark::State& state) {
    stress_of_points<D>(state, PointByPoint<Law>{law}, InstructionSet::baseline);
  });
  for (const InstructionSet set : instruction_sets()) {
    benchmark::RegisterBenchmark(
        (name + std::string{name_of(set)}).c_str(),
        [law, set](benchmark::State& state) { stress_of_points<D>(state, law, set); });
  }
}

template <int D>
void register_laws() {
  register_law<D, rheology::Newtonian>();
  register_law<D, rheology::MuOfI>();
  register_law<D, rheology::GranularElastoviscoplastic>();
  register_law<D, rheology::DruckerPrager>();
  register_law<D, rheology::MohrCoulomb>();
  register_law<D, rheology::ModifiedCamClay>();
}

}  // namespace

int main(int argc, char** argv) {
  register_laws<2>();
  register_laws<3>();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
