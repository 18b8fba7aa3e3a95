#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <cmath>
#include <random>

namespace scree::transport {
namespace {

/// Segregation of two fractions by a driver of its own at each face: f = B (phi (1 - phi), -phi (1 - phi)).
struct TwoClasses {
  struct AtFace {
    static constexpr int num_components = 2;
    using State = std::array<double, 2>;
    double driver;

    template <int D>
    State flux(const State& phi, const Vector<D>& normal) const noexcept {
      const double exchanged = driver * sum(normal) * phi[0] * phi[1];
      return {exchanged, -exchanged};
    }
    template <int D>
    double max_speed(const State& left, const State& right, const Vector<D>& /*normal*/) const noexcept {
      return std::abs(driver) * larger(std::abs(1 - 2 * left[0]), std::abs(1 - 2 * right[0]));
    }
  };

  const double* potential;  // one per site
  AtFace at(const Face& face) const noexcept {
    return {(potential[face.neighbour] - potential[face.owner]) / face.distance};
  }
};

/// A box, its filling, and two fractions in it.
template <int D>
struct Filling {
  Lattice<D> lattice;
  std::vector<double> masses;
  std::vector<double> potential;
  std::vector<double> phi;

  double mass_of_class(std::size_t k) const {
    double total = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      if (masses[i] > 0) total += masses[i] * phi[2 * i + k];
    }
    return total;
  }
};

constexpr double untouched = -7;

/// A third of the sites empty, a third of them full, the rest anything, down to slivers of 1e-3.
template <int D>
Filling<D> random_filling(Lattice<D> lattice, unsigned seed) {
  lattice.is_periodic.fill(false);
  Filling<D> filling{lattice, {}, {}, {}};
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> draw;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const double kind = draw(random);
    const double part = kind < 1.0 / 3 ? 0 : kind < 2.0 / 3 ? 1 : std::pow(10, -3 * draw(random));
    filling.masses.push_back(part * lattice.volume(lattice.site(site)));
    filling.potential.push_back(draw(random));
    const double phi = draw(random) < 0.5 ? 0 : draw(random);
    filling.phi.push_back(part > 0 ? phi : untouched);
    filling.phi.push_back(part > 0 ? 1 - phi : std::nan(""));
  }
  return filling;
}

template <int D, class R>
auto solver_of(const Filling<D>& filling, const R& reconstruction, Threads threads = {}) {
  OccupiedCells<D> cells{filling.lattice};
  cells.set_masses(filling.masses);
  return Solver{cells,
                TwoClasses{filling.potential.data()},
                reconstruction,
                SspRk2{},
                {.cfl = 0.5, .threads = threads}};
}

template <class L>
class EveryLimiterOnOccupiedCells : public ::testing::Test {};
TYPED_TEST_SUITE(EveryLimiterOnOccupiedCells, test::Types<LimiterList>);

TYPED_TEST(EveryLimiterOnOccupiedCells, KeepsBoundsSumsAndClassMasses) {  // Eqs. (T6), (T9), (T10)
  auto filling = random_filling(test::cube<2>(24), 3);
  const double before[] = {filling.mass_of_class(0), filling.mass_of_class(1)};
  auto solver = solver_of(filling, PiecewiseLinearCommon{TypeParam{}, 1.0});

  const Advance result = solver.advance(filling.phi, 0.2);

  EXPECT_GE(result.substeps, 10);
  for (std::size_t i = 0; i < filling.masses.size(); ++i) {
    const double phi[] = {filling.phi[2 * i], filling.phi[2 * i + 1]};
    if (filling.masses[i] == 0) {
      EXPECT_EQ(phi[0], untouched);
      EXPECT_TRUE(std::isnan(phi[1]));
      continue;
    }
    for (const double part : phi) {
      EXPECT_GE(part, -1e-14);
      EXPECT_LE(part, 1 + 1e-14);
    }
    EXPECT_NEAR(phi[0] + phi[1], 1, 1e-13);
  }
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(filling.mass_of_class(k), before[k], 1e-13 * before[k]);
}

TEST(OccupiedCells, AreTheSameInThreeDimensions) {
  auto filling = random_filling(test::cube<3>(9), 5);
  const double before = filling.mass_of_class(0);
  solver_of(filling, PiecewiseLinearCommon{Minmod{}, 1.0}).advance(filling.phi, 0.1);
  EXPECT_NEAR(filling.mass_of_class(0), before, 1e-13 * before);
}

TEST(OccupiedCells, LetASliverKeepTheStepOfFullCells) {  // rho_f = min(rho_i, rho_j)
  Filling<1> filling{test::line(50, 0, 1, false), std::vector<double>(50, 0.02), {}, {}};
  for (int i = 0; i < 50; ++i) {
    filling.potential.push_back(i * 0.02);
    filling.phi.push_back(0.5);
    filling.phi.push_back(0.5);
  }
  filling.phi[2] = 0.1;  // so that something moves
  filling.phi[3] = 0.9;
  const double full = solver_of(filling, PiecewiseLinearCommon{Minmod{}}).stable_time_step(filling.phi);
  for (const int place : {0, 17, 30, 49}) filling.masses[static_cast<std::size_t>(place)] = 1e-3 * 0.02;

  auto solver = solver_of(filling, PiecewiseLinearCommon{Minmod{}});
  EXPECT_GE(solver.stable_time_step(filling.phi), full * (1 - 8 * round_off));
  const double before = filling.mass_of_class(0);
  solver.advance(filling.phi, 10);

  for (const double part : filling.phi) {
    EXPECT_GE(part, -1e-14);
    EXPECT_LE(part, 1 + 1e-14);
  }
  EXPECT_NEAR(filling.mass_of_class(0), before, 1e-13 * before);
}

