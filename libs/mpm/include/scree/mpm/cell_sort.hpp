#pragma once

#include <scree/error.hpp>
#include <scree/grid.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>

namespace scree::mpm {

/// A point is outside the mesh, at a finite place.
class OutsideMesh : public RunError {
 public:
  using RunError::RunError;
};

/// Sorts the points by block and, within a block, by the cell in which their stencil begins; keeps the order
/// of those that share one. Brings points back into a periodic axis, fills each block to whole packs.
/// @param stencil_shift of the shape function: 0, 1/2 or 1 [spacings]
/// @throws OutsideMesh naming the point, its position and the mesh if one is outside it; RunError if the
/// position is not finite.
template <int D, int V>
[[nodiscard]] ParticleBlocks<D> cell_sort(Particles<D, V>& particles, const CartesianGrid<D>& grid,
                                          double stencil_shift, Threads threads);

/// The colours of a set of blocks; what cell_sort() calls last, and a restart from a checkpoint.
template <int D>
void colour_blocks(ParticleBlocks<D>& blocks, const CartesianGrid<D>& grid);

}  // namespace scree::mpm
