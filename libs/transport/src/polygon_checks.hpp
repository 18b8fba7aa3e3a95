#pragma once

#include <scree/transport/grids/polygonal_mesh.hpp>

namespace scree::transport::detail {

/// Where each thing of a mesh is right by itself.
/// @throws InputError naming the first index out of range, coordinate that is not finite, cell that is
/// degenerate, inverted or not convex, or that is there twice.
void check_polygons(const PolygonalMesh& mesh);

/// The mean of a cell's corners [m]: where messages say that it is.
[[nodiscard]] Vector<2> middle_of(const PolygonalMesh& mesh, Index cell);

}  // namespace scree::transport::detail
