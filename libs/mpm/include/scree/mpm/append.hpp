#pragma once

#include <scree/mpm/particles.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace scree::mpm {

/// Checks that points carry what those of a run do.
/// @throws InputError if `more` has other columns, or the same in another order.
template <int D, int V>
void require_columns(const Particles<D, V>& particles, const Particles<D, V>& more) {
  std::vector<const Column*> columns;
  particles.for_each_column([&](const Column& column) { columns.push_back(&column); });
  std::vector<const Column*> added;
  more.for_each_column([&](const Column& column) { added.push_back(&column); });
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Quantity& wanted = columns[i]->quantity();
    require(i < added.size() && added[i]->quantity() == wanted &&
                added[i]->num_components() == columns[i]->num_components(),
            "the points that are added lack the column '" + wanted.name + "' in its place");
  }
  require(added.size() == columns.size(), "the points that are added have a column too many");
}

/// Adds points after those that are there, with all that they carry. Points of a run belong in blocks: see
/// take_in() for those that come in while it runs.
/// @throws InputError as require_columns() does.
template <int D, int V>
void append(Particles<D, V>& particles, const Particles<D, V>& more) {
  require_columns(particles, more);
  std::vector<const Column*> added;
  more.for_each_column([&](const Column& column) { added.push_back(&column); });
  std::size_t i = 0;
  particles.for_each_column([&](Column& column) { column.append(*added[i++]); });
}

}  // namespace scree::mpm
