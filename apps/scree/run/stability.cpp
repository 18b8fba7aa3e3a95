#include "scree/run/stability.hpp"

#include "scree/assemble/streams.hpp"
#include "scree/run/simulation.hpp"
#include "scree/scene/axes.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/law_columns.hpp"

#include <scree/mpm/critical_step.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <variant>

namespace scree::app {

namespace {

constexpr double slack = 1 + 1e-9;  // of a step and the critical one: both are rounded

/// The step from which on waves grow under any scheme, wherever points lie [s].
template <int D>
[[nodiscard]] double critical_step_of_any(const CartesianGrid<D>& grid, const mpm::Rates& rates) {
  return mpm::critical_step<D>(Vector<D>::Constant(mpm::least_critical_sum), grid, rates);
}

template <int D, int V>
[[nodiscard]] Vector<D> critical_sums(const Scene& scene, const mpm::State<D, V>& state) {
  return mpm::critical_sums(state.particles, state.nodes.grid(), scene.shape, scene.transfer, scene.order,
                            scene.xpic_order);
}

/// Whether waves are sure to grow beyond (M199) under the means over cells that a scene asks for: where all
/// points of a cell see the same of a wave, as on hat functions, and the mean is taken of strain and stress
/// alike. Elsewhere a run may bear more.
[[nodiscard]] bool is_bound_under_means(const Scene& scene) noexcept {
  return !scene.averaging.is_on() || (std::holds_alternative<mpm::Linear>(scene.shape) &&
                                      scene.averaging.volume_change && scene.averaging.pressure);
}

/// The share that bounds a step, by its key.
struct Share {
  std::string_view key;
  double value;
};

[[nodiscard]] Share share_of(mpm::Limit limit, const mpm::TimeStepOptions& options) {
  if (limit == mpm::Limit::maximum) return {"maximum_dt", options.maximum};
  return {mpm::limit_names[static_cast<std::size_t>(limit)],
          limit == mpm::Limit::acoustic    ? options.acoustic
          : limit == mpm::Limit::advective ? options.advective
          : limit == mpm::Limit::viscous   ? options.viscous
                                           : options.relaxation};
}

/// Four digits, rounded down.
[[nodiscard]] double shortened(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / unit) * unit;
}

/// Three digits, rounded up.
[[nodiscard]] double lengthened(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::ceil(value / unit) * unit;
}

template <class List>
[[nodiscard]] std::string_view name_in(const List& list) {
  return std::visit([](const auto& entry) { return entry.name; }, list);
}

/// `transfer = "apic", shape = "linear", order = "usl"`, and `xpic_order = 2` where velocities are filtered
[[nodiscard]] std::string scheme_of(const Scene& scene) {
  return fmt::format("transfer = \"{}\", shape = \"{}\", order = \"{}\"{}", name_in(scene.transfer),
                     name_in(scene.shape), mpm::order_names[static_cast<std::size_t>(scene.order)],
                     scene.xpic_order > 0 ? fmt::format(", xpic_order = {}", scene.xpic_order) : "");
}

constexpr double soft = 0.1;  // [-], of the modulus: half of it of the height is compression, which is seen
constexpr double margin = 1 + 1e-6;  // of advice: density is integrated in steps, and sums are rounded

/// Of points that begin as dense as they will stay.
template <int D, int V>
[[nodiscard]] std::string warning_of_density(const Simulation<D, V>& simulation, double modulus) {
  const Scene& scene = simulation.scene();
  const mpm::Particles<D, V>& particles = simulation.state.particles;
  const double density = std::visit([](const auto& law) { return law.density; }, scene.law);
  double highest = density;
  double mass = 0;
  double volume = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double here = particles.density.component(0)[p];
    highest = std::max(highest, here);
    mass += particles.mass.component(0)[p];
    volume += particles.mass.component(0)[p] / here;
  }
  if (!(std::log(highest / density) >= soft)) return {};
  // highest/density = exp(weight/modulus) (1 + surface/modulus), no more than exp((weight + surface)/modulus)
  const double surface = scene.material.surface_pressure;
  const double weight = modulus * (std::log(highest / density) - std::log1p(surface / modulus));
  return fmt::format(
      "[rheology] bulk_modulus = {:g}: at the start the material is up to {:.0f} % denser, and {:.0f} % "
      "heavier in all, than where nothing presses, and will swell and sink by as much as it spreads and "
      "heaps up: give {:.3g} or more to keep the first to about a tenth [Pa]",
      modulus, 100 * (highest / density - 1), 100 * (mass / (density * volume) - 1),
      lengthened((weight + surface) / soft * margin));
}

