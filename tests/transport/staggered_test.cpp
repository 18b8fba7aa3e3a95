#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/staggered.hpp>

#include <gtest/gtest.h>

#include <random>

namespace scree::transport {
namespace {

using test::Centred;
using test::pi;

template <int D>
double centred_error(
    Index n) {  // sin(2 pi sum x) carried along all axes for a tenth of a period, dt = 0.2 dx
  const Lattice<D> lattice = test::cube<D>(n);
  const double average = std::pow(std::sin(pi * lattice.spacing[0]) / (pi * lattice.spacing[0]), D);
  const auto wave = [&](double time) {
    std::vector<double> u;
    for (Index site = 0; site < lattice.num_sites(); ++site) {
      u.push_back(average * std::sin(2 * pi * (lattice.position(lattice.site(site)).sum() - D * time)));
    }
    return u;
  };
  auto u = wave(0);
  StaggeredSolver solver{lattice, Advection<D>{Vector<D>::Ones()}, Centred{}, {.cfl = 0.2}};
  solver.advance(u, 0.1);
  return test::linf(u, wave(0.1));
}

TEST(Staggered, IsSecondOrderInEveryDimension) {
  // Waves of 25 cells and more: the next term is (2 pi/25)^2 = 6 % of the first at most, which is 0.09 in
  // log2.
  EXPECT_NEAR(std::log2(centred_error<1>(64) / centred_error<1>(128)), 2, 0.09);
  EXPECT_NEAR(std::log2(centred_error<2>(64) / centred_error<2>(128)), 2, 0.09);
  EXPECT_NEAR(std::log2(centred_error<3>(25) / centred_error<3>(50)), 2, 0.09);
}

/// A line of 70 cells, laid along one axis of a box whose other axes have three.
template <int D>
std::vector<double> along(int axis, bool is_periodic) {
  Lattice<D> lattice = test::cube<D>(3);
  lattice.count[static_cast<std::size_t>(axis)] = 70;
  lattice.is_periodic[static_cast<std::size_t>(axis)] = is_periodic;
  lattice.spacing = Vector<D>::Constant(1.0 / 70);
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const auto i = static_cast<double>(lattice.site(site)[static_cast<std::size_t>(axis)]);
    u.push_back(std::tanh(3 * std::sin(2 * pi * i / 70)));
  }
  Vector<D> velocity = Vector<D>::Zero();
  velocity[axis] = 0.8;
  StaggeredSolver{lattice, Advection<D>{velocity}, Minmod{}, {.cfl = 0.3}}.advance(u, 0.3);
  std::vector<double> line;
  for (Index i = 0; i < 70; ++i) line.push_back(u[static_cast<std::size_t>(i * lattice.stride(axis))]);
  return line;
}

TEST(Staggered, IsTheSameAlongEveryAxisInEveryDimension) {
  for (const bool is_periodic : {true, false}) {
    const auto line = along<1>(0, is_periodic);
    for (int axis = 0; axis < 2; ++axis) EXPECT_LE(test::linf(along<2>(axis, is_periodic), line), 1e-14);
    for (int axis = 0; axis < 3; ++axis) EXPECT_LE(test::linf(along<3>(axis, is_periodic), line), 1e-14);
  }
}

/// Two waves along each axis, sharpened.
template <int D>
std::vector<double> pattern(const Lattice<D>& lattice) {
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<D> x = lattice.position(lattice.site(site));
    double value = 0;
    for (int axis = 0; axis < D; ++axis) value += std::tanh(3 * std::sin(2 * pi * (x[axis] + 0.1 * axis)));
    u.push_back(value);
  }
  return u;
}

template <int D>
std::vector<double> burgers(const Lattice<D>& lattice, Threads threads) {
  auto u = pattern(lattice);
  StaggeredSolver{lattice, Burgers{}, VanLeer{}, {.cfl = 0.3, .threads = threads}}.advance(u, 0.05);
  return u;
}

TEST(Staggered, HasTheSameBitsForAnyNumberOfThreads) {
  Lattice<2> plane = test::cube<2>(70);  // two tiles of a row
  plane.count = {70, 23};
  plane.is_periodic = {false, true};
  EXPECT_EQ(burgers(plane, {1}), burgers(plane, {2}));
  EXPECT_EQ(burgers(plane, {1}), burgers(plane, {5}));
  Lattice<3> box = test::cube<3>(11);
  box.is_periodic = {true, false, true};
  EXPECT_EQ(burgers(box, {1}), burgers(box, {2}));
  EXPECT_EQ(burgers(box, {1}), burgers(box, {64}));
}

