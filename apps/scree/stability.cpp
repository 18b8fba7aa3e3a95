#include "scree/stability.hpp"

#include "scree/axes.hpp"
#include "scree/dimensions.hpp"
#include "scree/streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace scree::app {

namespace {

/// What (c dt/h)^2 + 8/3 nu dt/h^2 must not exceed. Shapes of up to three nodes give points in the middle of
/// cells the same two, those of hat functions; under cubic ones the limit is beyond 1.
[[nodiscard]] double wave_limit(const Scene& scene) {
  const bool keeps_gradient = std::visit([](const auto& rule) { return rule.has_affine; }, scene.transfer);
  if (keeps_gradient) return 1;
  if (scene.order != mpm::Order::usl) return 2;
  return std::visit([](const auto& shape) { return shape.support <= 3 ? 0.5 : 1.0; }, scene.shape);
}

/// The step at which the limit is reached [s]; infinite without sound and viscosity.
[[nodiscard]] double critical_step(double limit, const mpm::Rates& rates, double h) {
  const double sound = rates.wave_speed / h;
  const double damping = 8.0 / 3 * rates.kinematic_viscosity / (h * h);
  return 2 * limit / (damping + std::sqrt(damping * damping + 4 * limit * sound * sound));
}

/// Four digits, rounded down.
[[nodiscard]] double shortened(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / unit) * unit;
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
  const CartesianGrid<D>& grid = state.nodes.grid();
  const mpm::TimeStep step = mpm::stable_time_step(grid, state.rates, scene.time_step);
  const double critical = critical_step(wave_limit(scene), state.rates, grid.spacing().minCoeff());
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
      "would be compressed beyond sense: give more than that, and ten times that to keep it below a tenth "
      "[Pa]",
      modulus, pressure, pressure / modulus)};
}

#define SCREE_INSTANCE(D, V)                                                             \
  template void require_stable_step(const Scene&, const mpm::State<D, V>&);              \
  template void require_stiff(const Scene&, const Filling<D>&, const mpm::Stages<D, V>&, \
                              const mpm::Particles<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
