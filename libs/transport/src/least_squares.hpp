#pragma once

#include <scree/transport/detail/patch.hpp>

#include <vector>

namespace scree::transport::detail {

/// The cells around each cell and their weights in its gradient, cell by cell.  Eqs. (T31) to (T32a)
template <int D>
struct Stencils {
  std::vector<StencilCell<D>> cells;  ///< in numbers of the grid
  std::vector<Index> first;           ///< of each cell, and one past the last
  std::vector<Matrix<D>> corrections;
};

/// @param rings of neighbours to take, at least; more where these do not show every direction.
template <int D>
[[nodiscard]] Stencils<D> make_stencils(const GridParts<D>& grid, int rings);

extern template Stencils<1> make_stencils<1>(const GridParts<1>&, int);
extern template Stencils<2> make_stencils<2>(const GridParts<2>&, int);
extern template Stencils<3> make_stencils<3>(const GridParts<3>&, int);

}  // namespace scree::transport::detail
