#pragma once

#include "scree/run/simulation.hpp"

#include <scree/io/column_writer.hpp>

namespace scree::app {

/// Writes the points as they are, with the fields that the scene asks for; points of mass zero are left out.
/// @throws RunError if it cannot be written; earlier frames stay.
template <int D, int V>
void write_frame(const Simulation<D, V>& simulation, io::FrameWriter& writer);

}  // namespace scree::app
