#pragma once

#include "scree/simulation.hpp"

#include <filesystem>
#include <string>

namespace scree::app {

/// Writes everything that a run needs to go on, every bit of it: points in their order, blocks, rates, clock
/// and tally. Changes nothing in the run.  @throws RunError if it cannot be written; the older file stays.
template <int D, int V>
void write_checkpoint(const Simulation<D, V>& simulation, const std::filesystem::path& path,
                      const std::string& scene_text);

/// Puts a simulation of the same scene where the checkpoint left off.
/// @throws InputError if the file is no checkpoint, is cut off, or is of a run with other parts.
template <int D, int V>
void read_checkpoint_into(Simulation<D, V>& simulation, const std::filesystem::path& path);

}  // namespace scree::app