TEST(Staggered, TreatsBothAxesAlike) {  // data mirrored in x = y stay so, to the order of the sums
  for (const bool is_periodic : {true, false}) {
    Lattice<2> lattice = test::cube<2>(70);
    lattice.is_periodic.fill(is_periodic);
    std::vector<double> u;
    for (Index site = 0; site < lattice.num_sites(); ++site) {
      const Vector<2> x = lattice.position(lattice.site(site));
      u.push_back(std::sin(2 * pi * (x[0] + x[1])) + std::cos(2 * pi * (x[0] - x[1])));
    }
    StaggeredSolver{lattice, Burgers{}, Minmod{}, {.cfl = 0.4}}.advance(u, 0.1);
    for (Index i = 0; i < 70; ++i) {
      for (Index j = 0; j < i; ++j) {
        const double one = u[static_cast<std::size_t>(lattice.index({i, j}))];
        const double other = u[static_cast<std::size_t>(lattice.index({j, i}))];
        EXPECT_NEAR(one, other, 1e-13);
      }
    }
  }
}

/// Density, momentum and energy of a gas that is uneven and moves.
template <int D>
std::vector<double> gas(const Lattice<D>& lattice) {
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<D> x = lattice.position(lattice.site(site));
    const double density = 1.2 + std::sin(2 * pi * x.sum());
    u.push_back(density);
    for (int axis = 0; axis < D; ++axis) u.push_back(density * 0.5 * std::cos(2 * pi * x[axis]));
    u.push_back(3 + density);
  }
  return u;
}

template <int D>
std::array<double, static_cast<std::size_t>(D) + 2> totals(const std::vector<double>& u) {
  std::array<double, static_cast<std::size_t>(D) + 2> sum{};
  for (std::size_t i = 0; i < u.size(); ++i) sum[i % sum.size()] += u[i];
  return sum;
}

template <int D>
void expect_balance(Index n, bool is_periodic) {
  Lattice<D> lattice = test::cube<D>(n);
  lattice.is_periodic.fill(is_periodic);
  BoxBoundaries<D, D + 2> walls;
  for (auto& axis : walls) axis.fill(Reflecting{});
  auto u = gas(lattice);
  const auto before = totals<D>(u);

  const Advance done =
      StaggeredSolver{lattice, Euler<D>{}, Minmod{}, {.cfl = 0.3, .boundaries = walls}}.advance(u, 0.2);

  const auto after = totals<D>(u);
  // Each step rounds each state some 2^D x 4 times; signs vary, the bound is for all of one sign.
  const double rounding = done.substeps * (4 << D) * round_off * before[D + 1];
  EXPECT_NEAR(after[0], before[0], rounding);
  EXPECT_NEAR(after[D + 1], before[D + 1], rounding);
  if (!is_periodic) return;  // walls push
  for (std::size_t axis = 1; axis <= D; ++axis) EXPECT_NEAR(after[axis], before[axis], rounding);
}

TEST(Staggered, ConservesToRoundOffWithPeriodicAndReflectingEnds) {
  for (const bool is_periodic : {true, false}) {
    expect_balance<1>(67, is_periodic);
    expect_balance<2>(23, is_periodic);
    expect_balance<3>(9, is_periodic);
  }
}

TEST(Staggered, KeepsUniformFlow) {  // through open ends, with the state outside given or not
  Lattice<3> lattice = test::cube<3>(7);
  lattice.is_periodic = {false, true, false};
  const std::array<double, 5> state{1.1, 0.3, -0.2, 0.1, 2.5};
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) u.insert(u.end(), state.begin(), state.end());
  BoxBoundaries<3, 5> ends;
  ends[0] = {Prescribed<5>{state}, Outflow{}};
  ends[2] = {UserGiven<3, 5>{}, Prescribed<5>{state}};

  const auto done =
      StaggeredSolver{lattice, Euler<3>{}, Minmod{2}, {.cfl = 0.3, .boundaries = ends}}.advance(u, 0.2);

  for (std::size_t i = 0; i < u.size(); ++i) {
    EXPECT_NEAR(u[i], state[i % 5], done.substeps * 32 * round_off * 2.5);  // 8 pieces x 4 terms a step
  }
}

