#pragma once

#include <scree/grid.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scree {

/// What a mesh is a cut through, and so what areas and masses on it are those of.
enum class Symmetry {
  plane,  ///< a flow that is the same at any depth: of a depth of 1 m, where the mesh has two axes
  axial   ///< a flow round an axis at the low end of axis 0, which is the radius: of a radian
};

/// How deep the flow is at a place: 1 in a plane flow, the radius in a radian round an axis [m], which is
/// zero beyond the axis.
template <int D>
[[nodiscard]] double depth_at(Symmetry symmetry, const CartesianGrid<D>& grid, const Vector<D>& x) noexcept {
  return symmetry == Symmetry::plane ? 1 : std::max(x[0] - grid.origin()[0], 0.0);
}

/// Integral of the hat function of a node over an axis of the mesh [m]: its spacing, or half of it at an end;
/// along the radius, weighted by it [m^2].  Eq. (M175)
template <int D>
[[nodiscard]] double hat_integral(Symmetry symmetry, const CartesianGrid<D>& grid, int axis,
                                  Index node) noexcept {
  const auto a = static_cast<std::size_t>(axis);
  const double h = grid.spacing()[axis];
  const bool is_low_end = !grid.is_periodic()[a] && node == 0;
  const bool is_high_end = !grid.is_periodic()[a] && node == grid.num_cells()[a];
  if (symmetry == Symmetry::plane || axis > 0) return is_low_end || is_high_end ? h / 2 : h;
  const auto i = static_cast<double>(node);
  if (is_low_end) return h * h / 6;
  return is_high_end ? h * h * (i / 2 - 1.0 / 6) : h * h * std::abs(i);
}

/// Radius of the middle of the control volumes with this coordinate along axis 0, whose low end is the axis
/// of symmetry [m]: their volume in a radian is that on the lattice times it.  Eq. (M180)
template <int D>
[[nodiscard]] double middle_radius(const Lattice<D>& lattice, Index coordinate) noexcept {
  const double h = lattice.spacing[0];
  const auto i = static_cast<double>(coordinate);
  if (lattice.sites == Sites::cells) return (i + 0.5) * h;
  if (coordinate == 0) return h / 4;
  return coordinate == lattice.count[0] - 1 ? (i - 0.25) * h : i * h;
}

/// Radius of the face above them [m].  Eq. (M180)
template <int D>
[[nodiscard]] double radius_above(const Lattice<D>& lattice, Index coordinate) noexcept {
  const auto i = static_cast<double>(coordinate);
  return (lattice.sites == Sites::cells ? i + 1 : i + 0.5) * lattice.spacing[0];
}

}  // namespace scree
