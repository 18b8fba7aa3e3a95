#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/grids/rectilinear.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/laws/user_law.hpp>
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

/// N size classes with the arithmetic of the probe that says what a machine can do: an arithmetic mean size,
/// one driver per axis, remixing.
template <int N>
struct ProbeClasses {
  static constexpr int num_components = N;
  using State = std::array<double, static_cast<std::size_t>(N)>;

  State sizes;        // [m]
  Vector<3> drivers;  // [m/s]
  double remixing;    // [m^2/s]

  State flux(const State& phi, const Vector<3>& normal) const noexcept {
    double mean = 0;
    for_each_component<N>([&](std::size_t k) { mean += phi[k] * sizes[k]; });
    const double driver = dot<3>(drivers, normal);
    State f;
    for_each_component<N>([&](std::size_t k) { f[k] = driver * (phi[k] * (mean - sizes[k])); });
    return f;
  }
  double max_speed(const State& /*left*/, const State& /*right*/, const Vector<3>& normal) const noexcept {
    return 2 * std::abs(dot<3>(drivers, normal)) * sizes[N - 1];
  }
  State potential(const State& phi) const noexcept {
    State K;
    for_each_component<N>([&](std::size_t k) { K[k] = remixing * phi[k]; });
    return K;
  }
  double max_diffusivity(const State& /*left*/, const State& /*right*/) const noexcept { return remixing; }
};

/// Grain-size segregation as a run has it: a harmonic mean size and a driver of its own at each face.
template <int N>
struct ClassesAtFace {
  static constexpr int num_components = N;
  using State = std::array<double, static_cast<std::size_t>(N)>;

  const State* inverse_sizes;  // [1/m], decreasing
  double driver;               // [m/s]
  double remixing;             // [m^2/s]

  State flux(const State& phi, const Vector<3>& /*normal*/) const noexcept {
    const Sums sums = sums_of(phi);
    const double factor = driver / sums.volume_per_size;
    State f;
    for_each_component<N>([&](std::size_t k) {
      f[k] = factor * (phi[k] * (sums.volume_per_size - sums.volume * (*inverse_sizes)[k]));
    });
    return f;
  }
  double max_speed(const State& left, const State& right, const Vector<3>& /*normal*/) const noexcept {
    return std::abs(driver) * larger(relative_speed(left), relative_speed(right));
  }
  State potential(const State& phi) const noexcept {
    State K;
    for_each_component<N>([&](std::size_t k) { K[k] = remixing * phi[k]; });
    return K;
  }
  double max_diffusivity(const State& /*left*/, const State& /*right*/) const noexcept { return remixing; }

 private:
  struct Sums {
    double volume = 0;
    double volume_per_size = 0;
  };
  Sums sums_of(const State& phi) const noexcept {
    Sums sums;
    for_each_component<N>([&](std::size_t k) {
      sums.volume += phi[k];
      sums.volume_per_size += phi[k] * (*inverse_sizes)[k];
    });
    return sums;
  }
  double relative_speed(const State& phi) const noexcept {
    const Sums sums = sums_of(phi);
    const double mean_size = sums.volume / sums.volume_per_size;
    return larger(mean_size * inverse_sizes->front() - 1, 1 - mean_size * inverse_sizes->back());
  }
};

template <int N>
struct Classes {
  std::array<double, static_cast<std::size_t>(N)> inverse_sizes;
  double remixing;
  const double* drivers;  // one row of num_sites per axis
  Index num_sites;

  ClassesAtFace<N> at(const Face& face) const noexcept {
    return {&inverse_sizes, drivers[face.axis * num_sites + face.owner], remixing};
  }
};

/// One evaluation of d(phi)/dt of N classes on 40^3 occupied cells; rate in cell-classes.
template <int N, class Law, class Reconstruct>
void run_rates(benchmark::State& state, const Law& law, const Reconstruct& reconstruction) {
  const Lattice<3> lattice = periodic_lattice<3>(40);
  const auto num_sites = static_cast<std::size_t>(lattice.num_sites());
  std::vector<double> masses(num_sites);
  std::vector<double> phi(num_sites * N);
  for (std::size_t i = 0; i < num_sites; ++i) {
    masses[i] = 1 + 0.3 * std::sin(0.1 * static_cast<double>(i));
    double total = 0;
    for (std::size_t k = 0; k < N; ++k) {
      phi[i * N + k] = 1 + 0.5 * std::sin(0.37 * static_cast<double>(i) + static_cast<double>(k));
      total += phi[i * N + k];
    }
    for (std::size_t k = 0; k < N; ++k) phi[i * N + k] /= total;
  }
  OccupiedCells<3> cells{lattice};
  cells.set_masses(masses);
  SemiDiscrete<OccupiedCells<3>, Law, Reconstruct, KurganovTadmor> rates{
      {cells, law, reconstruction, {}, {}}, 0.5, {}};
  Fields<N> fields{lattice.num_sites()};
  Fields<N> result{lattice.num_sites()};
  fields.gather(phi, {});

  while (state.KeepRunning()) benchmark::DoNotOptimize(rates(fields, result, 0));

  state.SetItemsProcessed(state.iterations() * static_cast<Index>(num_sites) * N);
}

