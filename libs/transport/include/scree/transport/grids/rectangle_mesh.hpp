#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/grids/polygonal_mesh.hpp>

#include <array>
#include <cstdint>

namespace scree::transport {

/// What a rectangle is cut into.
enum class Cut {
  quadrilaterals,
  triangles,  ///< each quadrilateral in two, the diagonal chosen at random
  mixed       ///< hexagons, some cut in two or in four: pentagons, quadrilaterals, triangles too
};

/// A rectangle to be meshed. Its boundaries are "left", "right", "bottom" and "top".
struct Rectangle {
  Vector<2> low = Vector<2>::Zero();   ///< lower left corner [m]
  Vector<2> high = Vector<2>::Ones();  ///< upper right corner [m]
  Indices<2> count{16, 16};            ///< quadrilaterals, or hexagons, along each axis, at least 1
  Cut cut = Cut::triangles;
  /// Inner vertices are moved at random, along each axis by up to this part of a cell, 0 to 0.3 [-]; of
  /// hexagons by 2/5 of that, of half their width and of their height.
  double perturbation = 0;
  /// Inner vertices are moved smoothly, by up to this part of the rectangle, 0 to 0.1 [-].
  double distortion = 0;
  std::uint64_t seed = 1;  ///< of all that is random
  /// Axes whose two ends are one: "left" with "right", "bottom" with "top".
  std::array<bool, 2> is_periodic{};
};

/// @throws InputError if a number is outside its range.
[[nodiscard]] PolygonalMesh make_mesh(const Rectangle& rectangle);

}  // namespace scree::transport
