#include "bodies.hpp"
#include "schemes.hpp"

#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <type_traits>
#include <variant>
#include <vector>

namespace scree::mpm {
namespace {

/// All blocks of so many cells along each axis of a mesh, and their colours.
template <int D>
ParticleBlocks<D> all_blocks(const CartesianGrid<D>& grid) {
  constexpr Index edge = block_edge<D>;
  ParticleBlocks<D> blocks;
  Lattice<D> lattice;
  for (std::size_t axis = 0; axis < D; ++axis) {
    lattice.count[axis] = (grid.num_cells()[axis] + 1 + edge - 1) / edge;
  }
  for (Index b = 0; b < lattice.num_sites(); ++b) {
    Indices<D> first_cell = lattice.site(b);
    for (Index& cell : first_cell) cell = cell * edge - 1;
    blocks.blocks.push_back({first_cell, 0, 0});
  }
  colour_blocks(blocks, grid);
  return blocks;
}

/// The nodes that points of a block can give to: its skin to either side, and their stencils.
template <int D>
std::vector<Index> nodes_of(const ParticleBlock<D>& block, const CartesianGrid<D>& grid, Index support) {
  const Lattice<D> nodes = grid.nodes();
  Lattice<D> reached;
  reached.count.fill(2 * block_skin<D> + block_edge<D> + support - 1);
  std::set<Index> found;
  for (Index r = 0; r < reached.num_sites(); ++r) {
    Indices<D> node = reached.site(r);
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Index n = nodes.count[axis];
      node[axis] += block.first_cell[axis] - block_skin<D>;
      node[axis] =
          grid.is_periodic()[axis] ? (node[axis] % n + n) % n : std::clamp<Index>(node[axis], 0, n - 1);
    }
    found.insert(nodes.index(node));
  }
  return {found.begin(), found.end()};
}

/// Counts every node once for each block of a colour that can give to it.
template <int D>
void expect_blocks_of_a_colour_apart(const CartesianGrid<D>& grid, Index support) {
  const auto blocks = all_blocks(grid);
  for (const auto& colour : blocks.colours) {
    std::vector<int> users(static_cast<std::size_t>(grid.nodes().num_sites()), 0);
    for (const Index b : colour) {
      for (const Index node : nodes_of(blocks.blocks[static_cast<std::size_t>(b)], grid, support)) {
        ++users[static_cast<std::size_t>(node)];
      }
    }
    EXPECT_LE(std::ranges::max(users), 1)
        << grid.num_cells()[0] << " cells under " << support << " nodes, periodic: " << grid.is_periodic()[0];
  }
}

template <class Dimension>
class BlocksOfOneColour : public ::testing::Test {};
TYPED_TEST_SUITE(BlocksOfOneColour, Dimensions);

TYPED_TEST(BlocksOfOneColour, ShareNoNodeUnderAnyShape) {
  constexpr int D = TypeParam::value;
  for (const AnyShape& shape : every<AnyShape>()) {
    constexpr Index edge = block_edge<D>;
    const auto support =
        std::visit([](auto one) { return static_cast<Index>(decltype(one)::support); }, shape);
    for (Index cells = 1; cells <= 6 * edge + 1;
         cells += D == 1 ? 5 : 1) {  // 1, 2, .. 7 blocks, whole or not
      Indices<D> count;
      count.fill(edge);  // two blocks, the second with the last node alone
      count[0] = cells;
      for (const bool is_periodic : {false, true}) {
        std::array<bool, D> periodic;
        periodic.fill(is_periodic);
        expect_blocks_of_a_colour_apart<D>({Vector<D>::Zero(), Vector<D>::Ones(), count, periodic}, support);
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

TEST(ResumedBlocks, HaveTheirColoursAgain) {
  const CartesianGrid<3> grid{Vector<3>::Zero(), Vector<3>::Ones(), {24, 5, 5}, {false, false, false}};
  auto particles = seed_box<3, 3>(grid, Vector<3>{1, 1, 1}, Vector<3>{23, 4, 4}, {1, 1, 1}, 1000);
  const auto stages = stages_of<3, 3>(particles, Cubic{}, Apic{});
  const auto state = start(particles, grid, stages, {1});
  State<3, 3> resumed{state.particles, Nodes<3>{grid, stages.transfer->record()}};
  resumed.blocks.blocks = state.blocks.blocks;

  resume(resumed, stages);

  EXPECT_EQ(resumed.blocks.colours, state.blocks.colours);
}

}  // namespace
}  // namespace scree::mpm