TEST(Staggered, TakesInWhatAnEndSends) {  // at half time: the mean of an inflow that grows with time is exact
  const Lattice<1> lattice = test::line(40, 0, 1, false);
  std::vector<double> u(40, 0.0);
  BoxBoundaries<1, 1> ends;
  const UserGiven<1, 1> inflow{[](const auto& /*inside*/, const BoundaryFace<1>& face) {
    EXPECT_EQ(face.centre[0], 0);
    return std::array<double, 1>{face.time};
  }};
  ends[0] = {inflow, Outflow{}};
  StaggeredSolver solver{lattice, Advection<1>{Vector<1>{1.0}}, Minmod{}, {.cfl = 0.3, .boundaries = ends}};

  solver.advance(u, 0.5);

  double content = 0;
  for (const double value : u) content += value / 40;
  EXPECT_NEAR(content, 0.5 * 0.5 / 2, 1000 * round_off);  // some hundred steps of some ten roundings
  EXPECT_EQ(solver.time(), 0.5);
}

template <class L>
class StaggeredWith : public ::testing::Test {};
TYPED_TEST_SUITE(StaggeredWith, test::Types<LimiterList>);

struct Variation {
  double rise;     ///< largest of total variation in a pair of steps [-]
  double outside;  ///< how far the bounds of the start were left [-]
};

template <int D, class Law, class L>
Variation run(const Lattice<D>& lattice, std::vector<double> u, const Law& law, const L& limiter,
              double cfl) {
  StaggeredSolver solver{lattice, law, limiter, {.cfl = cfl}};
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  const double floor = *low;
  const double ceiling = *high;
  Variation worst{0, 0};
  for (int pair = 0; pair < 150; ++pair) {
    const double before = test::total_variation(u);
    solver.advance(u, 2 * solver.stable_time_step(u));
    worst.rise = std::max(worst.rise, test::total_variation(u) - before);
    for (const double value : u) worst.outside = std::max({worst.outside, floor - value, value - ceiling});
  }
  return worst;
}

/// Both directions of flow, and a sonic point.
std::vector<double> both_ways() {
  auto u = test::square_and_bump(100);
  for (double& value : u) value = 2 * value - 1;
  return u;
}

// Two steps' rounding: 100 cells x about twenty operations on values of at most 1.
constexpr double rounding = 100 * 20 * round_off;

TYPED_TEST(StaggeredWith, KeepsTotalVariationAndBoundsWhereProven) {  // Eq. (T45)
  const Lattice<1> lattice = test::line(100, 0, 1);
  const TypeParam limiter{};
  const double cfl = StaggeredSolver<Burgers, TypeParam, 1>::proven_cfl(limiter);
  const Variation carried =
      run(lattice, test::square_and_bump(100), Advection<1>{Vector<1>{1.0}}, limiter, cfl);
  const Variation steepened = run(lattice, both_ways(), Burgers{}, limiter, cfl);
  for (const Variation& worst : {carried, steepened}) {
    EXPECT_LE(worst.rise, rounding);
    EXPECT_LE(worst.outside, rounding);
  }
}

TYPED_TEST(StaggeredWith, BreaksBoundsBelowTheLimitOfTheFans) {  // where it fails: a sonic point at CFL 0.45
  const Variation worst = run(test::line(100, 0, 1), both_ways(), Burgers{}, TypeParam{}, 0.45);
  EXPECT_GE(worst.outside, 1e-3);
}

TEST(Staggered, PromisesWhatIsProven) {  // Eq. (T45): (sqrt(7) - 2)/2 and /6 for minmod, as its authors have
  EXPECT_DOUBLE_EQ((StaggeredSolver<Burgers, Minmod, 1>::proven_cfl(Minmod{1})), (std::sqrt(7.0) - 2) / 2);
  EXPECT_DOUBLE_EQ((StaggeredSolver<Burgers, Minmod, 1>::proven_cfl(Minmod{2})), (std::sqrt(8.0) - 2) / 4);
  EXPECT_DOUBLE_EQ((StaggeredSolver<Burgers, Minmod, 2>::proven_cfl(Minmod{1})), (std::sqrt(7.0) - 2) / 6);
  EXPECT_EQ((StaggeredSolver<Burgers, Minmod, 2>::proven_cfl(Minmod{2})), 0);
}

TEST(Staggered, KeepsBoundsInTwoDimensionsWhereProven) {
  const Lattice<2> lattice = test::cube<2>(40);
  for (const double theta : {1.0, 1.3}) {
    const Minmod limiter{theta};
    const double cfl = StaggeredSolver<Burgers, Minmod, 2>::proven_cfl(limiter);
    EXPECT_LE(run(lattice, pattern(lattice), Burgers{}, limiter, cfl).outside,
              2 * rounding);  // values up to 2
  }
}

