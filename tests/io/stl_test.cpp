#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/stl.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace scree::io {
namespace {

using test::message_of;

const std::string facet_a =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string facet_b =
    "facet normal 0 0 1\n outer loop\n vertex 1 0 0\n vertex 1 1 2.5e-1\n vertex 0 1 -0.0\n endloop\n "
    "endfacet\n";

template <class Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A binary file of triangles, nine coordinates each.
[[nodiscard]] std::string binary(const std::vector<float>& coordinates, const std::string& title = "bed") {
  std::string bytes = title;
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t first = 0; first < coordinates.size(); first += 9) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (std::size_t i = 0; i < 9; ++i) append(bytes, coordinates[first + i]);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

const std::vector<float> two_triangles{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0.25F, 0, 1, -0.0F};

[[nodiscard]] std::string fault(const std::string& bytes) {
  return message_of<InputError>([&] { static_cast<void>(parse_stl(bytes, "bed.stl")); });
}

void expect_two_triangles(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.vertices.size(), 4U);  // of six corners, two and two are one
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.triangles[0], (std::array<Index, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.triangles[1], (std::array<Index, 3>{1, 3, 2}));
  EXPECT_EQ(mesh.vertices[3], (Vector<3>{1, 1, 0.25}));
}

TEST(Stl, IsTheSameAsTextAndBinary) {
  expect_two_triangles(parse_stl("solid my bed\n" + facet_a + facet_b + "endsolid my bed\n", "bed.stl"));
  expect_two_triangles(parse_stl(binary(two_triangles), "bed.stl"));
}

TEST(Stl, IsBinaryIfItsLengthSaysSoWhateverItsTitle) {
  expect_two_triangles(parse_stl(binary(two_triangles, "solid bed"), "bed.stl"));
}

TEST(Stl, IsReadFromAFile) {
  const test::Scratch scratch;
  std::ofstream{scratch / "bed.stl", std::ios::binary} << binary(two_triangles);

  expect_two_triangles(read_stl(scratch / "bed.stl"));
}

TEST(Stl, RefusesATruncatedBinary) {
  const std::string bytes = binary(two_triangles);

  EXPECT_EQ(
      fault(bytes.substr(0, 150)),
      "bed.stl: is no STL: a text begins with 'solid', and 2 triangles of a binary one take 184 bytes, not "
      "150");
}

TEST(Stl, RefusesATruncatedText) {
  EXPECT_EQ(fault("solid bed\n" + facet_a), "bed.stl:9: ends where 'facet' is due");
  EXPECT_EQ(fault("solid bed\n" + facet_a.substr(0, facet_a.find("endloop"))),
            "bed.stl:7: ends where 'endloop' is due");
  EXPECT_EQ(fault("solid bed\nfacet normal 0 0 1\nouter loop\nvertex 0 0"),
            "bed.stl:4: ends where a number is due");
}

TEST(Stl, RefusesWhatIsNotATriangle) {
  EXPECT_EQ(fault("solid bed\nquad normal 0 0 1\n"), "bed.stl:2: 'facet' is due, not 'quad'");
  EXPECT_EQ(fault("solid bed\nendsolid bed\n"), "bed.stl: holds no triangle");
  EXPECT_EQ(fault(binary({0, 0, 0, 1, 0, 0, 0, 1, std::numeric_limits<float>::infinity()})),
            "bed.stl: triangle 0 has a corner that is not finite");
  EXPECT_EQ(fault("solid bed\nfacet normal 0 0 1 outer loop vertex 0 0 nan vertex 1 0 0 vertex 0 1 0"),
            "bed.stl:2: a corner that is not finite");
}

}  // namespace
}  // namespace scree::io
