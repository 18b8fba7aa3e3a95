#include "bodies.hpp"
#include "dry_wall.hpp"
#include "rubber.hpp"

#include <scree/mpm/boundaries/bed.hpp>
#include <scree/mpm/geostatic.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // [m/s^2]

/// The points of those `particles` that lie above a surface.
template <int D, int V>
void keep_above(Particles<D, V>& particles, const AnySurface<D>& surface) {
  std::vector<Index> above;
  for (Index p = 0; p < particles.size(); ++p) {
    Vector<D> x;
    for (int axis = 0; axis < D; ++axis) x[axis] = particles.position.component(axis)[p];
    if (surface(x).distance > 0) above.push_back(p);
  }
  particles.for_each_column([&](Column& column) { column.reorder(above); });
}

/// Mean position and velocity of all points.
struct Mean {
  Vector<2> position = Vector<2>::Zero();
  Vector<2> velocity = Vector<2>::Zero();
};
[[nodiscard]] Mean mean_of(const Particles<2>& particles) {
  Mean mean;
  double mass = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double m = particles.mass.component(0)[p];
    mass += m;
    for (int axis = 0; axis < 2; ++axis) {
      mean.position[axis] += m * particles.position.component(axis)[p];
      mean.velocity[axis] += m * particles.velocity.component(axis)[p];
    }
  }
  return {mean.position / mass, mean.velocity / mass};
}

/// A block of 1 m x 0.5 m on a slope that cuts the mesh obliquely.
struct SlidingBlock {
  static constexpr double spacing = 0.25;  // [m]
  static constexpr double rounding_speed = 10;

  SlidingBlock(double angle, double friction, double run)
      : downhill{std::cos(angle), -std::sin(angle)}, normal{std::sin(angle), std::cos(angle)} {
    const auto cells = [](double length) { return static_cast<Index>(std::ceil(length / spacing)); };
    const CartesianGrid<2> grid{Vector<2>{0, 0},
                                Vector<2>{spacing, spacing},
                                {cells((run + 2) * downhill[0] + 2), cells(3 - (run + 2) * downhill[1])},
                                {false, false}};
    const Vector<2> foot{0.5, grid.length(1) - 1.5};
    auto particles = on_slope(foot + 0.5 * downhill);
    stages.stress = std::make_unique<StressUpdateBy<2, 2, Rubber>>(Rubber{1e6, 6e5, 1000}, particles);
    stages.transfer = make_transfer<2, 2>(Quadratic{}, Apic{});
    stages.gravity = {0, -gravity};
    stages.boundaries.push_back(
        make_bed<2>(Contact<Dry>{Dry{friction}}, grid, PlaneSurface<2>{foot, normal}));
    state = std::make_unique<State<2, 2>>(start(std::move(particles), grid, stages, one_thread));
    begin = mean_of(state->particles).position;
  }

  [[nodiscard]] Particles<2> on_slope(const Vector<2>& corner) const {
    constexpr Index along = 8;
    constexpr Index across = 4;
    constexpr double edge = spacing / 2;
    Particles<2> particles;
    particles.resize(along * across);
    for (Index p = 0; p < particles.size(); ++p) {
      const Index row = p / along;
      const Vector<2> x = corner + edge * (static_cast<double>(p % along) + 0.5) * downhill +
                          edge * (static_cast<double>(row) + 0.5) * normal;
      for (int axis = 0; axis < 2; ++axis) particles.position.component(axis)[p] = x[axis];
      particles.density.component(0)[p] = 1000;
      particles.mass.component(0)[p] = 1000 * edge * edge;
      particles.id.component(0)[p] = static_cast<double>(p);
    }
    return particles;
  }

  void advance_to(double end) {
    while (time < end) {
      const double limit = stable_time_step(state->nodes.grid(), state->rates, {}).dt;
      const double dt = std::min(limit, end - time);
      step(*state, stages, dt, one_thread);
      time = dt < limit ? end : time + dt;
      ++num_steps;
    }
  }
  [[nodiscard]] double distance() const { return (mean_of(state->particles).position - begin).dot(downhill); }
  /// Velocity along the bed and mu times that across [m/s].
  [[nodiscard]] double slid(double friction) const {
    const Vector<2> velocity = mean_of(state->particles).velocity;
    return velocity.dot(downhill) + friction * velocity.dot(normal);
  }

