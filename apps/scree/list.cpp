#include "scree/chosen.hpp"
#include "scree/run.hpp"

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
  return text;
}

template <class List>
[[nodiscard]] std::string section(std::string_view title) {
  std::string text = fmt::format("{}\n", title);
  for_each_entry<List>([&](auto entry) {
    using Model = typename decltype(entry)::type;
    text += fmt::format("  {:<28} {}\n", Model::name, Model::summary) + keys_of<Model>();
  });
  return text;
}

[[nodiscard]] std::string section_of_paths() {
  std::string text = "paths of a material point (scree path: [[stages]] path)\n";
  for (const rheology::NamedPath& path : rheology::named_paths) {
    text += fmt::format("  {:<28} {}\n", path.name, path.summary);
  }
  return text;
}

}  // namespace

std::string list_of_parts() {
  return section<rheology::AnyLaw>("laws ([rheology] law)") +
         section<grainsize::AnyClosure>("segregation closures ([segregation] closure)") +
         section<transport::AnyFlux>("numerical fluxes (segregation uses kurganov_tadmor)") +
         section<transport::AnyLimiter>("limiters ([segregation] limiter)") +
         section<transport::AnyIntegrator>("integrators ([segregation] integrator)") +
         section<mpm::AnyShape>("shape functions ([numerics] shape)") +
         section<mpm::AnyTransfer>("transfers ([numerics] transfer)") +
         section<mpm::AnyWall>("walls ([boundaries] y_low, ..; or an axis is \"periodic\")") +
         section<rheology::AnyWallLaw>("walls with friction ([boundaries.y_low] law, ..)") +
         section_of_paths();
}

}  // namespace scree::app
