#pragma once

#include <scree/input_column.hpp>
#include <scree/mpm/particles.hpp>

#include <string_view>

namespace scree::mpm {

/// Checks what a law is to read of the points that have mass: when a run is assembled, and when what it reads
/// has changed.
/// @param column index of the column among the particles' own
/// @throws InputError naming law, column, value and range, and the first point whose value is out of it.
template <int D, int V>
void require_in_range(const Particles<D, V>& particles, std::size_t column, const InputColumn& input,
                      std::string_view law);

}  // namespace scree::mpm
