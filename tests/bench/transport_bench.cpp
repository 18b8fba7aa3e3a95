#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace {

using namespace scree;
using namespace scree::transport;

template <int D>
Lattice<D> periodic_lattice(Index n) {
  Lattice<D> lattice;
  lattice.count.fill(n);
  lattice.spacing = Vector<D>::Constant(1.0 / static_cast<double>(n));
  lattice.first = lattice.spacing / 2;
  lattice.is_periodic.fill(true);
  return lattice;
}

/// The flux of N size classes whose driver differs from face to face, as grain-size segregation has it,
/// with remixing: what the segregation step of a run costs, on the transport side.
template <int N>
struct ClassesAtFace {
  static constexpr int num_components = N;
  using State = std::array<double, static_cast<std::size_t>(N)>;

  const double* sizes;  // [m]
  double driver;        // [m/s]

  template <int D>
  State flux(const State& phi, const Vector<D>& normal) const noexcept {
    double mean = 0;
    for_each_component<N>([&](std::size_t k) { mean += phi[k] * sizes[k]; });
    State f;
    const double b = driver * sum(normal);
    for_each_component<N>([&](std::size_t k) { f[k] = b * phi[k] * (mean - sizes[k]); });
    return f;
  }
  template <int D>
  double max_speed(const State& /*left*/, const State& /*right*/,
                   const Vector<D>& /*normal*/) const noexcept {
    return 2 * std::abs(driver) * sizes[N - 1];
  }
  State potential(const State& phi) const noexcept {
    State K;
    for_each_component<N>([&](std::size_t k) { K[k] = 0.01 * phi[k]; });
    return K;
  }
  double max_diffusivity(const State& /*left*/, const State& /*right*/) const noexcept { return 0.01; }
};

template <int N>
struct Classes {
  const double* sizes;
  const double* drive;  // one per site

  ClassesAtFace<N> at(const Face& face) const noexcept {
    return {sizes, (drive[face.neighbour] - drive[face.owner]) / face.distance};
  }
};

/// One evaluation of d(phi)/dt of N classes on 40^3 occupied cells; rate in cell-classes.
template <int N>
void segregation_rates(benchmark::State& state) {
  const Lattice<3> lattice = periodic_lattice<3>(40);
  const auto num_sites = static_cast<std::size_t>(lattice.num_sites());
  std::vector<double> masses(num_sites);
  std::vector<double> drive(num_sites);
  std::vector<double> phi(num_sites * N);
  for (std::size_t i = 0; i < num_sites; ++i) {
    masses[i] = 1 + 0.3 * std::sin(0.1 * static_cast<double>(i));
    drive[i] = std::cos(0.01 * static_cast<double>(i));
    for (std::size_t k = 0; k < N; ++k) {
      phi[i * N + k] = (1 + 0.5 * std::sin(0.37 * static_cast<double>(i) + static_cast<double>(k))) / N;
    }
  }
  std::vector<double> sizes(N);
  for (std::size_t k = 0; k < N; ++k) sizes[k] = 1e-3 * static_cast<double>(1 + k);
  OccupiedCells<3> cells{lattice};
  cells.set_masses(masses);
  SemiDiscrete<OccupiedCells<3>, Classes<N>, PiecewiseLinearCommon<Minmod>, KurganovTadmor> rates{
      {cells, {sizes.data(), drive.data()}, PiecewiseLinearCommon{Minmod{}}, {}, {}}, 0.5, {}};
  Fields<N> fields{lattice.num_sites()};
  Fields<N> result{lattice.num_sites()};
  fields.gather(phi, {});

  while (state.KeepRunning()) benchmark::DoNotOptimize(rates(fields, result, 0));

  state.SetItemsProcessed(state.iterations() * static_cast<Index>(num_sites) * N);
}
BENCHMARK(segregation_rates<2>);
BENCHMARK(segregation_rates<3>);
BENCHMARK(segregation_rates<4>);
BENCHMARK(segregation_rates<8>);
BENCHMARK(segregation_rates<16>);

/// SSPRK2 steps of a scalar, 512^2 or 64^3; rate in cell-steps.
template <int D>
void advection_step(benchmark::State& state) {
  const Lattice<D> lattice = periodic_lattice<D>(D == 2 ? 512 : 64);
  std::vector<double> u(static_cast<std::size_t>(lattice.num_sites()));
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = std::sin(0.01 * static_cast<double>(i));
  Solver solver{Cartesian<D>{lattice}, Advection<D>{Vector<D>::Ones()}, PiecewiseLinear{Minmod{}}};
  const double duration = 7.999 * solver.stable_time_step(u);  // eight steps

  int steps = 0;
  while (state.KeepRunning()) steps += solver.advance(u, duration).substeps;

  state.SetItemsProcessed(steps * lattice.num_sites());
}
BENCHMARK(advection_step<2>);
BENCHMARK(advection_step<3>);

/// SSPRK2 steps of a 2D gas, 512 x 512; rate in cell-steps.
void euler_step(benchmark::State& state) {
  const Lattice<2> lattice = periodic_lattice<2>(512);
  const Euler<2> gas;
  std::vector<double> u;
  for (Index i = 0; i < lattice.num_sites(); ++i) {
    const Vector<2> x = lattice.position(lattice.site(i));
    const auto cell = gas.state(1 + 0.2 * std::sin(6.283 * (x[0] + x[1])), Vector<2>{0.5, -0.3}, 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  Solver solver{Cartesian<2>{lattice}, gas, PiecewiseLinear{Minmod{}}};
  const double duration = 7.5 * solver.stable_time_step(u);  // eight steps

  int steps = 0;
  while (state.KeepRunning()) steps += solver.advance(u, duration).substeps;

  state.SetItemsProcessed(steps * lattice.num_sites());
}
BENCHMARK(euler_step);

}  // namespace
