#include "polygon_checks.hpp"

#include <scree/error.hpp>
#include <scree/transport/detail/place.hpp>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace scree::transport::detail {
namespace {

// Area that counts as none, as a part of the square of the longest side [-]: coordinates are rounded, and
// a cell this thin has a normal distance between its faces that is rounding only.
constexpr double degenerate = 1e-12;

[[noreturn]] void refuse(const std::ostringstream& text) {
  throw InputError{text.str()};
}

/// Twice the signed area of a triangle [m^2].
double cross(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

[[noreturn]] void fail_at_cell(const PolygonalMesh& mesh, Index cell, std::string_view what) {
  std::ostringstream text;
  text << "Polygonal: cell " << cell << " at ";
  text << position_text<2>(middle_of(mesh, cell));
  text << " m " << what;
  refuse(text);
}

void check_vertices(const PolygonalMesh& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (mesh.vertices[i].allFinite()) continue;
    std::ostringstream text;
    text << "Polygonal: vertex " << i << " is at ";
    text << position_text<2>(mesh.vertices[i]);
    text << " m: coordinates must be finite";
    refuse(text);
  }
}

void check_offsets(const PolygonalMesh& mesh) {
  const auto& first = mesh.first_corner;
  const auto num_corners = static_cast<Index>(mesh.corners.size());
  if (first.size() < 2 || first.front() != 0 || first.back() != num_corners) {
    std::ostringstream text;
    text << "Polygonal: first_corner must start at 0, end at the number of corners, " << num_corners
         << ", and have at least one cell";
    refuse(text);
  }
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    if (first[i + 1] - first[i] >= 3) continue;
    std::ostringstream text;
    text << "Polygonal: cell " << i << " has " << first[i + 1] - first[i] << " corners: must have at least 3";
    refuse(text);
  }
}

void check_indices(const PolygonalMesh& mesh) {
  const auto num_vertices = static_cast<Index>(mesh.vertices.size());
  const auto is_vertex = [&](Index i) { return 0 <= i && i < num_vertices; };
  for (Index cell = 0; cell < mesh.num_cells(); ++cell) {
    for (const Index corner : mesh.cell(cell)) {
      if (is_vertex(corner)) continue;
      std::ostringstream text;
      text << "Polygonal: cell " << cell << " has vertex " << corner << " as a corner: must lie in [0, "
           << num_vertices - 1 << "]";
      refuse(text);
    }
  }
  for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i) {
    const BoundaryEdge& edge = mesh.boundary_edges[i];
    if (is_vertex(edge.from) && is_vertex(edge.to)) {
      if (0 <= edge.boundary && static_cast<std::size_t>(edge.boundary) < mesh.boundary_names.size())
        continue;
      std::ostringstream text;
      text << "Polygonal: boundary edge " << i << " is on boundary " << edge.boundary << " of "
           << mesh.boundary_names.size();
      refuse(text);
    }
    std::ostringstream text;
    text << "Polygonal: boundary edge " << i << " joins vertices " << edge.from << " and " << edge.to
         << ": must lie in [0, " << num_vertices - 1 << "]";
    refuse(text);
  }
}

/// A polygon is convex, and goes round once, if it turns left at every corner and every triangle that the
/// first corner makes with a side has its area on the left.
void check_shape(const PolygonalMesh& mesh, Index cell) {
  const auto corners = mesh.cell(cell);
  const auto n = corners.size();
  const auto at = [&](std::size_t i) -> const Vector<2>& {
    return mesh.vertices[static_cast<std::size_t>(corners[i % n])];
  };
  double longest = 0;
  double shortest = (at(1) - at(0)).squaredNorm();
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    longest = std::max(longest, (at(i + 1) - at(i)).squaredNorm());
    shortest = std::min(shortest, (at(i + 1) - at(i)).squaredNorm());
    area += 0.5 * cross(at(0), at(i), at(i + 1));
  }
  if (!(shortest > degenerate * degenerate * longest)) {
    fail_at_cell(mesh, cell, "is degenerate: it has a side without length");
  }
  if (!(std::abs(area) > degenerate * longest)) fail_at_cell(mesh, cell, "is degenerate: it has no area");
  if (area < 0) fail_at_cell(mesh, cell, "is inverted: its corners must go round anticlockwise");
  for (std::size_t i = 0; i < n; ++i) {
    const bool turns_left = cross(at(i), at(i + 1), at(i + 2)) >= -degenerate * longest;
    if (turns_left && cross(at(0), at(i), at(i + 1)) >= -degenerate * longest) continue;
    std::ostringstream text;
    text << "is not convex at vertex " << corners[(i + 1) % n];
    fail_at_cell(mesh, cell, text.str());
  }
}

/// @throws InputError if two cells have the same corners.
void check_duplicates(const PolygonalMesh& mesh) {
  std::vector<std::vector<Index>> sorted;
  sorted.reserve(static_cast<std::size_t>(mesh.num_cells()));
  for (Index cell = 0; cell < mesh.num_cells(); ++cell) {
    sorted.emplace_back(mesh.cell(cell).begin(), mesh.cell(cell).end());
    std::sort(sorted.back().begin(), sorted.back().end());
  }
  std::vector<std::size_t> order(sorted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sorted[a] < sorted[b]; });
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (sorted[order[i]] != sorted[order[i + 1]]) continue;
    std::ostringstream text;
    text << "is there twice: it has the corners of cell " << order[i];
    fail_at_cell(mesh, static_cast<Index>(order[i + 1]), text.str());
  }
}

}  // namespace

Vector<2> middle_of(const PolygonalMesh& mesh, Index cell) {
  Vector<2> sum = Vector<2>::Zero();
  for (const Index corner : mesh.cell(cell)) sum += mesh.vertices[static_cast<std::size_t>(corner)];
  return sum / static_cast<double>(mesh.cell(cell).size());
}

void check_polygons(const PolygonalMesh& mesh) {
  check_vertices(mesh);
  check_offsets(mesh);
  check_indices(mesh);
  for (Index cell = 0; cell < mesh.num_cells(); ++cell) check_shape(mesh, cell);
  check_duplicates(mesh);
}

}  // namespace scree::transport::detail
