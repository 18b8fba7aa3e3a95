#include "bodies.hpp"
#include "messages.hpp"
#include "schemes.hpp"

#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/mpm/geostatic.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // [m/s^2]

/// Traction mu p + k v.
struct Rough {
  static constexpr std::string_view name = "rough";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  double friction;  ///< mu [-]
  double drag = 0;  ///< k [Pa s/m]

  template <class Real>
  [[nodiscard]] Real traction(const Real& pressure, const Real& speed,
                              const Input<Real>& /*in*/) const noexcept {
    return friction * pressure + drag * speed;
  }
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>& /*input*/) const noexcept {
    const Real rest = speed - contact.mobility * friction * contact.pressure;
    return select(rest <= 0.0, Real(0), rest / (1 + contact.mobility * drag));
  }
};
static_assert(WallLaw<Rough>);

/// A wall node of 2 kg in two dimensions with this velocity before the wall, after it.
[[nodiscard]] std::array<double, 2> after_wall(const Rough& law, const std::array<double, 2>& velocity,
                                               Hold hold = Hold::pushes, Side side = Side::low,
                                               Index along = 3) {
  Nodes<2> nodes{cube<2>(6, 0.25, false), {2, true}};
  const Index across = side == Side::low ? 1 : nodes.count(1) - 2;
  double* node = nodes[along * nodes.stride(0) + across * nodes.stride(1)];
  node[NodeRecord::mass] = 2;
  for (int i = 0; i < 2; ++i) {
    node[NodeRecord::momentum + i] = velocity[static_cast<std::size_t>(i)];
    node[nodes.record().increment() + i] = 10;
  }
  make_frictional_wall<2>(law, {}, hold, 1, side)->hold(nodes, 0.5);
  for (int i = 0; i < 2; ++i) {  // the increment changes as the velocity does
    EXPECT_EQ(node[nodes.record().increment() + i] - 10,
              node[NodeRecord::momentum + i] - velocity[static_cast<std::size_t>(i)]);
  }
  return {node[NodeRecord::momentum], node[NodeRecord::momentum + 1]};
}

using Velocity = std::array<double, 2>;

TEST(FrictionalWall, TakesFrictionInProportionToWhatItStops) {  // Eq. (M27)
  EXPECT_EQ(after_wall({.friction = 0.25}, {3, -4}), (Velocity{2, 0}));
  EXPECT_EQ(after_wall({.friction = 0.25}, {-3, -4}), (Velocity{-2, 0}));
  EXPECT_EQ(after_wall({.friction = 0.25}, {-3, 4}, Hold::pushes, Side::high), (Velocity{-2, 0}));
}

TEST(FrictionalWall, HoldsWhatIsInsideItsCone) {
  EXPECT_EQ(after_wall({.friction = 0.75}, {2.99, -4}), (Velocity{0, 0}));
  EXPECT_GT(after_wall({.friction = 0.75}, {3.01, -4})[0], 0);
}

TEST(FrictionalWall, DoesNoWorkWithoutFriction) {
  EXPECT_EQ(after_wall({.friction = 0}, {3, -4}), (Velocity{3, 0}));
}

TEST(FrictionalWall, PullsOnlyIfTold) {
  EXPECT_EQ(after_wall({.friction = 0.25}, {3, 4}), (Velocity{3, 4}));
  EXPECT_EQ(after_wall({.friction = 0.25}, {3, 4}, Hold::pushes_and_pulls), (Velocity{3, 0}));
}

/// The mobility is dt A/m: 0.5 s x 0.25 m / 2 kg, half of it beside another wall.
TEST(FrictionalWall, ActsOnTheAreaOfItsNode) {  // Eq. (M28)
  const Rough oil{.friction = 0, .drag = 16};

  EXPECT_EQ(after_wall(oil, {3, -4})[0], 3 / (1 + 16.0 / 16));
  EXPECT_EQ(after_wall(oil, {3, -4}, Hold::pushes, Side::low, 1)[0], 3 / (1 + 16.0 / 32));
}

