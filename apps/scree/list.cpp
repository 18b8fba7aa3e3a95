#include "scree/chosen.hpp"
#include "scree/run.hpp"

#include <scree/rheology/path/paths.hpp>
#include <scree/transport/fluxes.hpp>

#include <fmt/format.h>

namespace scree::app {

namespace {

template <class List>
[[nodiscard]] std::string section(std::string_view title) {
  std::string text = fmt::format("{}\n", title);
  for_each_entry<List>([&](auto entry) {
    using Model = typename decltype(entry)::type;
    text += fmt::format("  {:<28} {}\n", Model::name, Model::summary);
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
         section_of_paths();
}

}  // namespace scree::app
