#pragma once

#include <scree/mpm/block_motion.hpp>
#include <scree/mpm/block_size.hpp>
#include <scree/mpm/node_record.hpp>
#include <scree/mpm/point_transfer.hpp>
#include <scree/mpm/shapes.hpp>
#include <scree/mpm/transfers.hpp>
#include <scree/pack_size.hpp>

/// What the library hands to its kernels: bare arrays and numbers, nothing that has code of its own.
namespace scree::mpm {

/// The nodes that a block's points can reach while they stay within its skin.
template <int D, std::size_t S>
struct TileShape {
  static_assert(S <= max_support);
  static constexpr Index edge = tile_edge_of<D>(S);
  static_assert(edge <= 2 * block_edge<D>, "blocks of one colour would share nodes");
  static constexpr Index num_nodes = D == 1 ? edge : D == 2 ? edge * edge : edge * edge * edge;
};

/// Where a block's points may be without leaving its tile or the mesh, and how to find their nodes.
template <int D>
struct BlockPlace {
  Components<double, D> origin{};           ///< [m]
  Components<double, D> inverse_spacing{};  ///< [1/m]
  Components<double, D> low{};              ///< of the mesh [m]
  Components<double, D> high{};             ///< of the mesh [m]
  Components<double, D> first_base{};       ///< of stencils in the tile, in spacings
  Components<double, D> beyond_base{};      ///< the first one that is not
};

/// Edge of the largest tile.
template <int D>
inline constexpr std::size_t max_tile_edge = tile_edge_of<D>(max_support);

/// The nodes of a tile in the mesh: where the record of node (i, j, k) begins, offset[0][i] + offset[1][j] +
/// ..; an axis has no node where its offset is negative.
template <int D, class Value>
struct TileNodes {
  Value* values = nullptr;
  Components<std::array<Index, max_tile_edge<D>>, D> offset;
};

/// The columns of a block's points, bare: components are `stride` apart.
/// @tparam Value double, or const double of points that do not change
template <int D, int V, class Value>
struct PointColumns {
  Value* position = nullptr;
  Value* velocity = nullptr;
  Value* velocity_gradient = nullptr;
  const double* stress = nullptr;
  const double* mass = nullptr;
  Value* density = nullptr;
  Index stride = 0;
  Index begin = 0;
  Index end = 0;
};

/// The loops over a block's points, for one shape and one rule, compiled for one instruction set.
template <int D, int V>
struct TransferKernels {
  void (*scatter)(const AnyShape&, const PointColumns<D, V, const double>&, const BlockPlace<D>&,
                  const TileNodes<D, double>&, double dt) noexcept;
  BlockMotion (*gather)(const AnyShape&, const AnyTransfer&, const PointColumns<D, V, double>&,
                        const BlockPlace<D>&, const TileNodes<D, const double>&, double dt) noexcept;
};

// clang-format off
/// The kernels of each instruction set.  @param shape,rule places in the lists AnyShape and AnyTransfer
namespace baseline {
template <int D, int V>
[[nodiscard]] TransferKernels<D, V> transfer_kernels(std::size_t shape, std::size_t rule) noexcept;
}
namespace x86_64_v3 {
template <int D, int V>
[[nodiscard]] TransferKernels<D, V> transfer_kernels(std::size_t shape, std::size_t rule) noexcept;
}
namespace x86_64_v4 {
template <int D, int V>
[[nodiscard]] TransferKernels<D, V> transfer_kernels(std::size_t shape, std::size_t rule) noexcept;
}
// clang-format on

}  // namespace scree::mpm
