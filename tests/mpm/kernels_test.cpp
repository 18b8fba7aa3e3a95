#include "bodies.hpp"
#include "messages.hpp"
#include "reference_transfer.hpp"
#include "schemes.hpp"

#include <scree/mpm/cell_sort.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <type_traits>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr double spacing = 0.1;  // [m]
constexpr double dt = 1e-3;      // [s]
template <int D>
constexpr Index num_cells = block_edge<D> + 5;  // along each axis: more than one block and its skin

/// Where the points of a cloud are: anywhere in the mesh, and far from each other in a pack; or in a cube of
/// 1.6 cells, so that most packs' stencils begin at one node or at neighbours, in its middle as they were
/// sorted, or at the upper end of a block, which they have left together as far as they may.
enum class Density { thin, dense, leaving };

/// Points with all they have drawn at random; of a thin cloud they have moved since they were sorted, as far
/// as they may, from open ends as far away as a stencil reaches.
template <int D, int V>
struct Cloud {
  Cloud(const Transfer<D, V>& transfer, bool is_periodic, Density density = Density::thin)
      : grid{cube<D>(num_cells<D>, spacing, is_periodic)} {
    const bool is_dense = density != Density::thin;
    const double low = is_dense ? (num_cells<D> / 2.0 - 0.8) * spacing : is_periodic ? 0 : 1.5 * spacing;
    const double high = num_cells<D> * spacing - low;
    particles = scattered<D, V>(grid, 200, low);
    fill_at_random(particles.velocity, 1);
    fill_at_random(particles.velocity_gradient, 1 / spacing);
    fill_at_random(particles.stress, 1e4);
    const double end = (static_cast<double>(block_edge<D>) + transfer.stencil_shift()) * spacing;
    if (density == Density::leaving) move_all(0.999 * end - high);
    blocks = cell_sort(particles, grid, transfer.stencil_shift(), one_thread);
    if (density == Density::leaving) move_all(block_skin<D> * 0.999 * spacing);
    if (is_dense) return;
    std::mt19937 random{29};
    std::uniform_real_distribution<double> draw{-1, 1};
    for (double& x : particles.position.values()) {
      x += draw(random) * block_skin<D> * 0.999 * spacing;
      if (!is_periodic) x = std::clamp(x, low, high);
    }
  }

  void move_all(double way) {
    for (double& x : particles.position.values()) x += way;
  }

  CartesianGrid<D> grid;
  Particles<D, V> particles;
  ParticleBlocks<D> blocks;
};

/// How far two ways of rounding can be apart, relative to the largest weights times the largest values, for a
/// sum of `num_terms`. A coordinate of up to num_cells and the skin is rounded three times, and no weight
/// changes by more than 9 per spacing (the affine one, 4 N (i - xi)); weights of up to four take ten
/// roundings each. A product of weights has D of them, each way; every term of a sum has five roundings more.
/// Where an affine field goes from node to node, (M202), up to four values along each axis are added up, of
/// up to three steps each: twelve roundings more of a term.
template <int D>
constexpr double apart(double num_terms) {
  constexpr double coordinate = num_cells<D> + block_skin<D>;
  return 2 * round_off * (D * (9.0 * 3 * coordinate + 4 * 10) + (5 + 12 * D) * num_terms);
}

template <class Dimension>
class EveryKernel : public ::testing::Test {
 protected:
  /// Calls test(scheme, set, is periodic, V) for every scheme, instruction set of this machine, mesh and
  /// number of velocities.
  template <class Test>
  static void for_each_kernel(Test&& test) {
    constexpr int D = Dimension::value;
    for (const Scheme& scheme : every_scheme()) {
      SCOPED_TRACE(scheme.name());
      for (const InstructionSet set : instruction_sets()) {
        for (const bool is_periodic : {false, true}) {
          SCOPED_TRACE(std::string{name_of(set)} + (is_periodic ? ", periodic" : ""));
          test(scheme, set, is_periodic, Dimension{});
          if constexpr (D < 3) test(scheme, set, is_periodic, std::integral_constant<int, D + 1>{});
          if constexpr (D < 2) test(scheme, set, is_periodic, std::integral_constant<int, D + 2>{});
        }
      }
    }
  }
};
TYPED_TEST_SUITE(EveryKernel, Dimensions);

