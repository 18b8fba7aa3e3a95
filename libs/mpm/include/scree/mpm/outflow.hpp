#pragma once

#include <scree/mpm/leaving.hpp>
#include <scree/mpm/step.hpp>

#include <cstddef>
#include <optional>

namespace scree::mpm {

/// A box that takes away what enters it. An infinite corner makes it a half space.
template <int D>
struct Outflow {
  Vector<D> low = Vector<D>::Zero();   ///< lowest corner [m]
  Vector<D> high = Vector<D>::Zero();  ///< highest [m]
};

/// @throws InputError unless the box is at least a cell thick along each axis, so that no point passes
/// through it in a step, and lies in the mesh with a part of itself.
template <int D>
void check(const Outflow<D>& outflow, const CartesianGrid<D>& grid);

/// Between steps: takes the mass of every point in the box, which then only fills its block until points are
/// sorted. Sums run in the order of the points, so they have the same bits for any number of threads.
/// @param column as for count_point()  @returns what was taken.  @see Eq. (M161)
template <int D, int V>
[[nodiscard]] Passed<V> take_out(State<D, V>& state, const Outflow<D>& outflow,
                                 std::optional<std::size_t> column = {});

}  // namespace scree::mpm
