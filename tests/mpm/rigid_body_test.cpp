#include "bodies.hpp"
#include "dry_wall.hpp"
#include "messages.hpp"

#include <scree/mpm/boundaries/rigid_body.hpp>
#include <scree/mpm/terrain/triangle_surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace scree::mpm {
namespace {

using std::numbers::pi;

constexpr Threads one_thread{1};

TEST(RigidMotion, TurnsAboutItsPivotAndMovesIt) {  // Eq. (M66)
  const RigidMotion<2> motion{.pivot = Vector<2>{1, 0},
                              .place =
                                  [](double t) {
                                    return Vector<2>{1, 3 * t};
                                  },
                              .angle = [](double t) { return pi / 2 * t; }};
  const Pose<2> pose = pose_at(motion, 1);

  EXPECT_NEAR((pose.in_space(Vector<2>{2, 0}) - Vector<2>{1, 4}).norm(), 0, 16 * round_off);
  EXPECT_NEAR((pose.in_body(Vector<2>{1, 4}) - Vector<2>{2, 0}).norm(), 0, 16 * round_off);
}

TEST(RigidMotion, TurnsAboutAnyAxisInSpace) {  // a third of a turn about the diagonal takes x to y to z
  const Matrix<3> turn = turn_about<3>(Vector<3>{1, 1, 1}.normalized(), 2 * pi / 3);

  EXPECT_NEAR((turn - (Matrix<3>{} << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished()).norm(), 0, 64 * round_off);
}

/// A node in a mesh of spacing 1 at (3, 0), below the floor of a turning table, after it held.
TEST(RigidBody, TakesMaterialAlongOnTheChordOfItsWay) {  // Eq. (M67)
  const CartesianGrid<2> grid{Vector<2>{-4, -4}, Vector<2>{1, 1}, {8, 8}, {}};
  Nodes<2> nodes{grid, {.num_velocities = 2, .has_increment = false}};
  const Index n = nodes.place(7, 0) + nodes.place(4, 1) * nodes.stride(1);
  ASSERT_EQ(node_position(nodes, n), (Vector<2>{3, 0}));
  nodes[n][NodeRecord::mass] = 1;
  const double omega = 2;
  const double dt = 0.1;
  const auto table = make_rigid_body<2>(
      Contact<Sticks>{{}, Hold::pushes_and_pulls},
      AnySurface<2>{BallSurface<2>{Vector<2>{0, 0}, 3.5, BallSurface<2>::Material::outside}},
      RigidMotion<2>{.angle = [=](double t) { return omega * t; }});
  table->advance(1);

  table->hold(nodes, dt);

  const Vector<2> chord{3 * (std::cos(omega * dt) - 1) / dt, 3 * std::sin(omega * dt) / dt};
  EXPECT_NEAR(nodes[n][NodeRecord::momentum], chord[0], 64 * round_off / dt);
  EXPECT_NEAR(nodes[n][NodeRecord::momentum + 1], chord[1], 64 * round_off / dt);
}

/// The face x = 0 of a wall that reaches far along y and z, of triangles that look to where x grows.
[[nodiscard]] AnySurface<3> face_of_triangles() {
  return TriangleSurface{{.vertices = {{0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}},
                          .triangles = {{{0, 1, 2}}, {{0, 2, 3}}}}};
}

/// The same in space: a node at (0, 3, 0), on a face of triangles that turns about an oblique axis.
TEST(RigidBody, OfTrianglesTakesMaterialAlongOnTheChordOfItsWay) {  // Eqs. (M65)-(M67)
  const CartesianGrid<3> grid{Vector<3>::Constant(-4), Vector<3>::Constant(1), {8, 8, 8}, {}};
  Nodes<3> nodes{grid, {.num_velocities = 3, .has_increment = false}};
  const Index n =
      nodes.place(4, 0) + nodes.place(7, 1) * nodes.stride(1) + nodes.place(4, 2) * nodes.stride(2);
  const Vector<3> x{0, 3, 0};
  ASSERT_EQ(node_position(nodes, n), x);
  nodes[n][NodeRecord::mass] = 1;
  const double omega = 2;
  const double dt = 0.1;
  const Vector<3> axis = Vector<3>{1, 2, 2} / 3;
  const auto wall =
      make_rigid_body<3>(Contact<Sticks>{{}, Hold::pushes_and_pulls}, face_of_triangles(),
                         RigidMotion<3>{.angle = [=](double t) { return omega * t; }, .axis = axis});

  wall->hold(nodes, dt);

  // Along the axis x stays; across, it turns.
  const Vector<3> along = axis.dot(x) * axis;
  const Vector<3> arm = x - along;
  const Vector<3> ahead{axis[1] * x[2] - axis[2] * x[1], axis[2] * x[0] - axis[0] * x[2],
                        axis[0] * x[1] - axis[1] * x[0]};
  const Vector<3> chord = ((std::cos(omega * dt) - 1) * arm + std::sin(omega * dt) * ahead) / dt;
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(nodes[n][NodeRecord::momentum + static_cast<std::size_t>(i)], chord[i], 64 * round_off / dt);
}

TEST(RigidBody, LeavesMaterialAloneThatMovesWithIt) {
  const Vector<2> velocity{0.3, -0.2};
  auto particles =
      seed_box<2, 2>(cube<2>(8, 0.125, false), Vector<2>{0.25, 0.25}, Vector<2>{0.75, 0.75}, {2, 2}, 1000);
  for (Index p = 0; p < particles.size(); ++p) {
    for (int i = 0; i < 2; ++i) particles.velocity.component(i)[p] = velocity[i];
  }
  auto stages = stages_of<2, 2>(particles, Quadratic{}, Apic{});
  stages.boundaries.push_back(
      make_rigid_body<2>(Contact<Dry>{}, AnySurface<2>{PlaneSurface<2>{Vector<2>{0.3, 0.3}, Vector<2>{1, 2}}},
                         RigidMotion<2>{.place = [=](double t) -> Vector<2> { return t * velocity; }}));
  auto state = start(std::move(particles), cube<2>(8, 0.125, false), stages, one_thread);

  for (int n = 0; n < 10; ++n) step(state, stages, 0.01, one_thread);

  for (Index p = 0; p < state.particles.size(); ++p) {
    for (int i = 0; i < 2; ++i) {
      // Places of nodes, up to 1 m, are rounded and differenced over dt.
      EXPECT_NEAR(state.particles.velocity.component(i)[p], velocity[i],
                  rounding_of(2, 3, 10) + 10 * 4 * round_off / 0.01);
    }
  }
}

/// A piston that sets out softly and then moves at `speed` into a long bar, without friction; in space one of
/// triangles, and a bar of one cell by one between smooth walls.
template <int D>
struct Piston {
  static constexpr double speed = 1e-3;  // [m/s]
  static constexpr double ramp = 0.02;   // [s], to full speed: as long as sound takes for a fifth of the bar
  static constexpr double spacing = 0.01;                            // [m]
  static constexpr double section = D == 1 ? 1 : spacing * spacing;  // [m^(D - 1)]
  static constexpr Fluid bar{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};
  static constexpr double sound = 10;  // [m/s]

  Piston() {
    Indices<D> cells{160};
    Indices<D> per_cell{};
    per_cell.fill(2);
    std::fill(cells.begin() + 1, cells.end(), 1);
    Vector<D> origin = Vector<D>::Zero();
    origin[0] = -0.5;
    Vector<D> end = Vector<D>::Constant(spacing);
    end[0] = 1;
    const CartesianGrid<D> grid{origin, Vector<D>::Constant(spacing), cells, {}};
    auto particles = seed_box<D, D>(grid, Vector<D>::Zero(), end, per_cell, 1000);
    stages = stages_of<D, D>(particles, Linear{}, Apic{}, bar);
    RigidMotion<D> motion{.place = [](double t) -> Vector<D> { return way(t) * Vector<D>::Unit(0); }};
    stages.boundaries.push_back(make_rigid_body<D>(Contact<Slides>{}, face(), std::move(motion)));
    for (int axis = 1; axis < D; ++axis) {
      for (const Side side : {Side::low, Side::high})
        stages.boundaries.push_back(make_wall<D>(Slip{}, axis, side));
    }
    state = std::make_unique<State<D, D>>(start(std::move(particles), grid, stages, one_thread));
  }
  [[nodiscard]] static AnySurface<D> face() {
    if constexpr (D == 3) return face_of_triangles();
    return PlaneSurface<D>{Vector<D>::Zero(), Vector<D>::Unit(0)};
  }
  /// Of the piston, its speed rising by a half wave of cosine.
  [[nodiscard]] static double way(double t) {
    if (t >= ramp) return speed * (t - ramp / 2);
    return speed * (t - ramp / pi * std::sin(pi * t / ramp)) / 2;
  }
  void advance_to(double time) {
    const auto num_steps = static_cast<int>(std::lround((time - now) / dt));
    for (int n = 0; n < num_steps; ++n) step(*state, stages, dt, one_thread);
    now = time;
  }
  [[nodiscard]] double momentum() const { return momentum_of(state->particles, 0).total; }
  /// Of motion, and of compression to its square [J per m^(3 - D)].
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (Index p = 0; p < state->particles.size(); ++p) {
      const double m = state->particles.mass.component(0)[p];
      const double v = state->particles.velocity.component(0)[p];  // across it does not move
      const double compression = state->particles.density.component(0)[p] / 1000 - 1;
      sum += m * (v * v + sound * sound * compression * compression) / 2;
    }
    return sum;
  }
  static constexpr double dt = 1e-4;  // [s], a tenth of what sound takes for a cell
  Stages<D, D> stages;
  std::unique_ptr<State<D, D>> state;
  double now = 0;
};

/// Behind the front the pressure is rho c w, so momentum grows by that in each second. What is left of the
/// start has the length of the ramp, 20 cells: waves of that length are slow by (k h)^2/24, k = pi/0.2 m;
/// speeds are w/c of that of sound.
template <int D>
void expect_the_momentum_of_a_piston() {  // Eq. (M68)
  Piston<D> piston;
  piston.advance_to(0.04);
  const double before = piston.momentum();

  piston.advance_to(0.08);

  const double exact = 1000 * piston.sound * piston.speed * piston.section * 0.04;
  const double kh = pi / 20;
  EXPECT_NEAR(piston.momentum() - before, exact, exact * (kh * kh / 24 + piston.speed / piston.sound));
}

TEST(RigidBody, CompressesABarAsAPiston) {
  expect_the_momentum_of_a_piston<1>();
}

TEST(RigidBody, OfTrianglesCompressesABarAsAPiston) {
  expect_the_momentum_of_a_piston<3>();
}

/// Force times way of the piston is what the bar gains, to the same accuracy: half of it as motion.
TEST(RigidBody, DoesTheWorkOfItsForce) {
  Piston<1> piston;
  piston.advance_to(0.04);
  const double energy = piston.energy();
  const double momentum = piston.momentum();

  piston.advance_to(0.08);

  const double work = piston.speed * (piston.momentum() - momentum);
  const double kh = pi / 20;
  EXPECT_NEAR(piston.energy() - energy, work, 2 * work * (kh * kh / 24 + piston.speed / piston.sound));
}

/// Speed of a node at rest after a ball of radius 0.05 has gone past, by `way` in each step, a step on each
/// side of the node as far from it.
[[nodiscard]] double pushed_by_steps_of(double way) {
  Nodes<1> nodes{CartesianGrid<1>{Vector<1>{-1.0}, Vector<1>{0.1}, {20}, {}},
                 {.num_velocities = 1, .has_increment = false}};
  double* node = nodes[nodes.place(10, 0)];
  node[NodeRecord::mass] = 1;
  const auto ball = make_rigid_body<1>(
      Contact<Slides>{},
      AnySurface<1>{BallSurface<1>{Vector<1>{0.0}, 0.05, BallSurface<1>::Material::outside}},
      RigidMotion<1>{.place = [=](double t) { return Vector<1>{way * (t - 9.5)}; }});
  for (int n = 0; n < 20; ++n) {
    ball->hold(nodes, 1);
    ball->advance(1);
  }
  return node[NodeRecord::momentum];
}

/// Where it fails: a body that goes further in a step than it reaches, its size and a cell on both sides,
/// jumps over what is between. Here that is 0.3 m.
TEST(RigidBody, JumpsOverMaterialInStepsLongerThanItsReach) {
  EXPECT_NEAR(pushed_by_steps_of(0.29), 0.29, 64 * round_off);
  EXPECT_EQ(pushed_by_steps_of(0.31), 0);
}

TEST(RigidMotion, RefusesAnAxisThatIsNone) {
  EXPECT_EQ(message_of<InputError>([] {
              check(RigidMotion<3>{.axis = Vector<3>{0, 0, 2}});
            }),
            "RigidMotion: the axis must be of unit length");
  EXPECT_EQ(message_of<InputError>([] {
              check(RigidMotion<2>{.angle = [](double t) { return t; }, .axis = Vector<3>{1, 0, 0}});
            }),
            "RigidMotion: in two dimensions a body turns about z, in one not at all");
  EXPECT_EQ(message_of<InputError>([] { check(RigidMotion<1>{.pivot = Vector<1>{std::nan("")}}); }),
            "RigidMotion: the pivot must be finite");
}

}  // namespace
}  // namespace scree::mpm
