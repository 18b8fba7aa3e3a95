#pragma once

#include "transfer_kernels.hpp"

#include <scree/lattice.hpp>

/// What the library hands to its kernels of carried fields: bare arrays and numbers, nothing that has code of
/// its own.
namespace scree::mpm {

/// The sites that a block's points can reach, as TileShape has nodes: mesh cells, of which each point has
/// one, as far as points go.
template <int D, std::size_t S>
struct SiteTile {
  static constexpr Index edge = S == 1 ? tile_edge_of<D>(2) : TileShape<D, S>::edge;
  static constexpr Index num_sites = D == 1 ? edge : D == 2 ? edge * edge : edge * edge * edge;
};

/// The points of a block and where their sites are.
template <int D>
struct CarriedBlock {
  const double* position = nullptr;  ///< components are `stride` apart
  const double* mass = nullptr;
  Index stride = 0;
  Index begin = 0;
  Index end = 0;
  Components<double, D> origin{};           ///< [m]
  Components<double, D> inverse_spacing{};  ///< [1/m]
  Components<double, D> first{};            ///< lowest site of the tile
  /// The number of site (i, j, k) of the tile is site[0][i] + site[1][j] + ..; an axis has no site where its
  /// part is negative. Images past walls have the number of what they are images of.
  Components<std::array<Index, max_tile_edge<D>>, D> site{};
};

/// Up to four sums that points add to on their sites: of mass, or of mass times a field.
struct FourSums {
  std::array<const double*, 4> field{};  ///< one per point; null: the mass itself
  std::array<double*, 4> sum{};          ///< of site 0
  std::array<Index, 4> step{};           ///< from site to site
  int count = 0;
};

/// As many of them as a kernel adds to at once: so many that few points need two passes, so few that their
/// tiles stay near.
struct SiteSums {
  static constexpr Index most = 3;
  FourSums fours[most];
  Index num_fours = 0;
};

/// What a point reads of its sites and changes by it.  Eqs. (M22), (M23)
struct PointChange {
  const double* records = nullptr;  ///< of each site: loss ratios of all classes, then gain shares
  double* fractions = nullptr;      ///< point fastest, classes `stride` apart
  Index stride = 0;
  int num_classes = 0;
  bool is_exchange = true;  ///< else the gain shares are increments
};

template <int D>
struct CarriedKernels {
  void (*to_sites)(const AnyShape&, const CarriedBlock<D>&, const SiteSums&) noexcept;
  void (*to_points)(const AnyShape&, const CarriedBlock<D>&, const PointChange&) noexcept;
};

// clang-format off
/// The kernels of each instruction set.  @param shape place in the list AnyShape; cells need none
namespace baseline {
template <int D>
[[nodiscard]] CarriedKernels<D> carried_kernels(Sites sites, std::size_t shape) noexcept;
}
namespace x86_64_v3 {
template <int D>
[[nodiscard]] CarriedKernels<D> carried_kernels(Sites sites, std::size_t shape) noexcept;
}
namespace x86_64_v4 {
template <int D>
[[nodiscard]] CarriedKernels<D> carried_kernels(Sites sites, std::size_t shape) noexcept;
}
// clang-format on

}  // namespace scree::mpm
