#include "messages.hpp"

#include <scree/mpm/terrain/bed_nodes.hpp>
#include <scree/mpm/terrain/triangle_surface.hpp>

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace scree::mpm {
namespace {

/// The box [-1, 1] x [-2, 2] x [-3, 3], two triangles a side, seen from outside or from inside.
[[nodiscard]] TriangleMesh box(bool from_inside = false) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.push_back(Vector<3>{(corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 2.0 : -2.0,
                                      (corner & 4) != 0 ? 3.0 : -3.0});
  }
  mesh.triangles = {{{0, 2, 3}}, {{0, 3, 1}}, {{4, 5, 7}}, {{4, 7, 6}}, {{0, 1, 5}}, {{0, 5, 4}},
                    {{2, 6, 7}}, {{2, 7, 3}}, {{0, 4, 6}}, {{0, 6, 2}}, {{1, 3, 7}}, {{1, 7, 5}}};
  if (from_inside) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

/// Distance from that box, positive outside.
[[nodiscard]] double from_box(const Vector<3>& x) {
  const Vector<3> beyond = x.cwiseAbs() - Vector<3>{1, 2, 3};
  return beyond.cwiseMax(Vector<3>::Zero()).norm() + std::min(beyond.maxCoeff(), 0.0);
}

template <class Body>
void for_each_place(Body&& body) {
  std::mt19937 random{23};
  std::uniform_real_distribution<double> draw{-4, 4};
  for (int i = 0; i < 2000; ++i) body(Vector<3>{draw(random), draw(random), draw(random)});
}

// A place is projected on an edge or a face: some thirty operations on numbers up to 6.
constexpr double tolerance = 30 * 6 * round_off;

TEST(TriangleSurface, IsAsFarAsItsSidesEdgesAndCornersAre) {  // Eq. (M65)
  const TriangleSurface outside{box()};
  const TriangleSurface inside{box(true)};
  for_each_place([&](const Vector<3>& x) {
    EXPECT_NEAR(outside(x).distance, from_box(x), tolerance);
    EXPECT_NEAR(inside(x).distance, -from_box(x), tolerance);
  });
}

/// The normal is the gradient of the distance: central differences, wrong by the square of the step over that
/// of the distance, but where two sides are as near.
TEST(TriangleSurface, HasTheGradientOfTheDistanceAsNormal) {
  const TriangleSurface surface{box()};
  constexpr double step = 1e-5;
  for_each_place([&](const Vector<3>& x) {
    if (from_box(x) < 0.1) return;
    Vector<3> gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector<3> shift = step * Vector<3>::Unit(axis);
      gradient[axis] = (surface(x + shift).distance - surface(x - shift).distance) / (2 * step);
    }
    // Second derivatives jump where an edge takes over from a side, by 1/0.1.
    EXPECT_LE((surface(x).normal - gradient).norm(), step / 0.1 + tolerance / step);
  });
}

/// A spire of three steep sides, which face more than a right angle away from each other: places near its top
/// and its edges lie behind the plane of a side that is as near, and outside all the same.
TEST(TriangleSurface, KnowsItsSideAtSharpEdgesAndCorners) {
  TriangleMesh mesh{{Vector<3>{0, 0, 0}}, {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 1}}}};
  constexpr double third = 2 * std::numbers::pi / 3;
  for (int i = 0; i < 3; ++i)
    mesh.vertices.push_back(Vector<3>{std::cos(i * third), std::sin(i * third), -8});
  const TriangleSurface spire{mesh};

  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6;
    const Vector<3> from_top{0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.1};
    EXPECT_NEAR(spire(from_top).distance, from_top.norm(), tolerance);
  }
  for (int i = 0; i < 3; ++i) {
    const Vector<3> on_edge = mesh.vertices[static_cast<std::size_t>(1 + i)] / 2;
    const Vector<3> across{-std::sin(i * third), std::cos(i * third), 0};
    for (const double turn : {-0.9, 0.9}) {  // less than the 60 degrees to either side's normal
      const Vector<3> outward = on_edge.cross(across).normalized() * (on_edge.cross(across)[2] < 0 ? -1 : 1);
      const Vector<3> arm = 0.1 * (std::cos(turn) * outward + std::sin(turn) * across);
      EXPECT_NEAR(spire(on_edge + arm).distance, 0.1, 4 * tolerance);
    }
  }
}

