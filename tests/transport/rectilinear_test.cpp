#include "lines.hpp"
#include "lists.hpp"

#include <scree/transport/grids/rectilinear.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/reconstructions/admissible.hpp>
#include <scree/transport/reconstructions/in_primitives.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <random>

namespace scree::transport {
namespace {

using Edges1 = std::vector<double>;

/// n cells on [0, 1] whose extents are drawn from [1, ratio], on a logarithmic scale.
Edges1 random_edges(Index n, double ratio, unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> draw{0, std::log(ratio)};
  Edges1 edges{0};
  for (Index i = 0; i < n; ++i) edges.push_back(edges.back() + std::exp(draw(random)));
  const double length = edges.back();
  for (double& edge : edges) edge /= length;
  return edges;
}

/// n equal cells on [0, 1], their inner edges moved by up to a quarter of a cell to each side.
Edges1 shaken_edges(Index n, unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> draw{-0.25, 0.25};
  Edges1 edges;
  for (Index i = 0; i <= n; ++i) {
    const bool is_end = i == 0 || i == n;
    edges.push_back((static_cast<double>(i) + (is_end ? 0 : draw(random))) / static_cast<double>(n));
  }
  return edges;
}

/// n cells on [0, 1], three times as wide at one place as at another, in a smooth way.
Edges1 stretched_edges(Index n) {
  Edges1 edges;
  for (Index i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(n);
    edges.push_back(x + 0.5 / (2 * test::pi) * std::sin(2 * test::pi * x));
  }
  edges.back() = 1;
  return edges;
}

/// Averages of sin(2 pi x), and the L1 error after one period of advection.
template <class R>
double error_after_one_period(const Edges1& edges, const R& reconstruction) {
  const auto n = edges.size() - 1;
  const auto integral = [](double x) { return -std::cos(2 * test::pi * x) / (2 * test::pi); };
  std::vector<double> u;
  for (std::size_t i = 0; i < n; ++i) {
    u.push_back((integral(edges[i + 1]) - integral(edges[i])) / (edges[i + 1] - edges[i]));
  }
  const auto exact = u;
  Solver solver{
      Rectilinear<1>{{edges}, {true}}, Advection<1>{Vector<1>{1}}, reconstruction, SspRk2{}, {.cfl = 0.4}};
  solver.advance(u, 1);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (edges[i + 1] - edges[i]) * std::abs(u[i] - exact[i]);
  return sum;
}

/// Between 320 and 640 cells.
template <class MakeEdges, class R>
double last_order(MakeEdges&& make_edges, const R& reconstruction) {
  return std::log2(error_after_one_period(make_edges(320), reconstruction) /
                   error_after_one_period(make_edges(640), reconstruction));
}

/// From the least squares line through the errors at 80, 160, 320 and 640 cells: random cells scatter.
template <class MakeEdges, class R>
double mean_order(MakeEdges&& make_edges, const R& reconstruction) {
  double sum = 0;
  double sum_of_squares = 0;
  for (int k = 0; k < 4; ++k) {
    const double x = k - 1.5;
    sum += x * std::log2(error_after_one_period(make_edges(Index{80} << k), reconstruction));
    sum_of_squares += x * x;
  }
  return -sum / sum_of_squares;
}

using AnyLinear = WithAnyLimiter<PiecewiseLinear<Minmod>>;

template <class L>
class EveryLimiterOnRectilinear : public ::testing::Test {};
TYPED_TEST_SUITE(EveryLimiterOnRectilinear, test::Types<LimiterList>);

TYPED_TEST(EveryLimiterOnRectilinear, IsSecondOrderOnStretchedAndOnShakenCells) {  // L1, smooth data
  const AnyLinear reconstruction{PiecewiseLinear<TypeParam>{}};
  EXPECT_GE(last_order(stretched_edges, reconstruction), 1.85);
  EXPECT_GE(mean_order([](Index n) { return shaken_edges(n, 5); }, reconstruction), 1.85);
}

TYPED_TEST(EveryLimiterOnRectilinear, KeepsBoundsAndVariationAtThePromisedCfl) {  // Eq. (T62)
  const Edges1 edges = random_edges(100, 1000, 7);
  auto u = test::square_and_bump(100);
  const double variation = test::total_variation(u);
  Solver solver{Rectilinear<1>{{edges}, {true}},
                Advection<1>{Vector<1>{1}},
                AnyLinear{PiecewiseLinear<TypeParam>{}},
                ForwardEuler{},
                {.cfl = 0.5}};
  EXPECT_EQ(solver.promised_cfl({PiecewiseLinear<TypeParam>{}}), 0.5);

  constexpr int num_steps = 20000;
  const double dt = solver.stable_time_step(u);
  for (int step = 0; step < num_steps; ++step) solver.advance(u, dt);

  constexpr double rounding = num_steps * 5 * round_off;  // a mean of earlier values, but for five a step
  for (const double value : u) {
    EXPECT_GE(value, -rounding);
    EXPECT_LE(value, 1 + rounding);
  }
  EXPECT_LE(test::total_variation(u), variation * (1 + rounding));
}

TYPED_TEST(EveryLimiterOnRectilinear, IsExactForLinearProfiles) {  // Eq. (T60)
  const Edges1 edges = random_edges(40, 100, 3);
  const Rectilinear<1> grid{{edges}};
  using Law = Advection<1>;
  SemiDiscrete<Rectilinear<1>, Law, AnyLinear, KurganovTadmor> rates{
      {grid, Law{Vector<1>{2}}, {PiecewiseLinear<TypeParam>{}}, {}, {}}, 0.5, {}};
  Fields<1> u{40};
  Fields<1> rate{40};
  for (Index i = 0; i < 40; ++i) u.data()[i] = 3 - 5 * grid.position({i})[0];

  rates(u, rate, 0);

  // Cells 0 and 39 have no slope, so faces next to them are off. Four roundings of values below 3 in each
  // face, over the extent.
  for (Index i = 2; i < 38; ++i) EXPECT_NEAR(rate.data()[i], 10, 2 * 3 * 8 * round_off / grid.width(0, i));
}

/// Two fractions that change places.
struct Exchange {
  static constexpr int num_components = 2;
  using State = std::array<double, 2>;
  State flux(const State& u, const Vector<1>& n) const noexcept {
    return {n[0] * u[0] * u[1], -n[0] * u[0] * u[1]};
  }
  double max_speed(const State&, const State&, const Vector<1>&) const noexcept { return 1; }
};

TEST(Rectilinear, KeepsSumsOfComponentsAndTheirBounds) {  // one factor for all, Eq. (T61)
  const Edges1 edges = random_edges(60, 100, 11);
  std::vector<double> u;
  for (int i = 0; i < 60; ++i) {
    u.push_back(i < 20 ? 0 : 0.5 + 0.5 * std::sin(i));
    u.push_back(1 - u.back());
  }
  Solver solver{Rectilinear<1>{{edges}}, Exchange{}, PiecewiseLinearCommon{Minmod{2}, 1.0}};

  const Advance result = solver.advance(u, 0.2);

  ASSERT_GE(result.substeps, 100);
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_NEAR(u[2 * i] + u[2 * i + 1], 1, result.substeps * 8 * round_off);
    EXPECT_GE(u[2 * i], -result.substeps * 8 * round_off);
    EXPECT_LE(u[2 * i], 1 + result.substeps * 8 * round_off);
  }
}

/// Of several fractions too, whose common factor on unequal cells the one that is chosen has to find.
TYPED_TEST(EveryLimiterOnRectilinear, HasTheSameBitsIfItIsChosenAtRunTime) {
  using Alone = PiecewiseLinearCommon<TypeParam>;
  const Rectilinear<1> grid{{random_edges(60, 100, 11)}};
  const auto advanced = [&](const auto& reconstruction) {
    std::vector<double> u;
    for (int i = 0; i < 60; ++i) {
      u.push_back(i < 20 ? 0 : 0.5 + 0.5 * std::sin(i));
      u.push_back(1 - u.back());
    }
    Solver{grid, Exchange{}, reconstruction}.advance(u, 0.2);
    return u;
  };
  const Alone alone{.limiter = TypeParam{}, .scale = 1.0};

  EXPECT_EQ(advanced(WithAnyLimiter<PiecewiseLinearCommon<Minmod>>{alone}), advanced(alone));
}

/// A box of random cells in each dimension.
template <int D>
Rectilinear<D> random_box(Index n, const std::array<bool, D>& is_periodic) {
  std::array<Edges1, D> edges;
  for (std::size_t axis = 0; axis < D; ++axis) {
    edges[axis] = random_edges(n + static_cast<Index>(axis), 30, static_cast<unsigned>(axis));
  }
  return Rectilinear<D>{edges, is_periodic};
}

template <int D, class Visit>
void for_each_site(const Rectilinear<D>& grid, Visit&& visit) {
  Index num_sites = 1;
  for (const Index n : grid.count()) num_sites *= n;
  for (Index site = 0; site < num_sites; ++site) {
    Indices<D> at{};
    Index rest = site;
    for (std::size_t axis = 0; axis < D; ++axis) {
      at[axis] = rest % grid.count()[axis];
      rest /= grid.count()[axis];
    }
    visit(static_cast<std::size_t>(site), at);
  }
}

TEST(Rectilinear, ConservesToRoundOffInThreeDimensions) {
  const auto grid = random_box<3>(8, {true, false, true});
  std::vector<double> u;
  double before = 0;
  for_each_site<3>(grid, [&](std::size_t, const Indices<3>& at) {
    const Vector<3> x = grid.position(at);
    u.push_back(2 + std::sin(2 * test::pi * (x[0] + x[1])) * std::cos(2 * test::pi * x[2]));
    before += grid.volume(at) * u.back();
  });

  const Advance result = Solver{grid, Burgers{}, PiecewiseLinear{VanLeer{}}}.advance(u, 0.01);

  double after = 0;
  for_each_site<3>(grid, [&](std::size_t i, const Indices<3>& at) { after += grid.volume(at) * u[i]; });
  EXPECT_GE(result.substeps, 5);
  EXPECT_NEAR(after, before, result.substeps * 20 * round_off * before);  // six faces, two stages, the sum
}

TEST(Rectilinear, KeepsPressureAndVelocityThroughAContact) {  // scaled in the primitive variables, Eq. (T22)
  const Euler<1> gas;
  const Edges1 edges = random_edges(50, 30, 2);
  std::vector<double> u;
  for (int i = 0; i < 50; ++i) {
    const auto cell = gas.state(i < 20 ? 1 : 2 + std::sin(i), Vector<1>{0.8}, 1.5);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  Solver solver{Rectilinear<1>{{edges}, {true}}, gas,
                Admissible{InPrimitives{PiecewiseLinear{Minmod{2}}, gas}, gas}, ForwardEuler{}};

  const Advance result = solver.advance(u, 0.1);

  EXPECT_GE(result.substeps, 20);
  for (std::size_t i = 0; i < 50; ++i) {  // thirty roundings of the energy a step
    const Euler<1>::State cell{u[3 * i], u[3 * i + 1], u[3 * i + 2]};
    EXPECT_NEAR(gas.pressure(cell), 1.5, result.substeps * 30 * round_off * 5);
    EXPECT_NEAR(cell[1] / cell[0], 0.8, result.substeps * 30 * round_off * 5);
  }
}

TEST(Rectilinear, KeepsAFreeStream) {  // uniform gas: all faces carry the same, to the last bit
  const auto grid = random_box<2>(70, {true, true});
  const Euler<2> gas;
  const auto cell = gas.state(1.2, Vector<2>{3, -2}, 0.7);
  std::vector<double> u;
  for (std::size_t i = 0; i < 70 * 71; ++i) u.insert(u.end(), cell.begin(), cell.end());
  const auto before = u;
  Solver{grid, gas, PiecewiseLinear{Minmod{2}}}.advance(u, 0.01);
  EXPECT_EQ(u, before);
}

TEST(Rectilinear, EqualsTheUniformGridWhereCellsAreEqual) {
  const Lattice<2> lattice = test::cube<2>(40);
  Edges1 edges;
  for (int i = 0; i <= 40; ++i) edges.push_back(i / 40.0);
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site));
    u.push_back(std::sin(2 * test::pi * x[0]) + 0.3 * std::cos(2 * test::pi * (x[0] - x[1])));
  }
  auto v = u;
  const SolverOptions<Cartesian<2>, 1> options{.cfl = 0.4};
  const SolverOptions<Rectilinear<2>, 1> same_options{.cfl = 0.4};

  const Advance one =
      Solver{Cartesian<2>{lattice}, Burgers{}, PiecewiseLinear{Minmod{2}}, SspRk2{}, options}.advance(u, 0.1);
  const Advance other = Solver{Rectilinear<2>{{edges, edges}, {true, true}}, Burgers{},
                               PiecewiseLinear{Minmod{2}}, SspRk2{}, same_options}
                            .advance(v, 0.1);

  EXPECT_EQ(one.substeps, other.substeps);
  EXPECT_LE(test::linf(u, v),
            one.substeps * 20 * round_off);  // per step some ten operations on values to 1.3
}

