// du/dt on cells of any form: what must hold on every mesh, a bad one too.

#include "box_grid.hpp"
#include "lines.hpp"
#include "meshes.hpp"

#include <scree/error.hpp>
#include <scree/transport/cell_limiters.hpp>
#include <scree/transport/fluxes.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <random>

namespace scree::transport {
namespace {

using Exact = CellGradient<Unlimited>;
const Advection<2> wind{Vector<2>{1, 0.5}};

template <class Grid, class Law, class R>
std::vector<double> rates_of(
    const Grid& grid, const Law& law, const R& reconstruction, const std::vector<double>& u,
    NamedBoundaries<Grid::dimension, PointLawOf<Law>::num_components> boundaries = {}, double time = 0) {
  using Rates = SemiDiscrete<Grid, Law, R, KurganovTadmor>;
  Rates rates{{grid, law, reconstruction, {}, std::move(boundaries)}, 0.5, {}};
  typename Rates::Storage fields{rates.num_sites()};
  typename Rates::Storage result{rates.num_sites()};
  fields.gather(u, {});
  rates(fields, result, time);
  return {result.all().begin(), result.all().end()};
}

template <class B>
NamedBoundaries<2, 1> all_sides(const B& boundary) {
  return {{"left", boundary}, {"right", boundary}, {"bottom", boundary}, {"top", boundary}};
}

TEST(CellGradient, IsExactForLinearFieldsOnEveryMesh) {  // Eq. (T31): du/dt = -v . grad u in every cell
  for (const int rings : {1, 2}) {
    for (const auto& [name, rectangle] : test::rectangles(false)) {
      const Polygonal grid{make_mesh(rectangle)};
      std::vector<double> u;
      for (Index i = 0; i < grid.num_cells(); ++i)
        u.push_back(1 + 3 * grid.centre(i)[0] - 2 * grid.centre(i)[1]);

      const auto rates = rates_of(grid, wind, Exact{{}, rings}, u, all_sides(Outflow{}));

      // Fluxes below 5 of some fifty operations each; the weights of a gradient amplify roundings by up to
      // the square root of 1/0.05, the least that a stencil may see.
      const double tolerance = test::largest_area_per_volume(grid) * 5 * 50 * std::sqrt(1 / 0.05) * round_off;
      for (const double rate : rates)
        ASSERT_NEAR(rate, -(3 * 1 - 2 * 0.5), tolerance) << name << ' ' << rings;
    }
  }
}

TEST(CellGradient, IsExactInOneAndThreeDimensions) {
  const Lattice<1> line = test::line(10, 0, 1, false);
  std::vector<double> u;
  for (Index i = 0; i < 10; ++i) u.push_back(2 - 3 * line.position({i})[0]);
  for (const double rate :
       rates_of(test::BoxGrid<1>{line}, Advection<1>{Vector<1>{2.0}}, Exact{}, u, {{"rim", Outflow{}}})) {
    EXPECT_NEAR(rate, 6, 2 * 10 * 4 * 30 * round_off);  // two faces, 1/dx, fluxes below 4, thirty operations
  }

  Lattice<3> box = test::cube<3>(5);
  box.is_periodic.fill(false);
  const test::BoxGrid<3> grid{box};
  const Vector<3> gradient{1, -2, 0.5};
  u.clear();
  for (Index i = 0; i < grid.num_cells(); ++i) u.push_back(gradient.dot(grid.centre(i)));
  const Vector<3> velocity{1, 2, 3};
  const double area_per_volume = 2 * (1 / box.spacing.array()).sum();
  for (const double rate : rates_of(grid, Advection<3>{velocity}, Exact{}, u, {{"rim", Outflow{}}})) {
    EXPECT_NEAR(rate, -gradient.dot(velocity), area_per_volume * 20 * 50 * round_off);
  }
}

TEST(GreenGauss, IsNotExactForLinearFields) {  // so it is not what gradients are made of
  for (const Index n : {12, 48}) {
    const Polygonal grid{make_mesh({.count = {n, n}, .perturbation = 0.2, .is_periodic = {true, true}})};
    const Vector<2> gradient{3, -2};
    std::vector<Vector<2>> found(static_cast<std::size_t>(grid.num_cells()), Vector<2>::Zero());
    for (Index i = 0; i < grid.num_faces(); ++i) {
      const GridFace<2>& face = grid.face(i);
      // Half the difference of both cells, as it is in a linear field.
      const double half = 0.5 * gradient.dot(face.from_owner - face.from_neighbour);
      const auto owner = static_cast<std::size_t>(face.owner);
      const auto neighbour = static_cast<std::size_t>(face.neighbour);
      found[owner] += face.area * half * face.normal / grid.volume(face.owner);
      found[neighbour] += face.area * half * face.normal / grid.volume(face.neighbour);
    }
    double mean = 0;
    for (const Vector<2>& g : found) mean += (g - gradient).norm() / gradient.norm();
    mean /= static_cast<double>(grid.num_cells());
    EXPECT_GT(mean, 0.1) << n;  // the means of both cells are not the values at the faces: finer is no cure
  }
}

TEST(FreeStream, StaysOnEveryMesh) {
  const Euler<2> gas;
  const auto state = gas.state(1.2, Vector<2>{0.7, -0.4}, 1.5);
  const NamedBoundaries<2, 4> boundaries{{"left", Prescribed<4>{state}},
                                         {"right", Outflow{}},
                                         {"bottom", Outflow{}},
                                         {"top", Prescribed<4>{state}}};
  for (const auto& [name, rectangle] : test::rectangles(false)) {
    const Polygonal grid{make_mesh(rectangle)};
    std::vector<double> u;
    for (Index i = 0; i < grid.num_cells(); ++i) u.insert(u.end(), state.begin(), state.end());

    // Fluxes below 6, of some thirty operations.
    const double tolerance = test::largest_area_per_volume(grid) * 6 * 30 * round_off;
    for (const double rate : rates_of(grid, gas, CellGradient<SmoothCubic>{}, u, boundaries)) {
      ASSERT_NEAR(rate, 0, tolerance) << name;
    }
    for (const double rate : rates_of(grid, gas, PiecewiseConstant{}, u, boundaries)) {
      ASSERT_NEAR(rate, 0, tolerance) << name;
    }
  }
}

TEST(Unstructured, KeepsTheMassToRoundOff) {
  for (const auto& [name, rectangle] : test::rectangles(true)) {
    const Polygonal grid{make_mesh(rectangle)};
    std::mt19937_64 engine{7};
    std::vector<double> u(static_cast<std::size_t>(grid.num_cells()));
    for (double& value : u) value = static_cast<double>(engine() >> 11) * 0x1p-53;
    const double before = test::mass(grid, u);
    Solver solver{grid, Burgers{}, CellGradient{SmoothCubic{}}};

    const int steps = solver.advance(u, 0.05).substeps;

    // Every cell is rounded some ten times a step, by half a digit of at most 1.
    const double area = (rectangle.high - rectangle.low).prod();
    EXPECT_NEAR(test::mass(grid, u), before, 10 * steps * area * round_off) << name;
  }
}

template <int D>
void expect_as_on_a_lattice(const Lattice<D>& lattice) {
  const test::BoxGrid<D> grid{lattice};
  std::vector<double> u;
  for (Index i = 0; i < lattice.num_sites(); ++i) u.push_back(std::sin(3.0 * static_cast<double>(i * i)));
  using OnLattice = SemiDiscrete<Cartesian<D>, Burgers, PiecewiseConstant, KurganovTadmor>;
  OnLattice on_lattice{{lattice, {}, {}, {}, {}}, 1, {}};
  Fields<1> fields{lattice.num_sites()};
  Fields<1> expected{lattice.num_sites()};
  fields.gather(u, {});
  on_lattice(fields, expected, 0);
  std::vector<double> rates(u.size());
  expected.scatter(rates, {}, [](Index) { return true; });

  const auto found = rates_of(grid, Burgers{}, PiecewiseConstant{}, u);

  const double area_per_volume = 2 * (1 / lattice.spacing.array()).sum();
  for (std::size_t i = 0; i < u.size(); ++i) {
    EXPECT_NEAR(found[i], rates[i], area_per_volume * 2 * 10 * round_off);  // fluxes below 2, ten operations
  }
}

TEST(Unstructured, IsTheLatticeSchemeOnALattice) {
  expect_as_on_a_lattice<1>(test::line(20, 0, 1));
  Lattice<2> flat = test::cube<2>(7);
  flat.spacing = Vector<2>{0.1, 0.3};
  expect_as_on_a_lattice<2>(flat);
  expect_as_on_a_lattice<3>(test::cube<3>(4));
}

TEST(Unstructured, TakesTheStepsOfALattice) {  // Eq. (T34): a square of width h at CFL: dt 2 a/h <= CFL
  const test::BoxGrid<2> grid{test::cube<2>(8)};
  const double width = test::cube<2>(8).spacing[0];
  const std::vector<double> u(64, 1.0);
  Solver first{grid, Advection<2>{Vector<2>{3, -3}}, PiecewiseConstant{}, SspRk2{}, {.cfl = 1}};
  EXPECT_DOUBLE_EQ(first.stable_time_step(u), width / 6);
  Solver second{grid, Advection<2>{Vector<2>{3, -3}}, CellGradient{SmoothCubic{}}, SspRk2{}, {.cfl = 0.5}};
  EXPECT_DOUBLE_EQ(second.stable_time_step(u), 0.5 * width / 6);
}

TEST(Unstructured, HasTheSameBitsForAnyNumberOfThreads) {
  const Polygonal grid{make_mesh({.count = {80, 80}, .cut = Cut::mixed, .perturbation = 0.2})};  // 8 patches
  std::mt19937_64 engine{3};
  std::vector<double> start(static_cast<std::size_t>(grid.num_cells()));
  for (double& value : start) value = static_cast<double>(engine() >> 11) * 0x1p-53;
  const auto run = [&](int threads) {
    std::vector<double> u = start;
    Solver solver{grid,
                  Burgers{},
                  CellGradient{SmoothCubic{}},
                  SspRk2{},
                  {.threads = {threads}, .boundaries = all_sides(Outflow{})}};
    solver.advance(u, 0.005);
    return u;
  };

  const auto one = run(1);
  EXPECT_EQ(run(2), one);
  EXPECT_EQ(run(3), one);
}

TEST(Unstructured, DoesNotDependOnTheOrderOfTheCells) {  // but for rounding
  const PolygonalMesh mesh = make_mesh({.count = {12, 12}, .perturbation = 0.2, .is_periodic = {true, true}});
  const auto order = hilbert_order(mesh);
  const Polygonal grid{mesh};
  const Polygonal other{reordered(mesh, order)};
  const auto f = [](const Vector<2>& x) { return std::sin(6 * x[0]) * std::cos(5 * x[1]); };

  const auto rates = rates_of(grid, wind, CellGradient<SmoothCubic>{}, test::averages(grid, f));
  const auto moved = rates_of(other, wind, CellGradient<SmoothCubic>{}, test::averages(other, f));

  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_NEAR(moved[i], rates[static_cast<std::size_t>(order[i])],
                test::largest_area_per_volume(grid) * 2 * 100 * round_off);  // a hundred operations
  }
}

TEST(Unstructured, DoesNotDependOnHowCellsArePatched) {  // but for rounding: a square, and 8 x 8 of it
  const Rectangle square{
      .high = {8, 8}, .count = {8, 8}, .cut = Cut::quadrilaterals, .is_periodic = {true, true}};
  Rectangle large = square;
  large.high = {64, 64};
  large.count = {64, 64};
  const Polygonal one_patch{make_mesh(square)};
  const Polygonal patches{make_mesh(large)};
  const auto in_square = [](Index cell) { return static_cast<std::size_t>(cell / 64 % 8 * 8 + cell % 8); };
  std::vector<double> u;
  for (Index i = 0; i < 64; ++i) u.push_back(std::sin(3.0 * static_cast<double>(i * i)));
  std::vector<double> repeated;
  for (Index i = 0; i < 64 * 64; ++i) repeated.push_back(u[in_square(i)]);

  const auto expected = rates_of(one_patch, wind, CellGradient<SmoothCubic>{}, u);
  const auto rates = rates_of(patches, wind, CellGradient<SmoothCubic>{}, repeated);

  for (Index i = 0; i < 64 * 64; ++i) {
    // A hundred operations on fluxes below 2, and places rounded by 64 round-offs of a cell's width, in ten
    // cells.
    ASSERT_NEAR(rates[static_cast<std::size_t>(i)], expected[in_square(i)],
                test::largest_area_per_volume(patches) * 2 * (100 + 10 * 64) * round_off);
  }
}

/// Three quantities that the wind carries.
struct ThreeFractions {
  static constexpr int num_components = 3;
  using State = std::array<double, 3>;
  State flux(const State& u, const Vector<2>& normal) const noexcept {
    const double speed = wind.velocity.dot(normal);
    return {speed * u[0], speed * u[1], speed * u[2]};
  }
  double max_speed(const State& /*left*/, const State& /*right*/, const Vector<2>& normal) const noexcept {
    return std::abs(wind.velocity.dot(normal));
  }
};

TEST(CellGradientCommon, KeepsTheSumOfFractions) {  // and limiters of their own do not
  const Polygonal grid{make_mesh({.count = {12, 12}, .perturbation = 0.2, .is_periodic = {true, true}})};
  std::vector<double> u;
  for (Index i = 0; i < grid.num_cells(); ++i) {
    const Vector<2>& x = grid.centre(i);
    const double a = x[0] > 0.5 ? 0.5 : 0.1;
    const double b = x[1] > 0.4 ? 0.3 : 0.2 * x[0];
    u.insert(u.end(), {a, b, 1 - a - b});
  }
  const auto worst = [&](const auto& reconstruction) {
    const auto rates = rates_of(grid, ThreeFractions{}, reconstruction, u);
    double result = 0;
    for (std::size_t i = 0; i < rates.size(); i += 3) {
      result = std::max(result, std::abs(rates[i] + rates[i + 1] + rates[i + 2]));
    }
    return result;
  };

  const double area_per_volume = test::largest_area_per_volume(grid);
  EXPECT_LE(worst(CellGradientCommon{SmoothCubic{}, 2, 1.0}), area_per_volume * 3 * 50 * round_off);
  EXPECT_GE(worst(CellGradient{SmoothCubic{}}), 1e-3 * area_per_volume);
}

struct Decay : Advection<2> {
  static State source(const State& u, const Vector<2>& x, double time) noexcept {
    return {-u[0] * x[0] + time};
  }
};

TEST(Unstructured, AddsSources) {
  const Polygonal grid{make_mesh({.count = {5, 5}, .is_periodic = {true, true}})};
  const std::vector<double> u(static_cast<std::size_t>(grid.num_cells()), 2.0);
  const auto rates = rates_of(grid, Decay{wind}, Exact{}, u, {}, 7);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    EXPECT_NEAR(rates[i], 7 - 2 * grid.centre(static_cast<Index>(i))[0],
                test::largest_area_per_volume(grid) * 3 * 50 * round_off);
  }
}

