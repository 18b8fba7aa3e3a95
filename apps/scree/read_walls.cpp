#include "scree/read_walls.hpp"

#include "scree/axes.hpp"
#include "scree/chosen.hpp"
#include "scree/read_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace scree::app {

namespace {

using io::TomlTable;

/// The parameter of a law that a column asks for by name and unit.
[[nodiscard]] std::optional<double> parameter_of(const rheology::AnyLaw& any_law, const InputColumn& column) {
  return std::visit(
      [&](const auto& law) -> std::optional<double> {
        for (const auto& parameter : law.parameters) {
          if (parameter.name == column.name && parameter.unit == column.unit) return law.*parameter.member;
        }
        return std::nullopt;
      },
      any_law);
}

/// What the scene says of a column that a wall across an axis reads: the mean size of its grains, the depth
/// of its material along the axis, or a parameter of its law.
[[nodiscard]] std::optional<double> from_scene(const Scene& scene, std::size_t axis,
                                               const InputColumn& column) {
  if (column.name == "grain_size" && scene.grains) {
    return grainsize::arithmetic_mean(scene.grains->classes.diameters(), scene.grains->fractions);
  }
  const MaterialScene& material = scene.material;
  if (column.name == "depth" && axis < std::min(material.low.size(), material.high.size())) {
    return material.high[axis] - material.low[axis];
  }
  return parameter_of(scene.law, column);
}

/// What a law of friction reads, a key for each column; nothing if it reads nothing.
[[nodiscard]] std::vector<double> read_inputs(const TomlTable& table, const Scene& scene, std::size_t axis,
                                              const rheology::AnyWallLaw& any_law) {
  std::vector<double> inputs;
  std::visit(
      [&](const auto& law) {
        for (const InputColumn& column : law.inputs) {
          const std::string meaning = fmt::format("what the law of the wall reads [{}]", column.unit);
          const auto known = from_scene(scene, axis, column);
          const io::Bounds bounds = bounds_of(column.range);
          inputs.push_back(known ? table.number_or(*known, column.name, meaning, bounds)
                                 : table.number(column.name, meaning, bounds));
        }
      },
      any_law);
  return inputs;
}

[[nodiscard]] mpm::Hold read_hold(const TomlTable& table) {
  constexpr std::array<std::string_view, 2> holds{"pushes", "pushes_and_pulls"};
  const bool pulls =
      table.choice_or("pushes", "hold", "whether material may leave the wall", holds) == holds[1];
  return pulls ? mpm::Hold::pushes_and_pulls : mpm::Hold::pushes;
}

[[nodiscard]] FrictionScene read_friction(const TomlTable& table, const Scene& scene, std::size_t axis) {
  constexpr auto laws = names_of<rheology::AnyWallLaw>();
  FrictionScene wall;
  const std::string name = table.choice("law", "friction of the wall", laws);
  if (!table.is_sound("law")) return wall;
  read_named(table, name, wall.law);
  wall.inputs = read_inputs(table, scene, axis, wall.law);
  wall.hold = read_hold(table);
  return wall;
}

/// `law = "coulomb", friction = ..` of the wall law of this name; nothing if there is none.
[[nodiscard]] std::string example_of(std::string_view name) {
  std::string example;
  for_each_entry<rheology::AnyWallLaw>([&](auto entry) {
    using Law = typename decltype(entry)::type;
    if (Law::name != name) return;
    example = fmt::format("law = \"{}\"", name);
    for (const auto& parameter : Law::parameters) example += fmt::format(", {} = ..", parameter.name);
  });
  return example;
}

[[nodiscard]] WallScene read_wall(const TomlTable& boundaries, const std::string& key,
                                  std::string_view meaning, const Scene& scene, std::size_t axis) {
  if (boundaries.is_table(key)) return read_friction(boundaries.table(key), scene, axis);
  constexpr auto walls = names_of<mpm::AnyWall>();
  constexpr auto laws = names_of<rheology::AnyWallLaw>();
  std::vector<std::string_view> names{walls.begin(), walls.end()};
  names.insert(names.end(), laws.begin(), laws.end());
  names.push_back(OpenEnd::name);
  const std::string name = boundaries.choice(key, meaning, names);
  if (name == OpenEnd::name) return OpenEnd{};
  const std::string example = example_of(name);
  boundaries.check(example.empty(), {key},
                   fmt::format("a wall with friction is a table: {} = {{{}}}", key, example));
  mpm::AnyWall wall;
  read_named(boundaries, name, wall);
  return wall;
}

/// A periodic axis has no ends that a wall could stand on.
void refuse_walls(const TomlTable& boundaries, std::string_view axis) {
  for (const std::string_view end : {"low", "high"}) {
    const std::string key = fmt::format("{}_{}", axis, end);
    if (!boundaries.has(key)) continue;
    boundaries.add_fault(
        key,
        fmt::format("{0} is periodic, so that no wall can stand there; leave out {1}, or {0}", axis, key));
  }
}

}  // namespace

std::vector<AxisScene> read_axes(const TomlTable& boundaries, const Scene& scene) {
  constexpr std::array<std::string_view, 2> kinds{"walls", "periodic"};
  std::vector<AxisScene> axes;
  for (const std::string_view name : axis_names(scene.mesh.dimensions)) {
    AxisScene ends;
    ends.is_periodic =
        boundaries.choice_or("walls", name, "what ends this axis of the mesh", kinds) == "periodic";
    if (!ends.is_periodic) {
      const auto read = [&](std::string_view end) {
        return read_wall(boundaries, fmt::format("{}_{}", name, end), fmt::format("wall at the {} end", end),
                         scene, axes.size());
      };
      ends.low = read("low");
      ends.high = read("high");
    } else {
      refuse_walls(boundaries, name);
    }
    axes.push_back(ends);
  }
  return axes;
}

bool has_plain_walls(const std::vector<AxisScene>& axes) {
  return std::ranges::all_of(axes, [](const AxisScene& axis) {
    return std::holds_alternative<mpm::AnyWall>(axis.low) && std::holds_alternative<mpm::AnyWall>(axis.high);
  });
}

ContactScene read_contact(const TomlTable& table, const Scene& scene) {
  constexpr std::string_view key = "contact";
  constexpr auto laws = names_of<rheology::AnyWallLaw>();
  std::vector<std::string_view> names{mpm::Sticks::name, mpm::Slides::name};
  names.insert(names.end(), laws.begin(), laws.end());
  constexpr std::size_t no_axis = 3;  // the depth over ground is not the extent along an axis
  ContactScene contact;
  const bool is_table = table.is_table(key);
  const TomlTable own = is_table ? table.table(key) : table;
  const std::string_view name_key = is_table ? "law" : key;
  const std::string name = own.choice(name_key, "how it holds material that touches it", names);
  const std::string example = is_table ? std::string{} : example_of(name);
  table.check(example.empty(), {key}, fmt::format("a law of friction is a table: {} = {{{}}}", key, example));
  if (!own.is_sound(name_key)) return contact;
  if (name == mpm::Slides::name) contact.law = mpm::Slides{};
  if (is_table && name != mpm::Sticks::name && name != mpm::Slides::name) {
    rheology::AnyWallLaw law;
    read_named(own, name, law);
    contact.inputs = read_inputs(own, scene, no_axis, law);
    contact.law = law;
  }
  if (is_table) contact.hold = read_hold(own);
  return contact;
}

}  // namespace scree::app
