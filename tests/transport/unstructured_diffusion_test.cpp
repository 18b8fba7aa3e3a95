#include "meshes.hpp"

#include <scree/transport/cell_limiters.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace scree::transport {
namespace {

/// Heat at rest: K(u) = u.
struct Heat {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  static State flux(const State& /*u*/, const Vector<2>& /*normal*/) noexcept { return {0}; }
  static double max_speed(const State& /*l*/, const State& /*r*/, const Vector<2>& /*n*/) noexcept {
    return 0;
  }
  static State potential(const State& u) noexcept { return u; }
  static double max_diffusivity(const State& /*left*/, const State& /*right*/) noexcept { return 1; }
};

NamedBoundaries<2, 1> walls(const Polygonal& grid) {
  NamedBoundaries<2, 1> result;
  for (int i = 0; i < grid.num_boundaries(); ++i) result[std::string{grid.boundary_name(i)}] = ZeroFlux{};
  return result;
}

std::vector<double> rates_of(const Polygonal& grid, const std::vector<double>& u) {
  SemiDiscrete<Polygonal, Heat, PiecewiseConstant, KurganovTadmor> rates{
      {grid, {}, {}, {}, walls(grid)}, 0.5, {}};
  CellStates<1> fields{grid.num_cells()};
  CellStates<1> result{grid.num_cells()};
  fields.gather(u, {});
  rates(fields, result, 0);
  return {result.all().begin(), result.all().end()};
}

TEST(UnstructuredDiffusion, LeavesALinearFieldAlone) {  // Eq. (T36): away from walls, on every mesh
  const Vector<2> gradient{3, -2};
  for (const auto& [name, rectangle] : test::rectangles(false)) {
    const Polygonal grid{make_mesh(rectangle)};
    std::vector<double> u;
    for (Index i = 0; i < grid.num_cells(); ++i) u.push_back(gradient.dot(grid.centre(i)));
    std::vector<bool> is_inside(u.size(), true);
    std::vector<double> two_points(u.size(), 0.0);  // by differences alone
    double steepest = 0;                            // 1/(distance along the normal)
    for (Index i = 0; i < grid.num_faces(); ++i) {
      const GridFace<2>& face = grid.face(i);
      const auto owner = static_cast<std::size_t>(face.owner);
      if (face.neighbour == no_site) {
        is_inside[owner] = false;
        continue;
      }
      const auto neighbour = static_cast<std::size_t>(face.neighbour);
      const double distance = (face.from_owner - face.from_neighbour).dot(face.normal);
      const double flux = face.area * (u[neighbour] - u[owner]) / distance;
      two_points[owner] += flux / grid.volume(face.owner);
      two_points[neighbour] -= flux / grid.volume(face.neighbour);
      steepest = std::max(steepest, 1 / distance);
    }

    const auto rates = rates_of(grid, u);

    // Differences of values below 5 over distances, a hundred operations, gradients as in CellGradient's
    // test.
    const double tolerance =
        test::largest_area_per_volume(grid) * steepest * 5 * 100 * std::sqrt(1 / 0.05) * round_off;
    double worst = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!is_inside[i]) continue;
      ASSERT_NEAR(rates[i], 0, tolerance) << name;
      worst = std::max(worst, std::abs(two_points[i]));
    }
    EXPECT_GE(worst, 1) << name;  // without the rest a linear field would not stay
  }
}

TEST(UnstructuredDiffusion, LosesTheMaximumPrincipleOnSkewCells) {  // and not where cells are orthogonal
  const auto lowest = [](const Rectangle& rectangle) {
    const Polygonal grid{make_mesh(rectangle)};
    std::vector<double> u(static_cast<std::size_t>(grid.num_cells()), 0.0);
    u[u.size() / 2 + 6] = 1;  // in the middle
    Solver solver{grid, Heat{}, PiecewiseConstant{}, SspRk2{}, {.boundaries = walls(grid)}};
    solver.advance(u, solver.stable_time_step(u));
    return *std::min_element(u.begin(), u.end());
  };
  EXPECT_GE(lowest({.count = {12, 12}, .cut = Cut::quadrilaterals}), 0);
  EXPECT_LE(lowest({.count = {12, 12}, .cut = Cut::triangles, .perturbation = 0.3}),
            -1e-6);  // ten digits above rounding
}

double heat_error(Cut cut, Index n) {
  const Polygonal grid{
      make_mesh({.count = {n, n}, .cut = cut, .perturbation = 0.2, .is_periodic = {true, true}})};
  constexpr double k = 2 * std::numbers::pi;
  const double time = 0.01;
  const auto wave = [](double decay) {
    return [decay](const Vector<2>& x) { return decay * std::sin(k * x[0]) * std::sin(k * x[1]); };
  };
  auto u = test::averages(grid, wave(1));
  Solver solver{grid, Heat{}, PiecewiseConstant{}};
  solver.advance(u, time);
  return test::l1(grid, u, test::averages(grid, wave(std::exp(-2 * k * k * time))));
}

TEST(UnstructuredDiffusion, IsOfSecondOrder) {
  for (const Cut cut : {Cut::triangles, Cut::quadrilaterals, Cut::mixed}) {
    EXPECT_GE(std::log2(heat_error(cut, 8) / heat_error(cut, 32)) / 2, 1.8) << static_cast<int>(cut);
  }
}

}  // namespace
}  // namespace scree::transport
