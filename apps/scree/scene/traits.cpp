#include "scree/scene/traits.hpp"

#include "scree/scene/axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <variant>

namespace scree::app {

namespace {

constexpr std::string_view separator = " = ";

template <class List>
[[nodiscard]] std::string name_of(const List& list) {
  return std::visit([](const auto& entry) { return std::string{entry.name}; }, list);
}

template <class Numbers>
[[nodiscard]] std::string list_of(const Numbers& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

[[nodiscard]] std::string scheme_name(ViscosityScheme scheme) {
  if (scheme == ViscosityScheme::with_stress) return "explicit";
  return scheme == ViscosityScheme::implicit ? "implicit" : "auto";
}

void add_axes(const Scene& scene, std::vector<Trait>& traits) {
  const auto names = axis_names(scene.mesh.dimensions);
  for (std::size_t d = 0; d < names.size(); ++d) {
    traits.push_back(
        {fmt::format("[boundaries] {}", names[d]), scene.axes[d].is_periodic ? "periodic" : "walls"});
  }
}

void add_scheme(const Scene& scene, std::vector<Trait>& traits) {
  traits.push_back({"[numerics] transfer", name_of(scene.transfer)});
  traits.push_back(
      {"[numerics] order", std::string{mpm::order_names[static_cast<std::size_t>(scene.order)]}});
  traits.push_back({"[numerics] averaged_volume_change", fmt::format("{}", scene.averaging.volume_change)});
  traits.push_back({"[numerics] averaged_pressure", fmt::format("{}", scene.averaging.pressure)});
  traits.push_back(
      {"[numerics] mass_floor", fmt::format("{}", scene.mass_floor), fmt::format("{}", Scene{}.mass_floor)});
  traits.push_back({"[numerics] viscosity", scheme_name(scene.viscosity)});
}

/// An inflow goes on from the layers that have entered; when it ends may change.
void add_streams(const Scene& scene, std::vector<Trait>& traits) {
  for (std::size_t i = 0; i < scene.inflows.size(); ++i) {
    const InflowScene& inflow = scene.inflows[i];
    const std::string table = fmt::format("[[inflow]] {} ", i + 1);
    traits.push_back({table + "low", list_of(inflow.low)});
    traits.push_back({table + "high", list_of(inflow.high)});
    traits.push_back({table + "velocity", list_of(inflow.velocity)});
    traits.push_back({table + "points_per_cell", fmt::format("{}", inflow.points_per_cell)});
    traits.push_back({table + "fractions", list_of(inflow.fractions)});
    traits.push_back({table + "start", fmt::format("{}", inflow.start)});
  }
}

}  // namespace

std::vector<Trait> traits_of_points(const Scene& scene) {
  return {{"[mesh] dimensions", fmt::format("{}", scene.mesh.dimensions)},
          {"[mesh] velocity_components", fmt::format("{}", scene.mesh.velocity_components)},
          {"[mesh] symmetry", scene.mesh.is_axisymmetric ? "axisymmetric" : "plane"},
          {"[rheology] law", name_of(scene.law)},
          {"diameters of [grains]", scene.grains ? list_of(scene.grains->classes.diameters()) : "none"}};
}

std::vector<Trait> traits_of_boxes(const Scene& scene) {
  std::vector<Trait> traits{{"[mesh] size", list_of(scene.mesh.size)},
                            {"[mesh] cells", fmt::format("{}", scene.mesh.cells)},
                            {"[numerics] shape", name_of(scene.shape)}};
  if (const auto* gimp = std::get_if<mpm::Gimp>(&scene.shape)) {
    traits.push_back({"[numerics] points_per_axis", fmt::format("{}", 0.5 / gimp->half_width())});
  }
  return traits;
}

std::vector<Trait> traits_of_run(const Scene& scene) {
  std::vector<Trait> traits = traits_of_points(scene);
  const std::vector<Trait> boxes = traits_of_boxes(scene);
  traits.insert(traits.end(), boxes.begin(), boxes.end());
  add_axes(scene, traits);
  add_scheme(scene, traits);
  add_streams(scene, traits);
  return traits;
}

std::string traits_text(const std::vector<Trait>& traits) {
  std::string text;
  for (const Trait& trait : traits) text += fmt::format("{}{}{}\n", trait.key, separator, trait.value);
  return text;
}

std::string difference(const std::string& text, const std::vector<Trait>& traits) {
  std::string differences;
  for (const Trait& trait : traits) {
    const std::string start = fmt::format("\n{}{}", trait.key, separator);
    const std::string lines = "\n" + text;
    const auto found = lines.find(start);
    const auto first = found + start.size();
    const std::string there =
        found == std::string::npos ? trait.if_absent : lines.substr(first, lines.find('\n', first) - first);
    if (there == trait.value) continue;
    differences += fmt::format("{}{} is {} there and {} in the scene", differences.empty() ? "" : "; ",
                               trait.key, there, trait.value);
  }
  return differences;
}

}  // namespace scree::app
