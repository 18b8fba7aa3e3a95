#pragma once

#include "scree/run/simulation.hpp"

#include <string>

namespace scree::app {

/// What a run did, as JSON for summary.json. Looks for what bounds its steps.
/// @param wall_seconds since the run began here  @param outcome "finished", ...
template <int D, int V>
[[nodiscard]] std::string summary_json(Simulation<D, V>& simulation, double wall_seconds,
                                       const std::string& outcome);

/// What is missing of the mass that began or has entered, once what has left is counted, relative to it.
template <int D, int V>
[[nodiscard]] double mass_drift(const Simulation<D, V>& simulation);

/// The same of a size class, the largest; of all classes together where grains are crushed from one to the
/// next; 0 without grains.
template <int D, int V>
[[nodiscard]] double class_mass_drift(const Simulation<D, V>& simulation);

}  // namespace scree::app
