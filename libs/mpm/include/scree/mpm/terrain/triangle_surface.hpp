#pragma once

#include <scree/mpm/terrain/signed_distance.hpp>
#include <scree/triangle_mesh.hpp>

#include <memory>

namespace scree::mpm {

namespace detail {
class TriangleTree;
}

/// A surface of triangles, closed or open; material is on the side that their normals point to.
///
/// The distance is that of the nearest place of the triangles, to round-off, found in a tree of boxes. Its
/// sign is that of the angle-weighted pseudo-normal there, right on edges and corners too. Beyond the rim of
/// an open surface the sign is that of the plane of the triangle at the rim.  @see Eq. (M65),
/// \cite baerentzen2005
class TriangleSurface {
 public:
  /// @throws InputError naming the triangle if one has no area or names a vertex that is not there, or two
  /// that share an edge do not face the same way, or an edge has more than two.
  explicit TriangleSurface(TriangleMesh mesh);

  [[nodiscard]] FromSurface<3> operator()(const Vector<3>& x) const noexcept;

 private:
  std::shared_ptr<const detail::TriangleTree> tree_;
};
static_assert(SignedDistance<TriangleSurface, 3>);

}  // namespace scree::mpm
