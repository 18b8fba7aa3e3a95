#pragma once

#include <scree/transport/cell_states.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/cell_slopes.hpp>
#include <scree/transport/detail/patch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace scree::transport::detail {

/// What passes through a face, and what it counts for in the limit of dt.
template <int N>
struct FaceRecord {
  std::array<double, static_cast<std::size_t>(N)> flux;  ///< along the normal
  double speed;                                          ///< largest wave speed [m/s]
};

/// Up to so many faces, worked on together: component k of face i at [k][i].
constexpr Index num_tile_faces = 64;
template <int D, int N>
struct FaceTile {
  using Row = std::array<double, static_cast<std::size_t>(num_tile_faces)>;

  alignas(64) std::array<Row, static_cast<std::size_t>(N)> left;   ///< states on the owners' side
  alignas(64) std::array<Row, static_cast<std::size_t>(N)> right;  ///< on the neighbours'
  alignas(64) std::array<Row, static_cast<std::size_t>(D)> normal;
  alignas(64) std::array<Row, static_cast<std::size_t>(N)> flux;
  alignas(64) Row speed;
};

/// Copies in what there is at faces first .. first + count - 1. The rest of the last pack is the last face
/// once more: a law sees no states but those of faces.
/// @param sides what FaceSides points into
template <int D, int N>
void fill(FaceTile<D, N>& tile, const Patch<D>& patch, const CellStates<N>& sides, Index first,
          Index count) noexcept {
  for (Index i = 0; i < in_whole_packs(count); ++i) {
    const Index number = first + std::min(i, count - 1);
    const FaceSides& face = patch.faces.data()[number];
    const Vector<D>& normal = patch.normals.data()[number];
    const Vector<N> left = values_of<N>(sides, face.left);
    const Vector<N> right = values_of<N>(sides, face.right);
    for_each_component<N>([&](std::size_t k) {
      tile.left[k].data()[i] = left[static_cast<int>(k)];
      tile.right[k].data()[i] = right[static_cast<int>(k)];
    });
    for_each_component<D>([&](std::size_t d) { tile.normal[d].data()[i] = normal[static_cast<int>(d)]; });
  }
}

/// Fluxes through the first `count` faces of a tile, whole packs, on whole vectors where the law allows.
/// Eq. (T3)
template <class Law, class Flux, int D, int N>
[[gnu::noinline, gnu::flatten]] void flux_through(const Law& law, const Flux& numerical_flux, Index count,
                                                  FaceTile<D, N>& tile) noexcept {
  using State = std::array<double, static_cast<std::size_t>(N)>;
  const double* lefts = tile.left[0].data();
  const double* rights = tile.right[0].data();
  const double* normals = tile.normal[0].data();
  double* fluxes = tile.flux[0].data();
  double* speeds = tile.speed.data();
#pragma GCC ivdep
  for (Index i = 0; i < count; ++i) {
    const auto entry = [i](std::size_t k) { return static_cast<Index>(k) * num_tile_faces + i; };
    State left;
    State right;
    for_each_component<N>([&](std::size_t k) {
      left[k] = lefts[entry(k)];
      right[k] = rights[entry(k)];
    });
    Vector<D> normal;
    for_each_component<D>([&](std::size_t d) { normal[static_cast<int>(d)] = normals[entry(d)]; });
    const FaceFlux<State> face = numerical_flux(law, left, right, normal);
    for_each_component<N>([&](std::size_t k) { fluxes[entry(k)] = face.value[k]; });
    speeds[i] = face.speed;
  }
}

/// Copies the fluxes of the first `count` faces of a tile out.
template <int D, int N>
void copy_fluxes(const FaceTile<D, N>& tile, Index count, FaceRecord<N>* records) noexcept {
  for (Index i = 0; i < count; ++i) {
    for_each_component<N>([&](std::size_t k) { records[i].flux[k] = tile.flux[k].data()[i]; });
    records[i].speed = tile.speed.data()[i];
  }
}

}  // namespace scree::transport::detail
