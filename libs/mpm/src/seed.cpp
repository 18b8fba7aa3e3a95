#include "instances.hpp"

#include <scree/mpm/seed.hpp>

#include <cmath>
#include <string>

namespace scree::mpm {

namespace {

/// The regular points of a box along one axis: the first one and how many. A point on either end counts, as
/// far as round-off of its position can tell.
struct Range {
  Index first;
  Index count;
};

[[nodiscard]] Range points_between(double low, double high, double origin, double distance) {
  const double slack =
      1e-9;  // [-], of the distance: positions are sums of few roundings of the mesh's length
  const auto first = static_cast<Index>(std::ceil((low - origin) / distance - 0.5 - slack));
  const auto last = static_cast<Index>(std::floor((high - origin) / distance - 0.5 + slack));
  return {first, last - first + 1};
}

template <int D>
void require_inside(const CartesianGrid<D>& grid, const Vector<D>& low, const Vector<D>& high) {
  for (int axis = 0; axis < D; ++axis) {
    const double origin = grid.origin()[axis];
    const double slack = 1e-9 * grid.spacing()[axis];
    require(origin - slack <= low[axis] && high[axis] <= origin + grid.length(axis) + slack,
            "the material from " + std::to_string(low[axis]) + " to " + std::to_string(high[axis]) +
                " m along axis " + std::to_string(axis) + " reaches out of the mesh, which goes from " +
                std::to_string(origin) + " to " + std::to_string(origin + grid.length(axis)) + " m");
  }
}

}  // namespace

template <int D, int V>
Particles<D, V> seed_box(const CartesianGrid<D>& grid, const Vector<D>& low, const Vector<D>& high,
                         const Indices<D>& per_cell, double density) {
  require(density > 0 && std::isfinite(density), "seed_box: density must be positive and finite");
  require_inside(grid, low, high);
  Lattice<D> points;
  Indices<D> first{};
  double volume = 1;
  for (int axis = 0; axis < D; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    require(per_cell[a] >= 1, "seed_box: each cell must get at least one point along each axis");
    points.spacing[axis] = grid.spacing()[axis] / static_cast<double>(per_cell[a]);
    const Range range = points_between(low[axis], high[axis], grid.origin()[axis], points.spacing[axis]);
    require(range.count >= 1, "seed_box: the box is too thin to hold a point");
    first[a] = range.first;
    points.count[a] = range.count;
    points.first[axis] = grid.origin()[axis] + (static_cast<double>(first[a]) + 0.5) * points.spacing[axis];
    volume *= points.spacing[axis];
  }
  Particles<D, V> particles;
  particles.resize(points.num_sites());
  for (Index p = 0; p < particles.size(); ++p) {
    const Vector<D> x = points.position(points.site(p));
    for (int axis = 0; axis < D; ++axis) particles.position.component(axis)[p] = x[axis];
    particles.mass.component(0)[p] = density * volume;
    particles.density.component(0)[p] = density;
    particles.id.component(0)[p] = static_cast<double>(p);
  }
  return particles;
}

#define SCREE_INSTANCE(D, V)                                                                     \
  template Particles<D, V> seed_box(const CartesianGrid<D>&, const Vector<D>&, const Vector<D>&, \
                                    const Indices<D>&, double);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
