// Reconstruction in primitive variables, and scaled down to states that can be.

#include "lines.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/laws.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace scree::transport {
namespace {

using GasState = Euler<1>::State;
const Euler<1> gas;
const PiecewiseLinear mc{Minmod{2}};

/// Density and pressure over twelve powers of ten, velocities that reach Mach ten of a warm gas.
GasState near_vacuum(std::mt19937& random) {
  std::uniform_real_distribution<double> power{-12, 0};
  std::uniform_real_distribution<double> velocity{-10, 10};
  return gas.state(std::pow(10, power(random)), Vector<1>{velocity(random)}, std::pow(10, power(random)));
}

TEST(InPrimitives, KeepsPressureAndVelocityThroughAContact) {
  const auto edges =
      InPrimitives{mc, gas}(gas.state(1, Vector<1>{0.7}, 0.9), gas.state(0.6, Vector<1>{0.7}, 0.9),
                            gas.state(0.5, Vector<1>{0.7}, 0.9));
  for (const auto& edge : {edges.low, edges.high}) {
    EXPECT_NEAR(gas.primitive(edge)[1], 0.7, 8 * round_off);  // eight operations on numbers below 4
    EXPECT_NEAR(gas.primitive(edge)[2], 0.9, 32 * round_off);
  }
  EXPECT_NEAR(edges.low[0], 0.7, 4 * round_off);  // slope: minmod(-0.8, -0.25, -0.2)
}

TEST(InPrimitives, StaysBetweenItsNeighboursInDensity) {
  std::mt19937 random{5};
  for (int trial = 0; trial < 1000; ++trial) {
    const auto below = near_vacuum(random);
    const auto here = near_vacuum(random);
    const auto above = near_vacuum(random);
    const auto edges = InPrimitives{mc, gas}(below, here, above);
    for (const auto& edge : {edges.low, edges.high}) {
      const double rounding = 4 * round_off * here[0];  // four operations; a neighbour may be far smaller
      EXPECT_GE(edge[0], std::min({below[0], here[0], above[0]}) - rounding);
      EXPECT_LE(edge[0], std::max({below[0], here[0], above[0]}) + rounding);
    }
  }
}

TEST(InPrimitives, DoesNotKeepTheMean) {  // what Admissible makes up for, Eq. (T24)
  const auto edges = InPrimitives{mc, gas}(gas.state(1, Vector<1>{-1.0}, 1), gas.state(2, Vector<1>{0.0}, 1),
                                           gas.state(3, Vector<1>{1.0}, 1));
  // Edges 1.5, -0.5 and 2.5, 0.5: momentum -0.75 and 1.25, mean 0.25 where the cell has none.
  EXPECT_NEAR(0.5 * (edges.low[1] + edges.high[1]), 0.25, 4 * round_off);
}

TEST(Admissible, ChangesNothingWhereStatesCanBe) {  // to the bit
  const auto below = gas.state(1, Vector<1>{0.1}, 1);
  const auto here = gas.state(1.1, Vector<1>{0.2}, 0.9);
  const auto above = gas.state(1.3, Vector<1>{0.25}, 0.7);
  const auto plain = mc(below, here, above);
  const auto checked = Admissible{mc, gas}(below, here, above);
  EXPECT_EQ(plain.low, checked.low);
  EXPECT_EQ(plain.high, checked.high);
}

TEST(Admissible, ScalesBothFacesByOneFactor) {  // Eq. (T23): the mean is kept, and the direction
  const auto below = gas.state(1, Vector<1>{-3.0}, 0.4);
  const auto here = gas.state(0.5, Vector<1>{0.0}, 0.02);
  const auto above = gas.state(0.1, Vector<1>{3.0}, 0.4);
  const auto plain = mc(below, here, above);
  ASSERT_FALSE(gas.is_admissible(plain.low) && gas.is_admissible(plain.high));

  const auto checked = Admissible{mc, gas}(below, here, above);

  EXPECT_TRUE(gas.is_admissible(checked.low) && gas.is_admissible(checked.high));
  const double part = (checked.high[0] - here[0]) / (plain.high[0] - here[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(0.5 * (checked.low[k] + checked.high[k]), here[k], 4 * round_off);
    EXPECT_NEAR(checked.high[k] - here[k], part * (plain.high[k] - here[k]), 8 * round_off);
  }
}

TEST(Admissible, MakesFacesAdmissibleForAnyCells) {
  std::mt19937 random{17};
  const Admissible conserved{mc, gas};
  const Admissible primitive{InPrimitives{mc, gas}, gas};
  for (int trial = 0; trial < 10000; ++trial) {
    const auto below = near_vacuum(random);
    const auto here = near_vacuum(random);
    const auto above = near_vacuum(random);
    if (!gas.is_admissible(here)) continue;  // a cold, fast gas has lost its pressure to rounding
    for (const auto& edges : {conserved(below, here, above), primitive(below, here, above)}) {
      EXPECT_TRUE(gas.is_admissible(edges.low));
      EXPECT_TRUE(gas.is_admissible(edges.high));
    }
  }
}

/// Sixty cells of random gas; pressures of at least 1e-6 of the energy of motion, which rounding leaves.
std::vector<double> random_gas(std::mt19937& random) {
  std::uniform_real_distribution<double> power{-6, 0};
  std::uniform_real_distribution<double> velocity{-1, 1};
  std::vector<double> u;
  for (int i = 0; i < 60; ++i) {
    const double density = std::pow(10, power(random));
    const double pressure = density * std::pow(10, power(random));
    const auto cell = gas.state(density, Vector<1>{velocity(random)}, pressure);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  return u;
}

using Line = PiecewiseLinear<Minmod>;
/// Any of those that are tried: a solver of each flux is compiled once for all.
using Tried = AnyReconstruction<PiecewiseConstant, Line, Admissible<Line, Euler<1>>,
                                Admissible<InPrimitives<Line, Euler<1>>, Euler<1>>>;

/// Steps of near-vacuum data at the promised CFL number. @return the first failure; empty if there is none
template <class F>
std::string march(const Tried& reconstruction, unsigned seed) {
  std::mt19937 random{seed};
  auto u = random_gas(random);
  Solver<Cartesian<1>, Euler<1>, Tried, F> solver{Cartesian<1>{test::line(60, 0, 1)},
                                                  gas,
                                                  reconstruction,
                                                  ForwardEuler{},
                                                  {.cfl = std::min(0.5, reconstruction.promised_cfl())}};
  return test::message_of<RunError>([&] {
    for (int step = 0; step < 20; ++step) solver.advance(u, 0.999 * solver.stable_time_step(u));
  });
}

template <class F>
class Positivity : public ::testing::Test {};
using Fluxes = ::testing::Types<KurganovTadmor, KurganovNoellePetrova>;
TYPED_TEST_SUITE(Positivity, Fluxes);

TYPED_TEST(Positivity, OfMeansIsKeptAtThePromisedCfl) {  // Eqs. (T17), (T24): each solver checks every state
  for (unsigned seed = 1; seed <= 50; ++seed) {
    EXPECT_EQ(march<TypeParam>({PiecewiseConstant{}}, seed), "") << seed;
    EXPECT_EQ(march<TypeParam>({Admissible{mc, gas}}, seed), "") << seed;
    EXPECT_EQ(march<TypeParam>({Admissible{InPrimitives{mc, gas}, gas}}, seed), "") << seed;
  }
}

TYPED_TEST(Positivity, IsLostWithoutScaling) {
  int failures = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) failures += march<TypeParam>({mc}, seed).empty() ? 0 : 1;
  EXPECT_EQ(failures, 50);
}

TEST(Admissible, PromisesHalfOfWhatStandsBehindTheFaces) {  // Eq. (T24)
  EXPECT_DOUBLE_EQ((Admissible{mc, gas}.promised_cfl()), 0.5);
  EXPECT_DOUBLE_EQ((Admissible{InPrimitives{mc, gas}, gas}.promised_cfl()), 0.4);
  EXPECT_DOUBLE_EQ((InPrimitives{mc, gas}.promised_cfl()), 0.5);
}

TEST(Admissible, ConservesToRoundOff) {
  std::mt19937 random{23};
  auto u = random_gas(random);
  const auto totals = [&] {
    std::array<double, 3> sums{};
    for (std::size_t i = 0; i < u.size(); ++i) sums[i % 3] += u[i] / 60;
    return sums;
  };
  const auto before = totals();
  Solver solver{Cartesian<1>{test::line(60, 0, 1)}, gas};

  solver.advance(u, 0.5);

  // A few hundred steps of sixty roundings of densities and energies below 1.
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(totals()[k], before[k], 500 * 60 * round_off);
}

/// Error of a density wave 1 + sin(2 pi x)/5 that a wind carries round, by the usual reconstruction.
double wave_error(Index n) {
  const Lattice<1> lattice = test::line(n, 0, 1);
  const auto density =
      test::averages(lattice, [](double x) { return x - std::cos(2 * test::pi * x) / (10 * test::pi); });
  std::vector<double> u;
  for (const double value : density) {
    const auto cell = gas.state(value, Vector<1>{1.0}, 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  Solver{Cartesian<1>{lattice}, gas}.advance(u, 1);
  double sum = 0;
  for (std::size_t i = 0; i < density.size(); ++i)
    sum += std::abs(u[3 * i] - density[i]) * lattice.spacing[0];
  return sum;
}

TEST(UsualReconstruction, IsSecondOrderForAGas) {  // L1 >= 1.85, as for every limited scheme
  EXPECT_GE(std::log2(wave_error(80) / wave_error(320)) / 2, 1.85);
}

TEST(UsualFlux, IsCentralUpwindForSystemsThatBoundTheirWaves) {
  static_assert(std::is_same_v<UsualFlux<Euler<2>, 2>, KurganovNoellePetrova>);
  static_assert(std::is_same_v<UsualFlux<Burgers, 2>, KurganovTadmor>);
  static_assert(
      std::is_same_v<decltype(Solver{Cartesian<1>{test::line(4, 0, 1)}, gas}),
                     Solver<Cartesian<1>, Euler<1>, UsualReconstruction<Euler<1>>, KurganovNoellePetrova>>);
}

TEST(UsualReconstruction, FitsTheLaw) {
  static_assert(std::is_same_v<UsualReconstruction<Burgers>, Line>);
  static_assert(
      std::is_same_v<UsualReconstruction<Euler<2>>, Admissible<InPrimitives<Line, Euler<2>>, Euler<2>>>);
  EXPECT_EQ(usual_reconstruction(Burgers{}).limiter.sharpness(), 1.3);
}

/// Two parts of a whole that drift apart.
struct Parts {
  static constexpr int num_components = 2;
  static constexpr bool keeps_sum = true;
  using State = std::array<double, 2>;
  State flux(const State& u, const Vector<1>& normal) const noexcept {
    const double drift = normal[0] * u[0] * u[1];
    return {drift, -drift};
  }
  double max_speed(const State&, const State&, const Vector<1>&) const noexcept { return 1; }
};

TEST(UsualReconstruction, KeepsSums) {
  static_assert(std::is_same_v<UsualReconstruction<Parts>, PiecewiseLinearCommon<Minmod>>);
  std::vector<double> u;
  for (int i = 0; i < 40; ++i) {
    const double part = 0.5 + 0.4 * std::sin(0.7 * i * i);
    u.insert(u.end(), {part, 1 - part});
  }
  Solver{Cartesian<1>{test::line(40, 0, 1)}, Parts{}}.advance(u, 0.5);
  for (std::size_t i = 0; i < u.size(); i += 2)
    EXPECT_NEAR(u[i] + u[i + 1], 1, 1e-13);  // 50 steps of rounding
}

TEST(Solver, NamesTheSiteOfAStateThatCannotBe) {
  const Lattice<2> lattice = test::cube<2>(4);
  const Euler<2> law;
  std::vector<double> u;
  for (int i = 0; i < 16; ++i) {
    const auto cell = law.state(1, Vector<2>{0, 0}, 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  const std::size_t site = 4 * 9;
  Solver solver{Cartesian<2>{lattice}, law};
  const auto message = [&] { return test::message_of<InputError>([&] { solver.advance(u, 1); }); };

  u[site + 3] = -0.25;
  EXPECT_EQ(
      message(),
      "transport: the state (1, 0, 0, -0.25) is not admissible, at site (1, 2), position (0.375, 0.625) m");
  u[site] = std::nan("");
  EXPECT_EQ(
      message(),
      "transport: the state (nan, 0, 0, -0.25) is not admissible, at site (1, 2), position (0.375, 0.625) m");
  EXPECT_EQ(test::message_of<InputError>([&] { (void)solver.stable_time_step(u); }), message());
}

/// A gas whose energy is drained by a source.
TEST(Solver, NamesAStateThatARunHasMadeImpossible) {
  const auto drained = with_source(gas, [](const GasState&, const Vector<1>& x, double) {
    return GasState{0, 0, x[0] > 0.5 && x[0] < 0.6 ? -100.0 : 0.0};
  });
  std::vector<double> u;
  for (int i = 0; i < 10; ++i) u.insert(u.end(), {1, 0, 2.5});
  const auto before = u;
  Solver solver{Cartesian<1>{test::line(10, 0, 1)}, drained};

  const auto message = test::message_of<RunError>([&] { solver.advance(u, 1); });

  EXPECT_EQ(message.substr(0, 27), "transport: the state (1, 0,");
  EXPECT_EQ(message.substr(message.find(" is not")), " is not admissible, at site (5), position (0.55) m");
  EXPECT_EQ(u, before);
}

}  // namespace
}  // namespace scree::transport
