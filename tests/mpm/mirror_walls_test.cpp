#include "bodies.hpp"
#include "messages.hpp"
#include "schemes.hpp"
#include "typed_lists.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr Fluid water{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 1};

/// A box of walls, filled with stirred fluid, after some steps.
template <int D>
State<D, D> stirred_box(const AnyWall& rule, const AnyShape& shape, const AnyTransfer& transfer,
                        Index num_cells, double axis_sign = 1) {
  constexpr double spacing = 0.125;
  const Vector<D> low = Vector<D>::Constant(-spacing * static_cast<double>(num_cells) / 2);
  CartesianGrid<D> grid = cube<D>(num_cells, spacing, false);
  grid = CartesianGrid<D>{low, grid.spacing(), grid.num_cells(), grid.is_periodic()};
  auto particles = filled<D>(grid, 2);
  fill_at_random(particles.velocity, 1.0);
  for (double& x : particles.position.values()) x *= axis_sign;
  for (double& v : particles.velocity.values()) v *= axis_sign;
  auto stages = stages_of<D, D>(particles, shape, transfer, water);
  for (int axis = 0; axis < D; ++axis) {
    for (const Side side : {Side::low, Side::high}) {
      stages.boundaries.push_back(make_wall<D>(rule, axis, side));
    }
  }
  auto state = start(std::move(particles), grid, stages, one_thread);
  for (int n = 0; n < 5; ++n) step(state, stages, 1e-3, one_thread);
  return state;
}

template <class Rule>
class EveryWall : public ::testing::Test {};
TYPED_TEST_SUITE(EveryWall, testing::Each<AnyWall>, testing::EntryName);

TYPED_TEST(EveryWall, HoldsExactlyTheVelocitiesThatItsRuleNames) {  // Eqs. (M15), (M16)
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& transfer : every<AnyTransfer>()) {
      const auto state = stirred_box<2>(TypeParam{}, shape, transfer, 5);

      const Nodes<2>& nodes = state.nodes;
      for (Index along = 2; along < nodes.count(0) - 2; ++along) {
        const double* on_low_wall = nodes[along * nodes.stride(0) + nodes.stride(1)];
        for (int i = 0; i < 2; ++i) {
          EXPECT_EQ(on_low_wall[NodeRecord::momentum + i] == 0, TypeParam::holds(i, 1));
        }
      }
    }
  }
}

TYPED_TEST(EveryWall, MirrorsWhatIsInside) {  // Eq. (M14)
  const auto state = stirred_box<2>(TypeParam{}, Quadratic{}, Apic{}, 5);

  const Nodes<2>& nodes = state.nodes;
  for (Index along = 0; along < nodes.count(0); ++along) {
    const double* image = nodes[along];
    const double* inside = nodes[along + 2 * nodes.stride(1)];
    for (int i = 0; i < 2; ++i) {
      const double parity = TypeParam::holds(i, 1) ? -1 : 1;
      EXPECT_EQ(image[NodeRecord::momentum + i], parity * inside[NodeRecord::momentum + i]);
    }
  }
}

TYPED_TEST(EveryWall, LetsNothingThrough) {
  for (const AnyShape& shape : every<AnyShape>()) {
    const auto state = stirred_box<1>(TypeParam{}, shape, Apic{}, 5);

    const Nodes<1>& nodes = state.nodes;
    EXPECT_EQ(nodes[1][NodeRecord::momentum], 0);
    EXPECT_EQ(nodes[nodes.count(0) - 2][NodeRecord::momentum], 0);
  }
}

