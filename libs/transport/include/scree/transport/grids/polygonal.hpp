#pragma once

#include <scree/tensor.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/face.hpp>
#include <scree/transport/grids/polygonal_mesh.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::transport {

/// An unstructured mesh of convex polygons in the plane: triangles, quadrilaterals, hexagons, any mix.
///
/// A corner may lie on a straight side (a hanging node of a finer neighbour); the cell then has two faces
/// there. Vertices in no cell are allowed. Cells keep the numbers they come with: see hilbert_order.
/// Boundaries that are paired are periodic, and no boundaries any more; nor are names without an edge.
/// @see Eq. (T30)
class Polygonal {
 public:
  static constexpr int dimension = 2;

  /// @throws InputError naming cell, edge or tag and position if an index is out of range, a coordinate not
  /// finite, a cell inverted, degenerate, not convex or there twice, an edge has more than two cells or both
  /// on one side, an edge of the rim has no tag or an inner edge has one, a periodic edge has no partner, or
  /// the mesh falls into parts.
  explicit Polygonal(PolygonalMesh mesh);

  [[nodiscard]] Index num_cells() const noexcept { return static_cast<Index>(volumes_.size()); }
  [[nodiscard]] Index num_faces() const noexcept { return static_cast<Index>(faces_.size()); }
  /// Area of a cell [m^2].
  [[nodiscard]] double volume(Index cell) const noexcept { return volumes_.data()[cell]; }
  /// Centroid of a cell [m].
  [[nodiscard]] const Vector<2>& centre(Index cell) const noexcept { return centres_.data()[cell]; }
  [[nodiscard]] const GridFace<2>& face(Index face) const noexcept { return faces_.data()[face]; }
  [[nodiscard]] int num_boundaries() const noexcept { return static_cast<int>(boundary_names_.size()); }
  [[nodiscard]] std::string_view boundary_name(int boundary) const noexcept {
    return boundary_names_.data()[boundary];
  }

  /// What it was made from: vertices and corners, for output.
  [[nodiscard]] const PolygonalMesh& mesh() const noexcept { return mesh_; }

 private:
  PolygonalMesh mesh_;
  std::vector<double> volumes_;
  std::vector<Vector<2>> centres_;
  std::vector<GridFace<2>> faces_;
  std::vector<std::string> boundary_names_;
};
static_assert(FaceGrid<Polygonal>);

}  // namespace scree::transport
