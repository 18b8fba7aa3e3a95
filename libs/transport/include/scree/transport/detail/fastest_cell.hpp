#pragma once

#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/numbering.hpp>

#include <algorithm>
#include <cmath>

// For messages: which cell makes steps short, and how far it is across a grid.

namespace scree::transport::detail {

/// Cells along the longest way through a grid.
template <class Grid>
[[nodiscard]] Index num_across(const Grid& grid) noexcept {
  if constexpr (LatticeGrid<Grid>) {
    const auto count = grid.count();
    return *std::max_element(count.begin(), count.end());
  } else {
    return static_cast<Index>(std::ceil(std::pow(grid.num_cells(), 1.0 / Grid::dimension)));
  }
}

/// How fast the waves between two states cross a cell [1/s].
/// @param width of the cell along the normal [m]
template <class Law, int D>
[[nodiscard]] double crossings(const Law& law, const typename Law::State& left,
                               const typename Law::State& right, const Vector<D>& normal,
                               double width) noexcept {
  double result = law.max_speed(left, right, normal) / width;
  if constexpr (Diffusive<Law>) result += 2 * law.max_diffusivity(left, right) / (width * width);
  return result;
}

/// The cell of a lattice that the waves between it and its upper neighbours cross fastest.
template <LatticeGrid Grid, class Law, class States>
[[nodiscard]] Index fastest_cell(const Grid& grid, const Law& law, const States& states) noexcept {
  constexpr int D = Grid::dimension;
  const Numbering<D> numbering{grid.count(), grid.is_periodic()};
  Index fastest = 0;
  double most = -1;
  for (Index cell = 0; cell < states.num_sites(); ++cell) {
    if (!(grid.density(cell) > 0)) continue;
    const Indices<D> site = numbering.site(cell);
    for (int axis = 0; axis < D; ++axis) {
      const Index coordinate = site[static_cast<std::size_t>(axis)];
      const Index above = numbering.neighbour(cell, coordinate, axis, 1);
      const Index other = above != no_site && grid.density(above) > 0 ? above : cell;
      const double width = grid.width(axis, coordinate);
      const double here =
          crossings<PointLawOf<Law>, D>(law_at(law, Face{cell, other, axis, width}), states[cell],
                                        states[other], Vector<D>::Unit(axis), width);
      if (!(here > most)) continue;
      most = here;
      fastest = cell;
    }
  }
  return fastest;
}

/// The cell of any grid that the waves through one of its faces cross fastest.
template <FaceGrid Grid, class Law, class States>
[[nodiscard]] Index fastest_cell(const Grid& grid, const Law& law, const States& states) noexcept {
  constexpr int D = Grid::dimension;
  Index fastest = 0;
  double most = -1;
  for (Index i = 0; i < grid.num_faces(); ++i) {
    const GridFace<D> face = grid.face(i);
    const Index other = face.neighbour == no_site ? face.owner : face.neighbour;
    const Index cell =
        grid.volume(other) < grid.volume(face.owner) ? other : face.owner;  // the smaller of both
    const double here = crossings<PointLawOf<Law>, D>(law_at<D>(law, face), states[face.owner], states[other],
                                                      face.normal, grid.volume(cell) / face.area);
    if (!(here > most)) continue;
    most = here;
    fastest = cell;
  }
  return fastest;
}

}  // namespace scree::transport::detail
