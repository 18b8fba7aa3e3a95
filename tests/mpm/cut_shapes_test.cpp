// What points beside a wall with friction, which cuts shape functions off, give to nodes and take from them.

#include "bodies.hpp"
#include "dry_wall.hpp"
#include "schemes.hpp"

#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/terrain/bed_nodes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace scree::mpm {
namespace {

template <int D>
using Walls = std::vector<std::unique_ptr<Boundary<D>>>;

/// Walls with friction all round.
template <int D>
[[nodiscard]] Walls<D> box() {
  Walls<D> walls;
  for (int axis = 0; axis < D; ++axis) {
    for (const Side side : {Side::low, Side::high}) {
      walls.push_back(make_frictional_wall<D>(Dry{}, {}, Hold::pushes, axis, side));
    }
  }
  return walls;
}

constexpr std::array<double, 3> no_gravity{};

/// What points give to nodes within walls, in a step of 1 s.
template <int D>
void give(const Particles<D>& particles, const ParticleBlocks<D>& blocks, const Transfer<D, D>& transfer,
          const Walls<D>& walls, Nodes<D>& nodes) {
  for (const ParticleBlock<D>& block : blocks.blocks) {
    transfer.scatter(particles, block, nodes, 1);
    for (const auto& wall : walls) transfer.scatter_cut(particles, block, nodes, *wall->cuts_shapes(), 1);
  }
  for (const auto& wall : walls) wall->fold(nodes, no_gravity.data(), 1);
}

/// The largest error of momentum at a node of a mesh with walls all round, in an affine velocity of about 1.
template <int D>
[[nodiscard]] double error_of_affine_velocity(const AnyShape& shape, const AnyTransfer& rule) {
  const auto grid = cube<D>(3, 1, false);
  auto particles = scattered<D>(grid, 40, 0);
  for (int axis = 0; axis < D; ++axis) {  // two of them exactly in corners
    particles.position.component(axis)[0] = 0;
    particles.position.component(axis)[1] = 3;
  }
  fill_at_random(particles.velocity_gradient, 0.2);
  const auto gradient = [&](int i, int j) { return particles.velocity_gradient.component(i + D * j)[0]; };
  const auto velocity_at = [&](const Vector<D>& x, int i) {
    double sum = 0.5;
    for (int j = 0; j < D; ++j) sum += gradient(i, j) * x[j];
    return sum;
  };
  for (Index p = 0; p < particles.size(); ++p) {
    Vector<D> x;
    for (int j = 0; j < D; ++j) x[j] = particles.position.component(j)[p];
    for (int i = 0; i < D; ++i) {
      particles.velocity.component(i)[p] = velocity_at(x, i);
      for (int j = 0; j < D; ++j) particles.velocity_gradient.component(i + D * j)[p] = gradient(i, j);
    }
  }
  const auto transfer = make_transfer<D, D>(shape, rule);
  Nodes<D> nodes{grid, transfer->record()};
  const auto walls = box<D>();
  const ParticleBlocks<D> blocks = cell_sort(particles, grid, transfer->stencil_shift(), {1});

  give(particles, blocks, *transfer, walls, nodes);

  double error = 0;
  for (const NodeRun& run : nodes.batch(0)) {
    for (Index n = run.begin; n < run.end; ++n) {
      const Vector<D> x = node_position(nodes, n);
      if (x.minCoeff() < 0 || x.maxCoeff() > 3) continue;  // an image
      for (int i = 0; i < D; ++i) {
        const double expected = nodes[n][NodeRecord::mass] * velocity_at(x, i);
        const double off = std::abs(nodes[n][NodeRecord::momentum + i] - expected);
        if (!(off <= error)) error = off;  // no number stays none
      }
    }
  }
  return error;
}

TEST(CutShapes, GiveEveryNodeAnAffineVelocity) {  // Eq. (M183), at walls, edges and corners
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& rule : every<AnyTransfer>()) {
      if (!Scheme{shape, rule}.has_affine()) continue;
      // 40 points of up to 2 kg with velocities of up to 0.5 + 3 (0.2 x 3), which are 1 on average.
      const double rounding = rounding_of(3, 4, 1) * 40 * 2 * 2.3;
      EXPECT_LE(error_of_affine_velocity<1>(shape, rule), rounding) << Scheme{shape, rule}.name();
      EXPECT_LE(error_of_affine_velocity<2>(shape, rule), rounding) << Scheme{shape, rule}.name();
      EXPECT_LE(error_of_affine_velocity<3>(shape, rule), rounding) << Scheme{shape, rule}.name();
    }
  }
}