/// At rest, with a source x + 2 y; a boundary that tells where it was asked.
struct Ramp {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  State flux(const State&, const Vector<2>&) const noexcept { return {0}; }
  double max_speed(const State&, const State&, const Vector<2>&) const noexcept { return 0; }
  State source(const State&, const Vector<2>& x, double) const noexcept { return {x[0] + 2 * x[1]}; }
};

TEST(Rectilinear, AsksSourcesAtTheCentresOfCells) {
  const auto grid = random_box<2>(70, {false, true});
  std::vector<double> u(70 * 71, 0.0);
  Solver{grid, Ramp{}, PiecewiseConstant{}}.advance(u, 1);
  for_each_site<2>(grid, [&](std::size_t i, const Indices<2>& at) {
    const Vector<2> x = grid.position(at);
    EXPECT_NEAR(u[i], x[0] + 2 * x[1], 8 * round_off * 3);
  });
}

TEST(Rectilinear, AsksBoundariesAtTheCentresOfTheirFaces) {
  const auto grid = random_box<2>(9, {false, false});
  std::vector<Vector<2>> asked;
  using State = std::array<double, 1>;
  const UserGiven<2, 1> record{[&](const State& inside, const BoundaryFace<2>& face) {
    asked.push_back(face.centre);
    return inside;
  }};
  std::vector<double> u(90, 1.0);
  Solver solver{grid,
                Advection<2>{Vector<2>{1, 1}},
                PiecewiseConstant{},
                SspRk2{},
                {.boundaries = {{{ZeroFlux{}, ZeroFlux{}}, {ZeroFlux{}, record}}}}};

  static_cast<void>(solver.stable_time_step(u));

  ASSERT_EQ(asked.size(), 9U);
  for (Index i = 0; i < 9; ++i) {
    EXPECT_EQ(asked[static_cast<std::size_t>(i)][0], grid.position({i, 0})[0]);
    EXPECT_EQ(asked[static_cast<std::size_t>(i)][1], 1);
  }
}