/// A wavy sheet of triangles, and the nearest of all of them one by one.
TEST(TriangleSurface, FindsTheNearestOfManyTriangles) {
  TriangleMesh mesh;
  constexpr Index n = 12;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) - n / 2.0;
      const double y = static_cast<double>(j) - n / 2.0;
      mesh.vertices.push_back(Vector<3>{x / 2, y / 2, std::sin(x) * std::cos(y)});
    }
  }
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const Index v = i + (n + 1) * j;
      mesh.triangles.push_back({v, v + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  }
  std::vector<TriangleSurface> one_by_one;
  for (const auto& triangle : mesh.triangles) {
    TriangleMesh one{mesh.vertices, {triangle}};
    one_by_one.emplace_back(std::move(one));
  }
  const TriangleSurface all{mesh};

  std::mt19937 random{29};
  std::uniform_real_distribution<double> draw{-3, 3};
  for (int k = 0; k < 100; ++k) {
    const Vector<3> x{draw(random), draw(random), draw(random)};
    double nearest = 1e9;
    for (const auto& one : one_by_one) nearest = std::min(nearest, std::abs(one(x).distance));
    EXPECT_EQ(std::abs(all(x).distance), nearest);
  }
}

TEST(TriangleSurface, HoldsTheNodesOfThePlaneThatItIs) {
  const CartesianGrid<3> grid{Vector<3>{0, 0, 0}, Vector<3>{0.25, 0.25, 0.25}, {4, 4, 4}, {}};
  const Vector<3> normal = Vector<3>{-0.3, 0.1, 1}.normalized();
  const auto on_plane = [&](double x, double y) {
    return Vector<3>{x, y, 0.37 - (normal[0] * x + normal[1] * y) / normal[2]};
  };
  const TriangleMesh mesh{{on_plane(-2, -2), on_plane(3, -2), on_plane(3, 3), on_plane(-2, 3)},
                          {{{0, 1, 2}}, {{0, 2, 3}}}};

  const auto by_triangles = bed_nodes<3>(grid, TriangleSurface{mesh});
  const auto by_plane = bed_nodes<3>(grid, PlaneSurface<3>{on_plane(0, 0), normal});

  ASSERT_EQ(by_triangles.size(), by_plane.size());
  for (std::size_t i = 0; i < by_plane.size(); ++i) {
    EXPECT_EQ(by_triangles[i].node, by_plane[i].node);
    EXPECT_NEAR(by_triangles[i].area, by_plane[i].area, 1e3 * tolerance);  // 64 samples in each of 8 cells
  }
}

/// Where it fails: an open surface has no inside. Beyond its rim the plane of the triangle there goes on.
TEST(TriangleSurface, GoesOnBeyondItsRimAsTheTriangleThere) {
  const TriangleSurface sheet{
      TriangleMesh{{Vector<3>{0, 0, 0}, Vector<3>{1, 0, 0}, Vector<3>{0, 1, 0}}, {{{0, 1, 2}}}}};

  EXPECT_NEAR((sheet(Vector<3>{0.5, -3, 4}).distance), 5, tolerance);
  EXPECT_NEAR((sheet(Vector<3>{0.5, -3, -4}).distance), -5, tolerance);
}

[[nodiscard]] std::string fault(const std::vector<std::array<Index, 3>>& triangles) {
  const std::vector<Vector<3>> vertices{Vector<3>{0, 0, 0}, Vector<3>{1, 0, 0}, Vector<3>{1, 1, 0},
                                        Vector<3>{0, 1, 0}, Vector<3>{2, 0, 0}};
  return message_of<InputError>([&] { TriangleSurface{TriangleMesh{vertices, triangles}}; });
}

TEST(TriangleSurface, RefusesWhatIsNoSurface) {
  EXPECT_EQ(fault({}), "TriangleSurface: has no triangle");
  EXPECT_EQ(fault({{{0, 1, 7}}}), "TriangleSurface: triangle 0 names vertex 7 of 5");
  EXPECT_EQ(fault({{{0, 1, 2}}, {{0, 1, 4}}}), "TriangleSurface: triangle 1 has no area");
  EXPECT_EQ(
      fault({{{0, 1, 2}}, {{0, 3, 2}}}),
      "TriangleSurface: triangle 0 and triangle 1 have an edge in the same direction: they face different "
      "ways, or the edge has more than two triangles");
}

}  // namespace
}  // namespace scree::mpm