/// What the heaviest column of cells weighs, over its area [Pa].
template <int D, int V>
[[nodiscard]] double largest_load(const Simulation<D, V>& simulation) {
  const CartesianGrid<D>& grid = simulation.grid();
  const mpm::Particles<D, V>& particles = simulation.state.particles;
  const int normal = normal_component(D);
  const double gravity = std::abs(simulation.stages().gravity[static_cast<std::size_t>(normal)]);
  std::map<Indices<D>, double> loads;
  for (Index p = 0; p < particles.size(); ++p) {
    Indices<D> column{};
    double area = 1;  // [m^2], of what points are the mass of: per metre across, or of a radian
    for (int d = 0; d < D; ++d) {
      if (d == normal) continue;
      const double place = (particles.position.component(d)[p] - grid.origin()[d]) / grid.spacing()[d];
      column[static_cast<std::size_t>(d)] = static_cast<Index>(std::floor(place));
      area *= grid.spacing()[d];
      if (d == 0 && simulation.scene().mesh.is_axisymmetric) {
        area *= (std::floor(place) + 0.5) * grid.spacing()[d];
      }
    }
    loads[column] += gravity * particles.mass.component(0)[p] / area;
  }
  double most = 0;
  for (const auto& [column, load] : loads) most = std::max(most, load);
  return most;
}

/// Of points that another run has left, maybe under another modulus. At rest p = K (rho/rho_0 - 1) bears what
/// is above.
template <int D, int V>
[[nodiscard]] std::string warning_of_weight(const Simulation<D, V>& simulation, double modulus) {
  const double load = largest_load(simulation);
  if (!(load / modulus >= std::expm1(soft))) return {};
  return fmt::format(
      "[rheology] bulk_modulus = {:g}: the points of [material] checkpoint weigh up to {:.4g} Pa on what is "
      "below them, which makes it {:.0f} % denser than where nothing presses, and it will swell and sink by "
      "as much as it spreads and heaps up: give {:.3g} or more to keep that to about a tenth [Pa]",
      modulus, load, 100 * load / modulus, lengthened(load / std::expm1(soft) * margin));
}

}  // namespace

template <int D, int V>
void require_stable_step(const Scene& scene, const mpm::State<D, V>& state) {
  const CartesianGrid<D>& grid = state.nodes.grid();
  const mpm::TimeStep step = mpm::stable_time_step(grid, state.rates, scene.time_step);
  if (step.dt <= critical_step_of_any(grid, state.rates)) return;
  const double critical = mpm::critical_step(critical_sums(scene, state), grid, state.rates);
  if (step.dt <= critical * slack) return;
  const auto [key, value] = share_of(step.limit, scene.time_step);
  throw InputError{fmt::format(
      "[numerics] {} = {:g}: must be at most {:.4g}: it allows steps of {:.4g} s, and from the critical one, "
      "{:.4g} s, on waves of sound and viscosity grow under {}",
      key, value, shortened(value * critical / step.dt), step.dt, critical, scheme_of(scene))};
}