  Vector<2> downhill;
  Vector<2> normal;
  Vector<2> begin;
  Stages<2, 2> stages;
  std::unique_ptr<State<2, 2>> state;
  double time = 0;
  int num_steps = 0;
};

/// 19.86 m in 5 s at 24 degrees with friction tan 15, as printed, to the 1e-3 that is asked of the method.
/// What is not exact are the first instants: the block starts without stress, and until its weight has run
/// through it parts of it do not slide.
TEST(Bed, LetsABlockSlideAsFarAsItShould) {  // Eq. (M63)
  const double friction = std::tan(15 * degree);
  SlidingBlock block{24 * degree, friction, 20};

  block.advance_to(5);

  const double exact = gravity * (std::sin(24 * degree) - friction * std::cos(24 * degree)) * 25 / 2;
  EXPECT_NEAR(exact, 19.86, 0.005);
  EXPECT_NEAR(block.distance(), exact, 1e-3 * exact);
}

/// Momentum along and mu times that across change by the weight alone while all of the block slides,
/// whichever way the bed cuts the mesh: 4.05543 m/s^2 at 30 degrees with mu = 0.1.
TEST(Bed, LetsABlockSlideAtItsAcceleration) {
  SlidingBlock block{30 * degree, 0.1, 9};
  block.advance_to(0.5);
  const double before = block.slid(0.1);
  const int steps_before = block.num_steps;

  block.advance_to(2);

  const double acceleration = gravity * (std::sin(30 * degree) - 0.1 * std::cos(30 * degree));
  EXPECT_NEAR(acceleration, 4.05543, 5e-6);
  // Rounding of velocities up to 10 m/s on the way of each step.
  EXPECT_NEAR(block.slid(0.1) - before, 1.5 * acceleration,
              rounding_of(2, 3, block.num_steps - steps_before) * SlidingBlock::rounding_speed);
}

/// The largest share of its pressure that a bed had to bear as friction, to hold all that touched it.
struct Needed {
  static constexpr std::string_view name = "needed";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  double* share;

  template <class Real>
  [[nodiscard]] Real traction(const Real&, const Real&, const Input<Real>&) const noexcept {
    return 0;
  }
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>&) const noexcept {
    *share = std::max(*share, speed / (contact.mobility * contact.pressure));
    return 0;
  }
};
static_assert(WallLaw<Needed>);

/// Water that rests on a bed at 20 degrees between two smooth walls.
template <class Law>
struct Pool {
  static constexpr double depth = 1.4;         // [m]
  static constexpr double compression = 1e-3;  // rho g H/K
  static constexpr Index num_cells = 20;
  static constexpr double spacing = 0.1;
  static constexpr Fluid water{1000 * gravity * depth / compression, 1000, 0};

  explicit Pool(const Law& law, const AnyShape& shape = Linear{}, double lowered = 0) {
    const auto grid = cube<2>(num_cells, spacing, false);
    const Vector<2> normal{-std::sin(20 * degree), std::cos(20 * degree)};
    const Vector<2> foot{0, 0.137};
    auto particles = seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{2, depth}, {2, 2}, 1000);
    keep_above<2>(particles, PlaneSurface<2>{foot, normal});
    stages = stages_of<2, 2>(particles, shape, Apic{}, water);
    stages.gravity = {0, -gravity};
    for (const Side side : {Side::low, Side::high})
      stages.boundaries.push_back(make_wall<2>(Slip{}, 0, side));
    const PlaneSurface<2> bed{foot - lowered * normal, normal};
    stages.boundaries.push_back(make_bed<2>(Contact<Law>{law}, grid, bed));
    set_geostatic(particles, *stages.stress, 1, depth, gravity);
    state = std::make_unique<State<2, 2>>(start(std::move(particles), grid, stages, one_thread));
  }
  /// Largest speed on the way of `num_steps`, over that of sound.
  [[nodiscard]] double unrest(int num_steps) {
    const double dt = stable_time_step(state->nodes.grid(), state->rates, {}).dt;
    double fastest = 0;
    for (int n = 0; n < num_steps; ++n) {
      step(*state, stages, dt, one_thread);
      fastest = std::max(fastest, largest(state->particles.velocity));
    }
    return fastest / state->rates.wave_speed;
  }
  /// Largest error of the pressure, over that at the bottom.
  [[nodiscard]] double pressure_error() const {
    double error = 0;
    const auto& particles = state->particles;
    for (Index p = 0; p < particles.size(); ++p) {
      const double rest = 1000 * gravity * (depth - particles.position.component(1)[p]);
      error = std::max(error, std::abs(-particles.stress.component(0)[p] - rest));
    }
    return error / (1000 * gravity * depth);
  }
  Stages<2, 2> stages;
  std::unique_ptr<State<2, 2>> state;
};

