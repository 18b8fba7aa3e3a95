#pragma once

#include "scree/run/simulation.hpp"

#include <filesystem>
#include <string>

namespace scree::app {

/// Writes everything that a run needs to go on, every bit of it: points in their order, blocks, rates, clock
/// and tally. Changes nothing in the run.  @throws RunError if it cannot be written; the older file stays.
template <int D, int V>
void write_checkpoint(const Simulation<D, V>& simulation, const std::filesystem::path& path,
                      const std::string& scene_text);

/// Puts a simulation where the checkpoint left off. Its scene may differ from that of the checkpoint in all
/// but traits_of_run(), and in how many [[outflow]] there are.
/// @throws InputError if the file is no checkpoint, is cut off, or is of another run; then naming all that
/// differs, as it is there and in the scene.
template <int D, int V>
void read_checkpoint_into(Simulation<D, V>& simulation, const std::filesystem::path& path);

}  // namespace scree::app
