#include "scree/assemble/make_points.hpp"

#include "scree/assemble/ground.hpp"
#include "scree/assemble/mixture.hpp"
#include "scree/assemble/overlaps.hpp"
#include "scree/assemble/stored_points.hpp"
#include "scree/assemble/streams.hpp"
#include "scree/scene/axes.hpp"
#include "scree/scene/dimensions.hpp"

#include <scree/io/bounds.hpp>
#include <scree/mpm/append.hpp>
#include <scree/mpm/geostatic.hpp>
#include <scree/mpm/terrain/above_bed.hpp>

namespace scree::app {

namespace {

/// @param allowed depth in a body [m]
/// @throws InputError if a body begins inside the material.
template <int D, int V>
void require_clear_of_bodies(const Scene& scene, const mpm::Particles<D, V>& particles, double allowed = 0) {
  if constexpr (D > 1) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      try {
        mpm::require_above(particles, surface_of<D>(scene.bodies[i]), allowed);
      } catch (const InputError& error) {
        throw InputError{"[[bodies]] " + std::to_string(i + 1) + ": as " + error.what()};
      }
    }
  }
}

/// Material that flows lies a little deep in what holds it, as the nodes of the mesh do that are held.
template <int D, int V>
[[nodiscard]] mpm::Particles<D, V> points_of_checkpoint(const Scene& scene, const CartesianGrid<D>& grid,
                                                        const mpm::AnySurface<D>& ground) {
  auto particles = stored_points<D, V>(*scene.material.stored, grid);
  const double allowed = grid.spacing().minCoeff() / 2;
  try {
    if (ground) mpm::require_above(particles, ground, allowed);
    require_clear_of_bodies(scene, particles, allowed);
  } catch (const InputError& error) {
    throw InputError{"[material] checkpoint: " + std::string{error.what()}};
  }
  return particles;
}

/// Points in the box of a stream, clear of ground and bodies.
template <int D, int V>
[[nodiscard]] mpm::Particles<D, V> box_of_stream(const Scene& scene, std::size_t number,
                                                 const CartesianGrid<D>& grid,
                                                 const mpm::AnySurface<D>& ground) {
  auto points = mpm::fill_box(stream_of<D, V>(scene, scene.inflows[number]), grid);
  try {
    if (ground) mpm::require_above(points, ground);
    require_clear_of_bodies(scene, points);
  } catch (const InputError& error) {
    throw InputError{"[[inflow]] " + std::to_string(number + 1) + ": " + error.what()};
  }
  if (scene.grains) Mixture{scene}.add_to(points, scene.inflows[number].fractions);
  return points;
}

/// Whether a point has a density at which it bears this pressure.
template <int D, int V>
[[nodiscard]] bool can_bear(const mpm::Particles<D, V>& particles, const mpm::StressUpdate<D, V>& stress,
                            double pressure) {
  constexpr double nothing = 1e-6;  // [-], of the law's own density: material so thin is none
  try {
    return stress.density_at(particles, 0, pressure) > nothing * particles.density.component(0)[0];
  } catch (const RunError&) {
    return false;
  }
}

}  // namespace

template <int D, int V>
mpm::Particles<D, V> make_points(const Scene& scene, const Filling<D>& filling, const CartesianGrid<D>& grid,
                                 const mpm::AnySurface<D>& ground) {
  mpm::Particles<D, V> particles;
  if (scene.material.stored) {
    particles = points_of_checkpoint<D, V>(scene, grid, ground);
  } else if (!scene.material.is_absent) {
    particles = filling.template points<V>();
    require_clear_of_bodies(scene, particles);
  }
  require_clear_of_streams(scene, particles);
  if (scene.grains) Mixture{scene}.add_to(particles);
  for (std::size_t i = 0; i < scene.inflows.size(); ++i) {
    const auto box = box_of_stream<D, V>(scene, i, grid, ground);
    if (begins_full(scene.inflows[i])) mpm::append(particles, box);
  }
  if (!scene.inflows.empty()) {
    double number = 0;
    for (double& id : particles.id.values()) id = number++;
  }
  return particles;
}

template <int D, int V>
void settle(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages,
            mpm::Particles<D, V>& particles, Threads threads) {
  const int normal = normal_component(D);
  const double gravity = -stages.gravity[static_cast<std::size_t>(normal)];
  const double pressure = scene.material.surface_pressure;
  if (gravity == 0 && pressure == 0) return;
  require(can_bear(particles, *stages.stress, pressure),
          "[material] surface_pressure = " + io::to_text(pressure) + ": the law '" +
              std::string{stages.stress->law()} +
              "' has no density at which it bears this pressure [Pa], as the top of the material does at the "
              "start; give another");
  const std::function<double(const Vector<D>&)> top = [&](const Vector<D>& x) {
    return surface_above(scene, filling, x);
  };
  mpm::set_geostatic(particles, *stages.stress, normal, top, gravity, pressure, threads);
}

#define SCREE_INSTANCE(D, V)                                                                           \
  template mpm::Particles<D, V> make_points<D, V>(const Scene& scene, const Filling<D>& filling,       \
                                                  const CartesianGrid<D>& grid,                        \
                                                  const mpm::AnySurface<D>& ground);                   \
  template void settle(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages, \
                       mpm::Particles<D, V>& particles, Threads threads);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
