#include "lines.hpp"

#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace scree::transport {
namespace {

/// A third of the cells masked, a third full, the rest filled in part, down to slivers of 1e-3.
std::vector<double> random_fill(Index num_sites, unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> draw;
  std::vector<double> shares;
  for (Index site = 0; site < num_sites; ++site) {
    const double kind = draw(random);
    shares.push_back(kind < 1.0 / 3 ? 0 : kind < 2.0 / 3 ? 1 : std::pow(10, -3 * draw(random)));
  }
  return shares;
}

template <int D>
OccupiedCells<D> filled(const Lattice<D>& lattice, const std::vector<double>& shares) {
  OccupiedCells<D> cells{Cartesian<D>{lattice}};
  cells.set_fill(shares);
  return cells;
}

template <int D>
std::vector<double> still_gas(Index num_sites, double density, double pressure) {
  const auto cell = Euler<D>{}.state(density, Vector<D>::Zero(), pressure);
  std::vector<double> u;
  for (Index site = 0; site < num_sites; ++site) u.insert(u.end(), cell.begin(), cell.end());
  return u;
}

/// The largest momentum of any cell.
template <int D>
double largest_momentum(const std::vector<double>& u) {
  double largest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const std::size_t k = i % (D + 2);
    if (k > 0 && k <= D) largest = std::max(largest, std::abs(u[i]));
  }
  return largest;
}

/// How far rounding may set a gas going: per step, axis and stage eight roundings of p dt/w, where
/// dt c/w <= 1/2.
double rounding_of_momentum(const Advance& result, double pressure, double sound_speed, int num_axes) {
  return result.substeps * num_axes * 2 * 8 * round_off * pressure / (2 * sound_speed);
}

TEST(Walls, LeaveAStillGasAtRest) {  // the area times the normal of a cell's surface adds to zero, Eq. (T65)
  Lattice<2> lattice = test::cube<2>(70);
  lattice.is_periodic = {false, true};
  auto u = still_gas<2>(lattice.num_sites(), 1, 3);
  Solver solver{filled(lattice, random_fill(lattice.num_sites(), 3)),
                Euler<2>{},
                PiecewiseLinear{Minmod{2}},
                SspRk2{},
                {.boundaries = {{{Reflecting{}, Reflecting{}}, {Reflecting{}, Reflecting{}}}}}};

  const Advance result = solver.advance(u, 0.3);

  EXPECT_GE(result.substeps, 80);
  EXPECT_LE(largest_momentum<2>(u), rounding_of_momentum(result, 3, std::sqrt(1.4 * 3), 2));
}

TEST(Walls, LeaveAStillGasAtRestInThreeDimensionsAndOnUnequalCells) {
  const Lattice<3> lattice = test::cube<3>(9);
  auto u = still_gas<3>(lattice.num_sites(), 1, 3);
  const Advance result = Solver{
      filled(lattice, random_fill(lattice.num_sites(), 5)), Euler<3>{},
      PiecewiseLinear{
          Minmod{}}}.advance(u, 0.2);
  EXPECT_LE(largest_momentum<3>(u), rounding_of_momentum(result, 3, std::sqrt(1.4 * 3), 3));

  const Rectilinear<2> grid{{std::vector<double>{0, 0.1, 0.4, 0.5, 1}, {0, 0.5, 0.6, 2}}, {true, true}};
  OccupiedCells<2, Rectilinear<2>> cells{grid};
  cells.set_fill(random_fill(12, 4));
  auto v = still_gas<2>(12, 1, 3);
  const Advance other = Solver{cells, Euler<2>{}, PiecewiseLinear{Minmod{}}}.advance(v, 1);
  EXPECT_LE(largest_momentum<2>(v), rounding_of_momentum(other, 3, std::sqrt(1.4 * 3), 2));
}

/// The same gas, of which no mirror image is known.
struct WithoutMirror {
  static constexpr int num_components = 3;
  using State = Euler<1>::State;
  Euler<1> gas{};
  State flux(const State& u, const Vector<1>& normal) const noexcept { return gas.flux(u, normal); }
  double max_speed(const State& left, const State& right, const Vector<1>& normal) const noexcept {
    return gas.max_speed(left, right, normal);
  }
};

TEST(Walls, ThatDoNotReflectSetAStillGasGoing) {  // where it fails: the pressure of the wall is missing
  const Lattice<1> lattice = test::line(10, 0, 1);
  auto shares = std::vector<double>(10, 1.0);
  shares[4] = 0;
  shares[7] = 0.25;
  auto u = still_gas<1>(10, 1, 3);
  const double dt = 1e-3;

  Solver{filled(lattice, shares), WithoutMirror{}, PiecewiseConstant{}, ForwardEuler{}}.advance(u, dt);

  EXPECT_NEAR(u[3 * 3 + 1], dt * 3 / 0.1, 1e-15);         // all of p beside the mask
  EXPECT_NEAR(u[3 * 6 + 1], dt * 0.75 * 3 / 0.1, 1e-15);  // and the closed part of it beside a quarter
  EXPECT_NEAR(u[3 * 1 + 1], 0, 1e-15);
}