/// How far a pair of steps leaves the bounds of its data in the plane, carried along the diagonal: the worst
/// that a search among fields of 6 x 6 values in [0, 1] finds.
double worst_outside(double theta, double cfl) {
  const Lattice<2> lattice = test::cube<2>(6);
  StaggeredSolver solver{lattice, Advection<2>{Vector<2>{1, 1}}, Minmod{theta}, {.cfl = cfl}};
  const double pair = 2 * cfl * lattice.spacing[0];
  const auto outside = [&](const std::vector<double>& u) {
    auto after = u;
    solver.advance(after, pair);
    const auto [low, high] = std::minmax_element(u.begin(), u.end());
    const auto [least, most] = std::minmax_element(after.begin(), after.end());
    return std::max(*low - *least, *most - *high);
  };
  std::mt19937 random{1};
  std::uniform_real_distribution<double> uniform{0, 1};
  double worst = -1;
  for (int start = 0; start < 8; ++start) {
    std::vector<double> u(36);
    for (double& value : u) value = std::round(uniform(random));
    double here = outside(u);
    for (int trial = 0; trial < 2000; ++trial) {  // keeps what is no better for the scheme
      double& value = u[static_cast<std::size_t>(uniform(random) * 36)];
      const double before = value;
      value = uniform(random) < 0.5 ? std::round(uniform(random)) : uniform(random);
      const double now = outside(u);
      (now >= here ? here : value) = now >= here ? now : before;
    }
    worst = std::max(worst, here);
  }
  return worst;
}

// Eq. (T45) gives 0.108 and 0.076 for theta 1 and 1.3, none for 2. What is proven is nearly sharp: the search
// fails there, and finds a field at 1.6 times as much. At the default, 9/10 of the 1D number, it is a few per
// cent.
TEST(Staggered, LeavesBoundsInThePlaneBeyondWhatIsProven) {
  using Plane = StaggeredSolver<Advection<2>, Minmod, 2>;
  for (const double theta : {1.0, 1.3}) {
    const double proven = Plane::proven_cfl(Minmod{theta});
    EXPECT_LE(worst_outside(theta, proven), 40 * round_off)
        << theta;  // some forty operations on values up to 1
    EXPECT_GE(worst_outside(theta, 1.6 * proven), 1e-3) << theta;
  }
  EXPECT_GE(worst_outside(2, 0.05), 1e-3);
}

TEST(Staggered, KnowsHowFarItIsLinearlyStable) {  // Eq. (T46)
  EXPECT_DOUBLE_EQ((StaggeredSolver<Burgers, Minmod, 1>::largest_cfl()), 0.5);
  EXPECT_DOUBLE_EQ((StaggeredSolver<Burgers, Minmod, 2>::largest_cfl()), std::pow(2, 0.75) / 4);
  EXPECT_DOUBLE_EQ((StaggeredSolver<Burgers, Minmod, 3>::largest_cfl()), std::sqrt(5.0) / 6);
}

/// Largest value that noise has grown to in 300 pairs of steps of a CFL number that no one checks, without a
/// limiter, carried along the diagonal.
template <int D>
double grown(double cfl, Index n) {
  using Sweep = detail::StaggeredSweep<Advection<D>, Centred, D>;
  const Lattice<D> lattice = test::cube<D>(n);
  const Sweep to_corners{lattice};
  const Sweep to_cells{detail::corners_of(lattice)};
  detail::Pieces<D, 1> pieces{lattice};
  Fields<1> cells{lattice.num_sites()};
  Fields<1> corners{lattice.num_sites()};
  std::mt19937 random{17};
  std::uniform_real_distribution<double> draw{-1, 1};
  for (Index site = 0; site < lattice.num_sites(); ++site) cells.data()[site] = draw(random);
  const Advection<D> law{Vector<D>::Ones()};
  const typename Sweep::Step step{law, Centred{}, {}, cfl * lattice.spacing[0], 0};
  const auto half = [&](const Sweep& from, const Fields<1>& source, const Sweep& to, Fields<1>& target) {
    from.make_pieces(step, source, pieces, 0, from.num_rows());
    from.close(pieces);
    for (Index row = 0; row < to.num_rows(); ++row) {
      const Index start = row * n;
      detail::join(pieces, pieces.entry(to.source().site(start)), n, target.data() + start, target.stride());
    }
  };
  for (int pair = 0; pair < 300; ++pair) {
    half(to_corners, cells, to_cells, corners);
    half(to_cells, corners, to_corners, cells);
  }
  double largest = 0;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    largest = std::max(largest, std::abs(cells.data()[site]));
  }
  return largest;
}

