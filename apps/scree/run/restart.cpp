#include "scree/run/restart.hpp"

#include "scree/scene/checkpoint_layout.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/material_columns.hpp"
#include "scree/scene/traits.hpp"

#include <scree/io/checkpoint.hpp>

#include <algorithm>

namespace scree::app {

namespace {

/// Names of the columns, one on a line.
template <int D, int V>
[[nodiscard]] std::string column_names(const mpm::Particles<D, V>& particles) {
  std::string names;
  particles.for_each_column([&](const mpm::Column& column) { names += column.quantity().name + '\n'; });
  return names;
}

/// Blocks as one list of integers: first cell, begin, end of each.
template <int D>
[[nodiscard]] std::vector<std::int64_t> flattened(const mpm::ParticleBlocks<D>& blocks) {
  std::vector<std::int64_t> flat;
  for (const auto& block : blocks.blocks) {
    flat.insert(flat.end(), block.first_cell.begin(), block.first_cell.end());
    flat.push_back(block.begin);
    flat.push_back(block.end);
  }
  return flat;
}

template <int D>
[[nodiscard]] mpm::ParticleBlocks<D> unflattened(std::span<const std::int64_t> flat) {
  mpm::ParticleBlocks<D> blocks;
  for (std::size_t i = 0; i + D + 2 <= flat.size(); i += D + 2) {
    mpm::ParticleBlock<D> block;
    std::copy_n(flat.begin() + static_cast<std::ptrdiff_t>(i), D, block.first_cell.begin());
    block.begin = flat[i + D];
    block.end = flat[i + D + 1];
    blocks.blocks.push_back(block);
  }
  return blocks;
}

/// Calls visit(name, number) for every number of a run that is not a column, the same way for writing and
/// reading.
template <class SimulationType, class Visit>
void for_each_number(SimulationType& simulation, Visit&& visit) {
  visit("time", simulation.clock.time);
  visit("moved_time", simulation.clock.moved);
  visit("first_dt", simulation.clock.first_dt);
  visit("step", simulation.clock.step);
  visit("frame", simulation.clock.frame);
  visit("unsegregated_time", simulation.clock.unsegregated_time);
  visit("unsegregated_steps", simulation.clock.unsegregated_steps);
  visit("wave_speed", simulation.state.rates.wave_speed);
  visit("kinematic_viscosity", simulation.state.rates.kinematic_viscosity);
  visit("advection_rate", simulation.state.rates.advection_rate);
  visit("relaxation_rate", simulation.state.rates.relaxation_rate);
  visit("mass_floor", simulation.state.mass_floor);
  visit("next_id", simulation.state.next_id);
  visit("first_mass", simulation.tally.first_mass);
  visit("segregation_steps", simulation.tally.segregation_steps);
  visit("segregation_substeps", simulation.tally.segregation_substeps);
  visit("lowest_fraction", simulation.tally.fractions.lowest);
  visit("highest_fraction", simulation.tally.fractions.highest);
  visit("fraction_sum_error", simulation.tally.fractions.sum_error);
  for (std::size_t i = 0; i < mpm::limit_names.size(); ++i) {
    visit("steps_by_" + std::string{mpm::limit_names[i]}, simulation.tally.steps_by_limit[i]);
  }
}

/// Calls visit(sums) for what has been absorbed, and for what each outflow has taken.
template <class SimulationType, class Visit>
void for_each_passed(SimulationType& simulation, Visit&& visit) {
  visit(simulation.state.absorbed);
  for (auto& taken : simulation.streams.taken) visit(taken);
}

/// Layers that have entered by each inflow; what has left, and of which classes.
template <int D, int V>
void write_streams(const Simulation<D, V>& simulation, io::CheckpointWriter& writer) {
  std::vector<std::int64_t> layers;
  for (const auto& inflow : simulation.streams.inflows) layers.push_back(inflow.num_layers());
  std::vector<std::int64_t> points;
  std::vector<double> sums;
  for_each_passed(simulation, [&](const mpm::Passed<V>& passed) {
    points.push_back(passed.count);
    sums.push_back(passed.mass);
    sums.insert(sums.end(), passed.momentum.begin(), passed.momentum.end());
    std::vector<double> carried = passed.carried;
    carried.resize(simulation.tally.first_class_masses.size());
    sums.insert(sums.end(), carried.begin(), carried.end());
  });
  writer.add("inflow_layers", std::span<const std::int64_t>{layers});
  writer.add("left_points", std::span<const std::int64_t>{points});
  writer.add("left_sums", std::span<const double>{sums});
}

template <int D, int V>
void restore_streams(Simulation<D, V>& simulation, const io::Checkpoint& checkpoint) {
  Streams<D, V>& streams = simulation.streams;
  const auto layers = checkpoint.integers("inflow_layers", static_cast<Index>(streams.inflows.size()));
  for (std::size_t i = 0; i < layers.size(); ++i) streams.inflows[i].resume(layers[i]);
  const std::size_t num_classes = simulation.tally.first_class_masses.size();
  const auto num_passed = static_cast<Index>(1 + streams.taken.size());
  const auto points = checkpoint.integers("left_points", num_passed);
  const auto sums = checkpoint.doubles("left_sums", num_passed * static_cast<Index>(1 + V + num_classes));
  auto count = points.begin();
  auto sum = sums.begin();
  for_each_passed(simulation, [&](mpm::Passed<V>& passed) {
    passed.count = *count++;
    passed.mass = *sum++;
    for (double& momentum : passed.momentum) momentum = *sum++;
    passed.carried.assign(sum, sum + static_cast<std::ptrdiff_t>(num_classes));
    sum += static_cast<std::ptrdiff_t>(num_classes);
  });
}

void require_as_many(Index in_checkpoint, std::size_t in_scene, const std::string& tables,
                     const std::filesystem::path& path) {
  require(in_checkpoint == static_cast<Index>(in_scene), path.string() + ": is of another scene: it has " +
                                                             std::to_string(in_checkpoint) + ' ' + tables +
                                                             ", the scene has " + std::to_string(in_scene));
}

template <int D, int V>
void require_same_parts(const Simulation<D, V>& simulation, const io::Checkpoint& checkpoint,
                        const std::filesystem::path& path) {
  const std::string here = std::to_string(D) + "D with " + std::to_string(V) + " velocity components";
  const auto dimensions = checkpoint.integer("dimensions");
  const auto components = checkpoint.integer("velocity_components");
  require(dimensions == D && components == V,
          path.string() + ": is of a run in " + std::to_string(dimensions) + "D with " +
              std::to_string(components) + " velocity components; the scene is in " + here);
  require_as_many(checkpoint.length("inflow_layers"), simulation.streams.inflows.size(), "[[inflow]]", path);
  require_as_many(checkpoint.length("left_points") - 1, simulation.streams.taken.size(), "[[outflow]]", path);
  const std::string differences = difference(checkpoint.text("traits"), traits_of_run(simulation.scene()));
  require(differences.empty(), path.string() + ": is of another run: " + differences);
  simulation.state.particles.for_each_column([&](const mpm::Column& column) {
    require(
        checkpoint.contains(entry_of(column.quantity().name)) || column.quantity().name == friction_column,
        path.string() + ": is of another scene: it has no column '" + column.quantity().name + "'");
  });
}

}  // namespace

template <int D, int V>
void write_checkpoint(const Simulation<D, V>& simulation, const std::filesystem::path& path,
                      const std::string& scene_text) {
  io::CheckpointWriter writer{path, checkpoint_version};
  writer.add_text("scene", scene_text);
  writer.add_text("traits", traits_text(traits_of_run(simulation.scene())));
  const Vector<D> spacing = simulation.grid().spacing();
  writer.add("spacing", std::span<const double>{spacing.data(), D});
  writer.add_text("columns", column_names(simulation.state.particles));
  writer.add("dimensions", std::int64_t{D});
  writer.add("velocity_components", std::int64_t{V});
  for_each_number(simulation, [&](const std::string& name, const auto& number) { writer.add(name, number); });
  writer.add("first_class_masses", std::span<const double>{simulation.tally.first_class_masses});
  write_streams(simulation, writer);
  writer.add("blocks", std::span<const std::int64_t>{flattened(simulation.state.blocks)});
  simulation.state.particles.for_each_column(
      [&](const mpm::Column& column) { writer.add(entry_of(column.quantity().name), column.values()); });
  writer.commit();
}

template <int D, int V>
void read_checkpoint_into(Simulation<D, V>& simulation, const std::filesystem::path& path) {
  const io::Checkpoint checkpoint = io::read_checkpoint(path, checkpoint_version);
  require_same_parts(simulation, checkpoint, path);
  for_each_number(simulation, [&](const std::string& name, auto& number) {
    if constexpr (std::is_same_v<std::decay_t<decltype(number)>, double>) {
      number = checkpoint.number(name);
    } else {
      number = checkpoint.integer(name);
    }
  });
  auto& tally = simulation.tally;
  tally.first_class_masses =
      checkpoint.doubles("first_class_masses", static_cast<Index>(tally.first_class_masses.size()));
  restore_streams(simulation, checkpoint);
  auto& state = simulation.state;
  state.blocks = unflattened<D>(checkpoint.integers("blocks", checkpoint.length("blocks")));
  const Index size = checkpoint.length(entry_of(state.particles.mass.quantity().name));
  state.particles.resize(size);
  state.particles.for_each_column([&](mpm::Column& column) {
    if (!checkpoint.contains(entry_of(column.quantity().name)))
      return;  // found anew, as walls of this scene want it
    const auto values = checkpoint.doubles(entry_of(column.quantity().name), size * column.num_components());
    std::copy(values.begin(), values.end(), column.values().begin());
  });
  simulation.resume();
}

#define SCREE_INSTANCE(D, V)                                                                                 \
  template void write_checkpoint(const Simulation<D, V>&, const std::filesystem::path&, const std::string&); \
  template void read_checkpoint_into(Simulation<D, V>&, const std::filesystem::path&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
