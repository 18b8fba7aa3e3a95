#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/boundaries.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <numeric>

namespace scree::transport {
namespace {

double mass(const std::vector<double>& u, double dx) {
  return dx * std::accumulate(u.begin(), u.end(), 0.0);
}

template <class B>
class EveryBoundary : public ::testing::Test {};
using Boundaries = test::Types<BoundaryList<1, 1>>;
TYPED_TEST_SUITE(EveryBoundary, Boundaries);

TYPED_TEST(EveryBoundary, ClosesTheBudget) {  // what is missing went out through the ends, to round-off
  const Lattice<1> lattice = test::line(50, 0, 1, false);
  const Burgers law;
  using Rates = SemiDiscrete<Cartesian<1>, Burgers, PiecewiseLinear<Minmod>, KurganovTadmor>;
  const TypeParam boundary{};
  Rates rates{{lattice, law, {}, {}, {{{boundary, boundary}}}}, 0.5, {}};
  const auto u = test::averages(lattice, [](double x) { return 0.3 * x - std::cos(5 * x); });
  Fields<1> fields{50};
  Fields<1> result{50};
  fields.gather(u, {});

  rates(fields, result, 0);

  const auto out = [&](double inside, double sign) {
    return boundary
        .flux(KurganovTadmor{}, law, {inside}, BoundaryFace<1>{Vector<1>{0.5 + sign / 2}, Vector<1>{sign}, 0})
        .value[0];
  };
  double sum = 0;
  for (const double rate : result.all()) sum += lattice.spacing[0] * rate;
  // Fifty differences of fluxes below 20, each rounded.
  EXPECT_NEAR(sum, -out(u.front(), -1) - out(u.back(), 1), 50 * 20 * round_off);
}

TEST(ZeroFlux, KeepsTheMass) {
  const Lattice<1> lattice = test::line(100, 0, 1, false);
  auto u = test::square_and_bump(100);
  const double before = mass(u, lattice.spacing[0]);
  Solver solver{Cartesian<1>{lattice}, Burgers{}, PiecewiseLinear{Minmod{}}};

  solver.advance(u, 2);

  EXPECT_NEAR(mass(u, lattice.spacing[0]), before, 1e-13 * before);  // 300 steps of 100 roundings, at random
}

TEST(Outflow, LetsAWaveLeave) {
  const Lattice<1> lattice = test::line(100, 0, 1, false);
  auto u = test::square_and_bump(100);
  Solver solver{Cartesian<1>{lattice},
                Advection<1>{Vector<1>{1.0}},
                PiecewiseLinear{Minmod{}},
                SspRk2{},
                {.boundaries = {{{Outflow{}, Outflow{}}}}}};

  solver.advance(u, 3);

  for (const double value : u) EXPECT_NEAR(value, 0, 1e-10);  // tail of the smeared wave
}

TEST(Prescribed, SendsItsStateIn) {
  const Lattice<1> lattice = test::line(100, 0, 1, false);
  std::vector<double> u(100, 0.0);
  Solver solver{Cartesian<1>{lattice},
                Advection<1>{Vector<1>{1.0}},
                PiecewiseLinear{Minmod{}},
                SspRk2{},
                {.boundaries = {{{Prescribed<1>{{0.7}}, Outflow{}}}}}};

  solver.advance(u, 0.5);
  EXPECT_NEAR(mass(u, lattice.spacing[0]), 0.7 * 0.5, 1e-12);  // nothing has left yet but the tail
  solver.advance(u, 2.5);
  for (const double value : u) EXPECT_NEAR(value, 0.7, 1e-10);
}

TEST(UserGiven, SendsInWhatItsFunctionSaysAtTheTimeOfEachStage) {  // advection of sin(t) from x = 0
  const auto error = [](Index n, double start) {
    const Lattice<1> lattice = test::line(n, 0, 1, false);
    const auto exact = [&](double time) {
      return test::averages(lattice, [&](double x) { return std::cos(time - x); });  // of sin(time - x)
    };
    auto u = exact(start);
    const UserGiven<1, 1> inflow{[](const std::array<double, 1>& /*inside*/, const BoundaryFace<1>& face) {
      return std::array<double, 1>{std::sin(face.time - face.centre[0])};
    }};
    Solver solver{Cartesian<1>{lattice},
                  Advection<1>{Vector<1>{1.0}},
                  PiecewiseLinear{test::Centred{}},
                  SspRk2{},
                  {.cfl = 0.4, .boundaries = {{{inflow, Outflow{}}}}, .start_time = start}};
    solver.advance(u, 0.5);
    solver.advance(u, 0.5);
    EXPECT_DOUBLE_EQ(solver.time(), start + 1);
    return test::l1(u, exact(start + 1), lattice.spacing[0]);
  };
  // Second order inside; the first cell has no slope: one order less there, in one cell, so two in L1.
  EXPECT_GE(std::log2(error(100, 3) / error(200, 3)), 1.85);
}

TEST(UserGiven, IsAnOpenEndUntilItIsGiven) {
  const std::array<double, 1> inside{0.4};
  const BoundaryFace<1> face{Vector<1>{1.0}, Vector<1>{1.0}, 0};
  const UserGiven<1, 1> boundary;
  EXPECT_EQ(boundary.flux(KurganovTadmor{}, Burgers{}, inside, face).value,
            Outflow{}.flux(KurganovTadmor{}, Burgers{}, inside, face).value);
}

TEST(Reflecting, ClosesForALawWithoutAMirrorImage) {
  const BoundaryFace<1> face{Vector<1>{1.0}, Vector<1>{1.0}, 0};
  EXPECT_EQ(Reflecting{}.flux(KurganovTadmor{}, Burgers{}, {0.4}, face).value[0], 0);
}

TEST(Periodicity, IsAPropertyOfTheLattice) {  // a shift by any number of cells changes nothing
  const Lattice<1> lattice = test::line(100, 0, 1);
  auto u = test::square_and_bump(100);
  auto shifted = u;
  std::rotate(shifted.begin(), shifted.begin() + 37, shifted.end());
  Solver solver{Cartesian<1>{lattice}, Burgers{}, PiecewiseLinear{VanLeer{}}};

  solver.advance(u, 0.3);
  solver.advance(shifted, 0.3);

  std::rotate(u.begin(), u.begin() + 37, u.end());
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], shifted[i], 1e-14) << i;
}

}  // namespace
}  // namespace scree::transport
