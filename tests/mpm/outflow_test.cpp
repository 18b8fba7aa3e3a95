#include "messages.hpp"
#include "streams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::mpm {
namespace {

/// Dust of unequal masses that flies to the right, with a share of two kinds that each point carries.
template <int D = 2>
struct Flight {
  Flight() {
    const auto grid = cube<D>(24, 0.125, false);
    auto particles = scattered<D>(grid, 600, 0.5);
    kinds = particles.add_column({"kinds", "k", "-"}, 2);
    for (Index p = 0; p < particles.size(); ++p) {
      particles.velocity.component(0)[p] = 3;
      particles.velocity.component(1)[p] = -0.5;
      if constexpr (D == 3) particles.velocity.component(2)[p] = 0.25;
      particles.column(kinds).component(0)[p] = p % 2 == 0 ? 0.25 : 1;
      particles.column(kinds).component(1)[p] = p % 2 == 0 ? 0.75 : 0;
    }
    stages = stages_of<D, D>(particles, Quadratic{}, Apic{});
    stages.mass_floor = 0;  // [-]: else what lighter nodes than that get of lone points is lost
    state = std::make_unique<State<D, D>>(start(std::move(particles), grid, stages, {1}));
  }
  [[nodiscard]] double carried(int kind) const {
    const auto& particles = state->particles;
    double sum = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      sum += particles.mass.component(0)[p] * particles.column(kinds).component(kind)[p];
    }
    return sum;
  }
  std::size_t kinds = 0;
  Stages<D, D> stages;
  std::unique_ptr<State<D, D>> state;
};

template <int D>
[[nodiscard]] Outflow<D> right_half() {
  Outflow<D> box{.low = Vector<D>::Constant(-std::numeric_limits<double>::infinity()),
                 .high = Vector<D>::Constant(std::numeric_limits<double>::infinity())};
  box.low[0] = 2;
  return box;
}

TEST(Outflow, TakesWhatIsInItAndNothingElse) {
  Flight<2> flight;

  for (int n = 0; n < 40; ++n) {
    step(*flight.state, flight.stages, 0.01, {1});
    static_cast<void>(take_out(*flight.state, right_half<2>()));
    const auto& particles = flight.state->particles;
    for (Index p = 0; p < particles.size(); ++p) {
      const bool is_there = particles.mass.component(0)[p] > 0;
      ASSERT_TRUE(!is_there || particles.position.component(0)[p] < 2);
    }
  }
}

template <int D>
void expect_that_is_counted_what_is_missing() {
  Flight<D> flight;
  const double mass = Passage<D>::sum_of(flight.state->particles.mass);
  const Momentum momentum = momentum_of(flight.state->particles, 0);
  const double coarse = flight.carried(1);
  Passed<D> taken;
  constexpr int num_steps = 40;

  for (int n = 0; n < num_steps; ++n) {
    step(*flight.state, flight.stages, 0.01, {1});
    taken += take_out(*flight.state, right_half<D>(), flight.kinds);
  }

  const auto& left = flight.state->particles;
  const double sums = 600 * round_off;  // of 600 points
  ASSERT_GT(taken.count, 300);
  EXPECT_NEAR(taken.mass + Passage<D>::sum_of(left.mass), mass, sums * mass);
  EXPECT_NEAR(taken.momentum[0] + momentum_of(left, 0).total, momentum.total,
              (sums + rounding_of(D, 3, num_steps)) * momentum.size);
  ASSERT_EQ(taken.carried.size(), 2U);
  EXPECT_NEAR(taken.carried[1] + flight.carried(1), coarse, sums * coarse);
  EXPECT_NEAR(taken.carried[0] + taken.carried[1], taken.mass, sums * mass);
}

TEST(Outflow, CountsWhatIsMissing) {
  expect_that_is_counted_what_is_missing<2>();
  expect_that_is_counted_what_is_missing<3>();
}

TEST(Outflow, CanTakeEverything) {
  Flight<2> flight;
  const Outflow<2> all{.low = {0, 0}, .high = {3, 3}};

  EXPECT_EQ(take_out(*flight.state, all).count, 600);
  EXPECT_EQ(take_out(*flight.state, all).count, 0);
  for (int n = 0; n < 10; ++n) step(*flight.state, flight.stages, 0.01, {1});
  EXPECT_EQ(Passage<2>::sum_of(flight.state->particles.mass), 0);
}

/// A point that has gone on round a periodic axis is where its place in the period is.
TEST(Outflow, SeesPlacesInThePeriod) {
  const auto grid = cube<1>(8, 0.125, true);
  Particles<1> particles;
  particles.resize(1);
  particles.mass.component(0)[0] = 1;
  particles.density.component(0)[0] = 1000;
  particles.position.component(0)[0] = 0.9;
  auto stages = stages_of<1, 1>(particles, Linear{}, Apic{});
  auto state = start(std::move(particles), grid, stages, {1});
  state.particles.position.component(0)[0] = 1.02;  // 0.02 round the end, not yet sorted

  EXPECT_EQ(take_out(state, Outflow<1>{.low = Vector<1>{0.8}, .high = Vector<1>{1.5}}).count, 0);
  EXPECT_EQ(take_out(state, Outflow<1>{.low = Vector<1>{0.0}, .high = Vector<1>{0.25}}).count, 1);
}

/// Where it fails: a box thinner than a cell could be passed in a step; and one that no point can reach.
TEST(Outflow, RefusesABoxThatIsThinOrOutside) {
  const auto grid = cube<2>(24, 0.125, false);
  const auto message_of_box = [&](const Vector<2>& low, const Vector<2>& high) {
    return message_of<InputError>([&] { check(Outflow<2>{low, high}, grid); });
  };

  EXPECT_EQ(message_of_box({0, 1}, {1, 1.1}),
            "Outflow: the box must be at least a cell, 0.125000 m, thick along axis 1");
  EXPECT_EQ(message_of_box({0, std::nan("")}, {1, 1.1}),
            "Outflow: the box must be at least a cell, 0.125000 m, thick along axis 1");
  EXPECT_EQ(message_of_box({3, 0}, {4, 3}), "Outflow: the box lies outside the mesh along axis 0");
  EXPECT_EQ(message_of_box({0, -1}, {3, 0}), "Outflow: the box lies outside the mesh along axis 1");
}

}  // namespace
}  // namespace scree::mpm