/// A shock tube along one axis of a box three cells thick, reflected at its far end.
template <int D>
std::vector<double> shock_tube(int axis, Index n, bool is_masked) {
  Lattice<D> lattice = test::cube<D>(3);
  lattice.is_periodic[static_cast<std::size_t>(axis)] = false;
  lattice.count[static_cast<std::size_t>(axis)] = is_masked ? n + 7 : n;
  lattice.spacing = Vector<D>::Constant(1.0 / static_cast<double>(n));
  const Euler<D> gas;
  std::vector<double> u;
  std::vector<double> shares;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Index i = lattice.site(site)[static_cast<std::size_t>(axis)];
    const bool is_left = 2 * i < n;
    const auto cell = gas.state(is_left ? 1 : 0.125, Vector<D>::Zero(), is_left ? 1 : 0.1);
    u.insert(u.end(), cell.begin(), cell.end());
    shares.push_back(i < n ? 1 : 0);
  }
  SolverOptions<OccupiedCells<D>, D + 2> options;
  options.boundaries[static_cast<std::size_t>(axis)] = {Reflecting{}, Reflecting{}};
  Solver solver{filled(lattice, shares), gas, PiecewiseLinear{Minmod{}}, SspRk2{}, options};
  // Short enough for one step each: limits differ in the last cell.
  for (int step = 0; step < 600; ++step)
    EXPECT_EQ(solver.advance(u, 0.1 / static_cast<double>(n)).substeps, 1);
  std::vector<double> tube;
  for (Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i * lattice.stride(axis) * (D + 2));
    tube.push_back(u[at]);
    tube.push_back(u[at + D + 1]);
  }
  return tube;
}

TEST(Walls, OfAMaskReflectAShockAsABoundaryDoes) {
  constexpr double rounding = 600 * 2 * 20 * round_off;  // some twenty roundings a stage, values up to 3
  const auto at_boundary = shock_tube<1>(0, 80, false);
  EXPECT_GT(at_boundary[2 * 79], 0.4);  // by now the shock has been thrown back: 0.27 before
  EXPECT_LE(test::linf(shock_tube<1>(0, 80, true), at_boundary), 3 * rounding);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_LE(test::linf(shock_tube<2>(axis, 80, true), at_boundary), 3 * rounding);
  }
}

/// A blast in the middle of a random filling, mirrored in x = y.
std::vector<double> blast(const Lattice<2>& lattice, std::vector<double>& shares) {
  const Euler<2> gas;
  std::vector<double> u;
  shares = random_fill(lattice.num_sites(), 8);
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Indices<2> at = lattice.site(site);
    if (at[1] > at[0]) continue;
    shares[static_cast<std::size_t>(lattice.index({at[1], at[0]}))] = shares[static_cast<std::size_t>(site)];
  }
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site)) - Vector<2>{0.5, 0.5};
    const auto cell = gas.state(1, Vector<2>::Zero(), x.norm() < 0.2 ? 10 : 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  return u;
}

TEST(Walls, KeepMassEnergySymmetryAndPositiveStatesInABlast) {  // slivers of 1e-3 at the full cells' step
  const Lattice<2> lattice = test::cube<2>(40);
  std::vector<double> shares;
  auto u = blast(lattice, shares);
  const auto total = [&](std::size_t k) {
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) sum += shares[i] * u[4 * i + k];
    return sum;
  };
  const double mass = total(0);
  const double energy = total(3);
  Solver solver{filled(lattice, shares), Euler<2>{}, PiecewiseLinear{Minmod{}}};
  Solver full{Cartesian<2>{lattice}, Euler<2>{}, PiecewiseLinear{Minmod{}}};
  EXPECT_GE(solver.stable_time_step(u), full.stable_time_step(u) * (1 - 8 * round_off));

  const Advance result = solver.advance(u, 0.2);

  EXPECT_GE(result.substeps, 50);
  // Per step and stage: ten roundings of each cell's share.
  EXPECT_NEAR(total(0), mass, result.substeps * 20 * round_off * mass);
  EXPECT_NEAR(total(3), energy, result.substeps * 20 * round_off * energy);
  const Euler<2> gas;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const auto i = static_cast<std::size_t>(site);
    if (shares[i] == 0) continue;
    const Euler<2>::State cell{u[4 * i], u[4 * i + 1], u[4 * i + 2], u[4 * i + 3]};
    EXPECT_GT(cell[0], 0);
    EXPECT_GT(gas.pressure(cell), 0);
    const Indices<2> at = lattice.site(site);
    const auto j = static_cast<std::size_t>(lattice.index({at[1], at[0]}));
    EXPECT_NEAR(u[4 * i], u[4 * j], 1e-11);  // 1e2 steps of twenty roundings, grown tenfold at shocks
    EXPECT_NEAR(u[4 * i + 1], u[4 * j + 2], 1e-11);
  }
}

TEST(Walls, GiveTheSameBitsForAnyNumberOfThreads) {
  const Lattice<2> lattice = test::cube<2>(40);
  std::vector<double> shares;
  const auto start = blast(lattice, shares);
  const auto advanced = [&](int num_threads) {
    auto u = start;
    Solver{
        filled(lattice, shares), Euler<2>{}, PiecewiseLinear{Minmod{}}, SspRk2{}, {.threads = {num_threads}}}
        .advance(u, 0.05);
    return u;
  };
  EXPECT_EQ(advanced(1), advanced(3));
}

TEST(OccupiedCells, RefuseSharesThatCannotBe) {
  OccupiedCells<1> cells{test::line(3, 0, 1)};
  const auto message = [&](std::vector<double> shares) {
    return test::message_of<InputError>([&] { cells.set_fill(shares); });
  };
  EXPECT_EQ(message({1, 0.5}), "OccupiedCells: 2 shares for 3 sites");
  EXPECT_EQ(message({1, 0, 1.5}), "OccupiedCells: the share of site 2 is 1.5: must lie in [0, 1]");
  EXPECT_EQ(message({std::nan(""), 0, 1}), "OccupiedCells: the share of site 0 is nan: must lie in [0, 1]");
  EXPECT_EQ(message({0, 0.5, 1}), "");
}

}  // namespace
}  // namespace scree::transport