TEST(Unstructured, TellsABoundaryItsPlaceAndTime) {
  const Polygonal grid{make_mesh({.count = {5, 5}})};
  const std::vector<double> u(static_cast<std::size_t>(grid.num_cells()), 0.0);
  auto boundaries = all_sides(Outflow{});
  boundaries["left"] =
      UserGiven<2, 1>{[](const std::array<double, 1>& /*inside*/, const BoundaryFace<2>& face) {
        return std::array<double, 1>{face.time * (1 + face.centre[1]) - face.outward[0]};
      }};
  const auto rates = rates_of(grid, Advection<2>{Vector<2>{1, 0}}, PiecewiseConstant{}, u, boundaries, 3);
  double inflow = 0;
  for (Index i = 0; i < grid.num_cells(); ++i) inflow += grid.volume(i) * rates[static_cast<std::size_t>(i)];
  EXPECT_NEAR(inflow, 3 * 1.5 + 1, 100 * round_off);  // integral of 3 (1 + y) + 1 along the left side
}

std::string message(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Unstructured, NamesTheCellThatIsNotFinite) {
  const Polygonal grid{make_mesh({.count = {2, 2}, .cut = Cut::quadrilaterals, .is_periodic = {true, true}})};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message([&] {
              rates_of(grid, wind, PiecewiseConstant{}, {1, 2, 3, nan});
            }),
            "transport: the rate of change is not finite in cell 1, position (0.75, 0.25) m");
  EXPECT_EQ(message([&] {
              rates_of(grid, wind, CellGradient<SmoothCubic>{}, {1, nan, 3, 4});
            }),
            "transport: the rate of change is not finite in cell 0, position (0.25, 0.25) m");
}

