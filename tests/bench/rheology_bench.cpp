// Every law over a block of points that stays in cache: by the kernel for each instruction set that runs
// here, and point by point as this program is compiled. The rate is in point updates: its inverse is the time
// per point.

#include "../rheology/points.hpp"

#include <scree/rheology/laws.hpp>
#include <scree/update_block.hpp>

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
  static constexpr std::size_t num_columns = 9 + 1 + Law::inputs.size() + Law::states.size() + 9;
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

  [[nodiscard]] double* column(std::size_t i) { return numbers.data() + i * size; }
  [[nodiscard]] double* state(std::size_t i) { return column(10 + Law::inputs.size() + i); }

  [[nodiscard]] LawBlock<Law> block() {
    LawBlock<Law> result;
    result.num_points = static_cast<Index>(size);
    for (std::size_t i = 0; i < 9; ++i) result.velocity_gradient[i] = {column(i), 1};
    result.density = column(9);
    for (std::size_t i = 0; i < Law::inputs.size(); ++i) result.inputs[i] = column(10 + i);
    for (std::size_t i = 0; i < Law::states.size(); ++i) result.states[i] = state(i);
    for (std::size_t i = 0; i < 9; ++i) result.stress[i] = state(Law::states.size() + i);
    return result;
  }
};

template <class Law>
void update(benchmark::State& state, BlockKernel<Law> kernel) {
  const Law law = typical<Law>();
  Points<Law> points{law};
  const LawBlock<Law> block = points.block();

  for (auto _ : state) {
    benchmark::DoNotOptimize(kernel(law, block, 1e-4));
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
  benchmark::RegisterBenchmark((name + "/points").c_str(), update<Law>, &update_block<double, Law>);
  for (const InstructionSet set : instruction_sets()) {
    benchmark::RegisterBenchmark((name + '/' + std::string{name_of(set)}).c_str(), update<Law>,
                                 block_kernel(typical<Law>(), set));
  }
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
