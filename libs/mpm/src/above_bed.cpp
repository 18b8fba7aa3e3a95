#include "instances.hpp"
#include "point_text.hpp"

#include <scree/mpm/terrain/above_bed.hpp>

#include <cmath>
#include <vector>

namespace scree::mpm {

namespace {

template <int D, int V>
[[nodiscard]] Vector<D> position_of(const Particles<D, V>& particles, Index p) {
  Vector<D> x;
  for (int axis = 0; axis < D; ++axis) x[axis] = particles.position.component(axis)[p];
  return x;
}

}  // namespace

template <int D, int V>
void require_above(const Particles<D, V>& particles, const AnySurface<D>& surface, double allowed) {
  double deepest = -allowed;
  Index worst = -1;
  for (Index p = 0; p < particles.size(); ++p) {
    const double distance = surface(position_of(particles, p)).distance;
    require(!std::isnan(distance), "nothing is known of the bed at " + point_text(particles, p));
    if (distance >= deepest) continue;
    deepest = distance;
    worst = p;
  }
  if (worst < 0) return;
  char depth[32];
  std::snprintf(depth, sizeof depth, "%.6g", -deepest);
  throw InputError{"the bed cuts the material: " + point_text(particles, worst) + " is " + depth +
                   " m below it"};
}

template <int D, int V>
void keep_above(Particles<D, V>& particles, const AnySurface<D>& surface) {
  std::vector<Index> above;
  for (Index p = 0; p < particles.size(); ++p) {
    if (surface(position_of(particles, p)).distance > 0) above.push_back(p);
  }
  require(!above.empty(), "all material lies below the bed");
  particles.for_each_column([&](Column& column) { column.reorder(above); });
}

#define SCREE_INSTANCE(D, V)                                                         \
  template void require_above(const Particles<D, V>&, const AnySurface<D>&, double); \
  template void keep_above(Particles<D, V>&, const AnySurface<D>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
