// The maximum principle on cells of any form, Eq. (T34), and where it ends.

#include "lists.hpp"
#include "meshes.hpp"

#include <scree/transport/cell_limiters.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace scree::transport {
namespace {

/// How far `u` leaves [low, high].
double outside(const std::vector<double>& u, double low, double high) {
  const auto [lowest, highest] = std::minmax_element(u.begin(), u.end());
  return std::max({0.0, low - *lowest, *highest - high});
}

// Twenty steps of two stages, some hundred operations each on values of at most 1.
constexpr double rounding = 20 * 2 * 100 * round_off;

template <class Law, class R>
double worst_of_random_data(const Law& law, const R& reconstruction, double low, double high, double cfl) {
  double worst = 0;
  for (const auto& [name, rectangle] : test::rectangles(true)) {
    const Polygonal grid{make_mesh(rectangle)};
    std::mt19937_64 engine{11};
    std::vector<double> u(static_cast<std::size_t>(grid.num_cells()));
    for (double& value : u) value = engine() % 3 == 0 ? low : high;  // jumps everywhere
    Solver solver{grid, law, reconstruction, SspRk2{}, {.cfl = cfl}};
    for (int step = 0; step < 20; ++step) {
      solver.advance(u, solver.stable_time_step(u));
      worst = std::max(worst, outside(u, low, high));
    }
  }
  return worst;
}

template <class L>
class EveryBoundedLimiter : public ::testing::Test {};
using BoundedLimiters = ::testing::Types<SmoothCubic, BarthJespersen, Venkatakrishnan>;
TYPED_TEST_SUITE(EveryBoundedLimiter, BoundedLimiters);

TYPED_TEST(EveryBoundedLimiter, KeepsTheMaximumPrincipleAtThePromisedCfl) {
  for (const int rings : {1, 2}) {
    const CellGradient<TypeParam> reconstruction{TypeParam{}, rings};
    const double cfl = reconstruction.promised_cfl();
    EXPECT_LE(worst_of_random_data(Advection<2>{Vector<2>{1, 0.3}}, reconstruction, 0, 1, cfl), rounding);
    EXPECT_LE(worst_of_random_data(Burgers{}, reconstruction, -1, 1, cfl), rounding);
  }
}

TEST(FirstOrder, KeepsTheMaximumPrincipleUpToOne) {
  EXPECT_LE(worst_of_random_data(Burgers{}, PiecewiseConstant{}, -1, 1, 1), rounding);
}

TEST(Unlimited, OvershootsAtAJump) {  // Gibbs
  EXPECT_GE(worst_of_random_data(Advection<2>{Vector<2>{1, 0.3}}, CellGradient<Unlimited>{}, 0, 1, 0.5),
            0.05);
}

TEST(Venkatakrishnan, OvershootsByLessThanItsEpsilon) {  // but by more than rounding, with K > 0
  const Rectangle rectangle = test::rectangles(true)[0].second;
  const Polygonal grid{make_mesh(rectangle)};
  double width = 0;
  for (Index i = 0; i < grid.num_cells(); ++i) width = std::max(width, std::sqrt(grid.volume(i)));
  const Venkatakrishnan limiter{5};
  std::vector<double> u = test::averages(grid, [](const Vector<2>& x) { return x[0] < 0.5 ? 0.0 : 1.0; });
  Solver solver{grid, Advection<2>{Vector<2>{1, 0.3}}, CellGradient{limiter}, ForwardEuler{}, {.cfl = 0.5}};

  double worst = 0;
  double bound = 0;
  for (int step = 0; step < 10; ++step) {
    solver.advance(u, solver.stable_time_step(u));
    worst = outside(u, 0, 1);
    bound += limiter.epsilon(width) / (2 * std::sqrt(2));  // each step, Eq. (T33b)
    EXPECT_LE(worst, bound + rounding);
  }
  EXPECT_GE(worst, 1e-3);
}

/// Four equilateral triangles: one in the middle, three round it.
PolygonalMesh four_triangles() {
  const double h = std::sqrt(3.0) / 2;
  PolygonalMesh mesh;
  mesh.vertices = {Vector<2>{-0.5, 0}, Vector<2>{0.5, 0}, Vector<2>{0, h},
                   Vector<2>{0, -h},   Vector<2>{1, h},   Vector<2>{-1, h}};
  mesh.add_cell(std::vector<Index>{0, 1, 2});
  mesh.add_cell(std::vector<Index>{0, 3, 1});
  mesh.add_cell(std::vector<Index>{1, 4, 2});
  mesh.add_cell(std::vector<Index>{0, 2, 5});
  mesh.boundary_names = {"rim"};
  mesh.boundary_edges = {{0, 3, 0}, {3, 1, 0}, {1, 4, 0}, {4, 2, 0}, {2, 5, 0}, {5, 0, 0}};
  return mesh;
}

// The middle cell has 5/6, the one below 0, the others 1: its gradient gives 1/2 at the lower face and 1 at
// the others, which Barth and Jespersen's limiter allows. Wind down takes (CFL/limit) x 1/2 out and brings
// the same volume with 1 in, so that the middle has 5/6 + CFL/3: 1 at the promised CFL number of 1/2.
TEST(PromisedCfl, IsSharpOnTriangles) {
  const Polygonal grid{four_triangles()};
  using Rates = SemiDiscrete<Polygonal, Advection<2>, CellGradient<BarthJespersen>, KurganovTadmor>;
  const CellGradient<BarthJespersen> reconstruction{{}, 1};
  Rates rates{{grid, {Vector<2>{0, -1}}, reconstruction, {}, {{"rim", Outflow{}}}}, 0.5, {}};
  CellStates<1> u{4};
  CellStates<1> rate{4};
  u.gather(std::vector<double>{5.0 / 6, 0, 1, 1}, {});

  const double limit = rates(u, rate, 0).limit;

  EXPECT_DOUBLE_EQ(limit, 2 / (2 * std::sqrt(3.0) / 6));  // D a/(2 h), the centre is height/3 from a face
  for (const double cfl : {0.25, 0.5, 0.6}) {
    EXPECT_NEAR(5.0 / 6 + cfl / limit * rate[0][0], 5.0 / 6 + cfl / 3, 50 * round_off) << cfl;
  }
}

/// A rigid turn round the middle of the unit square, once in 2 pi seconds.
struct Turn {
  static Advection<2> at(const GridFace<2>& face) noexcept {
    return {Vector<2>{0.5 - face.centre[1], face.centre[0] - 0.5}};
  }
};

double slotted_disk(const Vector<2>& x) {
  const bool is_in_disk = (x - Vector<2>{0.5, 0.75}).norm() < 0.15;
  const bool is_in_slot = std::abs(x[0] - 0.5) < 0.025 && x[1] < 0.85;
  return is_in_disk && !is_in_slot ? 1 : 0;
}

template <class L>
std::vector<double> turned(const Polygonal& grid, const L& limiter) {
  std::vector<double> u = test::averages(grid, slotted_disk);
  const NamedBoundaries<2, 1> still{{"left", Prescribed<1>{}},
                                    {"right", Prescribed<1>{}},
                                    {"bottom", Prescribed<1>{}},
                                    {"top", Prescribed<1>{}}};
  Solver solver{grid, Turn{}, CellGradient{limiter}, SspRk2{}, {.cfl = 0.5, .boundaries = still}};
  solver.advance(u, 0.7);
  return u;
}

TEST(SlottedDisk, KeepsItsBounds) {  // a law that differs from face to face
  for (const Cut cut : {Cut::triangles, Cut::mixed}) {
    const Polygonal grid{make_mesh({.count = {24, 24}, .cut = cut, .perturbation = 0.2})};
    EXPECT_LE(outside(turned(grid, SmoothCubic{}), 0, 1), 500 * 100 * round_off);  // 500 steps at most
    EXPECT_GE(outside(turned(grid, Unlimited{}), 0, 1), 0.02);
  }
}

/// An advected quantity that cannot be negative.
struct Positive : Advection<2> {
  static bool is_admissible(const State& u) noexcept { return u[0] >= -rounding; }
};

TEST(AdmissibleStates, AreKeptWithoutALimiter) {  // Eq. (T35): states at all faces admissible, so is the next
  const Polygonal grid{make_mesh({.count = {16, 16}, .perturbation = 0.2, .is_periodic = {true, true}})};
  std::vector<double> u = test::averages(grid, slotted_disk);
  std::vector<double> free = u;
  const Positive law{{Vector<2>{1, 0.3}}};
  Solver solver{grid, law, CellGradient{Unlimited{}}, SspRk2{}, {.cfl = 0.5}};
  Solver unaware{grid, Advection<2>{law.velocity}, CellGradient{Unlimited{}}, SspRk2{}, {.cfl = 0.5}};

  solver.advance(u, 0.2);
  unaware.advance(free, 0.2);

  EXPECT_GE(*std::min_element(u.begin(), u.end()), -rounding);
  EXPECT_LE(*std::min_element(free.begin(), free.end()), -0.02);
}

}  // namespace
}  // namespace scree::transport
