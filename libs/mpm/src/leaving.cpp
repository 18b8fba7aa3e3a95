#include "instances.hpp"

#include <scree/mpm/leaving.hpp>

#include <vector>

namespace scree::mpm {

namespace {

/// The ends of an axis between which points may be; none if it is periodic.
struct Ends {
  bool has_ends;
  double low;
  double high;
};

template <int D>
[[nodiscard]] Ends ends_of(const CartesianGrid<D>& grid, int axis) {
  return {!grid.is_periodic()[static_cast<std::size_t>(axis)], grid.origin()[axis],
          grid.origin()[axis] + grid.length(axis)};
}

template <int D, int V>
[[nodiscard]] bool is_outside(const Particles<D, V>& particles, const CartesianGrid<D>& grid, Index p) {
  for (int axis = 0; axis < D; ++axis) {
    const Ends ends = ends_of(grid, axis);
    const double x = particles.position.component(axis)[p];
    if (ends.has_ends && (x < ends.low || x > ends.high)) return true;
  }
  return false;
}

}  // namespace

template <int D, int V>
Passed<V> absorb_outside(Particles<D, V>& particles, const CartesianGrid<D>& grid,
                         std::optional<std::size_t> balanced) {
  Passed<V> left;
  std::vector<Index> staying;
  staying.reserve(static_cast<std::size_t>(particles.size()));
  for (Index p = 0; p < particles.size(); ++p) {
    if (particles.mass.component(0)[p] > 0 && is_outside(particles, grid, p)) {
      count_point(particles, p, balanced, left);
    } else {
      staying.push_back(p);
    }
  }
  if (left.count > 0) particles.for_each_column([&](Column& column) { column.reorder(staying); });
  return left;
}

template <int D, int V>
void reflect_outside(Particles<D, V>& particles, const CartesianGrid<D>& grid) {
  for (int axis = 0; axis < D; ++axis) {
    const Ends ends = ends_of(grid, axis);
    if (!ends.has_ends) continue;
    double* position = particles.position.component(axis);
    double* velocity = particles.velocity.component(axis);
    for (Index p = 0; p < particles.size(); ++p) {
      const bool is_low = position[p] < ends.low;
      if (!is_low && !(position[p] > ends.high)) continue;
      position[p] = 2 * (is_low ? ends.low : ends.high) - position[p];
      if (is_low == (velocity[p] < 0)) velocity[p] = -velocity[p];
    }
  }
}

#define SCREE_INSTANCE(D, V)                                                                                \
  template Passed<V> absorb_outside(Particles<D, V>&, const CartesianGrid<D>&, std::optional<std::size_t>); \
  template void reflect_outside(Particles<D, V>&, const CartesianGrid<D>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
