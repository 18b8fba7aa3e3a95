#include "instances.hpp"
#include "point_text.hpp"

#include <scree/mpm/limiting_point.hpp>

namespace scree::mpm {

template <int D, int V>
std::optional<Index> limiting_point(const Particles<D, V>& particles, const StressUpdate<D, V>& stress,
                                    const CartesianGrid<D>& grid, Limit limit) {
  const double cells_per_metre = std::sqrt(grid.spacing().cwiseInverse().squaredNorm());
  const auto rate_of = [&](Index p) {
    if (limit == Limit::advective) return advection_rate(particles, grid, p);
    const BlockStiffness stiffness = stress.stiffness(particles, p, p + 1);
    if (limit == Limit::viscous) return stiffness.kinematic_viscosity;
    if (limit == Limit::relaxation) return stiffness.relaxation_rate;
    return stiffness.wave_speed * cells_per_metre + advection_rate(particles, grid, p);
  };
  if (limit == Limit::maximum || limit == Limit::output) return std::nullopt;
  std::optional<Index> found;
  double largest = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    const double rate = rate_of(p);
    if (!std::isfinite(rate)) return p;
    if (rate > largest) {
      largest = rate;
      found = p;
    }
  }
  return found;
}

template <int D, int V>
std::string point_name(const Particles<D, V>& particles, Index p) {
  return point_text(particles, p);
}

#define SCREE_INSTANCE(D, V)                                                                      \
  template std::optional<Index> limiting_point(const Particles<D, V>&, const StressUpdate<D, V>&, \
                                               const CartesianGrid<D>&, Limit);                   \
  template std::string point_name(const Particles<D, V>&, Index);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
