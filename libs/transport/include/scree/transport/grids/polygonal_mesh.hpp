#pragma once

#include <scree/tensor.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace scree::transport {

/// An edge on the rim of a mesh, and which boundary it belongs to.
struct BoundaryEdge {
  Index from;    ///< a vertex
  Index to;      ///< the other one; either order
  int boundary;  ///< place in PolygonalMesh::boundary_names
};

/// Two boundaries that are one: each edge of `first`, moved by `translation`, lies on an edge of `second`.
struct PeriodicPair {
  std::string first;
  std::string second;
  Vector<2> translation;  ///< [m]
};

/// Polygons that share vertices: what a generator or a reader makes and Polygonal is built from. Plain data,
/// not checked.
struct PolygonalMesh {
  std::vector<Vector<2>> vertices;     ///< [m]; some may be in no polygon
  std::vector<Index> corners;          ///< vertices of all cells, one cell after the other, anticlockwise
  std::vector<Index> first_corner{0};  ///< of each cell, and one past the last corner: num_cells + 1
  std::vector<BoundaryEdge> boundary_edges;  ///< every edge of the rim
  std::vector<std::string> boundary_names;
  std::vector<PeriodicPair> periodic_pairs;

  [[nodiscard]] Index num_cells() const noexcept { return static_cast<Index>(first_corner.size()) - 1; }

  /// The vertices of a cell.
  [[nodiscard]] std::span<const Index> cell(Index i) const noexcept {
    const auto begin = static_cast<std::size_t>(first_corner[static_cast<std::size_t>(i)]);
    const auto end = static_cast<std::size_t>(first_corner[static_cast<std::size_t>(i) + 1]);
    return std::span{corners}.subspan(begin, end - begin);
  }

  /// Adds a cell. @param polygon its vertices, anticlockwise
  void add_cell(std::span<const Index> polygon) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    first_corner.push_back(static_cast<Index>(corners.size()));
  }
};

/// The cells along a Hilbert curve, so that neighbours are near in memory: mesh generators number badly, and
/// a step then waits for memory.
/// @return the old number of each new cell
[[nodiscard]] std::vector<Index> hilbert_order(const PolygonalMesh& mesh);

/// The mesh with its cells in another order, and its vertices in the order of their first use.
/// @param order the old number of each new cell; every one once
[[nodiscard]] PolygonalMesh reordered(const PolygonalMesh& mesh, std::span<const Index> order);

}  // namespace scree::transport
