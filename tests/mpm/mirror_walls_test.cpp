#include "bodies.hpp"
#include "dry_wall.hpp"
#include "messages.hpp"
#include "schemes.hpp"
#include "typed_lists.hpp"

#include <scree/mpm/boundaries/frictional.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <variant>
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

/// N_j of one axis at x, both in spacings.
[[nodiscard]] double shape_at(const AnyShape& any, double x, Index node) {
  return std::visit(
      [&](const auto& shape) {
        const double base = std::floor(x - shape.shift);
        const auto weights = shape.weights(x - base);
        const double place = static_cast<double>(node) - base;
        const bool is_reached = 0 <= place && place < static_cast<double>(weights.size());
        return is_reached ? weights[static_cast<std::size_t>(place)] : 0.0;
      },
      any);
}

/// What a node gets of points, as mass and as weight over gravity [kg], or of one of them [-].
struct Share {
  double mass;
  double weight;
};

/// Mirrors all round four cells of 1 m or, if told, friction at the low end of the last axis.
template <int D, class Rule>
struct Surroundings {
  AnyShape shape;
  bool has_friction = false;

  static constexpr Index num_cells = 4;

  [[nodiscard]] bool rubs_at_low_end(int axis) const { return has_friction && axis == D - 1; }

  [[nodiscard]] std::vector<std::unique_ptr<Boundary<D>>> walls() const {
    std::vector<std::unique_ptr<Boundary<D>>> walls;
    for (int axis = 0; axis < D; ++axis) {
      walls.push_back(rubs_at_low_end(axis)
                          ? make_frictional_wall<D>(Dry{}, {}, Hold::pushes, axis, Side::low)
                          : make_wall<D>(Rule{}, axis, Side::low));
      walls.push_back(make_wall<D>(Rule{}, axis, Side::high));
    }
    return walls;
  }

  /// Whether a mirror that the node is on holds this component of velocity.
  [[nodiscard]] bool holds(const Indices<D>& node, int component) const {
    for (int axis = 0; axis < D; ++axis) {
      const Index along = node[static_cast<std::size_t>(axis)];
      const bool is_on_mirror = along == num_cells || (along == 0 && !rubs_at_low_end(axis));
      if (is_on_mirror && Rule::holds(component, axis)) return true;
    }
    return false;
  }

  /// By the functions of one axis: N_in + N_img of mass, N_in + P N_img of weight; at a wall with friction
  /// what (M26) makes of them.
  [[nodiscard]] Share share_of(double x, Index node, int component, int axis) const {
    const double parity = Rule::holds(component, axis) ? -1 : 1;
    const double own = shape_at(shape, x, node);
    Share share{own, own};
    const auto add = [&](Index image, double of_mass, double of_weight) {
      share.mass += of_mass * shape_at(shape, x, image);
      share.weight += of_weight * shape_at(shape, x, image);
    };
    if (rubs_at_low_end(axis)) {
      if (node == 0) add(-1, 2, 2);
      if (node == 1) add(-1, -1, -1);
    } else if (node == 1) {
      add(-1, 1, parity);
    }
    if (node == num_cells - 1) add(num_cells + 1, 1, parity);
    return share;
  }

  /// The virtual work of the points' weight where the node has a velocity of 1 m/s, over gravity.
  [[nodiscard]] Share of_points(const Particles<D>& particles, const Indices<D>& node, int component) const {
    Share sum{};
    for (Index p = 0; p < particles.size(); ++p) {
      const double mass = particles.mass.component(0)[p];
      Share product{mass, mass};
      for (int axis = 0; axis < D; ++axis) {
        const double x = particles.position.component(axis)[p];
        const Share one = share_of(x, node[static_cast<std::size_t>(axis)], component, axis);
        product.mass *= one.mass;
        product.weight *= one.weight;
      }
      sum.mass += product.mass;
      sum.weight += product.weight;
    }
    return sum;
  }
};

/// Lets points without stress fall from rest for a moment: nodes begin by the weight that virtual work gives
/// them, over their mass.  Eq. (M200)
template <int D, class Rule>
void expect_weight_of_virtual_work(const Surroundings<D, Rule>& around, const AnyTransfer& transfer,
                                   Order order = Order::usl, bool has_last_wall_first = false) {
  const auto grid = cube<D>(around.num_cells, 1, false);
  auto particles = scattered<D>(grid, 50, 0);
  auto stages = stages_of<D, D>(particles, around.shape, transfer);
  stages.order = order;
  stages.boundaries = around.walls();
  if (has_last_wall_first) std::ranges::reverse(stages.boundaries);
  for (std::size_t i = 0; i < D; ++i) stages.gravity[i] = static_cast<double>(i + 1);  // away from friction
  auto state = start(std::move(particles), grid, stages, one_thread);
  const Particles<D> before = state.particles;
  const auto masses = before.mass.values();
  const double total = std::accumulate(masses.begin(), masses.end(), 0.0);

  constexpr double dt = 1.0 / (1 << 20);  // no point leaves its block
  step(state, stages, dt, one_thread);

  const Nodes<D>& nodes = state.nodes;
  for (Index n = 0; n < nodes.num_nodes(); ++n) {
    Indices<D> node{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      node[axis] = n / nodes.stride(axis) % nodes.count(axis) + nodes.first(axis);
    }
    if (std::ranges::any_of(node, [&](Index k) { return k < 0 || k > around.num_cells; })) continue;
    for (int i = 0; i < D; ++i) {
      const double gravity = stages.gravity[static_cast<std::size_t>(i)];
      const Share share = around.of_points(before, node, i);
      if (!(share.mass > state.mass_floor)) continue;
      const double expected = around.holds(node, i) ? 0 : gravity * share.weight / share.mass;
      EXPECT_NEAR(nodes[n][NodeRecord::momentum + i] / dt, expected,
                  gravity * rounding_of(D, 4, 1) * total / share.mass);
    }
  }
}

TYPED_TEST(EveryWall, MirrorsWeight) {  // Eq. (M200)
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& transfer : every<AnyTransfer>()) {
      expect_weight_of_virtual_work<1, TypeParam>({shape}, transfer);
      expect_weight_of_virtual_work<2, TypeParam>({shape}, transfer);
      expect_weight_of_virtual_work<3, TypeParam>({shape}, transfer);
    }
  }
}

TYPED_TEST(EveryWall, MirrorsWeightBesideAWallWithFrictionInAnyOrder) {  // Eqs. (M26), (M200)
  for (const bool has_last_wall_first : {false, true}) {
    for (const AnyTransfer& transfer : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
      for (const Order order : {Order::usl, Order::usf}) {
        expect_weight_of_virtual_work<1, TypeParam>({Cubic{}, true}, transfer, order, has_last_wall_first);
        expect_weight_of_virtual_work<2, TypeParam>({Cubic{}, true}, transfer, order, has_last_wall_first);
        expect_weight_of_virtual_work<3, TypeParam>({Cubic{}, true}, transfer, order, has_last_wall_first);
      }
    }
  }
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