/// What the compression of a cell leaves out of balance, its square, and rounding as in a column at rest.
[[nodiscard]] double rest(int num_steps) {
  const double per_cell = 1e-3 / 14;
  return 2 * num_steps * round_off + per_cell * per_cell;
}

TEST(Bed, HoldsAPoolAtRestThatItCutsObliquely) {  // the nodes that feel its pressure are those it holds
  constexpr int num_steps = 200;
  Pool<Sticks> pool{Sticks{}};
  EXPECT_LE(pool.unrest(num_steps), rest(num_steps));
  EXPECT_LE(pool.pressure_error(), 1e-3 + 1e-3);  // of the density's, and as much of the mesh's
}

/// Where it fails: points fill the cells that a bed cuts in steps, so that their pressure pushes along it
/// too. A bed bears that up to its friction; smoother ones let material go, and then their pressure rings.
TEST(Bed, HoldsAPoolAtRestFromAFrictionThatCanBeTold) {
  constexpr int num_steps = 100;
  double share = 0;
  Pool<Needed> probe{Needed{&share}};
  static_cast<void>(probe.unrest(1));
  ASSERT_GT(share, 0.1);
  ASSERT_LT(share, 1);

  Pool<Dry> rough{Dry{1.05 * share}};
  Pool<Dry> smooth{Dry{0.5 * share}};

  EXPECT_LE(rough.unrest(num_steps), rest(num_steps));

  EXPECT_GT(smooth.unrest(num_steps), 10 * rest(num_steps));
}

/// Where it would fail: a bed that holds only nodes below it does not bear the pressure of the others.
TEST(Bed, WouldNotBearThePressureByTheNodesBelowItAlone) {
  const double reach = Pool<Sticks>::spacing * (std::sin(20 * degree) + std::cos(20 * degree));
  Pool<Sticks> lowered{Sticks{}, Linear{}, reach};

  static_cast<void>(lowered.unrest(200));

  EXPECT_GT(lowered.pressure_error(), 1);
}

/// Where it fails: quadratic shapes reach half a cell further than hats. A plane a cell away takes the share
/// 1/2 (3/2 - 1)^2 = 1/8 of what a node there feels.
TEST(Bed, LeavesNodesBeyondItATailOfThePressureUnderQuadraticShapes) {
  Pool<Sticks> linear{Sticks{}};
  Pool<Sticks> quadratic{Sticks{}, Quadratic{}};

  static_cast<void>(linear.unrest(200));
  static_cast<void>(quadratic.unrest(200));
  EXPECT_GT(quadratic.pressure_error(), linear.pressure_error());
  EXPECT_LE(quadratic.pressure_error(), 1.0 / 8);
}

