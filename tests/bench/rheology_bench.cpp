// Every law over columns of points that stay in cache: one point at a time, and in packs of several widths.
// The rate is in point updates: its inverse is the time per point.

#include "../rheology/points.hpp"
#include "packs.hpp"

#include <scree/rheology/batch.hpp>
#include <scree/rheology/laws.hpp>

#include <benchmark/benchmark.h>

#include <array>
#include <span>
#include <string>
#include <type_traits>
#include <variant>

namespace {

using namespace scree;
using namespace scree::rheology;

/// Sheared, pressed points in 3D, a column per number.
template <class Law>
struct Points {
  static constexpr std::size_t size = 136;  // in the first cache, and no power of two: columns would collide
  static constexpr std::size_t num_columns = 9 + 1 + Law::inputs.size() + Law::states.size() + 6;
  alignas(64) std::array<double, num_columns * size> numbers{};

  explicit Points(const Law& law) {
    const auto gradients = velocity_gradients();
    for (std::size_t p = 0; p < size; ++p) {
      for (std::size_t i = 0; i < 9; ++i) column(i)[p] = gradients[p % gradients.size()].components[i];
      column(9)[p] = law.density * (1 + 1e-3 * static_cast<double>(p % 7));
      for (std::size_t i = 0; i < Law::inputs.size(); ++i) column(10 + i)[p] = Law::inputs[i].typical;
      for (std::size_t i = 0; i < Law::states.size(); ++i) state(i)[p] = Law::states[i].initial;
    }
  }

  [[nodiscard]] std::span<double> column(std::size_t i) { return {numbers.data() + i * size, size}; }
  [[nodiscard]] std::span<double> state(std::size_t i) { return column(10 + Law::inputs.size() + i); }

  [[nodiscard]] LawColumns<Law> columns() {
    LawColumns<Law> result;
    for (std::size_t i = 0; i < 9; ++i) result.velocity_gradient[i] = column(i);
    result.density = column(9);
    for (std::size_t i = 0; i < Law::inputs.size(); ++i) result.inputs[i] = column(10 + i);
    for (std::size_t i = 0; i < Law::states.size(); ++i) result.old_states[i] = result.states[i] = state(i);
    for (std::size_t i = 0; i < 6; ++i) result.stress[i] = state(Law::states.size() + i);
    return result;
  }
};

template <class Law, class Real>
void update(benchmark::State& state) {
  const Law law = typical<Law>();
  Points<Law> points{law};
  const LawColumns<Law> columns = points.columns();

  for (auto _ : state) {
    benchmark::DoNotOptimize(update_batch<Real>(law, columns, 1e-4));
    benchmark::ClobberMemory();
  }

  const auto num_points = static_cast<std::int64_t>(Points<Law>::size);
  state.SetItemsProcessed(state.iterations() * num_points);
  state.counters["ns_per_point"] =
      benchmark::Counter(1e-9 * static_cast<double>(state.iterations() * num_points),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Law>
void register_law() {
  const std::string name{Law::name};
  benchmark::RegisterBenchmark((name + "/double").c_str(), update<Law, double>);
  benchmark::RegisterBenchmark((name + "/pack:1").c_str(), update<Law, testing::Pack<1>>);
  benchmark::RegisterBenchmark((name + "/pack:2").c_str(), update<Law, testing::Pack<2>>);
  benchmark::RegisterBenchmark((name + "/pack:4").c_str(), update<Law, testing::Pack<4>>);
  benchmark::RegisterBenchmark((name + "/pack:8").c_str(), update<Law, testing::Pack<8>>);
}

template <class... Laws>
void register_laws(std::type_identity<std::variant<Laws...>> /*list*/) {
  (register_law<Laws>(), ...);
}

}  // namespace

int main(int argc, char** argv) {
  register_laws(std::type_identity<AnyLaw>{});
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
