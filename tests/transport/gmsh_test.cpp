#include <scree/error.hpp>
#include <scree/transport/grids/gmsh.hpp>
#include <scree/transport/grids/polygonal.hpp>

#include <gtest/gtest.h>

#include <sstream>

namespace scree::transport {
namespace {

/// A square of two triangles and a quadrilateral beside it, in the layout that Gmsh writes.
const std::string file = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 7 "in flow"
1 9 "wall"
2 8 "domain"
$EndPhysicalNames
$Entities
1 3 1 0
1 0 0 0 0
1 0 0 0 0 1 0 1 7 2 1 -1
2 0 0 0 2 1 0 1 9 2 1 -1
3 0 0 0 2 1 0 0 0
1 0 0 0 2 1 0 1 8 3 1 2 3
$EndEntities
$Nodes
2 6 1 60
0 1 0 1
1
0 0 0
2 1 0 5
20
30
40
50
60
1 0 0
2 0 0
2 1 0
1 1 0
0 1 0
$EndNodes
$Elements
6 12 1 12
0 1 15 1
1 1
1 1 1 1
2 60 1
1 2 1 5
3 1 20
4 20 30
5 30 40
6 40 50
7 50 60
1 3 1 1
8 20 50
2 1 2 2
9 1 20 50
10 1 50 60
2 1 3 1
11 20 30 40 50
$EndElements
$Periodic
0
$EndPeriodic
)";

PolygonalMesh read(const std::string& text) {
  std::istringstream input{text};
  return read_gmsh(input, "mesh.msh");
}

TEST(Gmsh, ReadsTrianglesQuadrilateralsAndNames) {
  const PolygonalMesh mesh = read(file);
  const Polygonal grid{mesh};

  ASSERT_EQ(grid.num_cells(), 3);
  EXPECT_EQ(mesh.cell(2).size(), 4U);
  EXPECT_DOUBLE_EQ(grid.volume(0), 0.5);
  EXPECT_DOUBLE_EQ(grid.volume(2), 1);
  ASSERT_EQ(grid.num_boundaries(), 2);
  EXPECT_EQ(grid.boundary_name(0), "in flow");
  EXPECT_EQ(grid.boundary_name(1), "wall");
  EXPECT_EQ(mesh.boundary_edges.size(), 6U);  // the line inside is in no group
}

/// What the reader says of the file with `from` replaced by `to`.
std::string message(const std::string& from, const std::string& to) {
  std::string text = file;
  text.replace(text.find(from), from.size(), to);
  try {
    static_cast<void>(read(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Gmsh, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(message("$MeshFormat", "hello"), "mesh.msh:1: found \"hello\", expected $MeshFormat");
  EXPECT_EQ(message("4.1 0 8", "2.2 0 8"),
            "mesh.msh:2: found format \"2.2\", expected format 4.1 (Gmsh: Mesh.MshFileVersion = 4.1)");
  EXPECT_EQ(message("4.1 0 8", "4.1 1 8"),
            "mesh.msh:2: found binary data, expected ASCII (Gmsh: Mesh.Binary = 0)");
  EXPECT_EQ(message("1 9 \"wall\"", "1 9 wall"),
            "mesh.msh:7: found wall, expected the name of a physical group in quotation marks");
  EXPECT_EQ(message("2 0 0 0 2 1 0 1 9 2 1 -1", "2 0 0 0 2 1 0 2 9 7 2 1 -1"),
            "mesh.msh:14: found curve 2 in 2 physical groups, expected one at most");
  EXPECT_EQ(message("2 6 1 60", "2 7 1 60"), "mesh.msh:33: found 6 nodes, expected 7");
  EXPECT_EQ(message("2 1 0\n1 1 0", "2 1 0\n1 x 0"), "mesh.msh:32: found \"x\", expected a coordinate");
  EXPECT_EQ(message("2 1 0\n1 1 0", "2 1 0.5\n1 1 0"),
            "mesh.msh:31: found z = 0.500000, expected a plane mesh: z = 0");
  EXPECT_EQ(message("30\n40\n", "30\n30\n"),
            "mesh.msh:31: found node 30 a second time, expected each node once");
  EXPECT_EQ(message("9 1 20 50", "9 1 20 51"), "mesh.msh:50: found node 51, expected one of the nodes");
  EXPECT_EQ(message("2 1 2 2", "2 1 9 2"),
            "mesh.msh:49: found elements of type 9, expected points (15), lines (1), triangles (2) or "
            "quadrilaterals (3)");
  EXPECT_EQ(message("$Nodes", "$Knots"), "mesh.msh:58: found the end, expected $EndKnots");
  EXPECT_EQ(message("$EndElements\n$Periodic\n0\n$EndPeriodic\n", ""),
            "mesh.msh:54: found the end, expected $EndElements");
  EXPECT_EQ(message("$EndElements\n", "12 1\n$EndElements\n"),
            "mesh.msh:54: found \"12\", expected $EndElements");
}

TEST(Gmsh, WantsElementsAfterNodes) {
  EXPECT_EQ(
      message("$Nodes\n2 6 1 60\n0 1 0 1\n1\n0 0 0\n2 1 0 5\n20\n30\n40\n50\n60\n1 0 0\n2 0 0\n2 1 0\n1 1 "
              "0\n0 1 0\n$EndNodes\n",
              ""),
      "mesh.msh:18: found $Elements, expected $Nodes before them");
}

TEST(Gmsh, NamesAFileThatIsNotThere) {
  try {
    static_cast<void>(read_gmsh(std::filesystem::path{"no_such_file.msh"}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "no_such_file.msh: cannot be opened");
  }
}

TEST(Gmsh, LeavesAnEdgeWithoutAGroupToTheMesh) {  // which then names it
  std::string text = file;
  const std::string tagged = "1 0 0 0 0 1 0 1 7 2 1 -1";
  text.replace(text.find(tagged), tagged.size(), "1 0 0 0 0 1 0 0 2 1 -1");
  try {
    const Polygonal grid{read(text)};
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "Polygonal: the edge of cell 1 between vertices 0 and 5, at (0, 0.5) m, is on the rim of the "
        "mesh, but has no boundary tag");
  }
}

}  // namespace
}  // namespace scree::transport
