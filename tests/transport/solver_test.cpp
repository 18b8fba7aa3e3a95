#include "lines.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace scree::transport {
namespace {

/// Two periods of two waves along each axis, sharpened.
template <int D>
std::vector<double> pattern(const Lattice<D>& lattice) {
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<D> x = lattice.position(lattice.site(site));
    double value = 0;
    for (int axis = 0; axis < D; ++axis)
      value += std::tanh(3 * std::sin(2 * test::pi * (x[axis] + 0.1 * axis)));
    u.push_back(value);
  }
  return u;
}

template <int D>
std::vector<double> burgers(const Lattice<D>& lattice, Threads threads) {
  auto u = pattern(lattice);
  Solver solver{Cartesian<D>{lattice}, Burgers{}, PiecewiseLinear{VanLeer{}}, SspRk2{}, {.threads = threads}};
  solver.advance(u, 0.05);
  return u;
}

TEST(Solver, HasTheSameBitsForAnyNumberOfThreads) {
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

TEST(Solver, HasTheSameBitsAndStepsWithAReconstructionChosenAtRunTime) {
  using Any = AnyReconstruction<PiecewiseLinear<Minmod>, PiecewiseLinear<VanLeer>>;
  const Lattice<2> lattice = test::cube<2>(70);  // two tiles of a row
  const auto run = [&](const auto& reconstruction) {
    auto u = pattern(lattice);
    const Advance done = Solver{Cartesian<2>{lattice}, Burgers{}, reconstruction}.advance(u, 0.05);
    return std::pair{u, done.substeps};
  };

  const auto with_minmod = run(PiecewiseLinear{Minmod{1.3}});  // which promises more than van Leer
  const auto with_van_leer = run(PiecewiseLinear{VanLeer{}});

  EXPECT_EQ(run(Any{PiecewiseLinear{Minmod{1.3}}}), with_minmod);
  EXPECT_EQ(run(Any{PiecewiseLinear{VanLeer{}}}), with_van_leer);
  EXPECT_NE(with_minmod.first, with_van_leer.first);
  EXPECT_LT(with_minmod.second, with_van_leer.second);
}

TEST(AnyReconstruction, IsTheOneThatIsChosen) {
  using State = std::array<double, 1>;
  using Any = AnyReconstruction<PiecewiseLinear<VanLeer>, Cweno3>;
  static_assert(Reconstruction<Any, 1>);
  static_assert(needs_equal_cells<Any> && leaves_bounds<Any>);
  static_assert(!needs_equal_cells<AnyReconstruction<PiecewiseConstant>>);
  static_assert(!leaves_bounds<AnyReconstruction<PiecewiseConstant>>);

  for (const State& above : {State{3}, State{7}}) {
    EXPECT_EQ(Any{Cweno3{}}(State{0}, State{1}, above).high, Cweno3{}(State{0}, State{1}, above).high);
    EXPECT_EQ(Any{PiecewiseLinear<VanLeer>{}}(State{0}, State{1}, above).low,
              PiecewiseLinear{VanLeer{}}(State{0}, State{1}, above).low);
  }
  EXPECT_EQ(AnyReconstruction<PiecewiseConstant>{}.promised_cfl(), PiecewiseConstant{}.promised_cfl());
}

TEST(Solver, TreatsBothAxesAlike) {  // data mirrored in x = y stay so, to the order of the sums
  const Lattice<2> lattice = test::cube<2>(70);
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site));
    u.push_back(std::sin(2 * test::pi * (x[0] + x[1])) + std::cos(2 * test::pi * (x[0] - x[1])));
  }
  Solver{Cartesian<2>{lattice}, Burgers{}, PiecewiseLinear{Minmod{}}}.advance(u, 0.1);
  for (Index i = 0; i < 70; ++i) {
    for (Index j = 0; j < i; ++j) {
      const double one = u[static_cast<std::size_t>(lattice.index({i, j}))];
      const double other = u[static_cast<std::size_t>(lattice.index({j, i}))];
      EXPECT_NEAR(one, other, 1e-13);
    }
  }
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
    u.push_back(std::tanh(3 * std::sin(2 * test::pi * i / 70)));
  }
  Vector<D> velocity = Vector<D>::Zero();
  velocity[axis] = 0.8;
  Solver solver{Cartesian<D>{lattice}, Advection<D>{velocity}, PiecewiseLinear{Minmod{}}};
  solver.advance(u, 0.3);
  std::vector<double> line;
  for (Index i = 0; i < 70; ++i) line.push_back(u[static_cast<std::size_t>(i * lattice.stride(axis))]);
  return line;
}

