#include "meshes.hpp"

#include <scree/error.hpp>
#include <scree/transport/grids/polygonal.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace scree::transport {
namespace {

/// A unit square with a triangle on its right: five vertices, one inner face.
PolygonalMesh house() {
  PolygonalMesh mesh;
  mesh.vertices = {Vector<2>{0, 0}, Vector<2>{1, 0}, Vector<2>{1, 1}, Vector<2>{0, 1}, Vector<2>{2, 0.5}};
  mesh.add_cell(std::vector<Index>{0, 1, 2, 3});
  mesh.add_cell(std::vector<Index>{1, 4, 2});
  mesh.boundary_names = {"floor", "roof"};
  mesh.boundary_edges = {{0, 1, 0}, {3, 2, 0}, {0, 3, 0}, {1, 4, 1}, {2, 4, 1}};
  return mesh;
}

TEST(Polygonal, MeasuresCellsAndFaces) {
  const Polygonal grid{house()};

  ASSERT_EQ(grid.num_cells(), 2);
  ASSERT_EQ(grid.num_faces(), 6);
  EXPECT_DOUBLE_EQ(grid.volume(0), 1);
  EXPECT_DOUBLE_EQ(grid.volume(1), 0.5);
  EXPECT_TRUE(grid.centre(0).isApprox(Vector<2>{0.5, 0.5}));
  EXPECT_TRUE(grid.centre(1).isApprox(Vector<2>{4.0 / 3, 0.5}));
  Index inner = 0;
  while (grid.face(inner).neighbour == no_site) ++inner;
  const GridFace<2>& face = grid.face(inner);
  EXPECT_EQ(face.owner, 0);
  EXPECT_EQ(face.neighbour, 1);
  EXPECT_EQ(face.boundary, -1);
  EXPECT_DOUBLE_EQ(face.area, 1);
  EXPECT_TRUE(face.normal.isApprox(Vector<2>{1, 0}));
  EXPECT_TRUE(face.from_owner.isApprox(Vector<2>{0.5, 0}));
  EXPECT_TRUE(face.from_neighbour.isApprox(Vector<2>{-1.0 / 3, 0}));
}

TEST(Polygonal, NamesItsBoundaries) {
  PolygonalMesh mesh = house();
  mesh.boundary_names.insert(mesh.boundary_names.begin(), "not used");
  for (BoundaryEdge& edge : mesh.boundary_edges) ++edge.boundary;

  const Polygonal grid{mesh};

  ASSERT_EQ(grid.num_boundaries(), 2);
  EXPECT_EQ(grid.boundary_name(0), "floor");
  EXPECT_EQ(grid.boundary_name(1), "roof");
  double roof = 0;
  for (Index i = 0; i < grid.num_faces(); ++i) roof += grid.face(i).boundary == 1 ? grid.face(i).area : 0.0;
  EXPECT_DOUBLE_EQ(roof, 2 * std::sqrt(1.25));
}

TEST(Polygonal, TakesHangingNodes) {  // a side of the large cell is two faces
  PolygonalMesh mesh;
  mesh.vertices = {
      Vector<2>{0, 0}, Vector<2>{2, 0}, Vector<2>{2, 1}, Vector<2>{2, 2},  Vector<2>{0, 2},
      Vector<2>{3, 0}, Vector<2>{3, 1}, Vector<2>{3, 2}, Vector<2>{9, 9.5}};  // and one vertex in no cell
  mesh.add_cell(std::vector<Index>{0, 1, 2, 3, 4});
  mesh.add_cell(std::vector<Index>{1, 5, 6, 2});
  mesh.add_cell(std::vector<Index>{2, 6, 7, 3});
  mesh.boundary_names = {"rim"};
  mesh.boundary_edges = {{0, 1, 0}, {1, 5, 0}, {5, 6, 0}, {6, 7, 0}, {7, 3, 0}, {3, 4, 0}, {4, 0, 0}};

  const Polygonal grid{mesh};

  EXPECT_EQ(grid.num_faces(), 7 + 3);
  EXPECT_DOUBLE_EQ(grid.volume(0), 4);
  EXPECT_TRUE(grid.centre(0).isApprox(Vector<2>{1, 1}));
}

TEST(Polygonal, ClosesEveryCell) {
  for (const bool is_periodic : {false, true}) {
    for (const auto& [name, rectangle] : test::rectangles(is_periodic)) {
      const Polygonal grid{make_mesh(rectangle)};
      std::vector<Vector<2>> sum(static_cast<std::size_t>(grid.num_cells()), Vector<2>::Zero());
      double total = 0;
      for (Index i = 0; i < grid.num_cells(); ++i) total += grid.volume(i);
      for (Index i = 0; i < grid.num_faces(); ++i) {
        const GridFace<2>& face = grid.face(i);
        EXPECT_EQ(face.neighbour == no_site, !is_periodic && face.boundary >= 0);
        sum[static_cast<std::size_t>(face.owner)] += face.area * face.normal;
        if (face.neighbour != no_site)
          sum[static_cast<std::size_t>(face.neighbour)] -= face.area * face.normal;
      }
      for (const Vector<2>& vector : sum) {
        EXPECT_LE(vector.norm(), 64 * round_off) << name;  // eight faces of less than 1 m, each rounded
      }
      const double area = (rectangle.high - rectangle.low).prod();
      EXPECT_NEAR(total, area, static_cast<double>(grid.num_cells()) * round_off * area) << name;
    }
  }
}

TEST(Polygonal, MixesCellsOfThreeToSixCorners) {
  const PolygonalMesh mesh = make_mesh({.cut = Cut::mixed});
  std::array<int, 7> count{};
  for (Index i = 0; i < mesh.num_cells(); ++i) ++count.at(mesh.cell(i).size());
  EXPECT_GT(count[3], 0);
  EXPECT_GT(count[4], 0);
  EXPECT_GT(count[6], count[4]);
}

TEST(HilbertOrder, KeepsNeighboursNear) {  // and is a permutation, and changes no cell
  const PolygonalMesh mesh = make_mesh({.count = {64, 64}, .cut = Cut::quadrilaterals});
  const auto order = hilbert_order(mesh);
  const PolygonalMesh other = reordered(mesh, order);
  const Polygonal before{mesh};
  const Polygonal after{other};

  auto sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], static_cast<Index>(i));
  Index jumps = 0;
  for (Index i = 0; i < after.num_cells(); ++i) {
    const Vector<2> same = before.centre(order[static_cast<std::size_t>(i)]) - after.centre(i);
    EXPECT_LE(same.norm(), 4 * round_off);
    if (i > 0 && (after.centre(i) - after.centre(i - 1)).norm() > 1.01 / 64) ++jumps;
  }
  EXPECT_EQ(jumps, 0);  // of squares, the curve goes from neighbour to neighbour
}