TEST(Staggered, BlowsUpWithoutALimiterAboveIt) {  // where it fails: 0.42 in 2D and 0.37 in 3D, not 1/2
  const double plane = StaggeredSolver<Burgers, Minmod, 2>::largest_cfl();
  EXPECT_LE(grown<2>(0.99 * plane, 24), 1);
  EXPECT_GE(grown<2>(1.15 * plane, 24), 1e3);
  const double box = StaggeredSolver<Burgers, Minmod, 3>::largest_cfl();
  EXPECT_LE(grown<3>(0.99 * box, 12), 1);
  EXPECT_GE(grown<3>(1.15 * box, 12), 1e3);
}

TEST(Staggered, TakesFewestEqualPairs) {
  const Lattice<1> lattice = test::line(10, 0, 1);
  std::vector<double> u(10, 1.0);
  StaggeredSolver solver{lattice, Advection<1>{Vector<1>{2.0}}, Minmod{}, {.cfl = 0.5}};
  EXPECT_DOUBLE_EQ(solver.stable_time_step(u), 0.5 * 0.1 / 2);

  const Advance result = solver.advance(u, 0.09);

  EXPECT_EQ(result.substeps, 4);
  EXPECT_EQ(result.largest_speed, 2);
  EXPECT_DOUBLE_EQ(result.stable_dt, 0.025);
}

TEST(Staggered, ShortensAPairThatAnEndWouldBreak) {  // a fast state comes in: nothing inside is fast yet
  const Lattice<1> lattice = test::line(20, 0, 1, false);
  std::vector<double> u(20, 0.01);
  BoxBoundaries<1, 1> ends;
  ends[0] = {Prescribed<1>{{1.0}}, Outflow{}};
  StaggeredSolver solver{lattice, Burgers{}, Minmod{}, {.cfl = 0.3, .boundaries = ends}};

  solver.advance(u, 0.5);

  for (const double value : u) {
    EXPECT_GE(value, 0.01 - rounding);
    EXPECT_LE(value, 1 + rounding);
  }
  EXPECT_GE(u[1], 0.9);
}

TEST(Staggered, RefusesWhatItCannotDo) {
  const Lattice<1> cells = test::line(10, 0, 1);
  const auto message = [](const Lattice<1>& lattice, double cfl) {
    return test::message_of<InputError>([&] { StaggeredSolver{lattice, Burgers{}, Minmod{}, {.cfl = cfl}}; });
  };
  EXPECT_EQ(message(cells, 0.6),
            "StaggeredSolver: the CFL number is 0.6: must lie in (0, 0.5], where the scheme is stable");
  EXPECT_EQ(message(cells, std::nan("")),
            "StaggeredSolver: the CFL number is nan: must lie in (0, 0.5], where the scheme is stable");
  Lattice<1> nodes = cells;
  nodes.sites = Sites::nodes;
  EXPECT_EQ(message(nodes, 0.4), "StaggeredSolver: the sites of the lattice are nodes: must be cells");
  EXPECT_EQ(message(cells, 0.4), "");
}

TEST(Staggered, RefusesWrongSizesAndTimes) {
  StaggeredSolver solver{test::cube<2>(4), Euler<2>{}, Minmod{}};
  std::vector<double> u(16, 1.0);
  EXPECT_EQ(test::message_of<InputError>([&] { solver.advance(u, 1); }),
            "Solver: 16 values for 16 sites x 4 components");
  u.resize(64, 1.0);
  EXPECT_EQ(test::message_of<InputError>([&] { solver.advance(u, -1); }),
            "Solver: the duration is -1 s: must be zero or positive, and finite");
}

TEST(Staggered, NamesThePlaceOfANaNAndLeavesTheStateAsItWas) {
  const Lattice<2> lattice = test::cube<2>(4);
  std::vector<double> u(16, 1.0);
  u[9] = std::nan("");  // cell (1, 2) at (0.375, 0.625)
  const auto before = u;
  // A finite speed: no slope carries it further than to the corners of its cell, of which this is the first.
  StaggeredSolver advection{lattice, Advection<2>{Vector<2>{1, 0}}, Minmod{}, {.cfl = 0.4}};
  EXPECT_EQ(test::message_of<RunError>([&] { advection.advance(u, 1); }),
            "transport: the rate of change is not finite at site (1, 2), position (0.25, 0.5) m");
  // A speed that is not: first between (1, 1) and (1, 2).
  StaggeredSolver shear{lattice, Burgers{}, Minmod{}, {.cfl = 0.4}};
  EXPECT_EQ(test::message_of<RunError>([&] { shear.advance(u, 1); }),
            "transport: the rate of change is not finite at site (1, 1), position (0.375, 0.375) m");
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_TRUE(u[i] == before[i] || i == 9);
}

}  // namespace
}  // namespace scree::transport
