#include "scree/scene/chosen.hpp"
#include "scree/scene/path_file.hpp"
#include "scree/scene/read_models.hpp"

#include <scree/rheology/path/paths.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace scree::app {

namespace {

using io::above;
using io::at_least;
using io::between;
using io::TomlTable;
using rheology::first_shear;
using rheology::symmetric_components;

/// What the law reads, a key per column.
[[nodiscard]] std::vector<double> read_inputs(const TomlTable& table, const rheology::AnyLaw& law) {
  std::vector<double> inputs;
  const auto read = [&](const auto& chosen) {
    for (const InputColumn& column : chosen.inputs) {
      const std::string meaning = fmt::format("what the law reads [{}]", column.unit);
      inputs.push_back(table.number(column.name, meaning, bounds_of(column.range)));
    }
  };
  std::visit(read, law);
  return inputs;
}

/// The law's memory at the start.
[[nodiscard]] std::vector<double> read_state(const TomlTable& table, const rheology::AnyLaw& law) {
  std::vector<double> numbers;
  const auto read = [&](const auto& chosen) {
    for (const StateColumn& state : chosen.states) numbers.push_back(read_initial(table, state));
  };
  std::visit(read, law);
  return numbers;
}

void read_start(const TomlTable& table, PathFile& file) {
  if (table.has("density")) {
    file.density = table.number("density", "density at the start [kg/m^3]", above(0));
    table.check(!table.has("pressure"), {"pressure", "density"}, "give a density or a pressure, not both");
    return;
  }
  file.pressure = table.number("pressure", "pressure at the start [Pa]", at_least(0));
}

/// Component by component; those that no key names do not move.
void read_components(const TomlTable& stage, rheology::Controls& controls) {
  const TomlTable strains = stage.table_or_empty("strain_rates");
  const TomlTable stresses = stage.table_or_empty("stress_rates");
  const TomlTable spin = stage.table_or_empty("spin");
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    const std::string_view name = symmetric_components[k].name;
    if (strains.has(name)) {
      controls.on[k] = rheology::strain_rate(strains.number(name, "rate of deformation D [1/s]"));
    }
    if (stresses.has(name)) {
      stresses.check(!strains.has(name), {name}, "has a strain rate too: give one of them");
      controls.on[k] =
          rheology::stress_rate(stresses.number(name, "rate of stress, tension positive [Pa/s]"));
    }
    if (k >= first_shear) controls.spin[k - first_shear] = spin.number_or(0, name, "spin W [1/s]");
  }
}

/// The planes that stay where they are: "xy" keeps those normal to y.
void read_simple_shear(const TomlTable& stage, rheology::Controls& controls) {
  if (!stage.has("simple_shear")) return;
  for (const std::string& plane : stage.strings("simple_shear", "shears of planes that stay")) {
    const auto* const found =
        std::find_if(symmetric_components.begin() + first_shear, symmetric_components.end(),
                     [&](const auto& component) { return component.name == plane; });
    const bool is_known = found != symmetric_components.end();
    stage.check(is_known, {"simple_shear"}, fmt::format("'{}' is none of xy, xz, yz", plane));
    if (!is_known) continue;
    controls.is_simple_shear[static_cast<std::size_t>(found - symmetric_components.begin()) - first_shear] =
        true;
  }
}

[[nodiscard]] rheology::Controls read_named_path(const TomlTable& stage) {
  std::array<std::string_view, rheology::named_paths.size()> names;
  std::ranges::transform(rheology::named_paths, names.begin(), &rheology::NamedPath::name);
  const std::string name = stage.choice("path", "ready-made path", names);
  const auto found = std::ranges::find(rheology::named_paths, name, &rheology::NamedPath::name);
  const std::string meaning = fmt::format("{} [{}]", found->summary, found->unit);
  return found->controls(stage.number("rate", meaning));
}

[[nodiscard]] rheology::Stage read_stage(const TomlTable& table, std::size_t number) {
  rheology::Stage stage;
  stage.name = table.string_or(fmt::format("{}", number), "name", "what the stage is");
  stage.duration = table.number("duration", "of the stage [s]", above(0));
  stage.num_steps = table.integer("steps", "steps of the stage", between(1, 1e6));
  if (table.has("path")) {
    stage.controls = read_named_path(table);
  } else {
    read_components(table, stage.controls);
    read_simple_shear(table, stage.controls);
  }
  return stage;
}

[[nodiscard]] PathFile read(io::TomlFile file, const std::vector<std::string>& overrides) {
  for (const std::string& assignment : overrides) file.set(assignment);
  const TomlTable root = file.root();
  PathFile path;
  path.title = root.string_or("", "title", "what the path shows");
  const TomlTable law = root.table("rheology");
  read_chosen(law, "law", "constitutive law", path.law);
  const TomlTable inputs = root.table_or_empty("inputs");
  if (law.is_sound("law")) {
    path.inputs = read_inputs(inputs, path.law);
    path.state = read_state(law.table_or_empty("initial"), path.law);
  }
  read_start(root.table("start"), path);
  const std::vector<TomlTable> stages = root.tables("stages");
  if (stages.empty()) root.add_fault("stages", "missing, expected at least one table [[stages]]");
  for (const TomlTable& stage : stages) path.stages.push_back(read_stage(stage, path.stages.size() + 1));
  file.finish();
  return path;
}

}  // namespace

PathFile read_path_file(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read(io::TomlFile::read(path), overrides);
}

PathFile parse_path_file(const std::string& text, const std::string& name,
                         const std::vector<std::string>& overrides) {
  return read(io::TomlFile::parse(text, name), overrides);
}

}  // namespace scree::app