void expect_error(const PolygonalMesh& mesh, const std::string& message) {
  try {
    const Polygonal grid{mesh};
    FAIL() << "expected: " << message;
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), message);
  }
}

void expect_error(const std::function<void(PolygonalMesh&)>& spoil, const std::string& message) {
  PolygonalMesh mesh = house();
  spoil(mesh);
  expect_error(mesh, message);
}

TEST(Polygonal, RefusesBadCells) {
  expect_error([](PolygonalMesh& mesh) { mesh.vertices[4][0] = std::numeric_limits<double>::quiet_NaN(); },
               "Polygonal: vertex 4 is at (nan, 0.5) m: coordinates must be finite");
  expect_error([](PolygonalMesh& mesh) { mesh.corners[5] = 7; },
               "Polygonal: cell 1 has vertex 7 as a corner: must lie in [0, 4]");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.add_cell(std::vector<Index>{0, 1});
      },
      "Polygonal: cell 2 has 2 corners: must have at least 3");
  expect_error(
      [](PolygonalMesh& mesh) { mesh.first_corner.back() = 6; },
      "Polygonal: first_corner must start at 0, end at the number of corners, 7, and have at least one "
      "cell");
  expect_error([](PolygonalMesh& mesh) { std::swap(mesh.corners[4], mesh.corners[5]); },
               "Polygonal: cell 1 at (1.33333, 0.5) m is inverted: its corners must go round anticlockwise");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.vertices[4] = {1, 0.25};
      },
      "Polygonal: cell 1 at (1, 0.416667) m is degenerate: it has no area");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.vertices[4] = {1, 0};
      },
      "Polygonal: cell 1 at (1, 0.333333) m is degenerate: it has a side without length");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.vertices[3] = {0.8, 0.3};
      },
      "Polygonal: cell 0 at (0.7, 0.325) m is not convex at vertex 3");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.add_cell(std::vector<Index>{4, 2, 1});
      },
      "Polygonal: cell 2 at (1.33333, 0.5) m is there twice: it has the corners of cell 1");
}

TEST(Polygonal, RefusesAPolygonThatCrossesItself) {  // a pentagram turns left at each corner
  PolygonalMesh mesh;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4 * std::acos(-1.0) * i / 5;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle));
  }
  mesh.add_cell(std::vector<Index>{0, 1, 2, 3, 4});
  try {
    const Polygonal grid{mesh};
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string{error.what()}.find("is not convex at vertex"), std::string::npos) << error.what();
  }
}

