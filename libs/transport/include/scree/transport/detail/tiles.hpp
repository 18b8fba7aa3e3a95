#pragma once

#include <scree/tensor.hpp>
#include <scree/transport/components.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace scree::transport::detail {

/// Sites of a row that are worked on together: their states stay in the first cache level, and the
/// compiler knows the distance between components.
constexpr Index tile_width = 64;

/// Sites in a whole number of vectors, whatever the instruction set.
constexpr Index pack_width = 8;

/// Calls work(begin, count) once or twice so that 0 .. total-1 is covered by whole packs, the last of which
/// may overlap: nothing remains for a loop of single sites but rows shorter than a pack. Work done twice
/// must give the same.
template <class Work>
void in_packs(Index total, Work&& work) noexcept {
  const Index whole = total < pack_width ? total : total / pack_width * pack_width;
  if (whole > 0) work(Index{0}, whole);
  if (whole < total) work(total - pack_width, pack_width);
}

/// One value for each site or face of a tile, and room for one to each side that leaves the rest in place:
/// vectors that start with the tile never straddle two lines of the cache.
using Lanes = std::array<double, tile_width + 2 * pack_width>;

/// Values at up to tile_width sites or faces, and one to each side: component k of entry i at
/// [k][i + pack_width].
template <int N>
struct Tile {
  static constexpr Index stride = tile_width + 2 * pack_width;
  alignas(64) std::array<Lanes, static_cast<std::size_t>(N)> values;

  [[nodiscard]] double* row(int k) noexcept {
    return values[static_cast<std::size_t>(k)].data() + pack_width;
  }
  [[nodiscard]] const double* row(int k) const noexcept {
    return values[static_cast<std::size_t>(k)].data() + pack_width;
  }
};

/// Fluxes through the faces of a tile, N components times the face's density, then what they drain from
/// their cells; a row for diffusion where the law has it.
template <int N, bool IsDiffusive>
struct FluxTile : Tile<N + (IsDiffusive ? 2 : 1)> {
  static constexpr int num_rows = N + (IsDiffusive ? 2 : 1);
  static constexpr bool has_diffusion = IsDiffusive;
  static constexpr int drain = N;          ///< density x largest wave speed, 0 where the face is closed
  static constexpr int diffusion = N + 1;  ///< density x diffusivity / distance
};

/// What the closed parts of both faces of each site along an axis add: N components of the flux out through
/// both, times the density behind the wall, and the drains of each.  Eq. (T65)
template <int N>
struct WallTile : Tile<N + 2> {
  static constexpr int drain_low = N;
  static constexpr int drain_high = N + 1;
};

/// The largest of all numbers that were put into its lanes; NaN if one was not finite.
class Largest {
 public:
  [[nodiscard]] double* lanes() noexcept { return lanes_.data(); }
  [[nodiscard]] double value() const noexcept {
    double result = 0;
    for (const double lane : lanes_) result = larger(result, lane);
    return result;
  }

 private:
  alignas(64) Lanes lanes_{};
};

}  // namespace scree::transport::detail