/// u_t = u_xx.
struct Heat {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  State flux(const State&, const Vector<1>&) const noexcept { return {0}; }
  double max_speed(const State&, const State&, const Vector<1>&) const noexcept { return 0; }
  State potential(const State& u) const noexcept { return u; }
  double max_diffusivity(const State&, const State&) const noexcept { return 1; }
};

TEST(Rectilinear, DiffusesALinearProfileNot) {  // distances between centres, Eq. (T11)
  const Rectilinear<1> grid{{random_edges(40, 100, 3)}};
  SemiDiscrete<Rectilinear<1>, Heat, PiecewiseConstant, KurganovTadmor> rates{
      {grid, {}, {}, {}, {}}, 0.5, {}};
  Fields<1> u{40};
  Fields<1> rate{40};
  for (Index i = 0; i < 40; ++i) u.data()[i] = 3 - 5 * grid.position({i})[0];

  rates(u, rate, 0);

  for (Index i = 1; i < 39; ++i) {  // eight roundings of 3 over the shorter distance and the extent
    const double distance = std::min(grid.distance_below(0, i), grid.distance_below(0, i + 1));
    EXPECT_NEAR(rate.data()[i], 0, 3 * 8 * round_off / (distance * grid.width(0, i)));
  }
}

/// The slope of cell 1 of three, in units of its extent, and how far its edge lies beyond cell 0.
TEST(Rectilinear, NeedsScaledDifferencesAndTheirBound) {  // where it fails without, Eqs. (T60), (T61)
  const double widths[] = {1, 9, 1};
  const double distance = (widths[0] + widths[1]) / 2;
  const std::array<double, 1> below{0};
  const std::array<double, 1> here{distance};  // the profile u = x
  const std::array<double, 1> above{2 * distance};
  const PiecewiseLinear mc{Minmod{2}};

  const auto raw = mc(below, here, above);
  EXPECT_EQ(raw.high[0] - raw.low[0], distance);  // 5 where 9 is right: a slope of 5/9

  const double ratio = widths[1] / distance;
  const auto right = detail::on_unequal_cells(mc, ratio, ratio)(below, here, above);
  EXPECT_DOUBLE_EQ(right.high[0] - right.low[0], widths[1]);

  // A kink: below the cell u falls by 1, above it rises on by 4. MC of scaled differences asks for a slope of
  // 2 * 1.8, whose half passes the lower neighbour by 0.8.
  const std::array<double, 1> steep{here[0] + 4};
  const std::array<double, 1> gentle{here[0] - 1};
  const std::array<double, 1> seen_below{here[0] - ratio};
  const std::array<double, 1> seen_above{here[0] + 4 * ratio};
  EXPECT_DOUBLE_EQ(gentle[0] - mc(seen_below, here, seen_above).low[0], 0.8);
  EXPECT_DOUBLE_EQ(detail::on_unequal_cells(mc, ratio, ratio)(gentle, here, steep).low[0], gentle[0]);
}

TEST(Rectilinear, RefusesEdgesThatCannotBe) {
  const auto message = [](Edges1 x, Edges1 y) {
    return test::message_of<InputError>([&] { Rectilinear<2>{{x, y}}; });
  };
  EXPECT_EQ(message({0, 1}, {0}), "Rectilinear: axis 1 has 1 edges: must have two or more");
  EXPECT_EQ(message({0, 1, std::nan("")}, {0, 1}), "Rectilinear: edge 2 of axis 0 is nan m: must be finite");
  EXPECT_EQ(message({0, 1}, {0, 2, 2}), "Rectilinear: edge 2 of axis 1 is 2 m: must exceed edge 1, 2 m");
  EXPECT_EQ(message({0, 1}, {0, 2}), "");
}

}  // namespace
}  // namespace scree::transport
