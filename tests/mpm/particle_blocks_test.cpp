#include "bodies.hpp"
#include "schemes.hpp"

#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <vector>

namespace scree::mpm {
namespace {

/// All blocks of a mesh of n x m cells, and their colours.
ParticleBlocks<2> all_blocks(const CartesianGrid<2>& grid) {
  ParticleBlocks<2> blocks;
  Indices<2> count{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    count[axis] = (grid.num_cells()[axis] + 1 + block_edge<2> - 1) / block_edge<2>;
  }
  for (Index j = 0; j < count[1]; ++j) {
    for (Index i = 0; i < count[0]; ++i) {
      blocks.blocks.push_back({{i * block_edge<2> - 1, j * block_edge<2> - 1}, 0, 0});
    }
  }
  colour_blocks(blocks, grid);
  return blocks;
}

/// The nodes that points of a block can give to: one cell beyond it to either side, and their stencils.
std::set<Index> nodes_of(const ParticleBlock<2>& block, const CartesianGrid<2>& grid, Index support) {
  const Lattice<2> lattice = grid.nodes();
  std::set<Index> nodes;
  const auto wrap = [&](Index node, std::size_t axis) {
    const Index n = lattice.count[axis];
    return grid.is_periodic()[axis] ? (node % n + n) % n : std::clamp<Index>(node, 0, n - 1);
  };
  const Index reach = block_edge<2> + support;
  for (Index j = -1; j < reach; ++j) {
    for (Index i = -1; i < reach; ++i) {
      nodes.insert(lattice.index({wrap(block.first_cell[0] + i, 0), wrap(block.first_cell[1] + j, 1)}));
    }
  }
  return nodes;
}

Index widest_support() {
  std::size_t widest = 0;
  for (const AnyShape& shape : every<AnyShape>()) {
    std::visit([&](auto one) { widest = std::max(widest, decltype(one)::support); }, shape);
  }
  return static_cast<Index>(widest);
}

TEST(ParticleBlocks, OfOneColourShareNoNode) {
  for (const Index cells : {1, 2, 7, 8, 15, 16, 20, 23, 24, 31, 39, 40, 55}) {  // 1, 2, 3, .. 7 blocks
    for (const bool is_periodic : {false, true}) {
      const CartesianGrid<2> grid{
          Vector<2>::Zero(), Vector<2>::Ones(), {cells, 20}, {is_periodic, is_periodic}};
      const auto blocks = all_blocks(grid);
      for (const auto& colour : blocks.colours) {
        std::set<Index> taken;
        for (const Index b : colour) {
          for (const Index node :
               nodes_of(blocks.blocks[static_cast<std::size_t>(b)], grid, widest_support())) {
            EXPECT_TRUE(taken.insert(node).second) << cells << " cells, block " << b << ", node " << node;
          }
        }
      }
    }
  }
}

TEST(ParticleBlocks, HaveOneColourEach) {
  const CartesianGrid<2> grid{Vector<2>::Zero(), Vector<2>::Ones(), {40, 23}, {true, false}};
  const auto blocks = all_blocks(grid);

  std::vector<int> visits(blocks.blocks.size(), 0);
  for (const auto& colour : blocks.colours) {
    EXPECT_FALSE(colour.empty());
    for (const Index b : colour) ++visits[static_cast<std::size_t>(b)];
  }

  for (const int count : visits) EXPECT_EQ(count, 1);
}

TEST(ParticleBlocks, AreEachVisitedOnce) {
  const CartesianGrid<2> grid{Vector<2>::Zero(), Vector<2>::Ones(), {40, 23}, {true, false}};
  const auto blocks = all_blocks(grid);
  for (const int threads : {1, 2, 3}) {
    std::vector<std::atomic<int>> visits(blocks.blocks.size());
    auto count = [&](Index b) { ++visits[static_cast<std::size_t>(b)]; };

    blocks.for_each({threads}, count);
    blocks.for_each_coloured({threads}, count);

    for (const auto& visited : visits) EXPECT_EQ(visited, 2);
  }
}

/// Cubic shapes have larger blocks in 3D than others: a run that goes on must colour them as such.
TEST(ResumedBlocks, AreThoseOfTheShapeAgain) {
  const CartesianGrid<3> grid{Vector<3>::Zero(), Vector<3>::Ones(), {24, 5, 5}, {false, false, false}};
  auto particles = seed_box<3, 3>(grid, Vector<3>{1, 1, 1}, Vector<3>{23, 4, 4}, {1, 1, 1}, 1000);
  const auto stages = stages_of<3, 3>(particles, Cubic{}, Apic{});
  const auto state = start(particles, grid, stages, {1});
  State<3, 3> resumed{state.particles, Nodes<3>{grid, stages.transfer->record()}};
  resumed.blocks.blocks = state.blocks.blocks;

  resume(resumed, stages);

  EXPECT_EQ(resumed.blocks.edge, 5);
  EXPECT_EQ(resumed.blocks.colours, state.blocks.colours);
}

}  // namespace
}  // namespace scree::mpm
