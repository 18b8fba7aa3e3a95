// Waves in an elastic bar: what each scheme makes of them, exactly, and the speed and loss that follow.

#include "elastic_bar.hpp"

#include "schemes.hpp"

#include <gtest/gtest.h>

namespace scree::mpm {
namespace {

struct NamedScheme {
  const char* name;
  AnyShape shape;
  AnyTransfer rule;
  /// A wave of k h is too slow by this share of (k h)^2, two points a cell.  Eq. (M86)
  double lag;
};
constexpr double quadratic_affine_lag = 0.16796875 / 1.5 - 0.046875 * 0.046875 / 0.5;
constexpr double quadratic_gradient_lag = 0.8125 / 6;
const std::array<NamedScheme, 7> lasting_schemes{
    NamedScheme{"linear apic", Linear{}, Apic{}, 1.0 / 24},
    NamedScheme{"linear aflip", Linear{}, Aflip{1}, 1.0 / 24},
    NamedScheme{"linear flip", Linear{}, PicFlip{1}, 1.0 / 24 + 3.0 / 32},
    NamedScheme{"quadratic apic", Quadratic{}, Apic{}, quadratic_affine_lag},
    NamedScheme{"quadratic aflip", Quadratic{}, Aflip{1}, quadratic_affine_lag},
    NamedScheme{"quadratic tpic", Quadratic{}, Tpic{}, quadratic_gradient_lag},
    NamedScheme{"quadratic flip", Quadratic{}, PicFlip{1}, quadratic_gradient_lag + 1.0 / 8}};

/// One of each transfer, and what those with a share make of a part of it.
[[nodiscard]] std::vector<AnyTransfer> transfers_and_blends() {
  std::vector<AnyTransfer> rules = every<AnyTransfer>();
  rules.insert(rules.end(), {AnyTransfer{PicFlip{0.9}}, AnyTransfer{Aflip{0.9}}});
  return rules;
}

TEST(ElasticBar, FollowsTheRecursionOfItsStepUnderEveryShapeAndTransfer) {  // Eq. (M85)
  constexpr int num_steps = 200;
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& rule : transfers_and_blends()) {
      for (const int half_waves : {1, 2, 5}) {
        const BarWave wave{shape, rule, 12, half_waves, 0.4};
        WaveRecursion exact{wave};
        BarInTheMesh bar{wave};

        for (int n = 0; n < num_steps; ++n) {
          exact.advance();
          bar.advance();
        }

        // Points move by `velocity` of a cell in each step, which changes the weights as much; F is rounded
        // against strains of `velocity`.
        const double tolerance = num_steps * (BarWave::velocity + 8 * round_off / BarWave::velocity);
        bar.for_each_point([&](double x, double v) { EXPECT_NEAR(v, exact.velocity_at(x), tolerance); });
      }
    }
  }
}

TEST(ElasticBar, FollowsTheRecursionOfItsStepInEveryOrderAndFiltered) {  // Eqs. (M126)-(M128), (M130)
  constexpr int num_steps = 200;
  const auto expect_recursion = [](const BarWave& wave) {
    WaveRecursion exact{wave};
    BarInTheMesh bar{wave};
    for (int n = 0; n < num_steps; ++n) {
      exact.advance();
      bar.advance();
    }
    const double tolerance = num_steps * (BarWave::velocity + 8 * round_off / BarWave::velocity);  // as above
    bar.for_each_point([&](double x, double v) { EXPECT_NEAR(v, exact.velocity_at(x), tolerance); });
  };
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const Order order : {Order::musl, Order::usf}) {
      for (const AnyTransfer& rule : transfers_and_blends()) {
        expect_recursion({shape, rule, 12, 2, 0.4, order});
      }
    }
    for (const int xpic_order : {1, 2, 5}) {
      for (const Order order : {Order::usl, Order::musl, Order::usf}) {
        expect_recursion({shape, PicFlip{1}, 12, 2, 0.4, order, xpic_order});
      }
    }
  }
}

/// Angular frequency of a wave over that of theory, from the time of its last of `num_zeros` zeros [-].
double frequency(const BarWave& wave, int num_zeros) {
  BarInTheMesh bar{wave};
  // The nth zero is at (n - 1/2) pi/omega; the strain is zero half a step before the first velocity.
  double last = bar.amplitude();
  int zeros = 0;
  for (int n = 1;; ++n) {
    bar.advance();
    const double now = bar.amplitude();
    if (now * last < 0 && ++zeros == num_zeros) {
      const double time = (n + 0.5 - now / (now - last)) * wave.dt();
      return (num_zeros - 0.5) * std::numbers::pi / (wave.wave_number() * BarWave::solid.wave_speed() * time);
    }
    last = now;
  }
}

