#include "scree/scene/axes.hpp"
#include "scree/scene/choices.hpp"
#include "scree/scene/chosen.hpp"
#include "scree/scene/map_files.hpp"
#include "scree/scene/output_fields.hpp"
#include "scree/scene/read_grains.hpp"
#include "scree/scene/read_ground.hpp"
#include "scree/scene/read_material.hpp"
#include "scree/scene/read_models.hpp"
#include "scree/scene/read_streams.hpp"
#include "scree/scene/read_walls.hpp"
#include "scree/scene/scene.hpp"
#include "scree/scene/traits.hpp"

#include <scree/io/toml_reader.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::app {

namespace {

using io::above;
using io::at_least;
using io::between;
using io::TomlTable;

[[nodiscard]] MeshScene read_mesh(const TomlTable& table) {
  MeshScene mesh;
  mesh.dimensions = static_cast<int>(table.integer("dimensions", "dimensions of space", between(1, 3)));
  if (!table.is_sound("dimensions")) mesh.dimensions = 2;
  mesh.velocity_components = static_cast<int>(table.integer_or(
      mesh.dimensions, "velocity_components", "components of velocity", between(mesh.dimensions, 3)));
  if (!table.is_sound("velocity_components")) mesh.velocity_components = mesh.dimensions;
  mesh.is_axisymmetric = table.choice_or("plane", "symmetry", "what the mesh is a cut through",
                                         names_of(choices::symmetries)) == "axisymmetric";
  table.check(!mesh.is_axisymmetric || (mesh.dimensions == 2 && mesh.velocity_components == 2),
              {"symmetry", "dimensions", "velocity_components"},
              "flow round an axis takes 2 dimensions and 2 components of velocity");
  const auto dimensions = static_cast<std::size_t>(mesh.dimensions);
  mesh.size = table.numbers("size", "edges of the mesh [m], one per dimension", above(0), dimensions);
  mesh.cells = table.integer("cells", "number of cells along y", between(1, 1e6));
  if (!table.is_sound("size") || !table.is_sound("cells")) {
    mesh.size.assign(dimensions, 1.0);
    mesh.cells = 1;
    return mesh;
  }
  const double edge = mesh.size[static_cast<std::size_t>(normal_component(mesh.dimensions))] /
                      static_cast<double>(mesh.cells);
  for (const double size : mesh.size) {
    const double cells = size / edge;
    table.check(std::round(cells) >= 1 && std::abs(cells - std::round(cells)) <= 1e-6 * cells,
                {"size", "cells"},
                fmt::format("each edge must be a whole number of cells, whose edge is {:g} m", edge));
  }
  return mesh;
}

[[nodiscard]] GravityScene read_gravity(const TomlTable& table) {
  GravityScene gravity;
  gravity.magnitude = table.number_or(9.81, "magnitude", "acceleration of gravity [m/s^2]", at_least(0));
  gravity.slope_degrees = table.number_or(0, "slope_degrees", "slope of the base [degrees]", between(0, 90));
  return gravity;
}

[[nodiscard]] SegregationScene read_segregation(const TomlTable& table) {
  SegregationScene scene;
  read_chosen(table, "closure", "what drives segregation", scene.closure);
  scene.remixing = table.number_or(0, "remixing", "diffusion of the fractions D [m^2/s]", at_least(0));
  read_chosen(table, "limiter", "slope limiter", scene.limiter, "minmod");
  read_chosen(table, "integrator", "time integrator", scene.integrator, "ssp_rk2");
  scene.cfl = table.number_or(0.5, "cfl", "Courant number of a segregation step [-]",
                              io::Bounds{0, 0.5, true, false});
  scene.control_volumes = table.choice_or("cells", "control_volumes", "where fractions are balanced",
                                          names_of(choices::control_volumes)) == "cells"
                              ? Sites::cells
                              : Sites::nodes;
  scene.map = table.choice_or("exchange", "map", "how changes come back to the points",
                              names_of(choices::carried_maps)) == "exchange"
                  ? mpm::CarriedMap::exchange
                  : mpm::CarriedMap::increments;
  scene.every = table.integer_or(100, "every", "momentum steps between segregation steps", between(1, 1e6));
  return scene;
}

/// The law's memory at the start, where it may be told.
[[nodiscard]] std::vector<InitialScene> read_initial(const TomlTable& table,
                                                     const rheology::AnyLaw& any_law) {
  std::vector<InitialScene> initial;
  const auto read = [&](const auto& law) {
    for (const StateColumn& state : law.states) {
      if (!state.start || !table.has(state.name)) continue;
      initial.push_back({std::string{state.name}, app::read_initial(table, state)});
    }
  };
  std::visit(read, any_law);
  return initial;
}

/// The boxes of uniform GIMP fill a cell only if there are as many as points.
void check_boxes(const TomlTable& table, const Scene& scene) {
  const auto* gimp = std::get_if<mpm::Gimp>(&scene.shape);
  if (gimp == nullptr) return;
  const auto check = [&](Index points_per_cell, const std::string& where) {
    const double points_per_axis = 0.5 / gimp->half_width();
    table.check(std::abs(points_per_axis - static_cast<double>(points_per_cell)) <= 1e-9 * points_per_axis,
                {"points_per_axis"},
                fmt::format("must be {} points_per_cell = {}: boxes of that many points fill a cell", where,
                            points_per_cell));
  };
  if (scene.material.stored) {
    const std::string differences = difference(scene.material.stored->traits, traits_of_boxes(scene));
    table.check(
        differences.empty(), {"shape"},
        fmt::format("the boxes of points of [material] checkpoint have another size: {}", differences));
  } else if (!scene.material.is_absent) {
    check(scene.material.points_per_cell, "[material]");
  }
  for (std::size_t i = 0; i < scene.inflows.size(); ++i) {
    check(scene.inflows[i].points_per_cell, fmt::format("[[inflow]] {}", i + 1));
  }
}

/// What a step does beside its own passes.
void read_extra_passes(const TomlTable& table, Scene& scene) {
  const std::string order = table.choice_or("usl", "order", "when in a step stress is brought up to date",
                                            names_of(choices::orders));
  for (std::size_t i = 0; i < mpm::order_names.size(); ++i) {
    if (order == mpm::order_names[i]) scene.order = static_cast<mpm::Order>(i);
  }
  scene.averaging.volume_change = table.boolean_or(false, "averaged_volume_change",
                                                   "whether laws see the mean change of volume of a cell");
  scene.averaging.pressure =
      table.boolean_or(false, "averaged_pressure", "whether forces are those of a cell's mean pressure");
  scene.xpic_order = static_cast<int>(table.integer_or(
      0, "xpic_order", "order of the filter of velocities; 0: they are not filtered", between(0, 20)));
  const auto* flip = std::get_if<mpm::PicFlip>(&scene.transfer);
  table.check(scene.xpic_order == 0 || (flip != nullptr && flip->increment_share() == 1),
              {"xpic_order", "transfer"},
              "velocities are filtered for transfer = \"pic_flip\" with increment_share = 1 only");
}

/// How the viscous part of the stress is advanced, and what that does not go with.
void read_viscosity(const TomlTable& table, Scene& scene) {
  const std::string viscosity =
      table.choice_or("explicit", "viscosity", "how the viscous part of the stress is advanced",
                      names_of(choices::viscosity_schemes));
  if (viscosity == "implicit") scene.viscosity = ViscosityScheme::implicit;
  if (viscosity == "auto") scene.viscosity = ViscosityScheme::automatic;
  const bool is_explicit = viscosity == "explicit";
  table.check(is_explicit || std::holds_alternative<mpm::Linear>(scene.shape), {"viscosity", "shape"},
              "viscosity is implicit for shape = \"linear\" only");
  table.check(is_explicit || !has_wall<FrictionScene>(scene.axes), {"viscosity"},
              "viscosity is implicit for walls without friction only");
  table.check(is_explicit || !has_wall<OpenEnd>(scene.axes), {"viscosity"},
              "viscosity is implicit without \"open\" ends only");
  table.check(is_explicit || (!scene.terrain && scene.bodies.empty()), {"viscosity"},
              "viscosity is implicit without terrain and bodies only");
  table.check(is_explicit || scene.inflows.empty(), {"viscosity"},
              "viscosity is implicit without [[inflow]] only");
}

void read_numerics(const TomlTable& table, Scene& scene) {
  read_chosen(table, "shape", "shape function of momentum", scene.shape, "linear");
  check_boxes(table, scene);
  read_chosen(table, "transfer", "how velocity travels between points and nodes", scene.transfer, "apic");
  read_extra_passes(table, scene);
  read_viscosity(table, scene);
  const io::Bounds share{0, 1, true, false};
  mpm::TimeStepOptions& options = scene.time_step;
  options.acoustic =
      table.number_or(options.acoustic, "acoustic", "share of the acoustic limit of dt [-]", share);
  options.advective =
      table.number_or(options.advective, "advective", "share of the advective limit of dt [-]", share);
  options.viscous =
      table.number_or(options.viscous, "viscous", "share of the viscous limit of dt [-]", share);
  options.relaxation = table.number_or(options.relaxation, "relaxation",
                                       "share of the time in which a law's memory changes [-]", share);
  options.maximum =
      table.number_or(0, "maximum_dt", "the user's own limit of dt [s]; 0 is none", at_least(0));
  scene.mass_floor =
      table.number_or(scene.mass_floor, "mass_floor",
                      "mass of the lightest node that moves, over that of the heaviest point [-]",
                      io::Bounds{0, 1, false, true});
}

[[nodiscard]] OutputScene read_output(const TomlTable& table, double end, bool has_grains,
                                      const rheology::AnyLaw& law) {
  OutputScene output;
  output.every = table.number_or(end, "every", "simulated time between frames [s]", above(0));
  output.checkpoint_every =
      table.number_or(end, "checkpoint_every", "simulated time between checkpoints [s]", above(0));
  output.fields =
      table.has("fields") ? table.strings("fields", "what each frame holds") : default_fields(has_grains);
  for (const std::string& field : output.fields) {
    const auto known = known_fields(has_grains, law);
    table.check(std::find(known.begin(), known.end(), field) != known.end(), {"fields"},
                fmt::format("'{}' is none of {}", field, fmt::join(known, ", ")));
  }
  return output;
}

/// What becomes of points that leave the mesh.
[[nodiscard]] mpm::Leaving read_leaving(const TomlTable& boundaries) {
  const std::string name = boundaries.choice_or(
      "stop", "leaving", "what becomes of a point that leaves the mesh", names_of(choices::leavings));
  if (name == "absorb") return mpm::Leaving::absorb;
  return name == "reflect" ? mpm::Leaving::reflect : mpm::Leaving::stop;
}

/// Where the map of the ground lies, for maps of what lies on it.
[[nodiscard]] MapPlace map_place_of(const Scene& scene) {
  if (!scene.terrain) return {};
  const auto* map = std::get_if<RasterScene>(&scene.terrain->surface);
  const auto* triangles = std::get_if<TrianglesScene>(&scene.terrain->surface);
  return map != nullptr ? map->place : triangles != nullptr ? triangles->place : MapPlace{};
}

/// What enters and what is taken away. Without material the streams have to bring it.
void read_what_passes(const TomlTable& root, Scene& scene) {
  scene.inflows = read_inflows(root.tables("inflow"), scene);
  scene.outflows = read_outflows(root.tables("outflow"), scene);
  MaterialScene& material = scene.material;
  const bool begins = std::ranges::any_of(scene.inflows, begins_full);
  if (material.stored && begins)
    root.add_fault("inflow", "with [material] checkpoint none may have start = 0");
  if (!material.is_absent) return;
  if (!begins) root.add_fault("inflow", "without [material] one must have start = 0");
  material.low.assign(scene.mesh.size.size(), std::numeric_limits<double>::infinity());
  material.high.assign(scene.mesh.size.size(), 0.0);
  for (const InflowScene& inflow : scene.inflows) {
    for (std::size_t d = 0; d < std::min(inflow.low.size(), inflow.high.size()); ++d) {
      material.low[d] = std::min(material.low[d], inflow.low[d]);
      material.high[d] = std::max(material.high[d], inflow.high[d]);
    }
  }
}

/// The ground, the material on it, and all else that touches material: by what each needs of the others.
void read_surroundings(const TomlTable& root, Scene& scene, SceneFiles& files) {
  if (root.has("terrain")) scene.terrain = read_terrain(root.table("terrain"), scene, files);
  scene.material.is_absent = !root.has("material") && root.has("inflow");
  if (!scene.material.is_absent) {
    scene.material = read_material(root.table("material"), scene, map_place_of(scene), files);
  }
  scene.bodies = read_bodies(root.tables("bodies"), scene, files);
  const TomlTable boundaries = root.table("boundaries");
  scene.axes = read_axes(boundaries, scene);
  scene.leaving = read_leaving(boundaries);
  read_what_passes(root, scene);
}

/// What flow round an axis does not go with.
void check_symmetry(const TomlTable& root, const Scene& scene) {
  if (!scene.mesh.is_axisymmetric) return;
  const TomlTable boundaries = root.table("boundaries");
  const auto* axis = std::get_if<mpm::AnyWall>(&scene.axes[0].low);
  boundaries.check(!scene.axes[0].is_periodic && axis != nullptr && std::holds_alternative<mpm::Slip>(*axis),
                   {"x_low"}, "the axis of symmetry must be \"slip\"");
  root.table_or_empty("gravity").check(scene.gravity.slope_degrees == 0, {"slope_degrees"},
                                       "flow round an axis has none");
  const TomlTable numerics = root.table_or_empty("numerics");
  numerics.check(scene.viscosity == ViscosityScheme::with_stress, {"viscosity"},
                 "is explicit in flow round an axis");
  numerics.check(scene.order == mpm::Order::usl && !scene.averaging.is_on(),
                 {"order", "averaged_volume_change", "averaged_pressure"},
                 "flow round an axis takes \"usl\", without means over cells");
}

[[nodiscard]] ReadScene read(io::TomlFile file, const std::vector<std::string>& overrides,
                             const std::filesystem::path& folder) {
  for (const std::string& assignment : overrides) file.set(assignment);
  const TomlTable root = file.root();
  Scene scene;
  SceneFiles files{folder};
  scene.title = root.string_or("", "title", "what the scene is");
  scene.mesh = read_mesh(root.table("mesh"));
  scene.gravity = read_gravity(root.table_or_empty("gravity"));
  const TomlTable rheology = root.table("rheology");
  read_chosen(rheology, "law", "constitutive law", scene.law);
  if (rheology.is_sound("law")) scene.initial = read_initial(rheology.table_or_empty("initial"), scene.law);
  if (root.has("grains")) {
    scene.grains = read_grains(root.table("grains"));
    scene.mixture = read_mixture(root.table("grains"), scene);
  }
  read_surroundings(root, scene, files);
  rheology.check(!scene.material.stored || !rheology.has("initial"), {"initial"},
                 "the points of [material] checkpoint bring the law's memory with them");
  read_numerics(root.table_or_empty("numerics"), scene);
  const TomlTable time = root.table("time");
  scene.end = time.number("end", "simulated time at which the run ends [s]", above(0));
  if (root.has("segregation")) {
    scene.segregation = read_segregation(root.table("segregation"));
    if (!root.has("grains")) root.add_fault("segregation", "needs the table [grains]");
  }
  check_symmetry(root, scene);
  scene.output = read_output(root.table_or_empty("output"), scene.end, root.has("grains"), scene.law);
  file.finish();
  return {std::move(scene), file.to_text(), files.files()};
}

}  // namespace

ReadScene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read(io::TomlFile::read(path), overrides, path.parent_path());
}

ReadScene parse_scene(const std::string& text, const std::string& name,
                      const std::vector<std::string>& overrides) {
  return read(io::TomlFile::parse(text, name), overrides, std::filesystem::path{name}.parent_path());
}

}  // namespace scree::app