/// Of blocks whose points reach past a wall, the one at low x or the one at high y, places are kept as they
/// were when points gathered, and of no others.
TEST(CutShapes, KeepPlacesOfPointsBesideThemAlone) {
  constexpr Index num_cells = 6 * block_edge<2>;
  constexpr double untouched = -1;
  const auto grid = cube<2>(num_cells, 1, false);
  auto particles = filled<2>(grid, 1);
  auto stages = stages_of<2, 2>(particles, Cubic{}, Apic{});
  stages.boundaries.push_back(make_frictional_wall<2>(Dry{}, {}, Hold::pushes, 0, Side::low));
  stages.boundaries.push_back(make_frictional_wall<2>(Dry{}, {}, Hold::pushes, 1, Side::high));
  auto state = start(std::move(particles), grid, stages, {1});
  step(state, stages, 1e-3, {1});
  auto& kept = state.spare.position;
  std::fill(kept.begin(), kept.end(), untouched);

  step(state, stages, 1e-3, {1});

  const Index last_node =
      stages.transfer->tile_edge() - 1 - block_skin<2>;  // of a block, from its first cell on
  Index num_kept = 0;
  for (const ParticleBlock<2>& block : state.blocks.blocks) {
    const bool is_beside = block.first_cell[0] < block_skin<2> || block.first_cell[1] + last_node > num_cells;
    num_kept += is_beside ? 1 : 0;
    for (Index p = block.begin; p < block.end; ++p) {
      for (const Index place : {p, p + state.particles.size()}) {
        EXPECT_EQ(kept[static_cast<std::size_t>(place)] != untouched, is_beside) << p;
      }
    }
  }
  EXPECT_GT(num_kept, 0);
  EXPECT_LT(2 * num_kept, static_cast<Index>(state.blocks.blocks.size()));
}

/// The power of the forces that nodes get, at any velocities of theirs, and what points take of it by their
/// gradients, which should be the same. Of a few points beside walls all round.
template <int D>
[[nodiscard]] std::pair<double, double> powers(const AnyShape& shape, const AnyTransfer& rule) {
  const auto grid = cube<D>(5, 1, false);
  auto particles = scattered<D>(grid, 60, 0);
  fill_at_random(particles.stress, 1);
  const auto transfer = make_transfer<D, D>(shape, rule);
  Nodes<D> nodes{grid, transfer->record()};
  const auto walls = box<D>();
  const ParticleBlocks<D> blocks = cell_sort(particles, grid, transfer->stencil_shift(), {1});
  give(particles, blocks, *transfer, walls, nodes);
  const NodeRecord layout = nodes.record();
  const int place = layout.has_increment ? layout.increment() : NodeRecord::momentum;
  std::mt19937 random{3};
  std::uniform_real_distribution<double> draw{-1, 1};
  std::pair<double, double> power{0, 0};
  for (Index n = 0; n < nodes.num_nodes(); ++n) {
    const Vector<D> x = node_position(nodes, n);
    const bool is_image = x.minCoeff() < 0 || x.maxCoeff() > 5;
    for (int i = 0; i < D; ++i) {
      const double velocity = is_image ? 0 : draw(random);
      power.first += velocity * (is_image ? 0 : nodes[n][place + i]);
      nodes[n][NodeRecord::momentum + i] = velocity;
    }
  }
  for (const auto& wall : walls) wall->reflect(nodes);
  const Column position = particles.position;
  for (const ParticleBlock<D>& block : blocks.blocks) {
    static_cast<void>(transfer->gather(particles, block, nodes, 0));
    for (const auto& wall : walls) {
      transfer->gather_cut(particles, block, nodes, *wall->cuts_shapes(), position.component(0), 0);
    }
  }
  for (Index p = 0; p < particles.size(); ++p) {
    const double volume = particles.mass.component(0)[p] / particles.density.component(0)[p];
    for (int c = 0; c < D * D; ++c) {
      power.second -= volume * particles.stress.component(c)[p] * particles.velocity_gradient.component(c)[p];
    }
  }
  return power;
}

