// What critical_sums() and what follows from it say of points as they lie, without a step.

#include "messages.hpp"
#include "periodic_bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace scree::mpm {
namespace {

TEST(CriticalSum, IsThatOfFiniteDifferencesForPointsInTheMiddleOfCells) {
  EXPECT_NEAR(critical_sum_of({.shape = Linear{}, .transfer = Apic{}}), 1, 100 * round_off);
  EXPECT_NEAR(critical_sum_of({.shape = Quadratic{}, .transfer = Tpic{}}), 1, 100 * round_off);
  EXPECT_NEAR(critical_sum_of({.shape = Linear{}, .transfer = PicFlip{1}}), 0.5, 100 * round_off);
  EXPECT_NEAR(critical_sum_of({.shape = Linear{}, .transfer = PicFlip{1}, .order = Order::usf}), 4,
              100 * round_off);  // Eq. (M134)
}

/// Of points all over hat functions the shortest wave has P = 1/3 and Lambda = 4: under FLIP its sum is
/// 2/4 2/(2 - P) = 3/5. Places are taken to w = 1/1024, by which P, whose integrand (1 - 2 xi)^2 is curved by
/// 8, is off by 8/2 w^2/12, and the sum by 9/25 of that. P and Lambda are sums over as many places, of terms
/// above zero of a dozen operations each: both are off by no more than their roundings, and the sum by
/// (P/(2 - P) + 1) of them.
TEST(CriticalSum, TakesPlacesToAThousandthOfACell) {
  constexpr int num_places = 1024;
  const Bar bar{.shape = Linear{}, .transfer = PicFlip{1}, .per_cell = 8192};
  const double of_places = 9.0 / 25 / 3 / (double{num_places} * num_places);
  const double of_sums = (num_places + 12) * round_off * (1.0 / 5 + 1) * 0.6;

  EXPECT_NEAR(critical_sum_of(bar), 0.6, of_places + of_sums);
}

/// The table of docs/equations/mpm/step_limits.md, with 1, 2 and 3 points a cell, to half of its last digits.
TEST(CriticalSum, IsThatOfTheTable) {  // Eq. (M174)
  struct Row {
    AnyShape shape;
    AnyTransfer transfer;
    Order order;
    std::array<double, 3> sums;
    double last_digit;
  };
  const std::vector<Row> rows{
      {Linear{}, Apic{}, Order::usl, {1, 1, 1}, 0.01},
      {Linear{}, Tpic{}, Order::usl, {1, 1, 1}, 0.01},
      {Linear{}, PicFlip{1}, Order::usl, {0.50, 0.57, 0.59}, 0.01},
      {Linear{}, PicFlip{1}, Order::usf, {4, 3.0, 2.8}, 0.1},
      {Quadratic{}, Apic{}, Order::usl, {1, 1.71, 1.66}, 0.01},
      {Quadratic{}, Tpic{}, Order::usl, {1, 2.60, 1.93}, 0.01},
      {Quadratic{}, PicFlip{1}, Order::usl, {0.50, 1.82, 1.31}, 0.01},
      {Quadratic{}, PicFlip{1}, Order::usf, {4, 5.7, 5.3}, 0.1},
      {Cubic{}, Apic{}, Order::usl, {1.95, 2.76, 2.77}, 0.01},
      {Cubic{}, Tpic{}, Order::usl, {2.77, 3.15, 3.17}, 0.01},
      {Cubic{}, PicFlip{1}, Order::usl, {1.88, 2.21, 2.22}, 0.01},
      {Cubic{}, PicFlip{1}, Order::usf, {7.3, 7.3, 7.3}, 0.1},
  };
  for (const Row& row : rows) {
    for (Index per_cell = 1; per_cell <= 3; ++per_cell) {
      const Bar bar{.shape = row.shape, .transfer = row.transfer, .order = row.order, .per_cell = per_cell};
      const double printed = row.sums[static_cast<std::size_t>(per_cell - 1)];
      EXPECT_NEAR(critical_sum_of(bar), printed, row.last_digit / 2)
          << row.shape.index() << " " << row.transfer.index() << ", " << per_cell << " points a cell";
    }
  }
}

TEST(CriticalSum, AsksForPointsThatHaveAPlaceAndMass) {
  const auto grid = cube<1>(Bar::num_cells, Bar::spacing, true);
  const auto sums_of = [&](const Particles<1, 1>& particles) {
    return message_of<InputError>(
        [&] { static_cast<void>(critical_sums(particles, grid, Linear{}, Apic{}, Order::usl)); });
  };
  auto lost = points_of({.shape = Linear{}, .transfer = Apic{}});
  lost.position.component(0)[3] = std::nan("");
  auto massless = points_of({.shape = Linear{}, .transfer = Apic{}});
  std::fill(massless.mass.values().begin(), massless.mass.values().end(), 0.0);

  EXPECT_EQ(sums_of(lost), "material point 3 at (nan) m has no finite position");
  EXPECT_EQ(sums_of(massless), "critical_sums: there must be a point with mass");
}

TEST(CriticalSum, IsOfFilteredVelocitiesWhereAStepFiltersThem) {  // Eq. (M182)
  const auto message = [](const AnyTransfer& transfer) {
    return message_of<InputError>([&] {
      static_cast<void>(critical_sum_of({.shape = Linear{}, .transfer = transfer, .xpic_order = 2}));
    });
  };
  const std::string expected =
      "filtered velocities: their critical step is known of pic_flip with increment_share = 1 only";

  EXPECT_EQ(message(PicFlip{0.9}), expected);
  EXPECT_EQ(message(Aflip{1}), expected);
  EXPECT_EQ(message(Apic{}), expected);
}

/// Of two axes the one along which it is shorter: 2 h/c and, on twice the spacing, 0.5 h'/c = h/c.
TEST(CriticalStep, IsThatOfTheAxisThatBinds) {
  constexpr double spacing = Bar::spacing;
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{spacing, 2 * spacing}, {4, 4}, {false, false}};
  const Rates sound{.wave_speed = 10};
  const double nan = std::nan("");