TEST(Solver, IsTheSameAlongEveryAxisInEveryDimension) {
  for (const bool is_periodic : {true, false}) {
    const auto line = along<1>(0, is_periodic);
    for (int axis = 0; axis < 2; ++axis) EXPECT_LE(test::linf(along<2>(axis, is_periodic), line), 1e-14);
    for (int axis = 0; axis < 3; ++axis) EXPECT_LE(test::linf(along<3>(axis, is_periodic), line), 1e-14);
  }
}

TEST(Solver, ConservesOnCellsAndOnNodesWithHalfVolumes) {
  for (const Sites sites : {Sites::cells, Sites::nodes}) {
    Lattice<2> lattice = test::cube<2>(21);
    lattice.is_periodic = {false, false};
    lattice.sites = sites;
    auto u = pattern(lattice);
    const auto total = [&] {
      double sum = 0;
      for (Index site = 0; site < lattice.num_sites(); ++site) {
        sum += lattice.volume(lattice.site(site)) * (u[static_cast<std::size_t>(site)] + 2);
      }
      return sum;
    };
    const double before = total();
    Solver{Cartesian<2>{lattice}, Burgers{}, PiecewiseLinear{Minmod{2}}}.advance(u, 0.5);
    EXPECT_NEAR(total(), before, 1e-13 * before);  // round-off of 441 sites over some hundred steps
  }
}

TEST(Solver, TakesFewestEqualSteps) {
  const Lattice<1> lattice = test::line(10, 0, 1);
  std::vector<double> u(10, 1.0);
  Solver solver{
      Cartesian<1>{lattice}, Advection<1>{Vector<1>{2.0}}, PiecewiseLinear{Minmod{}}, SspRk2{}, {.cfl = 0.5}};
  EXPECT_DOUBLE_EQ(solver.stable_time_step(u), 0.5 * 0.1 / 2);

  const Advance result = solver.advance(u, 0.09);

  EXPECT_EQ(result.substeps, 4);
  EXPECT_EQ(result.largest_speed, 2);
  EXPECT_DOUBLE_EQ(result.stable_dt, 0.025);
}

TEST(Solver, DoesNothingInNoTime) {
  std::vector<double> u(10, 1.0);
  Solver solver{Cartesian<1>{test::line(10, 0, 1)}, Burgers{}, PiecewiseLinear{Minmod{}}};
  EXPECT_EQ(solver.advance(u, 0).substeps, 0);
}

TEST(Solver, LeavesStillStatesInOneStep) {
  std::vector<double> u(10, 0.0);
  Solver solver{Cartesian<1>{test::line(10, 0, 1)}, Burgers{}, PiecewiseLinear{Minmod{}}};
  EXPECT_EQ(solver.stable_time_step(u), std::numeric_limits<double>::infinity());
  EXPECT_EQ(solver.advance(u, 1e6).substeps, 1);
}

/// du/dt = 0, but the second look at it finds it fast.
struct Accelerating {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  State flux(const State& u, const Vector<1>& normal) const noexcept {
    return {normal[0] * u[0] * u[0] * u[0]};
  }
  double max_speed(const State& left, const State& right, const Vector<1>&) const noexcept {
    return 3 * larger(left[0] * left[0], right[0] * right[0]);
  }
};

TEST(Solver, ShortensAStepThatALaterStageWouldBreak) {  // inflow of a large state: the bounds are its own
  const Lattice<1> lattice = test::line(20, 0, 1, false);
  std::vector<double> u(20, 0.0);
  Solver solver{Cartesian<1>{lattice},
                Accelerating{},
                PiecewiseLinear{Minmod{2}},
                SspRk3{},
                {.cfl = 0.5, .boundaries = {{{Prescribed<1>{{1.0}}, Outflow{}}}}}};
  solver.advance(u, 0.2);
  for (const double value : u) {
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 1 + 4 * round_off);
  }
}

/// At rest, with a source s = x t.
struct Growing {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  State flux(const State&, const Vector<2>&) const noexcept { return {0}; }
  double max_speed(const State&, const State&, const Vector<2>&) const noexcept { return 0; }
  State source(const State&, const Vector<2>& x, double t) const noexcept { return {(x[0] + 2 * x[1]) * t}; }
};
static_assert(HasSource<Growing, 2>);

