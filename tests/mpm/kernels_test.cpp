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
constexpr Index num_cells = 6;   // along each axis
constexpr double spacing = 0.1;  // [m]
constexpr double dt = 1e-3;      // [s]

/// Points with all they have drawn at random, in a box of open ends, as far from them as a stencil reaches.
template <int D, int V>
Particles<D, V> any_cloud() {
  auto particles = scattered<D, V>(cube<D>(num_cells, spacing, false), 200, 1.5 * spacing);
  fill_at_random(particles.velocity, 1);
  fill_at_random(particles.velocity_gradient, 1 / spacing);
  fill_at_random(particles.stress, 1e4);
  return particles;
}

/// How far two ways of rounding can be apart, relative to the largest weights times the largest values, for a
/// sum of `num_terms`. A coordinate of up to num_cells is rounded three times, and no weight changes by more
/// than 9 per spacing (the affine one, 4 N (i - xi)); weights of up to four take ten roundings each. A
/// product of weights has D of them, each way; every term of a sum has five roundings more.
constexpr double apart(int dimension, double num_terms) {
  return 2 * round_off * (dimension * (9.0 * 3 * num_cells + 4 * 10) + 5 * num_terms);
}

template <class Dimension>
class EveryKernel : public ::testing::Test {
 protected:
  /// Calls test(scheme, set, V) for every scheme, instruction set of this machine and number of velocities.
  template <class Test>
  static void for_each_kernel(Test&& test) {
    constexpr int D = Dimension::value;
    for (const Scheme& scheme : every_scheme()) {
      SCOPED_TRACE(scheme.name());
      for (const InstructionSet set : instruction_sets()) {
        SCOPED_TRACE(name_of(set));
        test(scheme, set, Dimension{});
        if constexpr (D < 3) test(scheme, set, std::integral_constant<int, D + 1>{});
        if constexpr (D < 2) test(scheme, set, std::integral_constant<int, D + 2>{});
      }
    }
  }
};
TYPED_TEST_SUITE(EveryKernel, Dimensions);

TYPED_TEST(EveryKernel, GivesTheNodesWhatSingleNumbersGive) {
  constexpr int D = TypeParam::value;
  this->for_each_kernel([](const Scheme& scheme, InstructionSet set, auto velocities) {
    constexpr int V = decltype(velocities)::value;
    const auto grid = cube<D>(num_cells, spacing, false);
    auto particles = any_cloud<D, V>();
    const auto transfer = make_transfer<D, V>(scheme.shape, scheme.rule, set);
    const auto blocks = cell_sort(particles, grid, transfer->stencil_shift(), one_thread);
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
        EXPECT_NEAR(nodes[n][place], expected[n][place], apart(D, terms) * scale);
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
  this->for_each_kernel([](const Scheme& scheme, InstructionSet set, auto velocities) {
    constexpr int V = decltype(velocities)::value;
    const auto grid = cube<D>(num_cells, spacing, false);
    auto particles = any_cloud<D, V>();
    const auto transfer = make_transfer<D, V>(scheme.shape, scheme.rule, set);
    const auto blocks = cell_sort(particles, grid, transfer->stencil_shift(), one_thread);
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
    const double rounding = apart(D, terms) * terms;  // nodal velocities up to 1 m/s
    for (Index p = 0; p < particles.size(); ++p) {
      const auto next = load(particles, p);
      const auto expected = reference.gather(before, p, nodes, dt);
      for (std::size_t i = 0; i < V; ++i) EXPECT_NEAR(next.velocity[i], expected.velocity[i], 3 * rounding);
      for (std::size_t j = 0; j < D; ++j) {
        EXPECT_NEAR(next.position[j], expected.position[j], dt * rounding + round_off);
        for (std::size_t i = 0; i < V; ++i) {
          EXPECT_NEAR(next.velocity_gradient[j][i], expected.velocity_gradient[j][i], rounding * 2 / spacing);
        }
      }
      EXPECT_NEAR(next.density, expected.density, 2 * expected.density * dt * D * rounding * 2 / spacing);
    }
  });
}

TEST(Kernels, TellTheFastestPointOfABlock) {
  const auto grid = cube<2>(num_cells, spacing, false);
  for (const InstructionSet set : instruction_sets()) {
    auto particles = any_cloud<2, 3>();
    const auto transfer = make_transfer<2, 3>(Quadratic{}, PicFlip{1}, set);
    const auto blocks = cell_sort(particles, grid, transfer->stencil_shift(), one_thread);
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

TEST(Kernels, SeeTheOnePointOfAPackThatLeavesItsReachOrIsNowhere) {
  const auto grid = cube<1>(200, spacing, false);
  for (const InstructionSet set : instruction_sets()) {
    for (Index place = 0; place < pack_size; ++place) {
      Particles<1> particles;
      particles.resize(pack_size);
      for (Index p = 0; p < pack_size; ++p) {
        particles.position.component(0)[p] = (p < place ? 100.75 : p == place ? 110.75 : 120.75) * spacing;
        particles.mass.component(0)[p] = 1;
        particles.density.component(0)[p] = 1000;
      }
      const auto transfer = make_transfer<1, 1>(Quadratic{}, Apic{}, set);
      const auto blocks = cell_sort(particles, grid, transfer->stencil_shift(), one_thread);
      ASSERT_EQ(blocks.blocks.size(), 1U);
      Nodes<1> nodes{grid, transfer->record()};
      for (const double speed : {0.0, -1.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
        for (Index node = 109; node <= 113; ++node) nodes[nodes.place(node, 0)][NodeRecord::momentum] = speed;
        auto moved = particles;

        const BlockMotion motion = transfer->gather(moved, blocks.blocks[0], nodes, block_edge<1> * spacing);

        EXPECT_EQ(motion.needs_sort, speed != 0) << name_of(set) << ", " << place << ", " << speed;
      }
    }
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
