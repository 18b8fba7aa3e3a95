#include "scree/stability.hpp"

#include "scree/axes.hpp"
#include "scree/dimensions.hpp"
#include "scree/streams.hpp"

#include <scree/mpm/critical_step.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace scree::app {

namespace {

/// The step from which on waves grow on points as they lie [s]; that of any scheme, if `dt` is not longer.
template <int D, int V>
[[nodiscard]] double critical_step(const Scene& scene, const mpm::State<D, V>& state, double dt) {
  const CartesianGrid<D>& grid = state.nodes.grid();
  const Vector<D> least = Vector<D>::Constant(mpm::least_critical_sum);
  const double of_any = mpm::critical_step<D>(least, grid, state.rates);
  if (dt <= of_any) return of_any;
  const Vector<D> sums = mpm::critical_sums(state.particles, grid, scene.shape, scene.transfer, scene.order);
  return mpm::critical_step(sums, grid, state.rates);
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

[[nodiscard]] double bulk_modulus_of(const rheology::AnyLaw& any_law) {
  return std::visit(
      [](const auto& law) {
        if constexpr (requires { law.bulk_modulus; }) {
          return static_cast<double>(law.bulk_modulus);
        } else {
          return std::numeric_limits<double>::infinity();
        }
      },
      any_law);
}

}  // namespace

template <int D, int V>
void require_stable_step(const Scene& scene, const mpm::State<D, V>& state) {
  const mpm::TimeStep step = mpm::stable_time_step(state.nodes.grid(), state.rates, scene.time_step);
  const double critical = critical_step(scene, state, step.dt);
  constexpr double slack = 1 + 1e-9;  // both are rounded
  if (step.dt <= critical * slack) return;
  const mpm::TimeStepOptions& options = scene.time_step;
  const bool is_own = step.limit == mpm::Limit::maximum;
  const double value = step.limit == mpm::Limit::acoustic    ? options.acoustic
                       : step.limit == mpm::Limit::advective ? options.advective
                       : step.limit == mpm::Limit::viscous   ? options.viscous
                       : is_own                              ? options.maximum
                                                             : options.relaxation;
  throw InputError{fmt::format(
      "[numerics] {} = {:g}: must be at most {:.4g}: it allows steps of {:.4g} s, and from the critical one, "
      "{:.4g} s, on waves of sound and viscosity grow under transfer = \"{}\", shape = \"{}\", order = "
      "\"{}\"",
      is_own ? "maximum_dt" : mpm::limit_names[static_cast<std::size_t>(step.limit)], value,
      shortened(value * critical / step.dt), step.dt, critical, name_in(scene.transfer), name_in(scene.shape),
      mpm::order_names[static_cast<std::size_t>(scene.order)])};
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
std::string softness_warning(const Scene& scene, const mpm::Particles<D, V>& particles) {
  constexpr double soft = 0.1;  // [-], of the modulus: half of it of the height is compression, which is seen
  const double modulus = bulk_modulus_of(scene.law);
  if (scene.material.stored || !std::isfinite(modulus)) return {};
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
  constexpr double margin = 1 + 1e-6;  // density is integrated in steps
  return fmt::format(
      "[rheology] bulk_modulus = {:g}: at the start the material is up to {:.0f} % denser, and {:.0f} % "
      "heavier in all, than where nothing presses, and will swell and sink by as much as it spreads and "
      "heaps up: give {:.3g} or more to keep the first to about a tenth [Pa]",
      modulus, 100 * (highest / density - 1), 100 * (mass / (density * volume) - 1),
      lengthened((weight + surface) / soft * margin));
}

#define SCREE_INSTANCE(D, V)                                                             \
  template void require_stable_step(const Scene&, const mpm::State<D, V>&);              \
  template void require_stiff(const Scene&, const Filling<D>&, const mpm::Stages<D, V>&, \
                              const mpm::Particles<D, V>&);                              \
  template std::string softness_warning(const Scene&, const mpm::Particles<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
