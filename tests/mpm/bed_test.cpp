#include "bodies.hpp"
#include "dry_wall.hpp"
#include "rubber.hpp"

#include <scree/mpm/boundaries/bed.hpp>
#include <scree/mpm/terrain/height_field.hpp>
#include <scree/mpm/terrain/triangle_surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // [m/s^2]

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

/// A slope that no axis of the mesh runs along, 0.3 down along x and 0.2 along y, as a plane, as a raster and
/// as triangles.
struct SlopeInSpace {
  [[nodiscard]] static double height(double x, double y) { return 1 - 0.3 * x - 0.2 * y; }  // [m]
  [[nodiscard]] static AnySurface<3> plane() {
    return PlaneSurface<3>{Vector<3>{0, 0, height(0, 0)}, Vector<3>{0.3, 0.2, 1}};
  }
  [[nodiscard]] static AnySurface<3> raster() {
    const Lattice<2> sites{
        .count = {9, 9}, .spacing = Vector<2>::Constant(0.5), .first = Vector<2>::Constant(-1)};
    std::vector<double> heights;
    heights.reserve(81);
    for (Index i = 0; i < sites.num_sites(); ++i) {
      const Vector<2> x = sites.position(sites.site(i));
      heights.push_back(height(x[0], x[1]));
    }
    return HeightField<3>{MapField<2>{sites, heights}};
  }
  [[nodiscard]] static AnySurface<3> triangles() {
    TriangleMesh mesh;
    for (const auto& [x, y] : {std::pair{-1, -1}, {3, -1}, {3, 3}, {-1, 3}})
      mesh.vertices.emplace_back(x, y, height(x, y));
    mesh.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
    return TriangleSurface{mesh};
  }
};

/// A block of 0.5 m x 0.5 m x 0.25 m that slides down that slope, at 2 m/s when it begins.
struct SlidingBlockInSpace {
  static constexpr double spacing = 0.125;  // [m]
  static constexpr double friction = 0.1;
  static constexpr double rounding_speed = 4;

  explicit SlidingBlockInSpace(const AnySurface<3>& surface) {
    const CartesianGrid<3> grid{
        Vector<3>::Zero(), Vector<3>::Constant(spacing), {16, 16, 12}, {false, false, false}};
    auto particles = at_the_top();
    stages.stress = std::make_unique<StressUpdateBy<3, 3, Rubber>>(Rubber{1e6, 6e5, 1000}, particles);
    stages.transfer = make_transfer<3, 3>(Quadratic{}, Apic{});
    stages.gravity = {0, 0, -gravity};
    stages.boundaries.push_back(make_bed<3>(Contact<Dry>{Dry{friction}}, grid, surface));
    state = std::make_unique<State<3, 3>>(start(std::move(particles), grid, stages, one_thread));
  }

  [[nodiscard]] Particles<3> at_the_top() const {
    constexpr double edge = spacing / 2;
    const Vector<3> corner{0.4, 0.4, SlopeInSpace::height(0.4, 0.4)};
    Particles<3> particles;
    particles.resize(256);  // 8 x 8 x 4
    for (Index p = 0; p < particles.size(); ++p) {
      const auto share = [](Index i) { return edge * (static_cast<double>(i) + 0.5); };
      const Vector<3> x =
          corner + share(p % 8) * downhill + share(p / 8 % 8) * across + share(p / 64) * normal;
      for (int axis = 0; axis < 3; ++axis) {
        particles.position.component(axis)[p] = x[axis];
        particles.velocity.component(axis)[p] = 2 * downhill[axis];
      }
      particles.density.component(0)[p] = 1000;
      particles.mass.component(0)[p] = 1000 * edge * edge * edge;
      particles.id.component(0)[p] = static_cast<double>(p);
    }
    return particles;
  }
  void advance(int num_steps) {
    for (int n = 0; n < num_steps; ++n) {
      step(*state, stages, dt, one_thread);
      const auto& particles = state->particles;
      for (Index p = 0; p < particles.size(); ++p) {
        Vector<3> v;
        for (int axis = 0; axis < 3; ++axis) v[axis] = particles.velocity.component(axis)[p];
        widest = std::max(widest, std::abs(v.dot(across)) / v.dot(downhill));
      }
    }
  }

  const Vector<3> normal = Vector<3>{0.3, 0.2, 1}.normalized();
  const Vector<3> downhill = (Vector<3>{0, 0, -1} + normal[2] * normal).normalized();
  const Vector<3> across = Vector<3>{normal[1] * downhill[2] - normal[2] * downhill[1],
                                     normal[2] * downhill[0] - normal[0] * downhill[2],
                                     normal[0] * downhill[1] - normal[1] * downhill[0]};
  static constexpr double dt = 1e-3;  // [s], a third of what sound takes for a cell
  Stages<3, 3> stages;
  std::unique_ptr<State<3, 3>> state;
  double widest = 0;  ///< tangent of the widest angle between a point's way and the slope's
};

/// In space too momentum along the slope and mu times that into it change by the weight alone, but for parts
/// of the block that swing across as it settles: of the friction of what slides at an angle alpha to the
/// slope 1 - cos alpha < tan^2 alpha/2 is missing along it, and sin alpha acts across. That is so in free
/// flight too: the bed bears the weight if less than a tenth of what that gives in the time goes into it.
TEST(Bed, LetsABlockSlideDownAnySlopeInSpace) {  // Eqs. (M60), (M63), (M65)
  constexpr int num_steps = 250;
  const double time = num_steps * SlidingBlockInSpace::dt;
  for (const auto& surface : {SlopeInSpace::plane(), SlopeInSpace::raster(), SlopeInSpace::triangles()}) {
    SlidingBlockInSpace block{surface};

    block.advance(num_steps);

    const Vector<3> gained = mean_of(block.state->particles).velocity - 2 * block.downhill;
    const double impulse = block.friction * gravity * block.normal[2] * time;
    const double exact = gravity * -block.downhill[2] * time - impulse;
    const double rounding = rounding_of(3, 3, num_steps) * SlidingBlockInSpace::rounding_speed;
    EXPECT_LT(std::abs(gained.dot(block.normal)), 0.1 * gravity * block.normal[2] * time);
    EXPECT_NEAR(gained.dot(block.downhill) + block.friction * gained.dot(block.normal), exact,
                impulse * block.widest * block.widest / 2 + rounding);
    EXPECT_NEAR(gained.dot(block.across), 0, impulse * block.widest + rounding);
    EXPECT_LT(block.widest, 0.01);  // so that a friction wrong by 1e-4 is seen
  }
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
