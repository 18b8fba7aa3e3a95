#pragma once

#include "kernels/carried_kernels.hpp"

#include <scree/grid.hpp>
#include <scree/instruction_set.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>

/// What those share who let points carry fields to sites: the kernels, and what these read of a block.
namespace scree::mpm::detail {

/// @param shape place in the list AnyShape; cells need none
template <int D>
[[nodiscard]] CarriedKernels<D> kernels_for([[maybe_unused]] InstructionSet set, Sites sites,
                                            std::size_t shape) noexcept {
#ifdef SCREE_WIDE_KERNELS
  if (set == InstructionSet::x86_64_v4) return x86_64_v4::carried_kernels<D>(sites, shape);
  if (set == InstructionSet::x86_64_v3) return x86_64_v3::carried_kernels<D>(sites, shape);
#endif
  return baseline::carried_kernels<D>(sites, shape);
}

/// @param part_of from a site along an axis (mesh numbering) and the axis to the part that it has
///        in the number of a site; negative if there is no such site
template <int D, int V, class PartOf>
[[nodiscard]] CarriedBlock<D> opened(const CartesianGrid<D>& grid, const Particles<D, V>& particles,
                                     const ParticleBlock<D>& block, const PartOf& part_of) noexcept {
  CarriedBlock<D> open;
  open.position = particles.position.component(0);
  open.mass = particles.mass.component(0);
  open.stride = particles.size();
  open.begin = block.begin;
  open.end = block.end;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Index first = block.first_cell[axis] - block_skin<D>;
    open.origin[axis] = grid.origin()[static_cast<int>(axis)];
    open.inverse_spacing[axis] = 1 / grid.spacing()[static_cast<int>(axis)];
    open.first[axis] = static_cast<double>(first);
    for (std::size_t i = 0; i < max_tile_edge<D>; ++i) {
      open.site[axis][i] = part_of(first + static_cast<Index>(i), axis);
    }
  }
  return open;
}

}  // namespace scree::mpm::detail