/// One point that slides down a bowl of radius 1 m from 60 degrees, and its speed at the bottom over that of
/// free fall, less one.
[[nodiscard]] double speed_error(double spacing, double dt, const AnyTransfer& transfer) {
  const auto num_cells = static_cast<Index>(std::ceil(1.2 / spacing));
  const CartesianGrid<2> grid{
      Vector<2>{-1, -0.2}, Vector<2>{spacing, spacing}, {num_cells, num_cells}, {false, false}};
  const Vector<2> centre{0, 1};
  Particles<2> particles;
  particles.resize(1);
  const double radius = 1 - spacing / 4;
  particles.position.component(0)[0] = centre[0] - radius * std::sin(60 * degree);
  particles.position.component(1)[0] = centre[1] - radius * std::cos(60 * degree);
  particles.mass.component(0)[0] = particles.density.component(0)[0] = 1000;
  const double top = particles.position.component(1)[0];
  auto stages = stages_of<2, 2>(particles, Linear{}, transfer, dust);
  stages.gravity = {0, -gravity};
  stages.boundaries.push_back(
      make_bed<2>(Contact<Slides>{}, grid, BallSurface<2>{centre, 1, BallSurface<2>::Material::inside}));
  auto state = start(std::move(particles), grid, stages, one_thread);
  while (state.particles.position.component(0)[0] < 0) step(state, stages, dt, one_thread);
  const double fall = top - state.particles.position.component(1)[0];
  const double speed =
      std::hypot(state.particles.velocity.component(0)[0], state.particles.velocity.component(1)[0]);
  return speed / std::sqrt(2 * gravity * fall) - 1;
}

/// Normals turn by h/R from node to node, which costs their square; and by omega dt from step to step, which
/// costs omega dt/2 over each radian were all nodes to meet it alike: with omega up to 3.1/s and pi/3 of way
/// less than 1.7 dt/s. A lone point is found to lose more, 2 to 7 dt/s.
TEST(Bed, LetsAPointFallThroughABowlAsFree) {
  const double coarse = speed_error(0.1, 1e-4, Apic{});
  const double fine = speed_error(0.025, 1e-4, Apic{});
  EXPECT_LE(std::abs(fine), 1e-3);
  EXPECT_LT(coarse, fine);
  EXPECT_GT(coarse / fine, 4);
}

/// A strip of rubber, two cells thick and 0.3 m long, along a bowl of radius 1 m at 60 degrees: it slides,
/// and so turns about the bowl's centre.
struct StripInABowl {
  explicit StripInABowl(double spacing)
      : grid{Vector<2>{-1.1, -0.2},
             Vector<2>::Constant(spacing),
             {static_cast<Index>(std::ceil(1.4 / spacing)), static_cast<Index>(std::ceil(1.3 / spacing))},
             {false, false}} {
    const double pitch = spacing / 2;
    const auto num_along = static_cast<Index>(0.3 / pitch);
    particles.resize(4 * num_along);
    for (Index p = 0; p < particles.size(); ++p) {
      const double radius = 1 - (static_cast<double>(p % 4) + 0.5) * pitch;
      const Index along = p / 4 - num_along / 2;
      const double angle = 60 * degree + static_cast<double>(along) * pitch;
      particles.position.component(0)[p] = -radius * std::sin(angle);
      particles.position.component(1)[p] = 1 - radius * std::cos(angle);
      particles.mass.component(0)[p] = rubber.density * radius * pitch * pitch;
      particles.density.component(0)[p] = rubber.density;
    }
    stages.stress = std::make_unique<StressUpdateBy<2, 2, Rubber>>(rubber, particles);
    stages.transfer = make_transfer<2, 2>(Quadratic{}, Apic{});
    stages.gravity = {0, -gravity};
    stages.boundaries.push_back(make_bed<2>(
        Contact<Slides>{}, grid, BallSurface<2>{Vector<2>{0, 1}, 1, BallSurface<2>::Material::inside}));
  }
  static constexpr Rubber rubber{.bulk_modulus = 1.33e6, .shear_modulus = 0.5e6, .density = 1000};

  CartesianGrid<2> grid;
  Particles<2> particles;
  Stages<2, 2> stages;
};

/// Angular momentum of a strip at the bottom over that of free fall, sqrt(2 m g fall I), less one.
[[nodiscard]] double spin_error(double spacing, double dt) {
  StripInABowl strip{spacing};
  double mass = 0;
  double inertia = 0;  // I, about the bowl's centre
  for (Index p = 0; p < strip.particles.size(); ++p) {
    const double m = strip.particles.mass.component(0)[p];
    mass += m;
    inertia += m * (std::pow(strip.particles.position.component(0)[p], 2) +
                    std::pow(strip.particles.position.component(1)[p] - 1, 2));
  }
  const double top = mean_of(strip.particles).position[1];
  auto state = start(std::move(strip.particles), strip.grid, strip.stages, one_thread);
  Mean mean = mean_of(state.particles);
  while (mean.position[0] < 0) {
    step(state, strip.stages, dt, one_thread);
    mean = mean_of(state.particles);
  }
  double spin = 0;
  for (Index p = 0; p < state.particles.size(); ++p) {
    const auto of = [&](const Column& column, int axis) { return column.component(axis)[p]; };
    spin += of(state.particles.mass, 0) *
            (of(state.particles.position, 0) * of(state.particles.velocity, 1) -
             (of(state.particles.position, 1) - 1) * of(state.particles.velocity, 0));
  }
  return spin / std::sqrt(2 * mass * gravity * (top - mean.position[1]) * inertia) - 1;
}

