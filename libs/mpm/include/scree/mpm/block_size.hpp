#pragma once

#include <scree/index.hpp>

namespace scree::mpm {

/// Edge of a block of cells along each axis [cells]: its nodes, with their halo, stay in the first cache.
/// Must exceed the widest stencil (3 nodes), so that blocks of one colour share no node.
template <int D>
inline constexpr Index block_edge = D == 1   ? 32
                                    : D == 2 ? 8
                                             : 4;

/// Points of one block fill whole packs of this many.
inline constexpr Index pack_size = 8;

}  // namespace scree::mpm
