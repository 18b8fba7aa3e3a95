#pragma once

#include <scree/tensor.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace scree::transport::detail {

/// Sites of a row that are worked on together: their states stay in the first cache level, and the
/// compiler knows the distance between components.
constexpr Index tile_width = 64;

/// Values at up to tile_width sites or faces, and one to each side: component k of entry i at [k][i + 1].
template <int N>
struct Tile {
  static constexpr Index stride = tile_width + 8;  // whole vectors
  alignas(64) std::array<std::array<double, stride>, static_cast<std::size_t>(N)> values;

  [[nodiscard]] double* row(int k) noexcept { return values[static_cast<std::size_t>(k)].data() + 1; }
  [[nodiscard]] const double* row(int k) const noexcept {
    return values[static_cast<std::size_t>(k)].data() + 1;
  }
};

/// Fluxes through the faces of a tile, N components times the face's density, then:
template <int N>
struct FluxTile : Tile<N + 3> {
  static constexpr int speed = N;          ///< largest wave speed, 0 where the face is closed [m/s]
  static constexpr int drain = N + 1;      ///< density x speed
  static constexpr int diffusion = N + 2;  ///< density x diffusivity / distance
};

/// A running maximum of magnitudes that a NaN does not slip through: the bit patterns of doubles that are
/// not negative are ordered as the doubles are, infinity and NaN on top.
class Maximum {
 public:
  void add(const double* values, Index count) noexcept {
    std::int64_t largest = bits_;
    for (Index i = 0; i < count; ++i) {
      largest = std::max(largest, std::bit_cast<std::int64_t>(values[i]) & magnitude);
    }
    bits_ = largest;
  }
  void add(const Maximum& other) noexcept { bits_ = std::max(bits_, other.bits_); }
  [[nodiscard]] double value() const noexcept { return std::bit_cast<double>(bits_); }

 private:
  static constexpr std::int64_t magnitude = 0x7fff'ffff'ffff'ffff;
  std::int64_t bits_ = 0;
};

}  // namespace scree::transport::detail
