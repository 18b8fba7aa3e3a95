#pragma once

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>

namespace scree::mpm {

/// Regularly spaced points, `per_cell` along each axis of a cell, in every place of the box [low, high]; each
/// at rest, with the mass of its share of the cell.
/// @param low,high corners of the box [m], inside the mesh
/// @param density [kg/m^3]
/// @throws InputError if the box reaches out of the mesh, holds no point, or the density is not positive.
template <int D, int V>
[[nodiscard]] Particles<D, V> seed_box(const CartesianGrid<D>& grid, const Vector<D>& low,
                                       const Vector<D>& high, const Indices<D>& per_cell, double density);

}  // namespace scree::mpm
