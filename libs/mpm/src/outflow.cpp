#include "instances.hpp"
#include "into_period.hpp"

#include <scree/mpm/outflow.hpp>

#include <string>

namespace scree::mpm {

namespace {

/// Whether a point of the block may be in the box. A block's points were in the cells from its first one to
/// one beyond its last one when they were sorted, as far as a stencil may begin before a point, and have
/// moved by its skin at most.
template <int D>
[[nodiscard]] bool may_reach(const ParticleBlock<D>& block, const Outflow<D>& outflow,
                             const CartesianGrid<D>& grid) {
  for (int axis = 0; axis < D; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (grid.is_periodic()[a]) continue;
    const auto first = static_cast<double>(block.first_cell[a] - block_skin<D>);
    const auto last = static_cast<double>(block.first_cell[a] + block_edge<D> + 1 + block_skin<D>);
    if (outflow.high[axis] < grid.origin()[axis] + first * grid.spacing()[axis] ||
        outflow.low[axis] > grid.origin()[axis] + last * grid.spacing()[axis]) {
      return false;
    }
  }
  return true;
}

template <int D, int V>
[[nodiscard]] bool is_in(const Outflow<D>& outflow, const Particles<D, V>& particles,
                         const CartesianGrid<D>& grid, Index p) {
  for (int axis = 0; axis < D; ++axis) {
    const double x = detail::into_period(particles.position.component(axis)[p], grid, axis);
    if (!(outflow.low[axis] <= x && x <= outflow.high[axis])) return false;
  }
  return true;
}

}  // namespace

template <int D>
void check(const Outflow<D>& outflow, const CartesianGrid<D>& grid) {
  constexpr double slack = 1e-6;  // [-], of a cell
  for (int axis = 0; axis < D; ++axis) {
    const double cell = grid.spacing()[axis];
    const std::string along = " along axis " + std::to_string(axis);
    require(outflow.high[axis] - outflow.low[axis] >= (1 - slack) * cell,
            "Outflow: the box must be at least a cell, " + std::to_string(cell) + " m, thick" + along);
    require(outflow.low[axis] < grid.origin()[axis] + grid.length(axis) &&
                outflow.high[axis] > grid.origin()[axis],
            "Outflow: the box lies outside the mesh" + along);
  }
}

template <int D, int V>
Passed<V> take_out(State<D, V>& state, const Outflow<D>& outflow, std::optional<std::size_t> column) {
  Passed<V> taken;
  Particles<D, V>& particles = state.particles;
  double* const mass = particles.mass.component(0);
  for (const ParticleBlock<D>& block : state.blocks.blocks) {
    if (!may_reach(block, outflow, state.nodes.grid())) continue;
    for (Index p = block.begin; p < block.end; ++p) {
      if (!(mass[p] > 0) || !is_in(outflow, particles, state.nodes.grid(), p)) continue;
      count_point(particles, p, column, taken);
      mass[p] = 0;
    }
  }
  return taken;
}

#define SCREE_INSTANCE(D, V) \
  template Passed<V> take_out(State<D, V>&, const Outflow<D>&, std::optional<std::size_t>);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
template void check(const Outflow<1>&, const CartesianGrid<1>&);
template void check(const Outflow<2>&, const CartesianGrid<2>&);
template void check(const Outflow<3>&, const CartesianGrid<3>&);

}  // namespace scree::mpm
