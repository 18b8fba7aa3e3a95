#pragma once

#include <scree/index.hpp>

#include <cstddef>

namespace scree::mpm {

/// Edge of a block of cells along each axis [cells]. The larger a block, the fewer of its nodes are its
/// neighbours' too, which each of them fetches and gives back; but nodes and points in work have to stay in
/// the first caches, and threads need blocks to share.
template <int D>
inline constexpr Index block_edge = D == 1   ? 32
                                    : D == 2 ? 16
                                             : 5;

/// How far points may go from their block before all are sorted anew [cells]. A tile may be as long as two
/// blocks, so that blocks of one colour share no node: under cubic splines in 3D there is no room for more.
/// In 2D two cells halve the sorts of one; the larger tile, of which only the part that points reach goes to
/// the nodes, costs less than could be measured.
template <int D>
inline constexpr Index block_skin = D == 2 ? 2 : 1;

/// Nodes along each axis that a block's points can reach, from `block_skin` before its first cell on.
template <int D>
[[nodiscard]] constexpr Index tile_edge_of(std::size_t support) noexcept {
  return block_edge<D> + 2 * block_skin<D> + static_cast<Index>(support) - 1;
}

/// The widest stencil of momentum, of cubic splines [nodes].
inline constexpr std::size_t max_support = 4;

}  // namespace scree::mpm