/// A column of one cell, on a slope, that is viscous enough to slide as a block.
template <int V = 2>
struct Block {
  Block(const Rough& wall, const std::array<double, V>& pull, const AnyShape& shape = Linear{},
        const AnyTransfer& transfer = Apic{}, const Fluid& law = clay) {
    const auto grid = cube<1>(3, height, false);
    auto particles = seed_box<1, V>(grid, Vector<1>{0.0}, Vector<1>{height}, {2}, law.reference_density);
    stages = stages_of<1, V>(particles, shape, transfer, law);
    stages.gravity = pull;
    stages.boundaries.push_back(make_frictional_wall<1>(wall, {}, Hold::pushes, 0, Side::low));
    if (law.bulk_modulus > 0) set_geostatic(particles, *stages.stress, 0, height, -pull[0]);
    state = std::make_unique<State<1, V>>(start(std::move(particles), grid, stages, one_thread));
  }
  void advance(int num_steps) {
    for (int n = 0; n < num_steps; ++n) {
      const double before = speed(1);
      step(*state, stages, dt, one_thread);
      distance += dt * (before + speed(1)) / 2;
    }
  }
  [[nodiscard]] double mass() const {
    double sum = 0;
    for (const double m : state->particles.mass.values()) sum += m;
    return sum;
  }
  /// Mean velocity [m/s].
  [[nodiscard]] double speed(int component) const {
    return momentum_of(state->particles, component).total / mass();
  }

  static constexpr double height = 0.1;  // [m]
  static constexpr double dt = 1e-4;     // [s], two fifths of the viscous limit rho h^2/(2 mu)
  static constexpr Fluid clay{.bulk_modulus = 1e7, .reference_density = 1000, .viscosity = 2e4};
  Stages<1, V> stages;
  std::unique_ptr<State<1, V>> state;
  double distance = 0;  // [m]
};

/// Gravity on a slope, normal to it and along it.
[[nodiscard]] std::array<double, 2> pull_at(double angle) {
  return {-gravity * std::cos(angle), gravity * std::sin(angle)};
}

/// What friction takes is mu times what the wall pushes: momentum along, and mu times that across, change by
/// the weight alone, whatever waves run through the block. 4.05543 m/s^2 at 30 degrees with mu = 0.1.
TEST(FrictionalWall, LetsABlockSlideAtItsAcceleration) {
  for (const AnyShape& shape : every<AnyShape>()) {
    Block<> block{Rough{.friction = 0.1}, pull_at(30 * degree), shape};
    block.advance(2000);  // it slides
    const double before = block.speed(1) + 0.1 * block.speed(0);

    constexpr int num_steps = 2000;
    block.advance(num_steps);

    const double gained = block.speed(1) + 0.1 * block.speed(0) - before;
    const double acceleration = gravity * (std::sin(30 * degree) - 0.1 * std::cos(30 * degree));
    // Rounding of a speed of 0.2 m/s at each step, and of stresses of 1 kPa that add up to nothing.
    const double rounding =
        rounding_of(1, 3, num_steps) * (0.2 + Block<>::dt * 1e3 / (1000 * Block<>::height));
    EXPECT_NEAR(gained, num_steps * Block<>::dt * acceleration, rounding);
    EXPECT_NEAR(acceleration, 4.05543, 5e-6);  // as printed
  }
}

/// 19.86 m in 5 s at 24 degrees with friction tan 15; started from rest, it takes the time h^2/nu = 1e-4 s
/// until shear has got through the block and it slides.
TEST(FrictionalWall, LetsABlockSlideAsFarAsItShould) {
  Block<> block{Rough{.friction = std::tan(15 * degree)}, pull_at(24 * degree)};

  block.advance(50000);

  EXPECT_NEAR(block.distance, 19.86, 1e-3 * 19.86);
}

/// Solid ground stays: below the angle the block creeps as a fluid of its viscosity over a bed without slip,
/// at most by rho g sin h^2/(2 mu) at its surface.
TEST(FrictionalWall, HoldsABlockBelowItsAngle) {
  const double friction = std::tan(24 * degree);
  Block<> held{Rough{.friction = friction}, pull_at(20 * degree)};
  Block<> let_go{Rough{.friction = friction}, pull_at(28 * degree)};

  held.advance(2000);
  let_go.advance(2000);

  const double creep = 1000 * gravity * std::sin(20 * degree) * 0.1 * 0.1 / (2 * 2e4);
  EXPECT_EQ(held.state->nodes[1][NodeRecord::momentum + 1], 0);
  EXPECT_LT(held.speed(1), creep);
  EXPECT_GT(let_go.speed(1),
            0.9 * 0.2 * gravity * (std::sin(28 * degree) - friction * std::cos(28 * degree)));
}

