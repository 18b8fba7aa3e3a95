#pragma once

#include <scree/mpm/boundary.hpp>
#include <scree/mpm/nodes.hpp>
#include <scree/mpm/particle_blocks.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace scree::mpm {

/// Where boundaries read means of what points carry: those nodes, and the blocks of points that give to them.
/// Nothing else has to be visited.  @see Eq. (M170)
template <int D>
class ReadNodes {
 public:
  using Boundaries = std::span<const std::unique_ptr<Boundary<D>>>;

  /// Finds both. Memory is taken for all that can be read of these blocks, so that it will do until there are
  /// others.
  /// @param tile_edge nodes that a block's points can give to, along each axis
  void find(Boundaries boundaries, const Nodes<D>& nodes, const ParticleBlocks<D>& blocks, Index tile_edge);

  /// Nodes in use, ascending.
  [[nodiscard]] std::span<const Index> nodes() const noexcept { return nodes_; }
  /// Blocks by their colours, as in ParticleBlocks.
  [[nodiscard]] const std::vector<std::vector<Index>>& colours() const noexcept { return colours_; }

 private:
  std::vector<std::uint8_t> is_read_;  ///< one for each node
  std::vector<Index> nodes_;
  std::vector<std::vector<Index>> colours_;
};

}  // namespace scree::mpm
