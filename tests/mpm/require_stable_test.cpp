// Steps from which points fly are refused, and what flies stops a run.

#include "messages.hpp"
#include "periodic_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace scree::mpm {
namespace {

/// A bar on hat functions in which sound runs at 10 m/s, and all that a step of it needs.
struct RunningBar {
  /// Velocity gradient of a cell whose ends part at a tenth of the speed of sound [1/s].
  static constexpr double flying = 1 / Bar::spacing;
  static constexpr double amplitude = 1e-8 * flying;  ///< of its shortest wave at the start [1/s]

  explicit RunningBar(const AnyTransfer& transfer)
      : particles{points_of({.shape = Linear{}, .transfer = transfer})} {
    sums = critical_sums(particles, grid, Linear{}, transfer, Order::usl);
    for (Index p = 0; p < particles.size(); ++p) {
      particles.velocity_gradient.component(0)[p] = p % 2 == 0 ? amplitude : -amplitude;
    }
    stages = stages_of<1, 1>(particles, Linear{}, transfer, {1e5, 1000, 0});
    state.emplace(start(std::move(particles), grid, stages, {1}));
  }
  void check(double dt) const { require_stable(*state, stages, sums, dt); }
  /// Steps until cells come apart, at most so many.
  [[nodiscard]] int steps_to_fly(double dt, int most) {
    int n = 0;
    while (n < most && largest(state->particles.velocity_gradient) < flying) {
      step(*state, stages, dt, {1});
      ++n;
    }
    return n;
  }

  CartesianGrid<1> grid = cube<1>(Bar::num_cells, Bar::spacing, true);
  Particles<1, 1> particles;
  Vector<1> sums;
  Stages<1, 1> stages;
  std::optional<State<1, 1>> state;
};

/// Under apic the shortest wave has sinh((n - 1/2) eta)/sinh(eta/2) times its amplitude after n steps,
/// cosh(eta/2) = C: 1e8 times after some ln(1e8)/eta steps. The last few are no longer linear.
TEST(RequireStable, RefusesStepsWithWhichPointsFly) {  // Eq. (M17)
  const double courant = 1.05;
  const double dt = courant * Bar::spacing / 10;
  RunningBar bar{Apic{}};

  EXPECT_EQ(message_of<InputError>([&] { bar.check(dt); }),
            "a step of 0.013125 s must not exceed the critical one, 0.0125 s, beyond which waves grow; it "
            "comes from the acoustic limit of material point 0 at (0.0625) m");
  const int num_steps = bar.steps_to_fly(dt, 1000);

  const double eta = 2 * std::acosh(courant);
  EXPECT_NEAR(num_steps, 0.5 + std::log(2 * std::sinh(eta / 2) * 1e8) / eta, 2);  // 29
}

TEST(RequireStable, LetsStepsPassThatHold) {
  const double critical = Bar::spacing / 10;
  constexpr int num_steps = 2000;
  RunningBar below{Apic{}};
  RunningBar above{Apic{}};

  EXPECT_NO_THROW(below.check(0.99 * critical));
  EXPECT_THROW(above.check(1.01 * critical), InputError);

  EXPECT_EQ(below.steps_to_fly(0.99 * critical, num_steps), num_steps);
  EXPECT_LT(above.steps_to_fly(1.01 * critical, num_steps), num_steps);
}

/// What has flown to pieces has no place any more, on a periodic axis too.
TEST(FlyingPoints, StopARunOnceTheyHaveNoPlace) {
  RunningBar bar{Apic{}};

  const std::string message =
      message_of<RunError>([&] { static_cast<void>(bar.steps_to_fly(std::nan(""), 10)); });

  EXPECT_EQ(message, "material point 0 at (nan) m has no finite position");
}

TEST(RequireStable, RefusesAStepThatIsNoNumber) {
  const RunningBar bar{Apic{}};

  EXPECT_EQ(message_of<InputError>([&] { bar.check(std::nan("")); }),
            "a step of nan s must not exceed the critical one, 0.0125 s, beyond which waves grow; it comes "
            "from the acoustic limit of material point 0 at (0.0625) m");
}

/// Rates that are no number are refused, not taken for no limit.
TEST(RequireStable, RefusesRatesThatAreNoNumber) {
  RunningBar bar{Apic{}};
  bar.state->rates.wave_speed = std::nan("");

  EXPECT_EQ(message_of<InputError>([&] { bar.check(1e-9); }),
            "a step of 1e-09 s must not exceed the critical one, nan s, beyond which waves grow; it comes "
            "from the acoustic limit of material point 0 at (0.0625) m");
}

/// A point that flies is not one where sound is fast: all have the same speed of it, and the first is named.
TEST(RequireStable, NamesThePointOfTheFastestSoundNotTheFastestPoint) {
  RunningBar bar{Apic{}};
  bar.state->particles.velocity.component(0)[5] = 200;

  EXPECT_EQ(message_of<InputError>([&] { bar.check(0.013125); }),
            "a step of 0.013125 s must not exceed the critical one, 0.0125 s, beyond which waves grow; it "
            "comes from the acoustic limit of material point 0 at (0.0625) m");
}

}  // namespace
}  // namespace scree::mpm