/// The probe's arithmetic and its plain minmod: to be compared with the probe.
template <int N>
void probe_rates(benchmark::State& state) {
  ProbeClasses<N> law{{}, Vector<3>{0.3, 0.2, 1.0}, 0.01};
  for (std::size_t k = 0; k < N; ++k) law.sizes[k] = 1e-3 * static_cast<double>(1 + k);
  run_rates<N>(state, law, PiecewiseLinear{Minmod{}});
}
BENCHMARK(probe_rates<2>);
BENCHMARK(probe_rates<8>);

/// What segregation costs in a run: its law, and one limiter factor for all classes.
template <int N>
void segregation_rates(benchmark::State& state) {
  std::vector<double> drivers(std::size_t{3} * 40 * 40 * 40);
  for (std::size_t i = 0; i < drivers.size(); ++i) drivers[i] = std::cos(0.01 * static_cast<double>(i));
  Classes<N> law{{}, 0.01, drivers.data(), 40 * 40 * 40};
  for (std::size_t k = 0; k < N; ++k) law.inverse_sizes[k] = 1e3 / static_cast<double>(1 + k);
  run_rates<N>(state, law, PiecewiseLinearCommon{Minmod{}, 1.0});
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

/// A 2D gas on 512 x 512 cells.
std::vector<double> gas_on(const Lattice<2>& lattice) {
  const Euler<2> gas;
  std::vector<double> u;
  for (Index i = 0; i < lattice.num_sites(); ++i) {
    const Vector<2> x = lattice.position(lattice.site(i));
    const auto cell = gas.state(1 + 0.2 * std::sin(6.283 * (x[0] + x[1])), Vector<2>{0.5, -0.3}, 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  return u;
}

/// SSPRK2 steps of it; rate in cell-steps.
template <class S>
void gas_steps(benchmark::State& state, const Lattice<2>& lattice, S&& solver) {
  auto u = gas_on(lattice);
  const double duration = 7.5 * solver.stable_time_step(u);  // eight steps
  int steps = 0;
  while (state.KeepRunning()) steps += solver.advance(u, duration).substeps;
  state.SetItemsProcessed(steps * lattice.num_sites());
}

void euler_step(benchmark::State& state) {
  const Lattice<2> lattice = periodic_lattice<2>(512);
  gas_steps(state, lattice, Solver{Cartesian<2>{lattice}, Euler<2>{}, PiecewiseLinear{Minmod{}}});
}
BENCHMARK(euler_step);

void euler_step_on_two_threads(benchmark::State& state) {  // by the clock
  const Lattice<2> lattice = periodic_lattice<2>(512);
  gas_steps(state, lattice,
            Solver{Cartesian<2>{lattice}, Euler<2>{}, PiecewiseLinear{Minmod{}}, SspRk2{}, {.threads = {2}}});
}
BENCHMARK(euler_step_on_two_threads)->UseRealTime();

/// The same cells, not known to be equal.
void euler_step_on_rectilinear(benchmark::State& state) {
  std::vector<double> edges;
  for (int i = 0; i <= 512; ++i) edges.push_back(i / 512.0);
  const Rectilinear<2> grid{{edges, edges}, {true, true}};
  gas_steps(state, periodic_lattice<2>(512), Solver{grid, Euler<2>{}, PiecewiseLinear{Minmod{}}});
}
BENCHMARK(euler_step_on_rectilinear);

/// The same cells, not known to be full.
void euler_step_on_occupied(benchmark::State& state) {
  const Lattice<2> lattice = periodic_lattice<2>(512);
  OccupiedCells<2> cells{lattice};
  cells.set_fill(std::vector<double>(512 * 512, 1.0));
  gas_steps(state, lattice, Solver{cells, Euler<2>{}, PiecewiseLinear{Minmod{}}});
}
BENCHMARK(euler_step_on_occupied);

/// With the usual reconstruction and flux: primitive variables, kept admissible, central-upwind.
void euler_usual_step(benchmark::State& state) {
  const Lattice<2> lattice = periodic_lattice<2>(512);
  gas_steps(state, lattice, Solver{Cartesian<2>{lattice}, Euler<2>{}});
}
BENCHMARK(euler_usual_step);

/// The flux and the speed as a user writes them who divides once.
void user_law_step(benchmark::State& state) {
  using State = std::array<double, 4>;
  const double gamma = 1.4;
  const auto pressure = [=](const State& u) {
    return (gamma - 1) * (u[3] - 0.5 * (u[1] * u[1] + u[2] * u[2]) * (1 / u[0]));
  };
  const auto fastest = [=](const State& u, const Vector<2>& normal) {
    const double speed = (u[1] * normal[0] + u[2] * normal[1]) * (1 / u[0]);
    return std::abs(speed) + std::sqrt(gamma * pressure(u) * (1 / u[0]));
  };
  const auto law = make_law<4, 2>(
      [=](const State& u, const Vector<2>& normal) {
        const double p = pressure(u);
        const double speed = (u[1] * normal[0] + u[2] * normal[1]) * (1 / u[0]);
        return State{u[0] * speed, u[1] * speed + p * normal[0], u[2] * speed + p * normal[1],
                     (u[3] + p) * speed};
      },
      [=](const State& left, const State& right, const Vector<2>& normal) {
        return larger(fastest(left, normal), fastest(right, normal));
      });
  const Lattice<2> lattice = periodic_lattice<2>(512);
  gas_steps(state, lattice, Solver{Cartesian<2>{lattice}, law, PiecewiseLinear{Minmod{}}});
}
BENCHMARK(user_law_step);

}  // namespace
