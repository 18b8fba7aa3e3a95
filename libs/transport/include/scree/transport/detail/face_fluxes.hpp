#pragma once

#include <scree/transport/cell_states.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/cell_slopes.hpp>
#include <scree/transport/detail/face_tables.hpp>

#include <array>

namespace scree::transport::detail {

/// What passes through a face, and what it counts for in the limit of dt.
template <int N>
struct FaceRecord {
  std::array<double, static_cast<std::size_t>(N)> flux;  ///< along the normal
  double speed;                                          ///< largest wave speed [m/s]
};

/// Up to so many faces, worked on together: component k of face i at [k][i].
constexpr Index num_tile_faces = 64;
template <int N>
struct FaceTile {
  using Row = std::array<double, static_cast<std::size_t>(num_tile_faces)>;

  alignas(64) std::array<Row, static_cast<std::size_t>(N)> left;   ///< states on the owners' side
  alignas(64) std::array<Row, static_cast<std::size_t>(N)> right;  ///< on the neighbours'
  alignas(64) std::array<Row, static_cast<std::size_t>(N)> flux;
  alignas(64) Row speed;
};

/// Fluxes through faces first .. first + count - 1 from the states in the tile, on whole vectors where the
/// law allows.  Eq. (T3)
template <class Law, class Flux, int D, int N>
[[gnu::noinline, gnu::flatten]] void flux_through(const FaceTables<D>& tables, const Law& law,
                                                  const Flux& numerical_flux, Index first, Index count,
                                                  FaceTile<N>& tile) noexcept {
  using State = std::array<double, static_cast<std::size_t>(N)>;
  const double* normals = tables.normals.data() + first;
  const Index num_faces = tables.num_faces;
  const double* lefts = tile.left[0].data();
  const double* rights = tile.right[0].data();
  double* fluxes = tile.flux[0].data();
  double* speeds = tile.speed.data();
#pragma GCC ivdep
  for (Index i = 0; i < count; ++i) {
    State left;
    State right;
    for_each_component<N>([&](std::size_t k) {
      left[k] = lefts[static_cast<Index>(k) * num_tile_faces + i];
      right[k] = rights[static_cast<Index>(k) * num_tile_faces + i];
    });
    Vector<D> normal;
    for_each_component<D>(
        [&](std::size_t d) { normal[static_cast<int>(d)] = normals[static_cast<Index>(d) * num_faces + i]; });
    const FaceFlux<State> face = numerical_flux(law, left, right, normal);
    for_each_component<N>(
        [&](std::size_t k) { fluxes[static_cast<Index>(k) * num_tile_faces + i] = face.value[k]; });
    speeds[i] = face.speed;
  }
}

}  // namespace scree::transport::detail