TEST(ElasticBar, VibratesTooSlowByTheSquareOfTheSpacing) {  // Eq. (M86)
  for (const NamedScheme& scheme : lasting_schemes) {
    SCOPED_TRACE(scheme.name);
    for (const Index num_cells : {10, 20}) {
      const BarWave wave{scheme.shape, scheme.rule, num_cells, 1, 0.1};
      const double kh = wave.wave_number() * wave.spacing();

      const double lag = 1 - frequency(wave, 20);

      // Next comes (k h)^4; the centred step is ahead by (omega dt)^2/24; the start is off by a phase of
      // (k h)^2, one in 20 half periods.
      const double tolerance = std::pow(kh, 4) / 24 + kh * kh * (0.01 / 24 + scheme.lag / 20);
      EXPECT_NEAR(lag, scheme.lag * kh * kh, tolerance);
    }
  }
}

/// Energy left of a wave after `num_periods`: the square of the amplitude at its last peak.
double energy_left(const BarWave& wave, int num_periods) {
  BarInTheMesh bar{wave};
  const double period = 2 * std::numbers::pi / (wave.wave_number() * BarWave::solid.wave_speed());
  const auto num_steps = static_cast<int>(num_periods * period / wave.dt());
  const auto last_period = static_cast<int>((num_periods - 1) * period / wave.dt());
  double peak = 0;
  for (int n = 0; n < num_steps; ++n) {
    bar.advance();
    if (n > last_period) peak = std::max(peak, bar.amplitude());
  }
  return peak * peak;
}

/// Twenty periods of a wave of k h = pi/10 at one Courant number.
struct LongRun {
  static constexpr int num_periods = 20;
  static constexpr double kh = std::numbers::pi / 10;

  explicit LongRun(double courant_number) : courant{courant_number} {}

  [[nodiscard]] double omega_dt() const { return kh * courant; }
  [[nodiscard]] double num_steps() const { return num_periods * 2 * std::numbers::pi / omega_dt(); }
  /// -log of the energy left [-].
  [[nodiscard]] double loss(const AnyShape& shape, const AnyTransfer& rule, Order order = Order::usl,
                            int xpic_order = 0) const {
    return -std::log(energy_left({shape, rule, 10, 1, courant, order, xpic_order}, num_periods));
  }
  /// Of a predicted loss: the next order, and one period of twenty, as its peak may be anywhere in it. And
  /// the start, which nodes see less of than points by M k^2/2.
  [[nodiscard]] static double tolerance(double predicted) {
    return predicted * (kh * kh + 1.0 / num_periods) + kh * kh / 4;
  }

  double courant;
};

TEST(StressLast, TakesEnergyOutOfFlipAtAPredictedRate) {  // Eq. (M87)
  // The gradient that strains the points is that of the nodes, whose increment the points feel only P times:
  // a viscosity, which takes (1 - P) (omega dt)^2 of the energy per step, 1 - P = (k h)^2 M/h^2 with the mean
  // M of the points.
  for (const auto& [shape, moment] : {std::pair{AnyShape{Linear{}}, 3.0 / 16}, {Quadratic{}, 1.0 / 4}}) {
    for (const double courant : {0.1, 0.2, 0.4}) {
      const LongRun run{courant};
      const double predicted =
          moment * LongRun::kh * LongRun::kh * run.omega_dt() * run.omega_dt() * run.num_steps();

      EXPECT_NEAR(run.loss(shape, PicFlip{1}), predicted, LongRun::tolerance(predicted));
    }
  }
}

TEST(StressByMappedVelocities, LeavesFlipItsEnergy) {  // Eq. (M133)
  // Points are strained by what they feel: the step is that of a spring with masses 1/P times the nodes'.
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const Order order : {Order::musl, Order::usf}) {
      for (const double courant : {0.1, 0.2, 0.4}) {
        EXPECT_NEAR(LongRun{courant}.loss(shape, PicFlip{1}, order), 0, LongRun::tolerance(0));
      }
    }
  }
}

TEST(StressByMappedVelocities, IsNoRemedyForApic) {  // Eq. (M88), which is the filter's own, in any order
  const LongRun run{0.2};
  for (const Order order : {Order::musl, Order::usf}) {
    const double loss = run.loss(Quadratic{}, Apic{}, order);

    EXPECT_NEAR(loss, run.loss(Quadratic{}, Apic{}), LongRun::tolerance(loss));
  }
}

TEST(Xpic, LosesAWaveByItsOrderAsAPower) {  // Eq. (M133): (1 - P)^m of the energy in each step
  constexpr double moment = 1.0 / 4;
  constexpr double unseen = moment * LongRun::kh * LongRun::kh;  // 1 - P
  for (const int order : {2, 3, 4}) {
    for (const double courant : {0.1, 0.4}) {
      const LongRun run{courant};
      const double predicted = std::pow(unseen, order) * run.num_steps();

      // Each factor 1 - P has its own next order, (k h)^2/6 and less.
      const double tolerance = LongRun::tolerance(predicted) + order * predicted * LongRun::kh * LongRun::kh;
      EXPECT_NEAR(run.loss(Quadratic{}, PicFlip{1}, Order::usf, order), predicted, tolerance);
    }
  }
}

