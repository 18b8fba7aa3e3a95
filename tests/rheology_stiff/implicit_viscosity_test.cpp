#include "bodies.hpp"

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

constexpr double density = 1000;  // [kg/m^3]

double kinetic_energy(const std::vector<double>& mass, const std::vector<double>& v) {
  const std::size_t num_components = v.size() / mass.size();
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += mass[i / num_components] * v[i] * v[i] / 2;
  return sum;
}

/// Viscosities over three decades, cell by cell [Pa s].
template <int D>
std::vector<double> rough_viscosity(const CartesianGrid<D>& grid) {
  auto mu = test::random_values(test::at(grid.cells().num_sites()), 0, 3);
  for (double& x : mu) x = std::pow(10, x);
  return mu;
}

template <class Solver>
struct ImplicitViscosities : testing::Test {};
using AllDimensions =
    testing::Types<ImplicitViscosity<1, 1>, ImplicitViscosity<1, 2>, ImplicitViscosity<1, 3>,
                   ImplicitViscosity<2, 2>, ImplicitViscosity<2, 3>, ImplicitViscosity<3, 3>>;
TYPED_TEST_SUITE(ImplicitViscosities, AllDimensions);

template <class Solver>
struct SizesOf;
template <int D_, int V_>
struct SizesOf<ImplicitViscosity<D_, V_>> {
  static constexpr int D = D_;
  static constexpr int V = V_;
};

TYPED_TEST(ImplicitViscosities, KeepMomentumToRoundOffWithoutWalls) {  // Eq. (R140)
  constexpr int V = SizesOf<TypeParam>::V;
  for (const bool is_periodic : {false, true}) {
    const auto grid = test::cube<SizesOf<TypeParam>::D>(6, is_periodic);
    const auto mass = test::full(grid, density);
    auto v = test::random_values(mass.size() * test::at(V), -1, 1);
    const auto before = v;
    TypeParam{grid, {.tolerance = 1e-3}}.advance(v, {mass}, rough_viscosity(grid), 10);
    double total = 0;
    for (const double m : mass) total += m;
    for (std::size_t k = 0; k < test::at(V); ++k) {
      double gained = 0;
      for (std::size_t i = k; i < v.size(); i += test::at(V)) {
        gained += mass[i / test::at(V)] * (v[i] - before[i]);
      }
      EXPECT_NEAR(gained, 0, 4 * static_cast<double>(mass.size()) * round_off * total);
    }
  }
}

TYPED_TEST(ImplicitViscosities, NeverGainEnergy) {
  constexpr int V = SizesOf<TypeParam>::V;
  const auto grid = test::cube<SizesOf<TypeParam>::D>(6, false);
  const auto mass = test::full(grid, density);
  TypeParam solver{grid};
  for (const double dt : {1e-6, 1e-2, 1e2, 1e6}) {
    auto v = test::random_values(mass.size() * test::at(V), -1, 1);
    const double before = kinetic_energy(mass, v);
    solver.advance(v, {mass}, rough_viscosity(grid), dt);
    // Momentum may be off by the tolerance, 1e-8 of the largest, at each node.
    EXPECT_LE(kinetic_energy(mass, v), before * (1 + 2e-8 * static_cast<double>(mass.size()))) << dt;
  }
}

TYPED_TEST(ImplicitViscosities, LeaveRigidMotionAlone) {
  constexpr int D = SizesOf<TypeParam>::D;
  constexpr int V = SizesOf<TypeParam>::V;
  const auto grid = test::cube<D>(6, false);
  const auto mass = test::full(grid, density);
  auto v = test::values_at_nodes<V>(grid, [](const Vector<D>& x) {
    Vector<V> motion = Vector<V>::Constant(2);
    if constexpr (D > 1) {
      motion[0] -= x[1];
      motion[1] += x[0];
    }
    return motion;
  });
  const auto before = v;
  TypeParam{grid}.advance(v, {mass}, std::vector<double>(test::at(grid.cells().num_sites()), 1e3), 0.1);
  EXPECT_LE(test::largest_difference(v, before), 3e-8);  // tolerance times the largest velocity
}

