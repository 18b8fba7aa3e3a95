#include "instances.hpp"

#include <scree/mpm/geostatic.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace scree::mpm {

namespace {

/// Density of a point at rest so deep that g z = `potential` [m^2/s^2]; nothing if the law has none.
/// The integral is by Gauss, whose places and weights are those for 0 to 1.  Eq. (M201)
template <int D, int V>
[[nodiscard]] std::optional<double> density_under(const Particles<D, V>& particles,
                                                  const StressUpdate<D, V>& stress, Index p, double potential,
                                                  double surface_pressure) {
  constexpr double outer = 0.11270166537925831;  // (1 - sqrt(3/5))/2
  constexpr std::array<double, 3> places{outer, 0.5, 1 - outer};
  constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  const double start = particles.density.component(0)[p];
  const auto pressure = [&](double density) { return stress.rest_pressure(particles, p, density); };
  const auto surface_density =
      rest_density([&](double density) { return pressure(density) - surface_pressure; }, start);
  if (!surface_density) return std::nullopt;
  const double rho_s = *surface_density;
  const auto excess = [&](double density) {
    const double s = std::log(density / rho_s);
    double mean = 0;  // of p/rho
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double rho = rho_s * std::exp(places[i] * s);
      mean += weights[i] * pressure(rho) / rho;
    }
    return pressure(density) / density - surface_pressure / rho_s + s * mean - potential;
  };
  return rest_density(excess, start);
}

template <int D, int V>
[[nodiscard]] std::vector<double> depths_of(const Particles<D, V>& particles, int axis,
                                            const std::function<double(const Vector<D>&)>& surface_above) {
  std::vector<double> depths(static_cast<std::size_t>(particles.size()));
  for (Index p = 0; p < particles.size(); ++p) {
    Vector<D> x;
    for (int d = 0; d < D; ++d) x[d] = particles.position.component(d)[p];
    depths[static_cast<std::size_t>(p)] = surface_above(x) - x[axis];
  }
  return depths;
}

}  // namespace

template <int D, int V>
void set_geostatic(Particles<D, V>& particles, const StressUpdate<D, V>& stress, int axis, double surface,
                   double gravity, double surface_pressure, Threads threads) {
  const std::function<double(const Vector<D>&)> level = [=](const Vector<D>&) { return surface; };
  set_geostatic(particles, stress, axis, level, gravity, surface_pressure, threads);
}

template <int D, int V>
void set_geostatic(Particles<D, V>& particles, const StressUpdate<D, V>& stress, int axis,
                   const std::function<double(const Vector<D>&)>& surface_above, double gravity,
                   double surface_pressure, Threads threads) {
  const std::vector<double> depths = depths_of(particles, axis, surface_above);
  std::vector<char> is_unborne(depths.size(), 0);
  constexpr Index batch = 64;
  for_each_block((particles.size() + batch - 1) / batch, threads, [&](Index b) {
    for (Index p = b * batch; p < std::min((b + 1) * batch, particles.size()); ++p) {
      const double depth = depths[static_cast<std::size_t>(p)];
      if (!(depth > 0)) continue;
      double& density = particles.density.component(0)[p];
      double& mass = particles.mass.component(0)[p];
      const double volume = mass / density;
      const auto found = density_under(particles, stress, p, gravity * depth, surface_pressure);
      if (!found) is_unborne[static_cast<std::size_t>(p)] = 1;
      density = found.value_or(density);
      mass = density * volume;
    }
  });
  const auto first = std::ranges::find(is_unborne, 1);
  if (first == is_unborne.end()) return;
  const double depth = depths[static_cast<std::size_t>(first - is_unborne.begin())];
  throw RunError{"the law '" + std::string{stress.law()} + "' has no density at which it rests " +
                 std::to_string(depth) + " m below a free surface"};
}

#define SCREE_INSTANCE(D, V)                                                                            \
  template void set_geostatic(Particles<D, V>&, const StressUpdate<D, V>&, int, double, double, double, \
                              Threads);                                                                 \
  template void set_geostatic(Particles<D, V>&, const StressUpdate<D, V>&, int,                         \
                              const std::function<double(const Vector<D>&)>&, double, double, Threads);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