TYPED_TEST(EveryKernel, GivesTheNodesWhatSingleNumbersGive) {
  constexpr int D = TypeParam::value;
  this->for_each_kernel([](const Scheme& scheme, InstructionSet set, bool is_periodic, auto velocities) {
    constexpr int V = decltype(velocities)::value;
    const auto transfer = make_transfer<D, V>(scheme.shape, scheme.rule, set);
    Cloud<D, V> cloud{*transfer, is_periodic};
    auto& [grid, particles, blocks] = cloud;
    Nodes<D> nodes{grid, transfer->record()};
    Nodes<D> expected{grid, transfer->record()};

    for (const auto& block : blocks.blocks) transfer->scatter(particles, block, nodes, dt);

    const ReferenceTransfer<D, V> reference{grid, scheme};
    for (Index p = 0; p < particles.size(); ++p) reference.scatter(particles, p, expected, dt);
    const double terms = static_cast<double>(particles.size());
    const double mass = terms * largest(particles.mass);
    const double force = mass / 1000 * largest(particles.stress) * 2 / spacing * D;  // slopes up to 2/spacing
    const double momentum = mass * (largest(particles.velocity) + D * 2 * spacing / spacing) +
                            (scheme.has_increment() ? 0 : dt * force);
    for (Index n = 0; n < nodes.num_nodes(); ++n) {
      const auto expect_near = [&](int place, double scale) {
        EXPECT_NEAR(nodes[n][place], expected[n][place], apart<D>(terms) * scale);
      };
      expect_near(NodeRecord::mass, mass);
      for (int i = 0; i < V; ++i) {
        expect_near(NodeRecord::momentum + i, momentum);
        if (scheme.has_increment()) expect_near(NodeRecord::increment() + i, force);
      }
    }
  });
}

TYPED_TEST(EveryKernel, GivesThePointsWhatSingleNumbersGive) {
  constexpr int D = TypeParam::value;
  this->for_each_kernel([](const Scheme& scheme, InstructionSet set, bool is_periodic, auto velocities) {
    constexpr int V = decltype(velocities)::value;
    const auto transfer = make_transfer<D, V>(scheme.shape, scheme.rule, set);
    for (const Density density : {Density::thin, Density::dense, Density::leaving}) {
      SCOPED_TRACE(static_cast<int>(density));
      Cloud<D, V> cloud{*transfer, is_periodic, density};
      auto& [grid, particles, blocks] = cloud;
      Nodes<D> nodes{grid, transfer->record()};
      std::mt19937 random{17};
      std::uniform_real_distribution<double> draw{-1, 1};
      for (Index n = 0; n < nodes.num_nodes(); ++n) {
        for (int i = 0; i < nodes.record().size(); ++i) nodes[n][i] = draw(random);
      }
      const auto before = particles;

      for (const auto& block : blocks.blocks) (void)transfer->gather(particles, block, nodes, dt);

      const ReferenceTransfer<D, V> reference{grid, scheme};
      const double terms = std::pow(static_cast<double>(scheme.support()), D);
      const double rounding = apart<D>(terms) * terms;  // nodal velocities up to 1 m/s
      const double of_position = 2 * round_off * largest(particles.position);
      for (Index p = 0; p < particles.size(); ++p) {
        const auto next = load(particles, p);
        const auto expected = reference.gather(before, p, nodes, dt);
        for (std::size_t i = 0; i < V; ++i) EXPECT_NEAR(next.velocity[i], expected.velocity[i], 3 * rounding);
        for (std::size_t j = 0; j < D; ++j) {
          EXPECT_NEAR(next.position[j], expected.position[j], dt * rounding + of_position);
          for (std::size_t i = 0; i < V; ++i) {
            EXPECT_NEAR(next.velocity_gradient[j][i], expected.velocity_gradient[j][i],
                        rounding * 2 / spacing);
          }
        }
        EXPECT_NEAR(next.density, expected.density, 2 * expected.density * dt * D * rounding * 2 / spacing);
      }
    }
  });
}

