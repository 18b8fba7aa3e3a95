#pragma once

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace scree::mpm {

/// What happens to a point that leaves the mesh through an end without a wall, or is thrown through one.
enum class Leaving {
  stop,    ///< the run ends, with an error that names the point
  absorb,  ///< it is removed, and counted
  reflect  ///< it is thrown back: its place mirrored in the end of the mesh, its velocity across it turned
           ///< round
};

/// What has passed out of a mesh, or into it.
template <int V>
struct Passed {
  Index count = 0;                   ///< points
  double mass = 0;                   ///< [kg]
  std::array<double, V> momentum{};  ///< [kg m/s]
  std::vector<double> carried;       ///< mass times each component of a column [kg times its unit]; or none

  Passed& operator+=(const Passed& other) {
    count += other.count;
    mass += other.mass;
    for (std::size_t i = 0; i < V; ++i) momentum[i] += other.momentum[i];
    carried.resize(std::max(carried.size(), other.carried.size()));
    for (std::size_t k = 0; k < other.carried.size(); ++k) carried[k] += other.carried[k];
    return *this;
  }
};

/// Adds a point of `particles` to what has passed.
/// @param column whose sums are kept too, by its index; none: no sums
template <int D, int V>
void count_point(const Particles<D, V>& particles, Index p, std::optional<std::size_t> column,
                 Passed<V>& passed) {
  const double mass = particles.mass.component(0)[p];
  ++passed.count;
  passed.mass += mass;
  for (int i = 0; i < V; ++i) {
    passed.momentum[static_cast<std::size_t>(i)] += mass * particles.velocity.component(i)[p];
  }
  if (!column) return;
  const Column& carried = particles.column(*column);
  passed.carried.resize(static_cast<std::size_t>(carried.num_components()));
  for (int k = 0; k < carried.num_components(); ++k) {
    passed.carried[static_cast<std::size_t>(k)] += mass * carried.component(k)[p];
  }
}

/// Removes the points outside the mesh; the others keep their order and all they carry. Sums run in the order
/// of the points, so they have the same bits for any number of threads. A point without a finite place stays.
/// @param balanced column of which sums are kept, as for count_point()
template <int D, int V>
[[nodiscard]] Passed<V> absorb_outside(Particles<D, V>& particles, const CartesianGrid<D>& grid,
                                       std::optional<std::size_t> balanced = {});

/// Throws the points outside the mesh back. One that is further out than the mesh is long stays there.
template <int D, int V>
void reflect_outside(Particles<D, V>& particles, const CartesianGrid<D>& grid);

}  // namespace scree::mpm
