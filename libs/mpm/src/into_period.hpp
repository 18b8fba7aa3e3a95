#pragma once

#include <scree/grid.hpp>

#include <cmath>
#include <cstddef>

namespace scree::mpm::detail {

/// Moves x by whole periods into the axis, or leaves it where it is if the axis has ends. What is no number
/// stays none, and what is so far away that its place in a period is lost to rounding may stay outside.
template <int D>
[[nodiscard]] double into_period(double x, const CartesianGrid<D>& grid, int axis) {
  if (!grid.is_periodic()[static_cast<std::size_t>(axis)]) return x;
  const double length = grid.length(axis);
  const double inside = x - length * std::floor((x - grid.origin()[axis]) / length);
  const double end = grid.origin()[axis] + length;
  return end <= inside && inside < end + length ? grid.origin()[axis] : inside;
}

}  // namespace scree::mpm::detail