template <int D, int V>
std::string instability(const Scene& scene, const mpm::State<D, V>& state,
                        const mpm::StressUpdate<D, V>& stress) {
  if (!is_bound_under_means(scene)) return {};
  const CartesianGrid<D>& grid = state.nodes.grid();
  const mpm::TimeStep step = mpm::stable_time_step(grid, state.rates, scene.time_step);
  // by the law as it is: in a restart state.rates are those of the run before
  const BlockStiffness largest = stress.stiffness(state.particles, 0, state.particles.size());
  if (step.dt <= critical_step_of_any(grid, {largest.wave_speed, largest.kinematic_viscosity, 0, 0})) {
    return {};
  }
  const double critical = mpm::unstable_step(state.particles, stress, grid, scene.shape, scene.transfer,
                                             scene.order, scene.xpic_order);
  if (step.dt <= critical * slack) return {};
  const auto [key, value] = share_of(step.limit, scene.time_step);
  const double safe = std::min(critical, mpm::critical_step(critical_sums(scene, state), grid, state.rates));
  return fmt::format(
      "[numerics] {} = {:g}: allows steps of {:.4g} s, and from {:.4g} s on, the critical one in the mean of "
      "all points, waves of sound and viscosity grow under {}: give at most {:.4g}",
      key, value, step.dt, critical, scheme_of(scene), shortened(value * safe / step.dt));
}

std::string one_mean_warning(const Scene& scene) {
  const auto& [volume_change, pressure] = scene.averaging;
  const bool is_identity = scene.mesh.dimensions == 1 && std::holds_alternative<mpm::Linear>(scene.shape);
  if (volume_change == pressure || is_identity) return {};
  constexpr std::array<std::string_view, 2> keys{"averaged_volume_change", "averaged_pressure"};
  return fmt::format(
      "[numerics] {} = true without {}: where the points of a cell differ in stiffness, waves may grow at "
      "steps far below the critical one, and the run is not stopped for them: give both, or none",
      keys[pressure ? 1 : 0], keys[pressure ? 0 : 1]);
}

std::string step_remedy(const Scene& scene, mpm::Limit limit) {
  if (limit == mpm::Limit::output) return {};
  const auto [key, value] = share_of(limit, scene.time_step);
  return fmt::format(" ([numerics] {} = {:g} bounds steps: give less)", key, value);
}

template <int D, int V>
void require_stiff(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages,
                   const mpm::Particles<D, V>& particles) {
  const int normal = normal_component(D);
  double depth = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    Vector<D> x;
    for (int d = 0; d < D; ++d) x[d] = particles.position.component(d)[p];
    depth = std::max(depth, surface_above(scene, filling, x) - x[normal]);
  }
  const double density = std::visit([](const auto& law) { return law.density; }, scene.law);
  const double gravity = -stages.gravity[static_cast<std::size_t>(normal)];
  const double pressure = density * gravity * depth + scene.material.surface_pressure;
  const double modulus = bulk_modulus_of(scene.law);
  if (pressure < modulus) return;
  throw InputError{fmt::format(
      "[rheology] bulk_modulus = {:g}: the material bears {:.4g} Pa at the start, {:.3g} times as much, and "
      "would be compressed beyond sense: give more than that, and ten times that to keep it to about a tenth "
      "[Pa]",
      modulus, pressure, pressure / modulus)};
}

template <int D, int V>
std::string softness_warning(const Simulation<D, V>& simulation) {
  const Scene& scene = simulation.scene();
  const double modulus = bulk_modulus_of(scene.law);
  if (!std::isfinite(modulus)) return {};
  return scene.material.stored ? warning_of_weight(simulation, modulus)
                               : warning_of_density(simulation, modulus);
}

#define SCREE_INSTANCE(D, V)                                                                               \
  template void require_stable_step(const Scene&, const mpm::State<D, V>&);                                \
  template std::string instability(const Scene&, const mpm::State<D, V>&, const mpm::StressUpdate<D, V>&); \
  template void require_stiff(const Scene&, const Filling<D>&, const mpm::Stages<D, V>&,                   \
                              const mpm::Particles<D, V>&);                                                \
  template std::string softness_warning(const Simulation<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