  EXPECT_NEAR(critical_step<2>({4, 0.25}, grid, sound), spacing / 10, 10 * round_off * spacing);
  EXPECT_NEAR(critical_step<2>({1, 4}, grid, sound), spacing / 10, 10 * round_off * spacing);
  EXPECT_TRUE(std::isnan(critical_step<2>({nan, 1}, grid, sound)));
  EXPECT_TRUE(std::isnan(critical_step<2>({1, nan}, grid, sound)));
  EXPECT_TRUE(std::isnan(critical_step<2>({1, 1}, grid, {.wave_speed = nan})));
}

/// A point of this fluid has the rates of any other.
TEST(UnstableStep, IsTheCriticalOneOfAFluid) {  // Eq. (M199)
  const auto grid = cube<1>(Bar::num_cells, Bar::spacing, true);
  const Fluid syrup{.bulk_modulus = 4000, .reference_density = 1000, .viscosity = 50};
  auto particles = points_of({.shape = Quadratic{}, .transfer = Apic{}, .per_cell = 2});
  const StressUpdateBy<1, 1, Fluid> stress{syrup, particles};

  const double dt = unstable_step(particles, stress, grid, Quadratic{}, Apic{}, Order::usl);

  const Vector<1> sums = critical_sums(particles, grid, Quadratic{}, Apic{}, Order::usl);
  const double expected = critical_step(sums, grid, {.wave_speed = 2, .kinematic_viscosity = 0.05});
  EXPECT_NEAR(dt, expected, 100 * round_off * expected);
}

TEST(UnstableStep, IsNoneWhereNothingMakesAWave) {
  const auto grid = cube<1>(Bar::num_cells, Bar::spacing, true);
  const auto step_of = [&](Particles<1, 1> particles, const Fluid& law) {
    const StressUpdateBy<1, 1, Fluid> stress{law, particles};
    return unstable_step(particles, stress, grid, Linear{}, PicFlip{1}, Order::usf);
  };
  const auto points = points_of({.shape = Linear{}, .transfer = Apic{}});

  EXPECT_TRUE(std::isinf(step_of(points, dust)));
  EXPECT_TRUE(std::isinf(step_of(Particles<1, 1>{}, {1000, 1000, 1})));
}

}  // namespace
}  // namespace scree::mpm
