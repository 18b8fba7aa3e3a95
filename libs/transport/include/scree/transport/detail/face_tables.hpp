#pragma once

#include <scree/tensor.hpp>
#include <scree/transport/face.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
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

/// A cell that a gradient is made from: it adds weight x (its value - the cell's own).  Eq. (T31)
template <int D>
struct StencilCell {
  std::int32_t cell;
  Vector<D> weight;  ///< [1/m]
};

/// A face as seen from one of its cells.
template <int D>
struct CellFace {
  std::int32_t face;
  double rate;       ///< area/volume, negative where the normal points outward [1/m]
  double closeness;  ///< D/(2 x distance of the face from the centre) [1/m].  Eq. (T34)
  Vector<D> offset;  ///< from the cell's centre to the face's [m]
};

/// The cells of a face, and where it is seen from them.
template <int D>
struct FaceCells {
  std::int32_t owner;
  std::int32_t neighbour;    ///< on a boundary the owner
  Vector<D> from_owner;      ///< [m]
  Vector<D> from_neighbour;  ///< [m]
};

/// A grid as the sweeps read it: faces in the order of their cells, those on boundaries last, boundary by
/// boundary; for each cell its faces and the cells of its gradient, one after the other.
template <int D>
struct FaceTables {
  Index num_cells = 0;
  Index num_inner = 0;  ///< faces between two cells
  Index num_faces = 0;
  std::vector<FaceCells<D>> faces;
  std::vector<double> normals;        ///< component d of face f at [d * num_faces + f] [-]
  std::vector<Index> first_boundary;  ///< first face of each boundary, and one past the last
  std::vector<Index> original;        ///< the grid's own number of each face
  std::vector<CellFace<D>> cell_faces;
  std::vector<Index> first_cell_face;  ///< of each cell, and one past the last
  std::vector<StencilCell<D>> stencil;
  std::vector<Index> first_stencil_cell;  ///< of each cell, and one past the last
  std::vector<double> widths;             ///< volume^(1/D) [m]

  [[nodiscard]] std::span<const CellFace<D>> faces_of(Index cell) const noexcept {
    const Index* first = first_cell_face.data() + cell;
    return {cell_faces.data() + first[0], static_cast<std::size_t>(first[1] - first[0])};
  }
  [[nodiscard]] std::span<const StencilCell<D>> stencil_of(Index cell) const noexcept {
    const Index* first = first_stencil_cell.data() + cell;
    return {stencil.data() + first[0], static_cast<std::size_t>(first[1] - first[0])};
  }
  [[nodiscard]] Vector<D> normal(Index face) const noexcept {
    Vector<D> result;
    for (int d = 0; d < D; ++d) result[d] = normals.data()[d * num_faces + face];
    return result;
  }
};

/// @param rings of neighbours for gradients; 0: none are needed
template <int D>
[[nodiscard]] FaceTables<D> make_face_tables(const GridParts<D>& grid, int rings);

extern template void check_grid<1>(const GridParts<1>&);
extern template void check_grid<2>(const GridParts<2>&);
extern template void check_grid<3>(const GridParts<3>&);
extern template void throw_not_finite_in_cell<1>(Index, const Vector<1>&);
extern template void throw_not_finite_in_cell<2>(Index, const Vector<2>&);
extern template void throw_not_finite_in_cell<3>(Index, const Vector<3>&);
extern template FaceTables<1> make_face_tables<1>(const GridParts<1>&, int);
extern template FaceTables<2> make_face_tables<2>(const GridParts<2>&, int);
extern template FaceTables<3> make_face_tables<3>(const GridParts<3>&, int);

}  // namespace scree::transport::detail
