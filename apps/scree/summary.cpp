#include "scree/summary.hpp"

#include "scree/dimensions.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scree::app {

template <int D, int V>
double class_mass_drift(const Simulation<D, V>& simulation) {
  const auto& first = simulation.tally.first_class_masses;
  if (first.empty()) return 0;
  const auto now = class_masses(simulation.state.particles);
  if (simulation.is_crushing()) {
    const double before = std::accumulate(first.begin(), first.end(), 0.0);
    return std::abs(std::accumulate(now.begin(), now.end(), 0.0) - before) / before;
  }
  double drift = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (first[k] > 0) drift = std::max(drift, std::abs(now[k] - first[k]) / first[k]);
  }
  return drift;
}

template <int D, int V>
std::string summary_json(const Simulation<D, V>& simulation, double wall_seconds, std::int64_t steps_here,
                         const std::string& outcome) {
  const Tally& tally = simulation.tally;
  const mpm::PhaseSeconds& seconds = simulation.state.seconds;
  const double updates = static_cast<double>(simulation.num_points()) * static_cast<double>(steps_here);
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
  if (simulation.scene().leaving == mpm::Leaving::absorb) {
    const mpm::Left<V>& absorbed = simulation.state.absorbed;
    json["absorbed"] = {{"points", absorbed.count}, {"mass", absorbed.mass}, {"momentum", absorbed.momentum}};
  }
  if (const auto share = simulation.ill_posed_share()) json["ill_posed_share"] = *share;
  if (simulation.scene().grains) {
    if (simulation.state.absorbed.count == 0) json["class_mass_drift"] = class_mass_drift(simulation);
    json["fraction_min"] = tally.fractions.lowest;
    json["fraction_max"] = tally.fractions.highest;
    json["fraction_sum_error"] = tally.fractions.sum_error;
    json["segregation_steps"] = tally.segregation_steps;
    json["segregation_substeps"] = tally.segregation_substeps;
  }
  return json.dump(2) + "\n";
}

#define SCREE_INSTANCE(D, V)                                 \
  template double class_mass_drift(const Simulation<D, V>&); \
  template std::string summary_json(const Simulation<D, V>&, double, std::int64_t, const std::string&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
