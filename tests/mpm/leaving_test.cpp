#include "bodies.hpp"
#include "messages.hpp"
#include "same_bits.hpp"

#include <scree/mpm/leaving.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace scree::mpm {
namespace {

/// Dust of unequal masses that flies through a mesh with a label that each point carries.
template <int D>
struct Flight {
  explicit Flight(Leaving leaving, Threads threads_ = {1}) : threads{threads_} {
    const auto grid = cube<D>(24, 0.125, false);
    auto particles = scattered<D>(grid, 600, 0.5);
    label = particles.add_column({"label", "l", "-"}, 1);
    for (Index p = 0; p < particles.size(); ++p) {
      particles.velocity.component(0)[p] = 3;
      particles.velocity.component(1)[p] = -0.5;
      if constexpr (D == 3) particles.velocity.component(2)[p] = 0.25;
      particles.column(label).component(0)[p] = particles.id.component(0)[p] + 0.5;
    }
    stages = stages_of<D, D>(particles, Quadratic{}, Apic{});
    stages.leaving = leaving;
    stages.mass_floor = 0;  // [-]: else what lighter nodes than that get of lone points is lost
    state = std::make_unique<State<D, D>>(start(std::move(particles), grid, stages, threads));
  }
  void advance(int num_steps) {
    for (int n = 0; n < num_steps; ++n) step(*state, stages, 0.01, threads);
  }
  [[nodiscard]] double mass() const {
    double sum = 0;
    for (const double m : state->particles.mass.values()) sum += m;
    return sum;
  }
  Threads threads;
  std::size_t label = 0;
  Stages<D, D> stages;
  std::unique_ptr<State<D, D>> state;
};

template <int D>
void expect_that_absorbed_is_what_is_missing() {
  Flight<D> flight{Leaving::absorb};
  const double mass = flight.mass();
  const Momentum momentum = momentum_of(flight.state->particles, 0);
  constexpr int num_steps = 50;  // a way of 1.5 m of 3

  flight.advance(num_steps);

  const Passed<D>& absorbed = flight.state->absorbed;
  Index left = 0;
  for (const double m : flight.state->particles.mass.values()) left += m > 0 ? 1 : 0;
  EXPECT_GT(absorbed.count, 100);
  EXPECT_EQ(absorbed.count + left, 600);
  EXPECT_NEAR(absorbed.mass + flight.mass(), mass, 600 * round_off * mass);  // sums of 600
  EXPECT_NEAR(absorbed.momentum[0] + momentum_of(flight.state->particles, 0).total, momentum.total,
              (600 * round_off + rounding_of(D, 3, num_steps)) * momentum.size);
}

TEST(Absorb, CountsWhatIsMissing) {
  expect_that_absorbed_is_what_is_missing<2>();
  expect_that_absorbed_is_what_is_missing<3>();
}

TEST(Absorb, KeepsWhatTheOthersCarry) {
  Flight<2> flight{Leaving::absorb};

  flight.advance(50);

  const auto& particles = flight.state->particles;
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    EXPECT_EQ(particles.column(flight.label).component(0)[p], particles.id.component(0)[p] + 0.5);
  }
}

TEST(Leaving, HasTheSameBitsForAnyNumberOfThreads) {
  for (const Leaving leaving : {Leaving::absorb, Leaving::reflect}) {
    Flight<2> one{leaving};
    one.advance(50);
    for (const int threads : {2, 3, 4}) {
      Flight<2> several{leaving, Threads{threads}};

      several.advance(50);

      EXPECT_EQ(one.state->absorbed.mass, several.state->absorbed.mass);
      EXPECT_EQ(one.state->absorbed.momentum, several.state->absorbed.momentum);
      expect_same_bits(one.state->particles, several.state->particles);
    }
  }
}

TEST(Absorb, EndsWithAnEmptyMesh) {
  Flight<2> flight{Leaving::absorb};

  flight.advance(120);

  EXPECT_EQ(flight.state->absorbed.count, 600);
  EXPECT_EQ(flight.state->particles.size(), 0);
}