TEST(Polygonal, RefusesBadEdges) {
  expect_error(
      [](PolygonalMesh& mesh) { mesh.boundary_edges.pop_back(); },
      "Polygonal: the edge of cell 1 between vertices 2 and 4, at (1.5, 0.75) m, is on the rim of the "
      "mesh, but has no boundary tag");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.boundary_edges.push_back({4, 2, 0});
      },
      "Polygonal: the edge of cell 1 between vertices 2 and 4, at (1.5, 0.75) m, has more than one "
      "boundary tag");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.boundary_edges.push_back({1, 2, 0});
      },
      "Polygonal: the edge of cell 0 between vertices 1 and 2, at (1, 0.5) m, has a boundary tag, but "
      "cells on both sides");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.boundary_edges.push_back({0, 2, 1});
      },
      "Polygonal: the boundary edge of \"roof\" between vertices 0 and 2 is no edge of a cell");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.boundary_edges.push_back({0, 9, 1});
      },
      "Polygonal: boundary edge 5 joins vertices 0 and 9: must lie in [0, 4]");
  expect_error([](PolygonalMesh& mesh) { mesh.boundary_edges[0].boundary = 2; },
               "Polygonal: boundary edge 0 is on boundary 2 of 2");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.vertices.emplace_back(0.5, 0.2);
        mesh.add_cell(std::vector<Index>{2, 5, 1});  // on the side of cell 0, where cell 1 is too
      },
      "Polygonal: the edge of cell 0 between vertices 1 and 2, at (1, 0.5) m, has more than two cells");
  expect_error(
      [](PolygonalMesh& mesh) {
        mesh.vertices.emplace_back(0.5, -1);
        mesh.boundary_edges.erase(mesh.boundary_edges.begin());
        mesh.vertices.emplace_back(0.5, 0.9);
        mesh.add_cell(std::vector<Index>{0, 1, 6});  // inside cell 0
      },
      "Polygonal: the edge of cell 0 between vertices 0 and 1, at (0.5, 0) m, has both cells on one side: "
      "they "
      "overlap, cell 2");
}

TEST(Polygonal, RefusesAMeshInParts) {
  PolygonalMesh mesh = house();
  for (const Vector<2>& vertex : house().vertices) mesh.vertices.emplace_back(vertex + Vector<2>{5, 0});
  mesh.add_cell(std::vector<Index>{5, 6, 7, 8});
  for (const auto& [a, b] : {std::pair{5, 6}, {6, 7}, {7, 8}, {8, 5}})
    mesh.boundary_edges.push_back({a, b, 0});
  expect_error(mesh, "Polygonal: cell 2 at (5.5, 0.5) m has no neighbour");

  mesh.add_cell(std::vector<Index>{6, 9, 7});
  mesh.boundary_edges.erase(mesh.boundary_edges.begin() + 6);
  mesh.boundary_edges.push_back({6, 9, 0});
  mesh.boundary_edges.push_back({9, 7, 0});
  expect_error(mesh, "Polygonal: cell 2 at (5.5, 0.5) m is not connected to cell 0");
}

TEST(Polygonal, RefusesPeriodicBoundariesThatDoNotFit) {
  PolygonalMesh mesh = make_mesh({.count = {2, 2}, .cut = Cut::quadrilaterals, .is_periodic = {true, false}});
  mesh.periodic_pairs[0].translation[1] = 0.1;
  expect_error(
      mesh,
      "Polygonal: the face at (0, 0.25) m of the periodic boundary \"left\" has no partner on \"right\" "
      "at (1, 0.35) m");
  mesh.periodic_pairs[0].second = "wright";
  expect_error(mesh, "Polygonal: there is no boundary \"wright\" to be periodic");
}

TEST(Rectangle, RefusesNumbersOutOfRange) {
  const auto message = [](const Rectangle& rectangle) {
    try {
      static_cast<void>(make_mesh(rectangle));
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  EXPECT_EQ(message({.high = Vector<2>{0, 1}}),
            "Rectangle: `high` must lie above and to the right of `low`, both finite");
  EXPECT_EQ(message({.count = {4, 0}}), "Rectangle: each axis must have at least one cell");
  EXPECT_EQ(message({.perturbation = 0.31}), "Rectangle: the perturbation must lie in [0, 0.3]");
  EXPECT_EQ(message({.distortion = -0.01}), "Rectangle: the distortion must lie in [0, 0.1]");
}

}  // namespace
}  // namespace scree::transport