TEST(CutShapes, TakeThePowerThatTheirForceGives) {  // Eqs. (M10), (M197), at walls, edges and corners
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& rule : every<AnyTransfer>()) {
      // 60 points of up to 2/1000 m^3, with D^2 stresses of 1 Pa and gradients of up to some 4/s.
      const auto near = [&](const std::pair<double, double>& power, int dimension) {
        const double rounding = rounding_of(dimension, 4, 1) * 60 * 0.002 * dimension * dimension * 4;
        EXPECT_NEAR(power.first, power.second, rounding) << Scheme{shape, rule}.name();
        EXPECT_GT(std::abs(power.first), 1e6 * rounding);
      };
      near(powers<1>(shape, rule), 1);
      near(powers<2>(shape, rule), 2);
      near(powers<3>(shape, rule), 3);
    }
  }
}

/// The forces [N] on nodes 1 m apart of a point of 1 m^3 under 1 Pa at `place` [m], walls with friction at 0
/// and at 8 m, and last the gradient [1/s] that it takes of nodes with the velocity cos x.
[[nodiscard]] std::vector<double> given_and_taken(const AnyTransfer& rule, double place) {
  const auto grid = cube<1>(8, 1, false);
  Particles<1> particles;
  particles.resize(1);
  for (Column* column : {&particles.mass, &particles.density, &particles.stress}) column->component(0)[0] = 1;
  particles.position.component(0)[0] = place;
  const auto transfer = make_transfer<1, 1>(Cubic{}, rule);
  Nodes<1> nodes{grid, transfer->record()};
  const auto walls = box<1>();
  const ParticleBlocks<1> blocks = cell_sort(particles, grid, transfer->stencil_shift(), {1});
  const ParticleBlock<1>& block = blocks.blocks.front();
  transfer->scatter(particles, block, nodes, 1);
  for (const auto& wall : walls) transfer->scatter_cut(particles, block, nodes, *wall->cuts_shapes(), 1);
  for (const auto& wall : walls) wall->fold(nodes, no_gravity.data(), 1);
  const NodeRecord layout = nodes.record();
  const int force = layout.has_increment ? layout.increment() : NodeRecord::momentum;
  std::vector<double> result;
  for (Index n = 0; n < nodes.num_nodes(); ++n) {
    const double x = node_position(nodes, n)[0];
    if (0 <= x && x <= 8) result.push_back(nodes[n][force]);
    nodes[n][NodeRecord::momentum] = std::cos(x);
  }
  for (const auto& wall : walls) wall->reflect(nodes);
  const Column position = particles.position;
  static_cast<void>(transfer->gather(particles, block, nodes, 0));
  for (const auto& wall : walls) {
    transfer->gather_cut(particles, block, nodes, *wall->cuts_shapes(), position.component(0), 0);
  }
  result.push_back(particles.velocity_gradient.component(0)[block.begin]);
  return result;
}

/// A slope 3 w (i - x) changes by 3 (2/3 2 + 2/3) = 6/m or less per m; the wall's node gets two images more
/// of it, and an image has up to three times the velocity of a node: 6 (1 + 1 + 1 + 3) for the gradient.
TEST(CutShapes, GiveAndTakeOnTheWallWhatTheyDoBesideIt) {  // Eq. (M197)
  constexpr double inside = 1e-9;                          // [m]
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{Aflip{0}}}) {
    for (const auto& [on, beside] :
         {std::pair{0.0, inside}, std::pair{1e-17, inside}, std::pair{8.0, 8 - inside}}) {
      const std::vector<double> at_wall = given_and_taken(rule, on);
      const std::vector<double> limit = given_and_taken(rule, beside);
      ASSERT_EQ(at_wall.size(), limit.size());
      EXPECT_GT(std::abs(*std::ranges::max_element(limit)), 0.5);
      for (std::size_t i = 0; i < limit.size(); ++i) {
        EXPECT_NEAR(at_wall[i], limit[i], 36 * inside)
            << Scheme{Cubic{}, rule}.name() << ", " << on << " m, " << i;
      }
    }
  }
}

}  // namespace
}  // namespace scree::mpm
