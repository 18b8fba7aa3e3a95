#pragma once

#include <scree/index.hpp>

#include <cstddef>

namespace scree::mpm {

/// Edge of a block of cells along each axis [cells], for stencils of so many nodes: its nodes, with their
/// halo, stay in the first cache. Must exceed the stencil, so that blocks of one colour share no node.
template <int D, std::size_t support = 3>
inline constexpr Index block_edge = D == 1         ? 32
                                    : D == 2       ? 8
                                    : support <= 3 ? 4
                                                   : 5;

/// The widest stencil of momentum, of cubic splines [nodes].
inline constexpr std::size_t max_support = 4;

}  // namespace scree::mpm