TYPED_TEST(EveryWall, AnswersAlikeOnBothEndsOfAnAxis) {
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& transfer : every<AnyTransfer>()) {
      const auto state = stirred_box<2>(TypeParam{}, shape, transfer, 5);
      const auto turned = stirred_box<2>(TypeParam{}, shape, transfer, 5, -1);

      std::vector<Index> by_id(static_cast<std::size_t>(turned.particles.size()));
      for (Index p = 0; p < turned.particles.size(); ++p) {
        if (!(turned.particles.mass.component(0)[p] > 0)) continue;
        by_id[static_cast<std::size_t>(turned.particles.id.component(0)[p])] = p;
      }
      // Pressures of bulk modulus times round-off become velocities dt K/(rho h), 0.8 m/s, times round-off.
      const double tolerance = rounding_of(2, 3, 5) * 2;
      for (Index p = 0; p < state.particles.size(); ++p) {
        if (!(state.particles.mass.component(0)[p] > 0)) continue;
        const Index q = by_id[static_cast<std::size_t>(state.particles.id.component(0)[p])];
        for (int i = 0; i < 2; ++i) {
          EXPECT_NEAR(state.particles.velocity.component(i)[p], -turned.particles.velocity.component(i)[q],
                      tolerance);
        }
      }
    }
  }
}

TYPED_TEST(EveryWall, HoldsBeforeItsImageIsTakenByTheWallAcross) {  // one cell wide: each is inside the other
  const auto state = stirred_box<1>(TypeParam{}, Quadratic{}, Apic{}, 1);

  const Nodes<1>& nodes = state.nodes;
  for (Index n = 0; n < nodes.num_nodes(); ++n) EXPECT_EQ(nodes[n][NodeRecord::momentum], 0);
}

TEST(NoSlip, KeepsALinearProfileOfShearUpToTheWall) {  // Eqs. (M14), (M15)
  constexpr double shear_rate = 3;
  constexpr double spacing = 0.1;
  const auto grid = cube<1>(8, spacing, false);
  for (const AnyShape& shape : every<AnyShape>()) {
    auto particles = filled<1, 2>(grid, 3);
    for (Index p = 0; p < particles.size(); ++p) {
      particles.velocity.component(1)[p] = shear_rate * particles.position.component(0)[p];
      particles.velocity_gradient.component(1)[p] = shear_rate;
    }
    auto stages = stages_of<1, 2>(particles, shape, Apic{});
    stages.boundaries.push_back(make_wall<1>(NoSlip{}, 0, Side::low));
    auto state = start(std::move(particles), grid, stages, one_thread);

    step(state, stages, 1e-3, one_thread);

    const double tolerance = rounding_of(1, 3, 1) * shear_rate;
    for (Index p = 0; p < state.particles.size(); ++p) {
      EXPECT_NEAR(state.particles.velocity.component(1)[p],
                  shear_rate * state.particles.position.component(0)[p], tolerance * grid.length(0));
      EXPECT_NEAR(state.particles.velocity_gradient.component(1)[p], shear_rate,
                  tolerance * grid.length(0) / spacing);
    }
  }
}

TEST(Slip, KeepsTheSpeedAlongTheWall) {  // Eq. (M16)
  const auto grid = cube<1>(4, 0.1, false);
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& transfer : every<AnyTransfer>()) {
      auto particles = filled<1, 2>(grid, 3);
      for (Index p = 0; p < particles.size(); ++p) particles.velocity.component(1)[p] = 2;
      auto stages = stages_of<1, 2>(particles, shape, transfer, water);
      for (const Side side : {Side::low, Side::high}) {
        stages.boundaries.push_back(make_wall<1>(Slip{}, 0, side));
      }
      auto state = start(std::move(particles), grid, stages, one_thread);

      constexpr int num_steps = 10;
      for (int n = 0; n < num_steps; ++n) step(state, stages, 1e-3, one_thread);

      for (Index p = 0; p < state.particles.size(); ++p) {
        EXPECT_NEAR(state.particles.velocity.component(1)[p], 2, 2 * rounding_of(1, 3, num_steps));
      }
    }
  }
}

TEST(MakeWall, RefusesAnAxisThatIsNotThere) {
  EXPECT_EQ(message_of<InputError>([] { static_cast<void>(make_wall<2>(NoSlip{}, 2, Side::low)); }),
            "make_wall: no such axis");
}

}  // namespace
}  // namespace scree::mpm