/// As of a point, if all nodes meet a turn alike, steps take 1.7 dt/s (0.8 are found), and never is there
/// more than free fall has. Were each node met like a bend of h/R, all of the way, pi/3, would cost (pi/3)
/// (h/R)/2, first order. But the affine velocity turns the body on between nodes, and what is left is of
/// second order, to the nearest whole one, less than a single such bend costs.
TEST(Bed, LetsABodyFallThroughABowlAsFree) {
  constexpr double dt = 5e-5;  // [s], a fifth of h/c or less
  constexpr double of_steps = 1.7 * dt;
  const double coarse = -spin_error(1.0 / 20, dt);
  const double fine = -spin_error(1.0 / 40, dt);

  EXPECT_GE(fine, 0);
  EXPECT_LE(fine, std::pow(1.0 / 40, 2) / 2);
  EXPECT_LE(coarse, std::pow(1.0 / 20, 2) / 2);
  EXPECT_GE(std::log2(coarse / fine), 1.5);  // as if steps took nothing
  ASSERT_GT(fine, of_steps);
  EXPECT_LE(std::log2((coarse - of_steps) / (fine - of_steps)), 2.5);  // and as if they took all they may
}

/// Where it fails: without an affine part, a point's velocity is as one on all nodes about it, and those
/// ahead stop it; it is thrown off the bed, which it meets again: an error in proportion to h/R.
TEST(Bed, ThrowsAPointOffABowlUnderFlip) {
  EXPECT_LT(speed_error(0.025, 1e-4, PicFlip{1}), 5 * speed_error(0.025, 1e-4, Apic{}));
}

/// A film of oil on a bed that lies anywhere in a cell, gravity along it, when it has become steady.
[[nodiscard]] double surface_speed(double bed, Index num_cells) {
  const double spacing = 1.0 / static_cast<double>(num_cells);
  const CartesianGrid<1> grid{Vector<1>{-4 * spacing}, Vector<1>{spacing}, {num_cells + 4}, {false}};
  auto particles = seed_box<1, 2>(grid, Vector<1>{bed}, Vector<1>{1.0}, {4}, 1000);
  auto stages = stages_of<1, 2>(particles, Linear{}, Apic{}, {1e5, 1000, 1000});
  stages.gravity = {0, 2};
  stages.boundaries.push_back(make_bed<1>(Contact<Sticks>{{}, Hold::pushes_and_pulls}, grid,
                                          PlaneSurface<1>{Vector<1>{bed}, Vector<1>{1.0}}));
  auto state = start(std::move(particles), grid, stages, one_thread);
  const double dt = 0.2 * spacing * spacing;
  for (double time = 0; time < 6; time += dt) step(state, stages, dt, one_thread);
  return largest(state.particles.velocity);
}

/// No slip is where the outermost node stands that feels the bed, less than a cell above: the film is thinner
/// by that, so the error is of first order in h.
TEST(Bed, DisplacesAFilmByTheDistanceOfItsOutermostNode) {
  for (const Index num_cells : {10, 20}) {
    const double spacing = 1.0 / static_cast<double>(num_cells);
    for (const double cut : {0.25, 0.75}) {
      const double thickness = 1 - spacing;  // of what flows above that node
      const double expected = 1000 * 2 * thickness * thickness / (2 * 1000);

      // The topmost point is h/8 below the surface; central differences are of second order; e^(-pi^2 6/4).
      EXPECT_NEAR(surface_speed(cut * spacing, num_cells), expected, spacing * spacing + 1e-6);
    }
  }
}

}  // namespace
}  // namespace scree::mpm