TEST(Kernels, TellTheFastestPointOfABlock) {
  for (const InstructionSet set : instruction_sets()) {
    const auto transfer = make_transfer<2, 3>(Quadratic{}, PicFlip{1}, set);
    Cloud<2, 3> cloud{*transfer, false};
    auto& [grid, particles, blocks] = cloud;
    const Nodes<2> nodes{grid, transfer->record()};

    const BlockMotion motion = transfer->gather(particles, blocks.blocks[0], nodes, dt);

    double fastest = 0;
    for (Index p = blocks.blocks[0].begin; p < blocks.blocks[0].end; ++p) {
      const auto speed = [&](int axis) { return std::abs(particles.velocity.component(axis)[p]); };
      fastest = std::max(fastest, (speed(0) + speed(1)) / spacing);
    }
    EXPECT_NEAR(motion.advection_rate, fastest, 4 * round_off * fastest);  // quotients and a sum
    EXPECT_FALSE(motion.needs_sort);
  }
}

/// A pack in one block, whose point number `place` is in the middle and the others are at its ends.
template <int D>
Particles<D> pack_about(Index place, Index first_cell) {
  constexpr Index edge = block_edge<D>;
  Particles<D> particles;
  particles.resize(pack_size);
  for (Index p = 0; p < pack_size; ++p) {
    const Index cell = p < place ? 0 : p == place ? edge / 2 : edge - 1;
    for (int axis = 0; axis < D; ++axis) {
      const Index along = axis == 0 ? cell : edge / 2;
      particles.position.component(axis)[p] = (static_cast<double>(first_cell + along) + 0.75) * spacing;
    }
    particles.mass.component(0)[p] = 1;
    particles.density.component(0)[p] = 1000;
  }
  return particles;
}

/// The nodes of that point alone move, and take it along, in a step of 1 s.
template <int D>
void expect_that_one_point_needs_a_sort(InstructionSet set) {
  constexpr Index edge = block_edge<D>;
  constexpr Index first_cell = 2 * edge - 1;  // of the third block along each axis
  constexpr double to_low =
      edge / 2 + 0.25 + block_skin<D>;  // from the point to where its reach ends [cells]
  constexpr double to_high = edge - edge / 2 - 0.25 + block_skin<D>;
  constexpr double lost = std::numeric_limits<double>::quiet_NaN();
  const auto grid = cube<D>(4 * edge, spacing, false);
  const auto transfer = make_transfer<D, D>(Quadratic{}, Apic{}, set);
  for (Index place = 0; place < pack_size; ++place) {
    auto particles = pack_about<D>(place, first_cell);
    const auto blocks = cell_sort(particles, grid, transfer->stencil_shift(), one_thread);
    ASSERT_EQ(blocks.blocks.size(), 1U);
    for (int axis = 0; axis < D; ++axis) {
      for (const double cells : {0.0, -to_low + 0.1, -to_low - 0.1, to_high - 0.1, to_high + 0.1, lost}) {
        Nodes<D> nodes{grid, transfer->record()};
        for (Index n = 0; n < nodes.num_nodes(); ++n) {
          const Index along = nodes.first(0) + n % nodes.count(0) - first_cell - edge / 2;
          if (0 <= along && along < 3) nodes[n][NodeRecord::momentum + axis] = cells * spacing;
        }
        auto moved = particles;

        const BlockMotion motion = transfer->gather(moved, blocks.blocks[0], nodes, 1);

        const bool stays = -to_low <= cells && cells < to_high;
        EXPECT_EQ(motion.needs_sort, !stays)
            << name_of(set) << ", " << place << ", " << cells << " along axis " << axis << " of " << D;
      }
    }
  }
}

TEST(Kernels, SeeTheOnePointOfAPackThatLeavesItsReachOrIsNowhere) {
  for (const InstructionSet set : instruction_sets()) {
    expect_that_one_point_needs_a_sort<1>(set);
    expect_that_one_point_needs_a_sort<2>(set);
  }
}

TEST(MakeTransfer, RefusesAnInstructionSetThatIsNotThere) {
  const auto sets = instruction_sets();
  for (const auto set : {InstructionSet::x86_64_v3, InstructionSet::x86_64_v4}) {
    if (std::ranges::find(sets, set) != sets.end()) continue;
    EXPECT_EQ(message_of<InputError>([&] { (void)make_transfer<2, 2>(Linear{}, Apic{}, set); }),
              "make_transfer: there are no kernels for " + std::string{name_of(set)} +
                  " in this build or on this machine");
  }
}

}  // namespace
}  // namespace scree::mpm
