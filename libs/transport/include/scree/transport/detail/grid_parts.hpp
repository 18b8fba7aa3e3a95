#pragma once

#include <scree/tensor.hpp>
#include <scree/transport/face.hpp>

#include <string>
#include <vector>

namespace scree::transport::detail {

/// A grid as its faces and cells: what any FaceGrid can tell.
template <int D>
struct GridParts {
  std::vector<GridFace<D>> faces;
  std::vector<double> volumes;     ///< [m^D]
  std::vector<Vector<D>> centres;  ///< [m]
  std::vector<std::string> boundary_names;

  template <class Grid>
  explicit GridParts(const Grid& grid) {
    for (Index i = 0; i < grid.num_faces(); ++i) faces.push_back(grid.face(i));
    for (Index i = 0; i < grid.num_cells(); ++i) {
      volumes.push_back(grid.volume(i));
      centres.push_back(grid.centre(i));
    }
    for (int i = 0; i < grid.num_boundaries(); ++i) boundary_names.emplace_back(grid.boundary_name(i));
  }
};

/// @throws InputError naming cell or face and position if a volume or an area is not positive, a normal not
/// of length 1, an index out of range, a cell not around its centre, or not closed.
template <int D>
void check_grid(const GridParts<D>& grid);

/// @throws RunError that names a cell where the rate of change is not finite, and its position.
template <int D>
[[noreturn]] void throw_not_finite_in_cell(Index cell, const Vector<D>& position);

extern template void check_grid<1>(const GridParts<1>&);
extern template void check_grid<2>(const GridParts<2>&);
extern template void check_grid<3>(const GridParts<3>&);
extern template void throw_not_finite_in_cell<1>(Index, const Vector<1>&);
extern template void throw_not_finite_in_cell<2>(Index, const Vector<2>&);
extern template void throw_not_finite_in_cell<3>(Index, const Vector<3>&);

}  // namespace scree::transport::detail
