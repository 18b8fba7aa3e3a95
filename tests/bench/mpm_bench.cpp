#include "../mpm/bodies.hpp"
#include "../mpm/dry_wall.hpp"

#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/mpm/boundaries/rigid_body.hpp>
#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/cell_sort.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

/// Whole steps of a swirl of 2^D points to a cell, jittered, in a square or cube away from the ends of its
/// mesh. Rates are point updates; beside them the wall-clock time of each phase [ns per point], and the
/// memory of the columns, held and by their sizes [bytes per point]. The law is a linear fluid.
namespace {

using namespace scree;
using namespace scree::mpm;

/// What material stands on, with dry friction: its own, or one that points carry.
enum class Base { none, wall, wall_that_reads, body_that_reads };

struct Case {
  Index fill;           ///< cells of material along each axis
  int num_classes = 0;  ///< of grain size
  int threads = 1;
  double share = 1;  ///< of the mesh that is filled, about: more is empty
  Base base = Base::none;
  double jitter = 0.075;      ///< of points about a lattice [cells]; up to 0.25 they cross no other's place
  double cells_per_step = 0;  ///< that all points go along the first axis of a periodic mesh; 0: the swirl
};

template <int D>
Particles<D> swirl(const CartesianGrid<D>& grid, Index fill, Index pad, double most_jitter = 0.075) {
  Indices<D> per_cell{};
  per_cell.fill(2);
  const double spacing = grid.spacing()[0];
  const Vector<D> low = Vector<D>::Constant(static_cast<double>(pad) * spacing);
  const Vector<D> high = low + Vector<D>::Constant(static_cast<double>(fill) * spacing);
  auto particles = seed_box<D, D>(grid, low, high, per_cell, 1000);
  std::mt19937 random{1};
  std::uniform_real_distribution<double> jitter{-most_jitter * spacing, most_jitter * spacing};
  for (Index p = 0; p < particles.size(); ++p) {
    Vector<3> x = Vector<3>::Zero();
    for (int axis = 0; axis < D; ++axis) {
      particles.position.component(axis)[p] += jitter(random);
      x[axis] = particles.position.component(axis)[p] - low[axis];
    }
    particles.velocity.component(0)[p] = 2 * std::sin(3 * x[0]) * std::cos(4 * x[1]);
    particles.velocity.component(1)[p] = -1.5 * std::cos(3 * x[0]) * std::sin(4 * x[1]);
    if (D == 3) particles.velocity.component(D - 1)[p] = 0.5 * std::sin(5 * x[2] + x[0]);
  }
  return particles;
}

/// Fractions of the points to the nodes and back, as a segregation step between them needs.
template <int D>
class Classes {
 public:
  Classes(Particles<D>& particles, const CartesianGrid<D>& grid, const AnyShape& shape, int count,
          Sites sites = Sites::nodes)
      : carried_{grid, sites, shape} {
    if (count == 0) return;
    column_ = particles.add_column({"fractions", "phi", "-"}, count);
    std::fill(fractions(particles).values().begin(), fractions(particles).values().end(), 1.0 / count);
    const auto num_sites = static_cast<std::size_t>(carried_.lattice().num_sites());
    masses_.resize(num_sites);
    means_.resize(num_sites * static_cast<std::size_t>(count));
    count_ = count;
  }
  void there_and_back(State<D, D>& state, Threads threads) {
    if (count_ == 0) return;
    std::vector<CarriedField> fields;
    for (int k = 0; k < count_; ++k) fields.push_back({&fractions(state.particles), k});
    carried_.to_sites(state.particles, state.blocks, fields, masses_, means_, threads);
    carried_.to_points(state.blocks, state.particles, fractions(state.particles), means_, means_,
                       CarriedMap::exchange, threads);
  }

