#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/input_column.hpp>
#include <scree/mpm/particles.hpp>

#include <cstddef>
#include <string_view>

namespace scree::mpm {

/// Index among the particles' own columns of the one that a law reads.
/// @throws InputError naming the law, and the column, if it is absent or in another unit.
template <int D, int V>
[[nodiscard]] std::size_t input_column(const Particles<D, V>& particles, const InputColumn& input,
                                       std::string_view law);

/// Gives the particles the column of a law's memory, or finds it, and begins it at its initial value.
/// @returns its index among the particles' own columns
template <int D, int V>
[[nodiscard]] std::size_t state_column(Particles<D, V>& particles, const StateColumn& state);

/// Checks what a law is to read of the points that have mass: when a run is assembled, and when what it reads
/// has changed.
/// @param column index of the column among the particles' own
/// @throws InputError naming law, column, value and range, and the first point whose value is out of it.
template <int D, int V>
void require_in_range(const Particles<D, V>& particles, std::size_t column, const InputColumn& input,
                      std::string_view law);

}  // namespace scree::mpm
