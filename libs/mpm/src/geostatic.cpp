#include "instances.hpp"

#include <scree/mpm/geostatic.hpp>

namespace scree::mpm {

namespace {

/// Pressure at a depth by the classical Runge-Kutta rule: the compression is small, few steps are exact.
template <int D, int V>
[[nodiscard]] double pressure_at(const Particles<D, V>& particles, const StressUpdate<D, V>& stress, Index p,
                                 double depth, double gravity, double surface_pressure) {
  constexpr int num_steps = 4;
  const double dz = depth / num_steps;
  const auto slope = [&](double pressure) { return gravity * stress.density_at(particles, p, pressure); };
  double pressure = surface_pressure;
  for (int i = 0; i < num_steps; ++i) {
    const double k1 = slope(pressure);
    const double k2 = slope(pressure + dz / 2 * k1);
    const double k3 = slope(pressure + dz / 2 * k2);
    const double k4 = slope(pressure + dz * k3);
    pressure += dz / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return pressure;
}

}  // namespace

template <int D, int V>
void set_geostatic(Particles<D, V>& particles, const StressUpdate<D, V>& stress, int axis, double surface,
                   double gravity, double surface_pressure) {
  const std::function<double(const Vector<D>&)> level = [=](const Vector<D>&) { return surface; };
  set_geostatic(particles, stress, axis, level, gravity, surface_pressure);
}

template <int D, int V>
void set_geostatic(Particles<D, V>& particles, const StressUpdate<D, V>& stress, int axis,
                   const std::function<double(const Vector<D>&)>& surface_above, double gravity,
                   double surface_pressure) {
  for (Index p = 0; p < particles.size(); ++p) {
    Vector<D> x;
    for (int d = 0; d < D; ++d) x[d] = particles.position.component(d)[p];
    const double depth = surface_above(x) - x[axis];
    if (!(depth > 0)) continue;
    double& density = particles.density.component(0)[p];
    double& mass = particles.mass.component(0)[p];
    const double volume = mass / density;
    density =
        stress.density_at(particles, p, pressure_at(particles, stress, p, depth, gravity, surface_pressure));
    mass = density * volume;
  }
}

#define SCREE_INSTANCE(D, V)                                                                             \
  template void set_geostatic(Particles<D, V>&, const StressUpdate<D, V>&, int, double, double, double); \
  template void set_geostatic(Particles<D, V>&, const StressUpdate<D, V>&, int,                          \
                              const std::function<double(const Vector<D>&)>&, double, double);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
