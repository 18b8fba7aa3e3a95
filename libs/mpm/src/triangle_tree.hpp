#pragma once

#include <scree/tensor.hpp>
#include <scree/triangle_mesh.hpp>

#include <array>
#include <vector>

namespace scree::mpm::detail {

/// The place of a triangle that is nearest to another place, and which part of it that is.
struct NearestPlace {
  Vector<3> place;
  int feature;  ///< 0: the face; 1 to 3: the edge from corner 0, 1, 2 on; 4 to 6: corner 0, 1, 2
};

/// Nearest place of a triangle, by the regions of its corners, edges and face.
[[nodiscard]] NearestPlace nearest_on_triangle(const std::array<Vector<3>, 3>& corners,
                                               const Vector<3>& x) noexcept;

/// A checked mesh with the pseudo-normals of its parts, and boxes around its triangles, halved again and
/// again.
class TriangleTree {
 public:
  explicit TriangleTree(TriangleMesh mesh);

  struct Found {
    double distance;          ///< [m], not negative
    Vector<3> place;          ///< nearest on the surface
    Vector<3> pseudo_normal;  ///< there, of any length
  };
  [[nodiscard]] Found nearest(const Vector<3>& x) const noexcept;

 private:
  struct Box {
    Vector<3> low = Vector<3>::Zero();
    Vector<3> high = Vector<3>::Zero();
    Index begin;       ///< of its triangles, in order_
    Index end;         ///< one past the last
    Index first_half;  ///< box; the second half follows it; -1: none
  };

  void find_normals();
  void build();
  void halve(Index box);
  [[nodiscard]] std::array<Vector<3>, 3> corners(Index triangle) const noexcept;

  TriangleMesh mesh_;
  std::vector<std::array<Vector<3>, 7>> normals_;  ///< of a triangle's features
  std::vector<Index> order_;
  std::vector<Box> boxes_;
};

}  // namespace scree::mpm::detail