TEST(Unstructured, NamesABoundaryWithoutACondition) {
  const Polygonal grid{make_mesh({.count = {2, 2}})};
  const std::vector<double> u(8, 0.0);
  auto boundaries = all_sides(Outflow{});
  boundaries.erase("top");
  EXPECT_EQ(message([&] { rates_of(grid, wind, PiecewiseConstant{}, u, boundaries); }),
            "transport: the boundary \"top\" of the grid has no condition");
  boundaries = all_sides(Outflow{});
  boundaries["lid"] = ZeroFlux{};
  EXPECT_EQ(message([&] { rates_of(grid, wind, PiecewiseConstant{}, u, boundaries); }),
            "transport: there is a condition for a boundary \"lid\", which the grid does not have");
  boundaries.erase("lid");
  EXPECT_EQ(message([&] {
              rates_of(grid, wind, Exact{{}, 3}, u, boundaries);
            }),
            "CellGradient: rings must be 1 or 2");
}

std::string message_of_spoilt(const std::function<void(std::vector<GridFace<2>>&)>& spoil) {
  Lattice<2> lattice = test::cube<2>(2);
  lattice.spacing = Vector<2>::Ones();
  lattice.first = Vector<2>::Constant(0.5);
  lattice.is_periodic.fill(false);
  test::BoxGrid<2> grid{lattice};
  spoil(grid.faces);
  return message([&] { rates_of(grid, wind, PiecewiseConstant{}, {0, 0, 0, 0}, {{"rim", ZeroFlux{}}}); });
}

