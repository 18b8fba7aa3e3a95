#pragma once

#include <scree/blocks.hpp>
#include <scree/lattice.hpp>
#include <scree/mpm/block_size.hpp>

#include <vector>

namespace scree::mpm {

/// A run of consecutive points whose stencils, when they were sorted, began in one block of cells. A point
/// may since have gone up to `block_skin` cells beyond the block; then all are sorted anew.
template <int D>
struct ParticleBlock {
  Indices<D> first_cell{};  ///< lowest stencil base of the block
  Index begin = 0;          ///< first point
  Index end = 0;            ///< one past the last point
};

/// Calls body(block index) for every block of a list, colour after colour.
template <class Body>
void for_each_coloured(const std::vector<std::vector<Index>>& colours, Threads threads, Body&& body) {
  for (const auto& colour : colours) {
    for_each_block(static_cast<Index>(colour.size()), threads,
                   [&](Index i) { body(colour[static_cast<std::size_t>(i)]); });
  }
}

/// The occupied blocks, and their colours: blocks of one colour touch no common node, so threads may take
/// them at the same time; colours are worked through in order, so sums have the same bits for any number of
/// threads.
template <int D>
struct ParticleBlocks {
  std::vector<ParticleBlock<D>> blocks;
  std::vector<std::vector<Index>> colours;

  /// Calls body(block index) for every block, colour after colour.
  template <class Body>
  void for_each_coloured(Threads threads, Body&& body) const {
    mpm::for_each_coloured(colours, threads, body);
  }

  /// Calls body(block index) for every block, in any order.
  template <class Body>
  void for_each(Threads threads, Body&& body) const {
    for_each_block(static_cast<Index>(blocks.size()), threads, body);
  }
};

}  // namespace scree::mpm
