#include <scree/transport/cell_limiters.hpp>
#include <scree/transport/grids/polygonal.hpp>
#include <scree/transport/grids/rectangle_mesh.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/solver.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace {

using namespace scree;
using namespace scree::transport;

enum class Order { generated, shuffled, hilbert };

/// 2e5 cells, periodic, vertices moved at random.
Polygonal mesh(Cut cut, Order order) {
  const Index n = cut == Cut::triangles ? 316 : 447;
  PolygonalMesh result = make_mesh({.count = {cut == Cut::mixed ? n * 3 / 4 : n, n},
                                    .cut = cut,
                                    .perturbation = 0.2,
                                    .is_periodic = {true, true}});
  if (order != Order::generated) {
    std::vector<Index> numbers(static_cast<std::size_t>(result.num_cells()));
    std::iota(numbers.begin(), numbers.end(), Index{0});
    std::mt19937_64 engine{1};
    for (std::size_t i = numbers.size(); i > 1; --i) std::swap(numbers[i - 1], numbers[engine() % i]);
    result = reordered(result, numbers);
    if (order == Order::hilbert) result = reordered(result, hilbert_order(result));
  }
  return Polygonal{result};
}

/// SSPRK2 steps of a 2D gas; rate in cell-steps.
template <class R>
void step(benchmark::State& state, Cut cut, Order order, int threads, R reconstruction) {
  const Polygonal grid = mesh(cut, order);
  const Euler<2> gas;
  std::vector<double> u;
  for (Index i = 0; i < grid.num_cells(); ++i) {
    const Vector<2> x = grid.centre(i);
    const auto cell = gas.state(1 + 0.2 * std::sin(6.283 * (x[0] + x[1])), Vector<2>{0.5, -0.3}, 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  Solver solver{grid, gas, reconstruction, SspRk2{}, {.threads = {threads}}};
  const double duration = 7.5 * solver.stable_time_step(u);  // eight steps

  int steps = 0;
  while (state.KeepRunning()) steps += solver.advance(u, duration).substeps;

  state.SetItemsProcessed(steps * grid.num_cells());
}

const CellGradient<SmoothCubic> smooth{};
const CellGradient<SmoothCubic> one_ring{SmoothCubic{}, 1};
const CellGradient<BarthJespersen> sharp{};

BENCHMARK_CAPTURE(step, triangles_generated, Cut::triangles, Order::generated, 1, smooth)->UseRealTime();
BENCHMARK_CAPTURE(step, triangles_shuffled, Cut::triangles, Order::shuffled, 1, smooth)->UseRealTime();
BENCHMARK_CAPTURE(step, triangles_hilbert, Cut::triangles, Order::hilbert, 1, smooth)->UseRealTime();
BENCHMARK_CAPTURE(step, triangles_hilbert_2_threads, Cut::triangles, Order::hilbert, 2, smooth)
    ->UseRealTime();
BENCHMARK_CAPTURE(step, triangles_first_order, Cut::triangles, Order::hilbert, 1, PiecewiseConstant{})
    ->UseRealTime();
BENCHMARK_CAPTURE(step, triangles_barth_jespersen, Cut::triangles, Order::hilbert, 1, sharp)->UseRealTime();
BENCHMARK_CAPTURE(step, triangles_one_ring, Cut::triangles, Order::hilbert, 1, one_ring)->UseRealTime();
BENCHMARK_CAPTURE(step, quadrilaterals, Cut::quadrilaterals, Order::hilbert, 1, smooth)->UseRealTime();
BENCHMARK_CAPTURE(step, mixed, Cut::mixed, Order::hilbert, 1, smooth)->UseRealTime();

}  // namespace
