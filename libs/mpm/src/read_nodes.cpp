#include "kernels/transfer_kernels.hpp"

#include <scree/mpm/read_nodes.hpp>

#include <array>
#include <cstddef>

namespace scree::mpm {

namespace {

/// The nodes along each axis that a block's points can give to, as the parts that they have in the number of
/// a node; negative where there is none.
template <int D>
using Tile = std::array<std::array<Index, max_tile_edge<D>>, static_cast<std::size_t>(D)>;

template <int D>
[[nodiscard]] Tile<D> tile_of(const Nodes<D>& nodes, const ParticleBlock<D>& block, Index edge) noexcept {
  Tile<D> tile{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    tile[axis].fill(-1);
    for (Index i = 0; i < edge; ++i) {
      const Index place = nodes.place(block.first_cell[axis] - block_skin<D> + i, axis);
      if (place >= 0) tile[axis][static_cast<std::size_t>(i)] = place * nodes.stride(axis);
    }
  }
  return tile;
}

/// Whether a node of a tile is marked, of those that have the part `node` of the axes beyond `axis`.
template <int D>
[[nodiscard]] bool has_marked(const Tile<D>& tile, std::span<const std::uint8_t> marks, std::size_t axis,
                              Index node) noexcept {
  for (const Index part : tile[axis]) {
    if (part < 0) continue;
    if (axis == 0 ? marks[static_cast<std::size_t>(node + part)] != 0
                  : has_marked<D>(tile, marks, axis - 1, node + part)) {
      return true;
    }
  }
  return false;
}

}  // namespace

template <int D>
void ReadNodes<D>::find(Boundaries boundaries, const Nodes<D>& nodes, const ParticleBlocks<D>& blocks,
                        Index tile_edge) {
  is_read_.assign(static_cast<std::size_t>(nodes.num_nodes()), 0);
  for (const auto& boundary : boundaries) {
    if (boundary->num_means() > 0) boundary->mark_read(nodes, is_read_);
  }
  nodes_.clear();
  nodes_.reserve(is_read_.size());
  for (Index batch = 0; batch < nodes.num_batches(); ++batch) {
    for (const NodeRun& run : nodes.batch(batch)) {
      for (Index node = run.begin; node < run.end; ++node) {
        if (is_read_[static_cast<std::size_t>(node)] != 0) nodes_.push_back(node);
      }
    }
  }
  colours_.resize(blocks.colours.size());
  for (std::size_t colour = 0; colour < colours_.size(); ++colour) {
    colours_[colour].clear();
    colours_[colour].reserve(blocks.colours[colour].size());
    for (const Index b : blocks.colours[colour]) {
      const auto tile = tile_of(nodes, blocks.blocks[static_cast<std::size_t>(b)], tile_edge);
      if (has_marked<D>(tile, is_read_, D - 1, 0)) colours_[colour].push_back(b);
    }
  }
}

template class ReadNodes<1>;
template class ReadNodes<2>;
template class ReadNodes<3>;

}  // namespace scree::mpm
