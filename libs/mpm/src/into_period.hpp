#pragma once

#include <scree/grid.hpp>

#include <cmath>
#include <cstddef>

namespace scree::mpm::detail {

/// Moves x by whole periods into the axis, or leaves it where it is if the axis has ends.
template <int D>
[[nodiscard]] double into_period(double x, const CartesianGrid<D>& grid, int axis) {
  if (!grid.is_periodic()[static_cast<std::size_t>(axis)]) return x;
  const double length = grid.length(axis);
  const double inside = x - length * std::floor((x - grid.origin()[axis]) / length);
  return inside < grid.origin()[axis] + length ? inside : grid.origin()[axis];
}

}  // namespace scree::mpm::detail
