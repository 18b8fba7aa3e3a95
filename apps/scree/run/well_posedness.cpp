#include "scree/run/well_posedness.hpp"

#include "scree/scene/axes.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/rheology/columns.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace scree::app {

namespace {

/// Effective viscosity of the scene's law at a mean size [Pa s].
[[nodiscard]] double viscosity_at(const rheology::AnyLaw& any_law, double grain_size) {
  return std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        using Input = typename Law::template Input<double>;
        const Deformation<double> at_rest{Tensor<double>{}, law.density};
        const auto input = rheology::made_of<Input>(Law::inputs, [&](const InputColumn& column) {
          return column.name == grain_size_column ? grain_size : 0.0;
        });
        return law.stiffness(at_rest, input, rheology::initial_state<Law>()).viscosity;
      },
      any_law);
}

/// Shear stress on the base of the material, at rest or in steady flow [Pa].
[[nodiscard]] double base_shear_stress(const Scene& scene) {
  const auto normal = static_cast<std::size_t>(normal_component(scene.mesh.dimensions));
  const double depth = scene.material.high[normal] - scene.material.low[normal];
  const double density = std::visit([](const auto& law) { return law.density; }, scene.law);
  return density * scene.gravity.magnitude * std::sin(scene.gravity.slope_degrees * std::numbers::pi / 180) *
         depth;
}

}  // namespace

std::optional<double> critical_remixing(const Scene& scene) {
  if (!scene.segregation || !scene.grains) return std::nullopt;
  const auto diameters = scene.grains->classes.diameters();
  const double s_a = grainsize::arithmetic_mean(diameters, scene.grains->fractions);
  const double s_h = grainsize::harmonic_mean(diameters, scene.grains->fractions);
  const double stress = base_shear_stress(scene);
  if (!(viscosity_at(scene.law, s_a) > 0) || !(stress > 0)) return std::nullopt;
  return std::visit(
      [&](const auto& closure) {
        const auto drive_at_stress = [&](double size) {
          return closure.drive(stress / viscosity_at(scene.law, size), size);
        };
        const double ds = 1e-4 * s_a;  // central difference: error of relative order 1e-8
        const double slope = (drive_at_stress(s_a + ds) - drive_at_stress(s_a - ds)) / (2 * ds);
        // The velocity over a unit step of drive in a unit distance is -c, without gravity.
        const double c = -closure.velocity({.left = 0, .right = 1, .distance = 1, .gravity = 0});
        return -c * (s_a - s_h) * slope;
      },
      scene.segregation->closure);
}

std::string ill_posedness_warning(const Scene& scene) {
  const auto critical = critical_remixing(scene);
  constexpr double noise = 1e-6;  // [-], of c gdot: what the differences above leave of a neutral coupling
  const double typical = critical ? std::abs(*critical) : 0;
  if (!critical || !(*critical > scene.segregation->remixing) || typical < noise) return {};
  return fmt::format(
      "this two-way coupling is ill-posed: remixing D = {:g} m^2/s is below D_crit = {:.4f} m^2/s (at the "
      "base, "
      "steady flow); layers grow at the scale of the mesh, faster the finer it is",
      scene.segregation->remixing, *critical);
}

}  // namespace scree::app
