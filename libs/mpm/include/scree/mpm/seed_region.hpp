#pragma once

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace scree::mpm {

/// How points are laid in cells.
template <int D>
struct PointLayout {
  Indices<D> per_cell{};  ///< points along each axis of a cell, at least one
  /// None: in the middle of their shares of the cell. A number: anywhere in them, drawn by a generator that
  /// begins with it, the same on every machine.
  std::optional<std::uint64_t> random_seed{};
};

/// Points at rest wherever a place of the mesh lies in a region, each with the mass of its share of a cell.
/// @param density_at [kg/m^3], asked at the middle of each share; 0 or less, or NaN: no material there
/// @throws InputError if a cell gets no point along an axis, or no share lies in the region.
template <int D, int V>
[[nodiscard]] Particles<D, V> seed_region(const CartesianGrid<D>& grid, const PointLayout<D>& layout,
                                          const std::function<double(const Vector<D>&)>& density_at);

/// Whether a place lies in a polygon, by the parity of the edges that a ray from it to the right crosses.
/// @param corners in order, at least three; the last is joined to the first  [m]  @param x [m]
[[nodiscard]] bool is_in_polygon(std::span<const Vector<2>> corners, const Vector<2>& x) noexcept;

/// Cells with points, and how many of them have fewer than wanted: a cell with too few carries its stress
/// badly, and neighbours without any come apart.
struct CellFilling {
  Index num_filled = 0;   ///< cells with a point
  Index num_too_few = 0;  ///< of these, with fewer than wanted
  Index fewest = 0;       ///< points in any of them
};

/// @param wanted points in a cell, for instance two along each axis
template <int D, int V>
[[nodiscard]] CellFilling cell_filling(const Particles<D, V>& particles, const CartesianGrid<D>& grid,
                                       Index wanted);

}  // namespace scree::mpm
