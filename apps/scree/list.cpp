#include "scree/run/run.hpp"
#include "scree/scene/choices.hpp"
#include "scree/scene/chosen.hpp"
#include "scree/scene/output_fields.hpp"

#include <scree/rheology/path/paths.hpp>
#include <scree/transport/fluxes.hpp>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace scree::app {

namespace {

/// "friction [-], cohesion [Pa]" of parameters or columns.
[[nodiscard]] std::string names_with_units(const auto& described) {
  std::vector<std::string> names;
  names.reserve(described.size());
  for (const auto& one : described) names.push_back(fmt::format("{} [{}]", one.name, one.unit));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// What a model has to be told, indented below its name; nothing if that is nothing.
template <class Model>
[[nodiscard]] std::string keys_of() {
  std::string text;
  if constexpr (requires { Model::parameters.size(); }) {
    if (!Model::parameters.empty())
      text += fmt::format("      with  {}\n", names_with_units(Model::parameters));
  }
  if constexpr (requires { Model::inputs.size(); }) {
    if (!Model::inputs.empty()) text += fmt::format("      reads {}\n", names_with_units(Model::inputs));
  }
  if constexpr (requires { Model::states.size(); }) {
    if (!Model::states.empty()) text += fmt::format("      keeps {}\n", names_with_units(Model::states));
  }
  return text;
}

[[nodiscard]] std::string line(std::string_view name, std::string_view summary) {
  return fmt::format("  {:<28} {}\n", name, summary);
}

/// The models of a library's list.
template <class List>
[[nodiscard]] std::string section(std::string_view title) {
  std::string text = fmt::format("{}\n", title);
  for_each_entry<List>([&](auto entry) {
    using Model = typename decltype(entry)::type;
    text += line(Model::name, Model::summary) + keys_of<Model>();
  });
  return text;
}

/// What else has a name and a summary each.
[[nodiscard]] std::string section(std::string_view title, const auto& entries) {
  std::string text = fmt::format("{}\n", title);
  for (const auto& entry : entries) text += line(entry.name, entry.summary);
  return text;
}

[[nodiscard]] std::string section_of_fields() {
  return "what a frame holds ([output] fields)\n" +
         fmt::format("  {}\n  with [grains] {}, and what the law reads\n", fmt::join(fields_of_points, ", "),
                     fmt::join(fields_of_grains, ", ")) +
         fmt::format("  what the law keeps; {} where the law can tell\n", stability_field);
}

[[nodiscard]] std::string list_of_surroundings() {
  return section("cuts ([mesh] symmetry)", choices::symmetries) +
         section("axes ([boundaries] x, y, z)", choices::axis_kinds) +
         section<mpm::AnyWall>("walls ([boundaries] y_low, ..)") +
         line(OpenEnd::name, "none: material flows out") +
         section<rheology::AnyWallLaw>(
             "friction of walls, ground and bodies ([boundaries.y_low] law, .., [terrain.contact] law)") +
         section("contacts without a law ([terrain], [[bodies]] contact)", choices::plain_contacts) +
         section("hold of walls with friction, ground and bodies ([boundaries.y_low] hold, ..)",
                 choices::holds) +
         section("what becomes of a point that leaves ([boundaries] leaving)", choices::leavings) +
         section("ground ([terrain] surface)", choices::terrain_surfaces) +
         section("bodies ([[bodies]] surface)", choices::body_surfaces);
}

}  // namespace

std::string list_of_parts() {
  return section<rheology::AnyLaw>("laws ([rheology] law)") + list_of_surroundings() +
         section("regions ([[material.regions]] shape)", choices::region_shapes) +
         section("layouts of points ([material] layout)", choices::layouts) +
         section<mpm::AnyShape>("shape functions ([numerics] shape)") +
         section<mpm::AnyTransfer>("transfers ([numerics] transfer)") +
         section("orders of stress in a step ([numerics] order)", choices::orders) +
         section("viscous part of the stress ([numerics] viscosity)", choices::viscosity_schemes) +
         section("distributions of grain size ([grains] distribution)", choices::distributions) +
         section<grainsize::AnyClosure>("segregation closures ([segregation] closure)") +
         section<transport::AnyFlux>("numerical fluxes (segregation uses kurganov_tadmor)") +
         section<transport::AnyLimiter>("limiters ([segregation] limiter)") +
         section<transport::AnyIntegrator>("integrators ([segregation] integrator)") +
         section("control volumes ([segregation] control_volumes)", choices::control_volumes) +
         section("ways back to the points ([segregation] map)", choices::carried_maps) + section_of_fields() +
         section("paths of a material point (scree path: [[stages]] path)", rheology::named_paths);
}

}  // namespace scree::app