TEST(OccupiedCells, SeparateAcrossEmptyOnes) {  // two heaps with a gap know nothing of each other
  Filling<1> filling{test::line(30, 0, 1, false), std::vector<double>(30, 1.0), {}, {}};
  for (int i = 0; i < 30; ++i) {
    filling.potential.push_back(std::sin(i));
    filling.phi.push_back(i < 15 ? 0.3 : 0.5 + 0.4 * std::cos(i));
    filling.phi.push_back(1 - filling.phi.back());
  }
  filling.masses[15] = 0;
  Filling<1> other = filling;
  for (std::size_t i = 16; i < 30; ++i) {
    other.phi[2 * i] = 0.2;
    other.phi[2 * i + 1] = 0.8;
    other.masses[i] = 0.4;
  }

  solver_of(filling, PiecewiseLinearCommon{Minmod{}}).advance(filling.phi, 1e-4);  // one step in both
  solver_of(other, PiecewiseLinearCommon{Minmod{}}).advance(other.phi, 1e-4);

  for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(filling.phi[i], other.phi[i]);
}

TEST(OccupiedCells, EqualThePlainLatticeWhenAllAreFull) {
  Lattice<2> lattice = test::cube<2>(20);
  lattice.is_periodic = {false, true};
  std::vector<double> masses;
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    masses.push_back(2 * lattice.volume(lattice.site(site)));
    u.push_back(std::sin(0.3 * static_cast<double>(site)));
  }
  auto v = u;
  OccupiedCells<2> cells{lattice};
  cells.set_masses(masses);

  Solver{cells, Burgers{}, PiecewiseLinear{Minmod{}}}.advance(u, 0.1);
  Solver{Cartesian<2>{lattice}, Burgers{}, PiecewiseLinear{Minmod{}}}.advance(v, 0.1);

  EXPECT_LE(test::linf(u, v), 1e-14);
}

/// Advection by a mass flux that leaves no cell fuller: rho v = curl psi, psi at the corners of 12 x 12
/// cells.
struct Swirl {
  struct AtFace {
    static constexpr int num_components = 1;
    using State = std::array<double, 1>;
    double velocity;
    State flux(const State& u, const Vector<2>& normal) const noexcept {
      return {velocity * sum(normal) * u[0]};
    }
    double max_speed(const State&, const State&, const Vector<2>&) const noexcept {
      return std::abs(velocity);
    }
  };
  const double* masses;
  const double* psi;  // at the upper corner of each site
  Lattice<2> lattice;

  AtFace at(const Face& face) const noexcept {
    const Indices<2> site = lattice.site(face.owner);
    const auto corner = [&](Index i, Index j) { return psi[lattice.index({(i + 12) % 12, (j + 12) % 12})]; };
    const double across = corner(site[0], site[1]);
    const double jump =
        face.axis == 0 ? across - corner(site[0], site[1] - 1) : corner(site[0] - 1, site[1]) - across;
    const double density = std::min(masses[face.owner], masses[face.neighbour]) / lattice.spacing.prod();
    return {jump / (lattice.spacing[0] * density)};
  }
};

TEST(OccupiedCells, KeepAUniformStreamUniform) {
  const Lattice<2> lattice = test::cube<2>(12);
  std::mt19937 random{17};
  std::uniform_real_distribution<double> draw{0.1, 1.0};
  std::vector<double> masses;
  std::vector<double> psi;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    masses.push_back(draw(random) * lattice.spacing.prod());
    psi.push_back(draw(random));
  }
  std::vector<double> u(masses.size(), 0.3);
  OccupiedCells<2> cells{lattice};
  cells.set_masses(masses);

  Solver solver{cells, Swirl{masses.data(), psi.data(), lattice}, PiecewiseLinear{Minmod{2}}};
  const Advance result = solver.advance(u, 0.05);

  EXPECT_GE(result.substeps, 5);
  for (const double value : u) EXPECT_NEAR(value, 0.3, 1e-13);  // some 100 steps of four cancelling fluxes
}

TEST(OccupiedCells, LoseMassWithoutTheirWeights) {  // the balance per volume, on a half filled column
  auto filling = random_filling(test::cube<1>(50), 23);
  const double before = filling.mass_of_class(0);
  Filling<1> unweighted = filling;
  for (double& mass : unweighted.masses) mass = mass > 0 ? 0.02 : 0;

  solver_of(filling, PiecewiseLinearCommon{Minmod{}}).advance(filling.phi, 0.05);
  solver_of(unweighted, PiecewiseLinearCommon{Minmod{}}).advance(unweighted.phi, 0.05);
  unweighted.masses = filling.masses;

  EXPECT_NEAR(filling.mass_of_class(0), before, 1e-13 * before);
  EXPECT_GE(std::abs(unweighted.mass_of_class(0) - before), 1e-3 * before);
}

TEST(OccupiedCells, RefuseMassesThatCannotBe) {
  OccupiedCells<1> cells{test::line(3, 0, 1)};
  const auto message = [&](std::vector<double> masses) {
    return test::message_of<InputError>([&] { cells.set_masses(masses); });
  };
  EXPECT_EQ(message({1, 2}), "OccupiedCells: 2 masses for 3 sites");
  EXPECT_EQ(message({1, -0.5, 2}),
            "OccupiedCells: the mass of site 1 is -0.5 kg: must be zero or positive, and finite");
  EXPECT_EQ(message({1, 2, std::nan("")}),
            "OccupiedCells: the mass of site 2 is nan kg: must be zero or positive, and finite");
}

}  // namespace
}  // namespace scree::transport
