#include "scree/scene/read_walls.hpp"

#include "scree/scene/axes.hpp"
#include "scree/scene/choices.hpp"
#include "scree/scene/chosen.hpp"
#include "scree/scene/law_columns.hpp"
#include "scree/scene/material_columns.hpp"
#include "scree/scene/read_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace scree::app {

namespace {

using io::TomlTable;

/// What the scene says of a column that a wall across an axis reads: the mean size of its grains, the depth
/// of its material along the axis, or the friction at which that yields.
[[nodiscard]] std::optional<double> from_scene(const Scene& scene, std::size_t axis,
                                               const InputColumn& column) {
  if (column.name == grain_size_column && scene.grains) {
    return grainsize::arithmetic_mean(scene.grains->classes.diameters(), scene.grains->fractions);
  }
  const MaterialScene& material = scene.material;
  if (column.name == "depth" && axis < std::min(material.low.size(), material.high.size())) {
    return material.high[axis] - material.low[axis];
  }
  if (column.name == friction_column) return yield_friction(scene.law);
  return std::nullopt;
}

/// The names of the columns of the material in a unit.
[[nodiscard]] std::vector<std::string_view> material_names(const Scene& scene, std::string_view unit) {
  std::vector<std::string_view> names;
  for (const MaterialColumn& column : material_columns(scene)) {
    if (column.unit == unit) names.push_back(column.name);
  }
  return names;
}

/// The column of the material that a key names, or that stands for the key where it is left out: its friction
/// is by place. Nothing if what the law reads is a number.
[[nodiscard]] std::string read_of_material(const TomlTable& table, const Scene& scene,
                                           const InputColumn& column) {
  const auto names = material_names(scene, column.unit);
  if (table.is_string(column.name) && !names.empty()) {
    return table.choice(
        column.name,
        fmt::format("a number, or what the law of the wall reads of the material [{}]", column.unit), names);
  }
  const bool is_own =
      column.name == friction_column && std::ranges::find(names, friction_column) != names.end();
  return is_own && !table.has(column.name) ? std::string{friction_column} : std::string{};
}

/// What a law of friction reads, a key for each column.
/// @param wall FrictionScene or ContactScene: what it is told goes there
template <class WallOrContact>
void read_inputs(const TomlTable& table, const Scene& scene, std::size_t axis,
                 const rheology::AnyWallLaw& any_law, WallOrContact& wall) {
  constexpr double unread = std::numeric_limits<double>::quiet_NaN();
  const auto read = [&](const InputColumn& column) {
    const std::string meaning = fmt::format("what the law of the wall reads [{}]", column.unit);
    const auto known = from_scene(scene, axis, column);
    const io::Bounds bounds = bounds_of(column.range);
    return known ? table.number_or(*known, column.name, meaning, bounds)
                 : table.number(column.name, meaning, bounds);
  };
  std::visit(
      [&](const auto& law) {
        for (const InputColumn& column : law.inputs) {
          wall.of_material.push_back(read_of_material(table, scene, column));
          wall.inputs.push_back(wall.of_material.back().empty() ? read(column) : unread);
        }
      },
      any_law);
}

[[nodiscard]] mpm::Hold read_hold(const TomlTable& table) {
  const bool pulls = table.choice_or("pushes", "hold", "whether material may leave the wall",
                                     names_of(choices::holds)) == "pushes_and_pulls";
  return pulls ? mpm::Hold::pushes_and_pulls : mpm::Hold::pushes;
}

[[nodiscard]] FrictionScene read_friction(const TomlTable& table, const Scene& scene, std::size_t axis) {
  constexpr auto laws = names_of<rheology::AnyWallLaw>();
  FrictionScene wall;
  const std::string name = table.choice("law", "friction of the wall", laws);
  if (!table.is_sound("law")) return wall;
  read_named(table, name, wall.law);
  read_inputs(table, scene, axis, wall.law, wall);
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
  std::vector<AxisScene> axes;
  for (const std::string_view name : axis_names(scene.mesh.dimensions)) {
    AxisScene ends;
    ends.is_periodic = boundaries.choice_or("walls", name, "what ends this axis of the mesh",
                                            names_of(choices::axis_kinds)) == "periodic";
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

ContactScene read_contact(const TomlTable& table, const Scene& scene) {
  constexpr std::string_view key = "contact";
  constexpr auto laws = names_of<rheology::AnyWallLaw>();
  constexpr auto plain = names_of(choices::plain_contacts);
  std::vector<std::string_view> names{plain.begin(), plain.end()};
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
    read_inputs(own, scene, no_axis, law, contact);
    contact.law = law;
  }
  if (is_table) contact.hold = read_hold(own);
  return contact;
}

}  // namespace scree::app
