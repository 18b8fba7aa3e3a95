#pragma once

#include <scree/grid.hpp>
#include <scree/index.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/point_transfer.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scree::mpm::detail {

/// A point's place in the mesh, in units of the spacing: the first node of its stencil and the rest.
struct Place {
  Index base;
  double xi;
};

[[nodiscard]] inline Place place_of(double x, double origin, double inverse_spacing, double shift) noexcept {
  const double along = coordinate(x, origin, inverse_spacing, shift);
  const double base = std::floor(along);
  return {static_cast<Index>(base), along - base + shift};
}

/// Of a point of a block, with all nodes of its stencil among those that the block can give to: what lies on
/// the high end of an axis, or a rounding past the block's reach, counts from the last base that has them.
template <class ShapeType, int D>
[[nodiscard]] Place place_in_block(double x, const CartesianGrid<D>& grid, int axis,
                                   const ParticleBlock<D>& block) noexcept {
  const auto a = static_cast<std::size_t>(axis);
  const Place at = place_of(x, grid.origin()[axis], 1 / grid.spacing()[axis], ShapeType::shift);
  const Index first = block.first_cell[a] - block_skin<D>;
  Index last = block.first_cell[a] + block_edge<D> + block_skin<D> - 1;
  if (!grid.is_periodic()[a]) {
    last = std::min(last, grid.num_cells()[a] + 2 - static_cast<Index>(ShapeType::support));
  }
  const Index base = std::clamp(at.base, std::min(first, last), last);
  return {base, at.xi + static_cast<double>(at.base - base)};
}

/// The velocity gradient of a point, [j][i]: dv_i/dx_j [1/s].
template <int D, int V>
[[nodiscard]] Components<Components<double, V>, D> gradient_of(const Particles<D, V>& particles,
                                                               Index p) noexcept {
  Components<Components<double, V>, D> gradient;
  for (int j = 0; j < D; ++j) {
    for (int i = 0; i < V; ++i) {
      gradient[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] =
          particles.velocity_gradient.component(i + V * j)[p];
    }
  }
  return gradient;
}

}  // namespace scree::mpm::detail