/// A wave of two and two thirds cells on a bar that moves through the mesh by an eighth of a cell in each
/// step, and never onto a node.
[[nodiscard]] BarWave moving_wave(const AnyShape& shape, const AnyTransfer& rule, int xpic_order = 0) {
  return {shape, rule, 8, 6, 0.4, Order::musl, xpic_order, 1.0 / 8, 1.0 / 16};
}

/// Size of a wave over its first, as by the recursion; expects the same of the library.
double growth_in(const BarWave& wave, int num_steps) {
  WaveRecursion exact{wave};
  BarInTheMesh bar{wave};
  const double first = exact.size();
  for (int n = 0; n < num_steps; ++n) {
    exact.advance();
    bar.advance();
  }
  // Of each step the second order, of the wave as large as it becomes, and the rounding of strains; both may
  // grow as the wave has.
  const double growth = std::max(1.0, exact.size() / first);
  const double of_a_step = BarWave::velocity * growth + 8 * round_off / BarWave::velocity;
  EXPECT_NEAR(bar.size(), exact.size(), num_steps * of_a_step * growth);
  return exact.size() / first;
}

/// ln |lambda_max(A)| s of a wave that moves by s = 1/8: of eight steps, when all but the fastest has been
/// left behind.
double predicted_rate(const BarWave& wave, int num_steps) {
  WaveRecursion exact{wave};
  for (int n = 0; n < num_steps; ++n) exact.advance();
  const double before = exact.size();
  for (int n = 0; n < 8; ++n) exact.advance();
  return std::log(exact.size() / before) / 8;
}

TEST(MovingBar, GrowsNoiseUnderFlipAtThePredictedRate) {  // Eq. (M192)
  // What a node gave to its points no node sees, in part, once they have moved: work is not given back where
  // it was taken. Nothing else moves the bar, so the energy is that of its motion through the mesh.
  EXPECT_GT(growth_in(moving_wave(Linear{}, PicFlip{1}), 400), 100);
  EXPECT_GT(growth_in(moving_wave(Quadratic{}, PicFlip{1}), 3200), 10);

  // Half of the last digit.
  EXPECT_NEAR(predicted_rate(moving_wave(Linear{}, PicFlip{1}), 4000), 0.0162, 5e-5);
  EXPECT_NEAR(predicted_rate(moving_wave(Quadratic{}, PicFlip{1}), 40000), 0.00132, 5e-6);
}

TEST(MovingBar, LosesNoiseUnderXpicAndUnderApicWithQuadraticShapes) {  // Eq. (M192)
  EXPECT_LT(growth_in(moving_wave(Linear{}, PicFlip{1}, 2), 80), 1e-2);
  EXPECT_LT(growth_in(moving_wave(Quadratic{}, PicFlip{1}, 2), 400), 1e-1);
  EXPECT_LT(growth_in(moving_wave(Quadratic{}, Apic{}), 80), 1e-1);
}

/// Of weights about a point a quarter of a cell from a node, quadratic shapes [spacings].
constexpr double fourth_moment = 0.16796875;
constexpr double third_moment = 0.046875;
constexpr double second_moment = 0.25;

void expect_loss_with_the_fourth_power(const AnyTransfer& rule, double per_step) {
  for (const double courant : {0.1, 0.2, 0.4}) {
    const LongRun run{courant};
    const double predicted = per_step * std::pow(LongRun::kh, 4) * run.num_steps();

    EXPECT_NEAR(run.loss(Quadratic{}, rule), predicted, LongRun::tolerance(predicted));
  }
}

TEST(Apic, LosesAWaveWithItsFourthPowerPerStepUnderQuadraticShapes) {  // Eq. (M88)
  constexpr double per_step =
      (fourth_moment - second_moment * second_moment - third_moment * third_moment / second_moment) / 4;
  expect_loss_with_the_fourth_power(Apic{}, per_step);
}

TEST(Tpic, LosesAWaveWithItsFourthPowerPerStepUnderQuadraticShapes) {  // Eq. (M88)
  constexpr double slope_of_third_moment = 1.0 / 16;
  constexpr double per_step =
      fourth_moment / 12 + second_moment * second_moment / 4 + second_moment * slope_of_third_moment / 6;
  expect_loss_with_the_fourth_power(Tpic{}, per_step);
}

TEST(Apic, KeepsAWaveUnderLinearShapes) {
  // Velocity and gradient of one point give both nodes of its cell their velocities back: nothing is lost but
  // the start.
  for (const double courant : {0.1, 0.4}) {
    EXPECT_NEAR(LongRun{courant}.loss(Linear{}, Apic{}), 0, LongRun::tolerance(0));
  }
}

}  // namespace
}  // namespace scree::mpm