/// Mirrored places stay in the mesh, and speed is as it was where dust meets no other dust.
TEST(Reflect, ThrowsPointsBackWithTheirSpeed) {
  const auto grid = cube<2>(4, 0.25, false);
  Particles<2> particles;
  particles.resize(2);
  for (Index p = 0; p < 2; ++p) particles.mass.component(0)[p] = 1;
  particles.position.component(0)[0] = 1.0625;
  particles.position.component(1)[0] = -0.125;
  particles.velocity.component(0)[0] = 2;
  particles.velocity.component(1)[0] = 1;  // on its way back already
  particles.position.component(0)[1] = 0.5;
  particles.position.component(1)[1] = 1;  // on the end is inside
  particles.velocity.component(1)[1] = 3;

  reflect_outside(particles, grid);

  EXPECT_EQ(particles.position.component(0)[0], 0.9375);
  EXPECT_EQ(particles.position.component(1)[0], 0.125);
  EXPECT_EQ(particles.velocity.component(0)[0], -2);
  EXPECT_EQ(particles.velocity.component(1)[0], 1);
  EXPECT_EQ(particles.position.component(1)[1], 1);
  EXPECT_EQ(particles.velocity.component(1)[1], 3);
}

template <int D>
void expect_that_all_mass_stays() {
  Flight<D> flight{Leaving::reflect};
  const double mass = flight.mass();

  flight.advance(150);

  EXPECT_EQ(flight.state->absorbed.count, 0);
  EXPECT_NEAR(flight.mass(), mass, 600 * round_off * mass);
}

TEST(Reflect, KeepsAllMassInTheMesh) {
  expect_that_all_mass_stays<2>();
  expect_that_all_mass_stays<3>();
}

TEST(Leaving, IsNoneThroughAPeriodicAxis) {
  const CartesianGrid<1> grid{Vector<1>{0.0}, Vector<1>{0.25}, {4}, {true}};
  Particles<1> particles;
  particles.resize(1);
  particles.mass.component(0)[0] = 1;
  particles.position.component(0)[0] = 1.5;

  reflect_outside(particles, grid);

  EXPECT_EQ(absorb_outside(particles, grid).count, 0);
  EXPECT_EQ(particles.position.component(0)[0], 1.5);
}

/// What is said of the first point for which this is true.
template <class Test>
[[nodiscard]] std::string text_of_first(const Particles<2>& particles, const Test& test) {
  for (Index p = 0; p < particles.size(); ++p) {
    const double x = particles.position.component(0)[p];
    const double y = particles.position.component(1)[p];
    if (!test(x, y)) continue;
    std::ostringstream text;
    text << "material point " << particles.id.component(0)[p] << " at (" << x << ", " << y << ") m ";
    return text.str();
  }
  return "no point ";
}

/// Where it fails: a place that is no number is neither inside nor outside, and ends the run under any rule.
TEST(Leaving, DoesNotHideAPointWithoutAPlace) {
  Flight<2> flight{Leaving::absorb};
  flight.state->particles.velocity.component(0)[0] = std::nan("");

  const std::string message = message_of<RunError>([&] { flight.advance(1); });

  const std::string point = text_of_first(
      flight.state->particles, [](double x, double y) { return !std::isfinite(x) || !std::isfinite(y); });
  EXPECT_EQ(message, point + "has no finite position");
}

TEST(Leaving, StopsTheRunUnlessTold) {
  Flight<2> flight{Leaving::stop};

  const std::string message = message_of<RunError>([&] { flight.advance(50); });

  const std::string point =
      text_of_first(flight.state->particles, [](double x, double y) { return x > 3 || y < 0; });
  EXPECT_EQ(message, point + "is outside the mesh [0, 3] x [0, 3] m");
}

}  // namespace
}  // namespace scree::mpm
