#include "scree/run/summary.hpp"

#include "scree/scene/dimensions.hpp"

#include <scree/mpm/limiting_point.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

namespace scree::app {

namespace {

[[nodiscard]] double sum_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

void add(std::vector<double>& sums, const std::vector<double>& values, double times) {
  for (std::size_t k = 0; k < values.size(); ++k) sums[k] += times * values[k];
}

template <int V>
[[nodiscard]] nlohmann::ordered_json json_of(const mpm::Passed<V>& passed) {
  return {{"points", passed.count}, {"mass", passed.mass}, {"momentum", passed.momentum}};
}

/// What began and has entered, and what is there and has left [kg].
struct Balance {
  std::vector<double> came;  ///< one per class
  std::vector<double> is;    ///< one per class
};

template <int D, int V>
[[nodiscard]] Balance class_balance(const Simulation<D, V>& simulation) {
  Balance balance{simulation.tally.first_class_masses, class_masses(simulation.state.particles)};
  for (const auto& inflow : simulation.streams.inflows) {
    add(balance.came, class_masses(inflow.layer()), static_cast<double>(inflow.num_layers()));
  }
  add(balance.is, simulation.state.absorbed.carried, 1);
  for (const auto& taken : simulation.streams.taken) add(balance.is, taken.carried, 1);
  return balance;
}

template <int D, int V>
void add_passed(const Simulation<D, V>& simulation, nlohmann::ordered_json& json) {
  const bool absorbs = simulation.scene().leaving == mpm::Leaving::absorb;
  if (absorbs) json["absorbed"] = json_of(simulation.state.absorbed);
  const Streams<D, V>& streams = simulation.streams;
  for (const auto& inflow : streams.inflows) json["inflow"].push_back(json_of(inflow.entered()));
  for (const auto& taken : streams.taken) json["outflow"].push_back(json_of(taken));
  if (absorbs || !streams.inflows.empty() || !streams.taken.empty()) {
    json["mass_drift"] = mass_drift(simulation);
  }
}

/// What bounds the step as things are.
template <int D, int V>
[[nodiscard]] std::optional<mpm::TimeStep> limit_of(const Simulation<D, V>& simulation) {
  try {
    return simulation.next_step();
  } catch (const InputError&) {  // nothing does: the run has failed by numbers that are none
    return std::nullopt;
  }
}

/// That, and the point that it comes from.
template <int D, int V>
void add_limit(const Simulation<D, V>& simulation, nlohmann::ordered_json& json) {
  const auto found = limit_of(simulation);
  if (!found) return;
  const mpm::TimeStep next = *found;
  json["limit"]["name"] = mpm::limit_names[static_cast<std::size_t>(next.limit)];
  json["limit"]["dt"] = next.dt;
  const auto& particles = simulation.state.particles;
  const auto point =
      mpm::limiting_point(particles, *simulation.stages().stress, simulation.grid(), next.limit);
  if (!point) return;
  json["limit"]["point"] = particles.id.component(0)[*point];
  for (int axis = 0; axis < D; ++axis) {
    json["limit"]["position"].push_back(particles.position.component(axis)[*point]);
  }
}

/// What the grains of a run did, and what bounded the steps of their segregation.
template <int D, int V>
void add_grains(Simulation<D, V>& simulation, nlohmann::ordered_json& json) {
  const Tally& tally = simulation.tally;
  json["class_mass_drift"] = class_mass_drift(simulation);
  json["fraction_min"] = tally.fractions.lowest;
  json["fraction_max"] = tally.fractions.highest;
  json["fraction_sum_error"] = tally.fractions.sum_error;
  json["segregation_steps"] = tally.segregation_steps;
  json["segregation_substeps"] = tally.segregation_substeps;
  const auto limit = simulation.segregation_limit();
  if (!limit) return;
  json["segregation_limit"]["dt"] = limit->dt;
  for (int axis = 0; axis < D; ++axis) {
    json["segregation_limit"]["position"].push_back(limit->position[axis]);
  }
}

}  // namespace

template <int D, int V>
double mass_drift(const Simulation<D, V>& simulation) {
  double came = simulation.tally.first_mass;
  for (const auto& inflow : simulation.streams.inflows) came += inflow.entered().mass;
  double is = sum_of(simulation.state.particles.mass.values()) + simulation.state.absorbed.mass;
  for (const auto& taken : simulation.streams.taken) is += taken.mass;
  return std::abs(is - came) / came;
}

template <int D, int V>
double class_mass_drift(const Simulation<D, V>& simulation) {
  if (simulation.tally.first_class_masses.empty()) return 0;
  const Balance balance = class_balance(simulation);
  if (simulation.is_crushing()) {
    return std::abs(sum_of(balance.is) - sum_of(balance.came)) / sum_of(balance.came);
  }
  double drift = 0;
  for (std::size_t k = 0; k < balance.came.size(); ++k) {
    const double came = balance.came[k];
    if (came > 0) drift = std::max(drift, std::abs(balance.is[k] - came) / came);
  }
  return drift;
}

template <int D, int V>
std::string summary_json(Simulation<D, V>& simulation, double wall_seconds, const std::string& outcome) {
  const Tally& tally = simulation.tally;
  const mpm::PhaseSeconds& seconds = simulation.state.seconds;
  const double updates = simulation.point_updates();
  const auto per_point = [&](double phase) { return updates > 0 ? 1e9 * phase / updates : 0; };
  nlohmann::ordered_json json;
  json["outcome"] = outcome;
  json["steps"] = simulation.clock.step;
  json["time"] = simulation.clock.time;
  json["wall_seconds"] = wall_seconds;
  json["points"] = simulation.num_points();
  json["point_updates_per_second"] = wall_seconds > 0 ? updates / wall_seconds : 0;
  json["ns_per_point"] = {{"stress_and_scatter", per_point(seconds.scatter)},
                          {"nodes", per_point(seconds.nodes)},
                          {"gather", per_point(seconds.gather)},
                          {"sort", per_point(seconds.sort)},
                          {"segregation", per_point(tally.segregation_seconds)}};
  json["steps_by_limit"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < mpm::limit_names.size(); ++i) {
    json["steps_by_limit"][std::string{mpm::limit_names[i]}] = tally.steps_by_limit[i];
  }
  add_limit(simulation, json);
  add_passed(simulation, json);
  if (const auto share = simulation.ill_posed_share()) json["ill_posed_share"] = *share;
  if (simulation.scene().grains) add_grains(simulation, json);
  return json.dump(2) + "\n";
}

#define SCREE_INSTANCE(D, V)                                 \
  template double class_mass_drift(const Simulation<D, V>&); \
  template double mass_drift(const Simulation<D, V>&);       \
  template std::string summary_json(Simulation<D, V>&, double, const std::string&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