TEST(Solver, AddsTheSourceAtItsPlaceAndTime) {  // SSPRK2 integrates a source linear in time exactly
  const Lattice<2> lattice = test::cube<2>(70);
  std::vector<double> u(4900, 1.0);
  Solver solver{Cartesian<2>{lattice}, Growing{}, PiecewiseConstant{}, SspRk2{}, {.start_time = 3}};
  solver.advance(u, 2);
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site));
    EXPECT_NEAR(u[static_cast<std::size_t>(site)], 1 + (x[0] + 2 * x[1]) * 8, 50 * round_off);  // 25, rounded
  }
}

TEST(Solver, RefusesAStartTimeThatIsNotFinite) {
  EXPECT_EQ(test::message_of<InputError>([] {
              Solver{Cartesian<1>{test::line(10, 0, 1)},
                     Burgers{},
                     PiecewiseConstant{},
                     SspRk2{},
                     {.start_time = std::nan("")}};
            }),
            "Solver: the start time is nan s: must be finite");
}

TEST(Solver, RefusesACflNumberThatItCannotPromise) {
  const auto message = [](double cfl) {
    return test::message_of<InputError>([&] {
      Solver{
          Cartesian<1>{test::line(10, 0, 1)}, Burgers{}, PiecewiseLinear{Minmod{2}}, SspRk2{}, {.cfl = cfl}};
    });
  };
  EXPECT_EQ(message(0.56),
            "Solver: the CFL number is 0.56: must lie in (0, 0.5], as the scheme promises no more");
  EXPECT_EQ(message(0), "Solver: the CFL number is 0: must lie in (0, 0.5], as the scheme promises no more");
  EXPECT_EQ(message(std::nan("")),
            "Solver: the CFL number is nan: must lie in (0, 0.5], as the scheme promises no more");
  EXPECT_EQ(message(0.5), "");
}

TEST(Solver, RefusesWrongSizesAndTimes) {
  Solver solver{Cartesian<2>{test::cube<2>(4)}, Euler<2>{}, PiecewiseLinear{Minmod{2}}};
  std::vector<double> u(16, 1.0);
  EXPECT_EQ(test::message_of<InputError>([&] { solver.advance(u, 1); }),
            "Solver: 16 values for 16 sites x 4 components");
  u.resize(64, 1.0);
  EXPECT_EQ(test::message_of<InputError>([&] { solver.advance(u, -1); }),
            "Solver: the duration is -1 s: must be zero or positive, and finite");
}

TEST(Solver, NamesTheSiteOfANaNAndLeavesTheStateAsItWas) {  // though the speed of advection is finite
  const Lattice<2> lattice = test::cube<2>(4);
  std::vector<double> u(16, 1.0);
  u[9] = std::nan("");  // site (1, 2): (0, 2), the first site with a face to it, is met first
  const auto before = u;
  Solver solver{Cartesian<2>{lattice}, Advection<2>{Vector<2>{1, 0}}, PiecewiseConstant{}};

  const auto message = test::message_of<RunError>([&] { solver.advance(u, 1); });

  EXPECT_EQ(message, "transport: the rate of change is not finite at site (1, 1), position (0.375, 0.375) m");
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_TRUE(u[i] == before[i] || i == 9);
}

/// Minmod of two that are no numbers is 0, but the value of the cell between them is none: it and the cells
/// that share a face with it have no rate, of which the first is named.
TEST(Solver, NamesTheFirstCellBesideANaNUnderMinmodWhereverThatIs) {
  constexpr Index edge = 4;
  const Lattice<2> lattice = test::cube<2>(edge);
  for (const double theta : {1.0, 2.0}) {
    ASSERT_EQ(Minmod{theta}(std::nan(""), std::nan("")), 0);
    for (Index n = 0; n < lattice.num_sites(); ++n) {
      std::vector<double> u(16, 1.0);
      u[static_cast<std::size_t>(n)] = std::nan("");
      Index first = n;
      for (const std::size_t axis : {0U, 1U}) {
        for (const Index step : {Index{1}, edge - 1}) {  // the mesh is periodic
          Indices<2> beside = lattice.site(n);
          beside[axis] = (beside[axis] + step) % edge;
          first = std::min(first, beside[0] + edge * beside[1]);
        }
      }
      Solver solver{Cartesian<2>{lattice}, Advection<2>{Vector<2>{1, 0}}, PiecewiseLinear{Minmod{theta}}};

      const auto message = test::message_of<RunError>([&] { solver.advance(u, 1); });

      const Indices<2> named = lattice.site(first);
      const std::string expected = "transport: the rate of change is not finite at site (" +
                                   std::to_string(named[0]) + ", " + std::to_string(named[1]) + "), position";
      EXPECT_EQ(message.substr(0, expected.size()), expected) << n;
    }
  }
}

}  // namespace
}  // namespace scree::transport
