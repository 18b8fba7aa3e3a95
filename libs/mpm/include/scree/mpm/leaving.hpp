#pragma once

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>

#include <array>

namespace scree::mpm {

/// What happens to a point that leaves the mesh through an end without a wall, or is thrown through one.
enum class Leaving {
  stop,    ///< the run ends, with an error that names the point
  absorb,  ///< it is removed, and counted
  reflect  ///< it is thrown back: its place mirrored in the end of the mesh, its velocity across it turned
           ///< round
};

/// What has left a mesh.
template <int V>
struct Left {
  Index count = 0;                   ///< points
  double mass = 0;                   ///< [kg]
  std::array<double, V> momentum{};  ///< [kg m/s]

  Left& operator+=(const Left& other) noexcept {
    count += other.count;
    mass += other.mass;
    for (std::size_t i = 0; i < V; ++i) momentum[i] += other.momentum[i];
    return *this;
  }
};

/// Removes the points outside the mesh; the others keep their order and all they carry. Sums run in the order
/// of the points, so they have the same bits for any number of threads. A point without a finite place stays.
template <int D, int V>
[[nodiscard]] Left<V> absorb_outside(Particles<D, V>& particles, const CartesianGrid<D>& grid);

/// Throws the points outside the mesh back. One that is further out than the mesh is long stays there.
template <int D, int V>
void reflect_outside(Particles<D, V>& particles, const CartesianGrid<D>& grid);

}  // namespace scree::mpm