TEST(FaceGrid, IsChecked) {
  using Faces = std::vector<GridFace<2>>;
  EXPECT_EQ(message_of_spoilt([](Faces& faces) { faces[0].owner = 4; }),
            "FaceGrid: face 0 at (1, 0.5) m lies between cells 4 and 1: must lie in [0, 3]");
  EXPECT_EQ(message_of_spoilt([](Faces& faces) { faces[1].boundary = 1; }),
            "FaceGrid: face 1 at (0, 0.5) m is on boundary 1 of 1");
  EXPECT_EQ(message_of_spoilt([](Faces& faces) { faces[0].area = 0; }),
            "FaceGrid: face 0 at (1, 0.5) m has an area that is not positive and finite");
  EXPECT_EQ(message_of_spoilt([](Faces& faces) { faces[0].normal *= 2; }),
            "FaceGrid: face 0 at (1, 0.5) m has a normal that is not of length 1");
  EXPECT_EQ(
      message_of_spoilt([](Faces& faces) { faces[0].normal *= -1; }),
      "FaceGrid: face 0 at (1, 0.5) m has a normal that does not point from its owner to its neighbour");
  EXPECT_EQ(
      message_of_spoilt([](Faces& faces) { faces[1].area = 1.5; }),
      "FaceGrid: cell 0 at (0.5, 0.5) m is not closed: the outward areas of its faces do not add to zero");
}

}  // namespace
}  // namespace scree::transport
