#pragma once

#include <scree/grid.hpp>

#include <cmath>
#include <cstddef>

namespace scree::mpm::detail {

/// Moves x by whole periods into the axis, or leaves it where it is if it lies there or the axis has ends.
/// What rounding takes past either end is at the origin. What is no number stays none, and what is so far
/// away that its place in a period is lost to rounding may stay outside.
template <int D>
[[nodiscard]] double into_period(double x, const CartesianGrid<D>& grid, int axis) {
  if (!grid.is_periodic()[static_cast<std::size_t>(axis)]) return x;
  const double length = grid.length(axis);
  const double origin = grid.origin()[axis];
  const double end = origin + length;
  if (origin <= x && x < end) return x;
  const double inside = x - length * std::floor((x - origin) / length);
  const bool is_past_low = origin - length < inside && inside < origin;
  const bool is_past_high = end <= inside && inside < end + length;
  return is_past_low || is_past_high ? origin : inside;
}

}  // namespace scree::mpm::detail