TEST(FrictionalWall, SlidesAlikeInAllDirections) {
  const auto along = pull_at(30 * degree);
  Block<3> straight{Rough{.friction = 0.3}, {along[0], along[1], 0}};
  Block<3> turned{Rough{.friction = 0.3}, {along[0], 0.6 * along[1], 0.8 * along[1]}};

  constexpr int num_steps = 2000;
  straight.advance(num_steps);
  turned.advance(num_steps);

  // Shear stress dt mu/(rho h^2) speed: a tenth of the speed a step; rounding as before.
  const double tolerance = rounding_of(1, 2, num_steps) * (straight.speed(1) + 0.1);
  EXPECT_NEAR(turned.speed(1), 0.6 * straight.speed(1), tolerance);
  EXPECT_NEAR(turned.speed(2), 0.8 * straight.speed(1), tolerance);
}

/// Material that leaves and shears on the way, on nodes, by one step.
struct Sheared {
  static constexpr double h = 0.125;  // [m]
  static constexpr double shear_rate = -3;
  [[nodiscard]] static double along(double y) { return 2 + shear_rate * y; }

  explicit Sheared(const AnyShape& shape) {
    const auto grid = cube<1>(4, h, false);
    auto particles = filled<1, 2>(grid, 3);
    for (Index p = 0; p < particles.size(); ++p) {
      particles.velocity.component(0)[p] = 1;
      particles.velocity.component(1)[p] = along(particles.position.component(0)[p]);
      particles.velocity_gradient.component(1)[p] = shear_rate;
    }
    auto stages = stages_of<1, 2>(particles, shape, Apic{});
    stages.boundaries.push_back(
        make_frictional_wall<1>(Rough{.friction = 0.5}, {}, Hold::pushes, 0, Side::low));
    state = std::make_unique<State<1, 2>>(start(std::move(particles), grid, stages, one_thread));
    step(*state, stages, 1e-3, one_thread);
  }
  /// Velocity along the wall at the node `number` inwards of it [m/s].
  [[nodiscard]] double at_node(Index number) const {
    return state->nodes[Nodes<1>::num_images + number][NodeRecord::momentum + 1];
  }
  std::unique_ptr<State<1, 2>> state;
};

/// Points sit at 1/6, 1/2, 5/6 and 7/6 of a cell from the wall; what they would give to the image comes home
/// with the speed of the place where it comes, Eq. (M183).
TEST(FrictionalWall, KeepsALinearProfileOfShear) {
  for (const AnyShape& shape : every_shape_for(3)) {
    const Sheared sheared{shape};

    for (const Index n : {0, 1, 2}) {
      EXPECT_NEAR(sheared.at_node(n), sheared.along(static_cast<double>(n) * sheared.h),
                  2 * rounding_of(1, 4, 1));
    }
  }
}

TEST(FrictionalWall, LetsGoWhatAMirrorHoldsBack) {
  for (const bool is_mirror : {true, false}) {
    Block<> block{Rough{.friction = 0.5}, {0, 0}, Quadratic{}, Apic{}, dust};
    if (is_mirror) block.stages.boundaries[0] = make_wall<1>(Slip{}, 0, Side::low);
    for (double& v : block.state->particles.velocity.values()) v = 1;

    block.advance(1);

    const double rounding = rounding_of(1, 3, 1);
    if (is_mirror) {
      EXPECT_LT(block.speed(0), 0.9);
    } else {
      EXPECT_NEAR(block.speed(0), 1, rounding);
    }
    EXPECT_NEAR(block.speed(1), 1, rounding);
  }
}

TEST(FrictionalWall, RefusesAnAxisThatIsNotThere) {
  EXPECT_EQ(
      message_of<InputError>([] {
        static_cast<void>(make_frictional_wall<2>(Rough{.friction = 0}, {}, Hold::pushes, 2, Side::low));
      }),
      "make_frictional_wall: no such axis");
}

/// Beyond an end of it is no image but the other end.
TEST(FrictionalWall, RefusesAPeriodicAxis) {
  EXPECT_EQ(message_of<InputError>([] {
              const auto grid = cube<1>(4, 0.25, true);
              auto particles = filled<1>(grid, 2);
              auto stages = stages_of<1, 1>(particles, Quadratic{}, Apic{});
              stages.boundaries.push_back(
                  make_frictional_wall<1>(Rough{.friction = 0}, {}, Hold::pushes, 0, Side::high));
              static_cast<void>(start(std::move(particles), grid, stages, one_thread));
            }),
            "a wall with friction stands on an axis that is periodic");
}

}  // namespace
}  // namespace scree::mpm
