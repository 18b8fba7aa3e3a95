#include "messages.hpp"

#include <scree/mpm/time_step.hpp>

#include <cmath>
#include <limits>

namespace scree::mpm {
namespace {

const CartesianGrid<2> grid{Vector<2>::Zero(), Vector<2>{0.1, 0.2}, {4, 4}, {false, false}};
constexpr TimeStepOptions whole{.acoustic = 1, .advective = 1, .viscous = 1, .maximum = 0};
constexpr double tolerance = 10 * round_off;  // relative, ten operations

TEST(StableTimeStep, LetsSoundCrossNoMoreThanACell) {  // Eq. (M17)
  const auto step =
      stable_time_step(grid, {.wave_speed = 10, .kinematic_viscosity = 0, .advection_rate = 0}, whole);

  const double expected = 1 / (10 * std::sqrt(1 / 0.01 + 1 / 0.04));
  EXPECT_NEAR(step.dt, expected, tolerance * expected);
  EXPECT_EQ(step.limit, Limit::acoustic);
}

TEST(StableTimeStep, CountsTheMotionOfThePointsToThatOfSound) {  // Eq. (M17)
  const auto step =
      stable_time_step(grid, {.wave_speed = 10, .kinematic_viscosity = 0, .advection_rate = 30}, whole);

  const double expected = 1 / (10 * std::sqrt(1 / 0.01 + 1 / 0.04) + 30);
  EXPECT_NEAR(step.dt, expected, tolerance * expected);
}

TEST(StableTimeStep, LetsAPointCrossNoMoreThanACell) {  // Eq. (M18)
  const auto step = stable_time_step(grid, {.wave_speed = 0, .kinematic_viscosity = 0, .advection_rate = 50},
                                     {.acoustic = 1, .advective = 0.2, .viscous = 1});

  EXPECT_NEAR(step.dt, 0.2 / 50, tolerance);
  EXPECT_EQ(step.limit, Limit::advective);
}

TEST(StableTimeStep, KeepsToTheLimitOfExplicitViscosity) {  // Eq. (M19)
  const auto step =
      stable_time_step(grid, {.wave_speed = 1, .kinematic_viscosity = 4, .advection_rate = 0}, whole);

  const double expected = 1 / (2 * 4 * (1 / 0.01 + 1 / 0.04));
  EXPECT_NEAR(step.dt, expected, tolerance * expected);
  EXPECT_EQ(step.limit, Limit::viscous);
}

TEST(StableTimeStep, FollowsTheMemoryOfTheLaw) {  // Eq. (M25)
  const auto step = stable_time_step(grid, {.wave_speed = 1, .relaxation_rate = 400}, {.relaxation = 0.25});

  EXPECT_EQ(step.dt, 0.25 / 400);
  EXPECT_EQ(step.limit, Limit::relaxation);
}

TEST(StableTimeStep, IsNoLongerThanTheUserWants) {
  const auto step = stable_time_step(grid, {}, {.maximum = 0.01});

  EXPECT_EQ(step.dt, 0.01);
  EXPECT_EQ(step.limit, Limit::maximum);
}

TEST(StableTimeStep, UsesTheGivenShares) {
  const Rates rates{.wave_speed = 10, .kinematic_viscosity = 0, .advection_rate = 0};
  const double limit = stable_time_step(grid, rates, whole).dt;

  const auto half = stable_time_step(grid, rates, {.acoustic = 0.5});

  EXPECT_NEAR(half.dt, limit / 2, tolerance * limit);
}

TEST(StableTimeStep, HasANameForEveryLimit) {
  EXPECT_EQ(limit_names[static_cast<std::size_t>(Limit::acoustic)], "acoustic");
  EXPECT_EQ(limit_names[static_cast<std::size_t>(Limit::advective)], "advective");
  EXPECT_EQ(limit_names[static_cast<std::size_t>(Limit::viscous)], "viscous");
  EXPECT_EQ(limit_names[static_cast<std::size_t>(Limit::maximum)], "maximum");
  EXPECT_EQ(limit_names[static_cast<std::size_t>(Limit::output)], "output");
}

TEST(StableTimeStep, RefusesSharesOutsideZeroToOne) {
  const Rates rates{.wave_speed = 10, .kinematic_viscosity = 0, .advection_rate = 0};
  for (const double share : {0.0, -0.5, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    for (const TimeStepOptions& options : {TimeStepOptions{.acoustic = share},
                                           {.advective = share},
                                           {.viscous = share},
                                           {.relaxation = share}}) {
      EXPECT_EQ(message_of<InputError>([&] { static_cast<void>(stable_time_step(grid, rates, options)); }),
                "TimeStepOptions: each share of a limit must lie in (0, 1]");
    }
  }
}

TEST(StableTimeStep, RefusesToRunWithoutALimit) {
  EXPECT_EQ(message_of<InputError>([] { static_cast<void>(stable_time_step(grid, {}, {})); }),
            "stable_time_step: nothing bounds the step; give a maximum");
}

}  // namespace
}  // namespace scree::mpm