TYPED_TEST(ImplicitViscosities, AgreeWhateverThePreconditioner) {
  constexpr int V = SizesOf<TypeParam>::V;
  const auto grid = test::cube<SizesOf<TypeParam>::D>(7, false);
  const auto mass = test::full(grid, density);
  const auto held = test::held_floor<V>(grid);
  const auto solve = [&](ViscousPreconditioner preconditioner) {
    auto v = test::random_values(mass.size() * test::at(V), -1, 1);
    TypeParam{grid, {.preconditioner = preconditioner}}.advance(v, {mass, held}, rough_viscosity(grid), 1);
    return v;
  };
  // Each is off by the tolerance over the slowest rate of decay by this step, of order 1 + mu dt/rho.
  const auto reference = solve(ViscousPreconditioner::automatic);
  EXPECT_LE(test::largest_difference(solve(ViscousPreconditioner::jacobi), reference), 1e-7);
  EXPECT_LE(test::largest_difference(solve(ViscousPreconditioner::multigrid), reference), 1e-7);
}

TYPED_TEST(ImplicitViscosities, HaveTheSameBitsForAnyNumberOfThreads) {
  constexpr int V = SizesOf<TypeParam>::V;
  const auto grid = test::cube<SizesOf<TypeParam>::D>(6, true);
  const auto mass = test::full(grid, density);
  const auto solve = [&](int threads) {
    auto v = test::random_values(mass.size() * test::at(V), -1, 1);
    TypeParam{grid, {.threads = Threads{threads}}}.advance(v, {mass}, rough_viscosity(grid), 1);
    return v;
  };
  EXPECT_EQ(solve(1), solve(4));
}

TEST(ImplicitViscosity, MovesWithAWallThatMoves) {
  const auto grid = test::cube<2>(8, false);
  const auto mass = test::full(grid, density);
  const auto held = test::held_floor<2>(grid);
  std::vector<double> v(2 * mass.size(), 0.0);
  for (std::size_t i = 0; i < v.size(); i += 2) v[i] = held[i] != 0 ? 3 : 0;
  ImplicitViscosity<2> solver{grid};
  const std::vector<double> viscosity(64, 1e3);
  // The slowest rate is nu (pi/2)^2 = 2.5/s: per step 1/(1 + 2.5e3).
  for (int step = 0; step < 3; ++step) solver.advance(v, {mass, held}, viscosity, 1e3);
  for (std::size_t i = 0; i < v.size(); ++i) {
    EXPECT_NEAR(v[i], i % 2 == 0 ? 3 : 0, 3 * 3e-8 + std::pow(2.5e3, -3)) << i;
    if (held[i] != 0) {
      EXPECT_EQ(v[i], i % 2 == 0 ? 3 : 0);
    }
  }
}

TEST(ImplicitViscosity, LeavesAloneWhatIsNotThere) {
  const auto grid = test::cube<2>(8, false);
  auto mass = test::full(grid, density);
  std::vector<double> filled(64, 0.0);
  for (std::size_t cell = 0; cell < 32; ++cell) filled[cell] = 1;
  for (std::size_t node = 0; node < mass.size(); ++node) {
    if (node >= 45)
      mass[node] = 0;  // above the lower half
    else if (node >= 36)
      mass[node] /= 2;  // on its surface
  }
  auto v = test::random_values(2 * mass.size(), -1, 1);
  const auto before = v;
  ImplicitViscosity<2>{grid}.advance(v, {mass, {}, filled}, std::vector<double>(64, 1e3), 1);
  for (std::size_t i = 90; i < v.size(); ++i) EXPECT_EQ(v[i], before[i]);

  // The same as without the empty half.
  const CartesianGrid<2> half{grid.origin(), grid.spacing(), {8, 4}, {false, false}};
  std::vector<double> w(before.begin(), before.begin() + 90);
  ImplicitViscosity<2>{half}.advance(w, {test::full(half, density)}, std::vector<double>(32, 1e3), 1);
  v.resize(90);
  EXPECT_LE(test::largest_difference(v, w), 1e-7);
}

TEST(ImplicitViscosity, TakesALightNodeAlongWithWhatHoldsIt) {
  const CartesianGrid<1> grid{Vector<1>{0.0}, Vector<1>{0.1}, {10}, {false}};
  for (const double light : {0.0, 1e-12, 1e-3}) {
    auto mass = test::full(grid, density);
    mass.back() = light;
    std::vector<double> v(11, 1.0);
    v.back() = -5;
    ImplicitViscosity<1>{grid}.advance(v, {mass}, std::vector<double>(10, 1e3), 10);
    EXPECT_NEAR(v.back(), 1, 1e-4) << light;  // the light one's own momentum, 6 * 1e-3 of 1000 kg
  }
}

}  // namespace
}  // namespace scree::rheology
