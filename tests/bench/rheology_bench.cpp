// Every law over columns of points that stay in cache: one point at a time, and in packs of several widths.
// The rate is in point updates: its inverse is the time per point.

#include "../rheology/points.hpp"
#include "packs.hpp"

#include <scree/rheology/laws.hpp>

#include <benchmark/benchmark.h>

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

using namespace scree;
using namespace scree::rheology;

/// Sheared, pressed points in 3D, a column per number.
template <class Law>
struct Columns {
  static constexpr std::size_t size = 520;  // not a power of two, whose columns would share cache sets
  std::vector<double> numbers = std::vector<double>((9 + 1 + 1 + Law::states.size() + 6) * size);

  [[nodiscard]] double* gradient(std::size_t i) { return numbers.data() + i * size; }
  [[nodiscard]] double* density() { return gradient(9); }
  [[nodiscard]] double* input() { return gradient(10); }
  [[nodiscard]] double* state(std::size_t i) { return gradient(11 + i); }
  [[nodiscard]] double* stress(std::size_t i) { return state(Law::states.size() + i); }

  explicit Columns(const Law& law) {
    const auto gradients = velocity_gradients();
    for (std::size_t p = 0; p < size; ++p) {
      for (std::size_t i = 0; i < 9; ++i) gradient(i)[p] = gradients[p % gradients.size()].components[i];
      density()[p] = law.density * (1 + 1e-3 * static_cast<double>(p % 7));
      input()[p] = 1e-3;
      for (std::size_t i = 0; i < Law::states.size(); ++i) state(i)[p] = Law::states[i].initial;
    }
  }
};

template <class Real>
[[nodiscard]] Real load(const double* from) {
  if constexpr (std::is_same_v<Real, double>) {
    return *from;
  } else {
    return Real(from, std::experimental::element_aligned);
  }
}

template <class Real>
void store(const Real& value, double* to) {
  if constexpr (std::is_same_v<Real, double>) {
    *to = value;
  } else {
    value.copy_to(to, std::experimental::element_aligned);
  }
}

template <class Real, class Law, std::size_t... S>
void update_points(const Law& law, Columns<Law>& columns, std::index_sequence<S...> /*states*/) {
  constexpr std::size_t lanes = sizeof(Real) / sizeof(double);
  const Real dt = 1e-4;
  for (std::size_t p = 0; p < Columns<Law>::size; p += lanes) {
    Deformation<Real> deformation{};
    for (std::size_t i = 0; i < 9; ++i) {
      deformation.velocity_gradient.components[i] = load<Real>(columns.gradient(i) + p);
    }
    deformation.density = load<Real>(columns.density() + p);
    const auto input = filled_with<typename Law::template Input<Real>>(load<Real>(columns.input() + p));
    const typename Law::template State<Real> old{load<Real>(columns.state(S) + p)...};
    const auto response = law.update(deformation, input, old, dt);
    const Symmetric<Real> sigma = symmetric(response.stress);
    const std::array six{sigma.xx, sigma.yy, sigma.zz, sigma.xy, sigma.xz, sigma.yz};
    for (std::size_t i = 0; i < 6; ++i) store(six[i], columns.stress(i) + p);
    if constexpr (sizeof...(S) == 6) {
      const auto& s = response.state;
      const std::array kept{s.xx, s.yy, s.zz, s.xy, s.xz, s.yz};
      for (std::size_t i = 0; i < 6; ++i) store(kept[i], columns.state(i) + p);
    }
  }
}

template <class Law, class Real>
void update(benchmark::State& state) {
  const Law law = typical<Law>();
  Columns<Law> columns{law};

  for (auto _ : state) {
    update_points<Real>(law, columns, std::make_index_sequence<Law::states.size()>{});
    benchmark::ClobberMemory();
  }

  const auto points = static_cast<std::int64_t>(Columns<Law>::size);
  state.SetItemsProcessed(state.iterations() * points);
  state.counters["ns_per_point"] =
      benchmark::Counter(1e-9 * static_cast<double>(state.iterations() * points),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Law>
void register_law() {
  const std::string name{Law::name};
  benchmark::RegisterBenchmark((name + "/double").c_str(), update<Law, double>);
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
