#pragma once

#include "scree/simulation.hpp"

#include <string>

namespace scree::app {

/// What a run did, as JSON for summary.json.
/// @param wall_seconds since the run began here  @param steps_here since then  @param outcome "finished", ...
template <int D, int V>
[[nodiscard]] std::string summary_json(const Simulation<D, V>& simulation, double wall_seconds,
                                       std::int64_t steps_here, const std::string& outcome);

/// Largest relative change of the mass of a size class since the run began; of all classes together where
/// grains are crushed from one to the next; 0 without grains.
template <int D, int V>
[[nodiscard]] double class_mass_drift(const Simulation<D, V>& simulation);

}  // namespace scree::app
