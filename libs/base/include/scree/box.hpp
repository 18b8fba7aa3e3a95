#pragma once

#include <scree/grid.hpp>

#include <array>
#include <cstddef>

namespace scree {

/// The grid of a box between two corners: `box<2>({0, 0}, {2, 1}, {200, 100})`.
///
/// @param low, high corners [m]  @param num_cells cells along each axis, at least 1
/// @param is_periodic axes whose two ends are one; none unless given
/// @throws InputError if `high` is not above `low` along each axis, or one is not finite, or an axis has no
/// cell.
template <int D>
[[nodiscard]] CartesianGrid<D> box(const std::array<double, static_cast<std::size_t>(D)>& low,
                                   const std::array<double, static_cast<std::size_t>(D)>& high,
                                   const Indices<D>& num_cells,
                                   const std::array<bool, static_cast<std::size_t>(D)>& is_periodic = {}) {
  Vector<D> origin;
  Vector<D> spacing;
  for (std::size_t axis = 0; axis < D; ++axis) {
    require(num_cells[axis] >= 1, "box: each axis must have at least one cell");
    require(high[axis] > low[axis], "box: the high corner must lie above the low one along each axis");
    origin[static_cast<int>(axis)] = low[axis];
    spacing[static_cast<int>(axis)] = (high[axis] - low[axis]) / static_cast<double>(num_cells[axis]);
  }
  return {origin, spacing, num_cells, is_periodic};
}

}  // namespace scree
