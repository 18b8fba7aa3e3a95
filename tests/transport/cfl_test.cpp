#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

namespace scree::transport {
namespace {

struct Variation {
  double rise;     ///< largest of total variation in one step [-]
  double outside;  ///< how far the bounds of the start were left [-]
};

using AnyLinear = WithAnyLimiter<PiecewiseLinear<Minmod>>;

/// Steps of a given CFL number, which no one checks.
template <class Law>
Variation run(std::vector<double> u, const Law& law, const AnyLinear& reconstruction,
              std::span<const double> kept, double cfl, int steps) {
  const Lattice<1> lattice = test::line(static_cast<Index>(u.size()), 0, 1);
  SemiDiscrete<Cartesian<1>, Law, AnyLinear, KurganovTadmor> rates{
      {lattice, law, reconstruction, {}, {}}, 0.5, {}};
  Fields<1> start{lattice.num_sites()};
  Fields<1> rate{lattice.num_sites()};
  Fields<1> stage{lattice.num_sites()};
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  const double floor = *low;
  const double ceiling = *high;
  Variation worst{0, 0};
  for (int step = 0; step < steps; ++step) {
    const double before = test::total_variation(u);
    start.gather(u, {});
    const double dt = cfl / rates(start, rate, 0).limit;
    stage = start;
    for (const double weight : kept) {
      rates(stage, rate, 0);
      for (std::size_t i = 0; i < u.size(); ++i) {
        stage.all()[i] = weight * start.all()[i] + (1 - weight) * (stage.all()[i] + dt * rate.all()[i]);
      }
    }
    stage.scatter(u, {}, [](Index) { return true; });
    worst.rise = std::max(worst.rise, test::total_variation(u) - before);
    for (const double value : u) worst.outside = std::max({worst.outside, floor - value, value - ceiling});
  }
  return worst;
}

// One step's rounding: 100 cells x about ten operations on values of at most 1.
constexpr double rounding = 100 * 10 * round_off;

template <class L>
class PromisedCfl : public ::testing::Test {};
TYPED_TEST_SUITE(PromisedCfl, test::Types<LimiterList>);

TYPED_TEST(PromisedCfl, KeepsTotalVariationAndBounds) {  // Eq. (T9)
  const AnyLinear reconstruction{PiecewiseLinear<TypeParam>{}};
  const Advection<1> law{Vector<1>{1.0}};
  for_each_entry(IntegratorList{}, [&]<class I>() {
    const Variation worst =
        run(test::square_and_bump(100), law, reconstruction, I::kept, reconstruction.promised_cfl(), 300);
    EXPECT_LE(worst.rise, rounding) << I::name;
    EXPECT_LE(worst.outside, rounding) << I::name;
  });
}

TYPED_TEST(PromisedCfl, KeepsTotalVariationOfBurgers) {
  const AnyLinear reconstruction{PiecewiseLinear<TypeParam>{}};
  std::vector<double> u = test::square_and_bump(100);
  for (double& value : u) value = 2 * value - 1;  // both directions of flow, and a sonic point
  for_each_entry(IntegratorList{}, [&]<class I>() {
    const Variation worst = run(u, Burgers{}, reconstruction, I::kept, reconstruction.promised_cfl(), 300);
    EXPECT_LE(worst.rise, rounding) << I::name;
    EXPECT_LE(worst.outside, rounding) << I::name;
  });
}

TEST(PromisedCfl, HoldsForOtherThetas) {
  const AnyLinear reconstruction{PiecewiseLinear{Minmod{1.3}}};
  const Variation worst = run(test::square_and_bump(100), Advection<1>{Vector<1>{1.0}}, reconstruction,
                              ForwardEuler::kept, reconstruction.promised_cfl(), 300);
  EXPECT_LE(worst.rise, rounding);
}

TEST(PromisedCfl, IsTheLimitOfForwardEuler) {  // beyond 1/(1 + theta/2) variation grows, by far
  const Advection<1> law{Vector<1>{1.0}};
  const auto rise = [&](double theta, double factor) {
    const AnyLinear reconstruction{PiecewiseLinear{Minmod{theta}}};
    return run(test::square_and_bump(100), law, reconstruction, ForwardEuler::kept,
               factor * reconstruction.promised_cfl(), 300)
        .rise;
  };
  for (const double theta : {1.0, 1.3, 2.0}) {
    EXPECT_LE(rise(theta, 0.99), rounding) << theta;
    EXPECT_GE(rise(theta, 1.06), 1e-6) << theta;
  }
}

TEST(PromisedCfl, IsNotExtendedByMoreStages) {  // a sonic point of Burgers, theta 2: beyond 1/2 bounds break
  const AnyLinear reconstruction{PiecewiseLinear{Minmod{2}}};
  std::vector<double> u(100, 1.0);
  std::fill(u.begin(), u.begin() + 50, -1.0);
  EXPECT_LE(run(u, Burgers{}, reconstruction, SspRk2::kept, 0.5, 300).rise, rounding);
  EXPECT_GE(run(u, Burgers{}, reconstruction, SspRk2::kept, 0.56, 300).rise, 1e-8);
}

TEST(Cfl, AddsUpOverTheAxes) {  // dt (a_x/dx + a_y/dy) <= cfl
  Lattice<2> lattice = test::cube<2>(8);
  lattice.spacing = Vector<2>{0.5, 0.25};
  Solver solver{Cartesian<2>{lattice},
                Advection<2>{Vector<2>{3, -2}},
                PiecewiseLinear{Minmod{}},
                SspRk2{},
                {.cfl = 0.5}};
  const std::vector<double> u(64, 1.0);
  EXPECT_DOUBLE_EQ(solver.stable_time_step(u), 0.5 / (3 / 0.5 + 2 / 0.25));
}

TEST(Cfl, IsNotShortenedByHalfVolumesAtWalls) {  // Eq. (T9): one face, and the whole value stands behind it
  Lattice<1> cells = test::line(10, 0, 1, false);
  Lattice<1> nodes = cells;
  nodes.count = {11};
  nodes.first[0] = 0;
  nodes.sites = Sites::nodes;
  const auto step = [](const Lattice<1>& lattice) {
    Solver solver{Cartesian<1>{lattice},
                  Advection<1>{Vector<1>{1.0}},
                  PiecewiseLinear{Minmod{2}},
                  SspRk2{},
                  {.cfl = 0.5}};
    return solver.stable_time_step(std::vector<double>(static_cast<std::size_t>(lattice.num_sites()), 1.0));
  };
  EXPECT_DOUBLE_EQ(step(nodes), step(cells));
}

TEST(Cfl, DividesTheTimeIntoEqualSteps) {
  EXPECT_DOUBLE_EQ(next_step(1, 0.95 * 10, 1), 0.1);
  EXPECT_DOUBLE_EQ(next_step(1, 10, 1), 0.1);
  EXPECT_DOUBLE_EQ(next_step(1, 10 * (1 + 8 * round_off), 1), 0.1);  // rounding does not add a step
  EXPECT_DOUBLE_EQ(next_step(1, 0, 1), 1);
}

}  // namespace
}  // namespace scree::transport