 private:
  Column& fractions(Particles<D>& particles) { return particles.column(column_); }
  CarriedCells<D, D> carried_;
  std::size_t column_ = 0;
  int count_ = 0;
  std::vector<double> masses_;
  std::vector<double> means_;
};

/// Lets material that reaches down to the low end of the last axis stand on a base there.
template <int D>
void stand(Particles<D>& particles, const AnyShape& shape, Base base, Stages<D, D>& stages) {
  if (base == Base::none) return;
  const std::size_t column = particles.add_column({"friction", "mu", "-"}, 1);
  std::ranges::fill(particles.column(column).values(), 0.5);
  CarriedInput<Rubs> carried;
  if (base != Base::wall) {
    stages.node_means = std::make_unique<NodeMeans<D, D>>(shape);
    carried.read(0, stages.node_means->add(particles, "friction", Rubs::inputs[0], Rubs::name));
  }
  if (base == Base::body_that_reads) {
    const PlaneSurface<D> floor{Vector<D>::Zero(), Vector<D>::Unit(D - 1)};
    stages.boundaries.push_back(make_rigid_body<D, Rubs>(Contact<Rubs>{}, floor, RigidMotion<D>{}, 0, {0.5},
                                                         Symmetry::plane, carried));
  } else {
    stages.boundaries.push_back(
        make_frictional_wall<D>(Rubs{}, {0.5}, Hold::pushes, D - 1, Side::low, Symmetry::plane, carried));
  }
}

template <int D>
void step_of_points(benchmark::State& bench, const AnyShape& shape, const AnyTransfer& rule,
                    const Case& what) {
  const Index pad = what.base == Base::none ? 5 : 0;
  const double edge = static_cast<double>(what.fill + 2 * pad) / std::pow(what.share, 1.0 / D);
  const double spacing = 1.0 / static_cast<double>(what.fill);
  const double dt = 0.02 * 0.4 * spacing / 20;  // so short that hardly anything changes, but all is computed
  const auto grid = cube<D>(static_cast<Index>(edge), spacing, what.cells_per_step > 0);
  auto particles = swirl<D>(grid, what.fill, pad, what.jitter);
  if (what.cells_per_step > 0) {
    std::ranges::fill(particles.velocity.values(), 0.0);
    std::fill_n(particles.velocity.component(0), particles.size(), what.cells_per_step * spacing / dt);
  }
  const Index num_points = particles.size();
  const Fluid fluid{.bulk_modulus = 4e5, .reference_density = 1000, .viscosity = 0.1};  // sound: 20 m/s
  Classes<D> classes{particles, grid, shape, what.num_classes};
  auto stages = stages_of<D, D>(particles, shape, rule, fluid);
  stand(particles, shape, what.base, stages);
  const Threads threads{what.threads};
  auto state = start(std::move(particles), grid, stages, threads);
  for (int n = 0; n < 3; ++n) step(state, stages, dt, threads);
  state.seconds = {};

  for (auto _ : bench) {
    step(state, stages, dt, threads);
    classes.there_and_back(state, threads);
  }

  bench.SetItemsProcessed(bench.iterations() * num_points);
  const double updates = static_cast<double>(bench.iterations() * num_points);
  bench.counters["scatter_ns"] = state.seconds.scatter / updates * 1e9;
  bench.counters["nodes_ns"] = state.seconds.nodes / updates * 1e9;
  bench.counters["bytes"] =
      static_cast<double>(state.particles.held_bytes()) / static_cast<double>(num_points);
  bench.counters["bytes_in_use"] = static_cast<double>(state.particles.bytes_per_particle());
  bench.counters["gather_ns"] = state.seconds.gather / updates * 1e9;
  bench.counters["sort_ns"] = state.seconds.sort / updates * 1e9;
}

/// Fractions to the sites and back alone.
template <int D>
void classes_of_points(benchmark::State& bench, Index fill, int count, Sites sites) {
  const auto grid = cube<D>(fill + 10, 1.0 / static_cast<double>(fill), false);
  auto particles = swirl<D>(grid, fill, 5);
  const Index num_points = particles.size();
  const AnyShape shape = Quadratic{};
  Classes<D> classes{particles, grid, shape, count, sites};
  const auto stages = stages_of<D, D>(particles, shape, Apic{});
  auto state = start(std::move(particles), grid, stages, Threads{1});
  for (auto _ : bench) classes.there_and_back(state, Threads{1});
  bench.SetItemsProcessed(bench.iterations() * num_points);
}

/// What a sort costs.
template <int D>
void sort_of_points(benchmark::State& bench, Index fill) {
  const auto grid = cube<D>(fill + 10, 1.0 / static_cast<double>(fill), false);
  auto particles = swirl<D>(grid, fill, 5);
  for (auto _ : bench) benchmark::DoNotOptimize(cell_sort(particles, grid, Quadratic::shift, Threads{1}));
  bench.SetItemsProcessed(bench.iterations() * particles.size());
}

template <int D>
void add(const std::string& name, const AnyShape& shape, const AnyTransfer& rule, const Case& what) {
  benchmark::RegisterBenchmark((std::to_string(D) + "D_" + name).c_str(),
                               [=](benchmark::State& bench) { step_of_points<D>(bench, shape, rule, what); })
      ->MeasureProcessCPUTime()
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

/// About 1e5 points, but where 2e6 are named.
template <int D>
void add_all() {
  constexpr Index fill = D == 2 ? 158 : 23;
  add<D>("apic_quadratic", Quadratic{}, Apic{}, {.fill = fill});
  add<D>("apic_quadratic_2_classes", Quadratic{}, Apic{}, {.fill = fill, .num_classes = 2});
  add<D>("apic_quadratic_8_classes", Quadratic{}, Apic{}, {.fill = fill, .num_classes = 8});
  add<D>("apic_quadratic_2_threads", Quadratic{}, Apic{}, {.fill = fill, .threads = 2});
  add<D>("apic_quadratic_2_percent_filled", Quadratic{}, Apic{}, {.fill = fill, .share = 0.02});
  add<D>("apic_quadratic_2e6_points", Quadratic{}, Apic{}, {.fill = D == 2 ? 707 : 63});
  add<D>("flip_quadratic", Quadratic{}, PicFlip{1}, {.fill = fill});
  add<D>("apic_cubic", Cubic{}, Apic{}, {.fill = fill});
  add<D>("apic_gimp", Gimp{2}, Apic{}, {.fill = fill});
  add<D>("tpic_quadratic", Quadratic{}, Tpic{}, {.fill = fill});
  add<D>("aflip_quadratic", Quadratic{}, Aflip{1}, {.fill = fill});
  add<D>("flip_linear", Linear{}, PicFlip{1}, {.fill = fill});
  add<D>("apic_quadratic_wall", Quadratic{}, Apic{}, {.fill = fill, .base = Base::wall});
  add<D>("apic_cubic_wall", Cubic{}, Apic{}, {.fill = fill, .base = Base::wall});
  add<D>("apic_quadratic_wall_that_reads", Quadratic{}, Apic{},
         {.fill = fill, .base = Base::wall_that_reads});
  add<D>("apic_quadratic_body_that_reads", Quadratic{}, Apic{},
         {.fill = fill, .base = Base::body_that_reads});
  add<D>("apic_quadratic_disordered", Quadratic{}, Apic{}, {.fill = fill, .jitter = 0.25});
  add<D>("apic_quadratic_stream", Quadratic{}, Apic{}, {.fill = fill, .cells_per_step = 0.2});
  for (const int count : {2, 8}) {
    for (const Sites sites : {Sites::cells, Sites::nodes}) {
      const std::string name = std::to_string(D) + "D_" + std::to_string(count) + "_classes_" +
                               (sites == Sites::cells ? "cells" : "nodes") + "_and_back";
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& bench) {
        classes_of_points<D>(bench, fill, count, sites);
      })->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::RegisterBenchmark((std::to_string(D) + "D_sort").c_str(), [](benchmark::State& bench) {
    sort_of_points<D>(bench, fill);
  })->Unit(benchmark::kMillisecond);
}

const bool is_registered = [] {
  add_all<2>();
  add_all<3>();
  return true;
}();

}  // namespace
