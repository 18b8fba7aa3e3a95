// From which step on waves grow where rates or places differ from point to point, shown by the step itself.

#include "growing_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace scree::mpm {
namespace {

/// A bar whose sum (M173) differs from point to point.
class PatchyBar {
 public:
  PatchyBar(const Bar& bar, Particles<1, 1> particles, const std::function<double(Index)>& share)
      : bar_{bar}, particles_{std::move(particles)} {
    const std::size_t column = particles_.add_column({"share", "s", "-"}, 1);
    double* const shares = particles_.column(column).component(0);
    for (Index p = 0; p < particles_.size(); ++p) shares[p] = share(p);
  }
  /// The sum of points of share 1 from which on waves grow, by (M199): the step at which it is 1 is one of
  /// `dt` times r, and the parts of sound and viscosity have r^2 and r of it.
  [[nodiscard]] double unstable_sum() const {
    Particles<1, 1> points = particles_;
    const Stages<1, 1> stages = stages_with(points, 1);
    const double r = unstable_step(points, *stages.stress, cube<1>(Bar::num_cells, Bar::spacing, true),
                                   bar_.shape, bar_.transfer, bar_.order, bar_.xpic_order) /
                     dt;
    return (1 - bar_.viscous) * r * r + bar_.viscous * r;
  }
  /// That by the largest share, which is to be 1.
  [[nodiscard]] double critical_sum() const {
    return critical_sums(particles_, cube<1>(Bar::num_cells, Bar::spacing, true), bar_.shape, bar_.transfer,
                         bar_.order, bar_.xpic_order)[0];
  }
  /// @param sum of points of share 1
  [[nodiscard]] double grown(double sum, int num_steps) const {
    Particles<1, 1> points = particles_;
    const Stages<1, 1> stages = stages_with(points, sum);
    return growth(std::move(points), stages, dt, num_steps);
  }

 private:
  static constexpr double dt = 0.01;  // [s]

  [[nodiscard]] Stages<1, 1> stages_with(Particles<1, 1>& points, double sum) const {
    Stages<1, 1> stages;
    stages.stress =
        std::make_unique<StressUpdateBy<1, 1, Patchwork>>(Patchwork{fluid_of(sum, bar_.viscous, dt)}, points);
    stages.transfer = make_transfer<1, 1>(bar_.shape, bar_.transfer);
    stages.order = bar_.order;
    if (bar_.xpic_order > 0) stages.xpic = make_xpic<1, 1>(bar_.shape, bar_.xpic_order);
    return stages;
  }

  Bar bar_;
  Particles<1, 1> particles_;
};

/// Two points in each cell, at 0.02 and 0.5 of it.
[[nodiscard]] Particles<1, 1> uneven_points() {
  auto particles = points_of({.shape = Quadratic{}, .transfer = Apic{}, .per_cell = 2});
  double* const x = particles.position.component(0);
  for (Index p = 0; p < particles.size(); ++p) {
    const Index cell = p / 2;
    x[p] = (static_cast<double>(cell) + (p % 2 == 0 ? 0.02 : 0.5)) * Bar::spacing;
  }
  return particles;
}

/// From 1, that of the first point, down to a hundredth, in no order.
[[nodiscard]] double any_share(Index p) {
  const double turns = static_cast<double>(p) / std::numbers::phi;
  return std::pow(0.01, turns - std::floor(turns));
}

/// The first of each cell of two has 19 times what the second has; the mean is 1/1.9.
[[nodiscard]] double uneven_share(Index p) {
  return p % 2 == 0 ? 1 : 1.0 / 19;
}

/// Where all cells are alike each wave is its own, and (M199) is where it grows.
TEST(UnstableStep, IsWhereWavesBeginToGrowInCellsThatAreAlike) {  // Eq. (M199)
  constexpr int num_steps = 200;
  for (const Bar& bar : every_bar()) {
    if (bar.per_cell != 2) continue;
    const PatchyBar patchy{bar, uneven_points(), uneven_share};
    const double sum = patchy.unstable_sum();
    EXPECT_LE(patchy.grown(0.97 * sum, num_steps), 2) << name_of(bar);
    EXPECT_GE(patchy.grown(1.03 * sum, num_steps), std::pow(1.03, num_steps) / 10) << name_of(bar);
  }
}

/// The stiff point of a cell is beside a node, where quadratic shapes see little of the shortest wave: the
/// mean of the sum may be more than twice what points of equal rates bear, and at 1.5 times none grows.
TEST(UnstableStep, IsNotThatOfMeanRates) {  // Eq. (M199)
  constexpr double of_mean = 1.9;           // a sum of share 1 over the mean
  for (const AnyTransfer& transfer : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const Bar bar{.shape = Quadratic{}, .transfer = transfer, .per_cell = 2};
    const PatchyBar patchy{bar, uneven_points(), uneven_share};
    const double of_equal = of_mean * patchy.critical_sum();

    EXPECT_GT(patchy.unstable_sum(), 2 * of_equal) << name_of(bar);
    EXPECT_LE(patchy.grown(1.5 * of_equal, 200), 2) << name_of(bar);
  }
}

/// However rates differ from point to point, waves grow beyond (M199), and none does by the largest rates.
TEST(UnstableStep, IsOneBeyondWhichWavesGrowHoweverRatesAreSpread) {  // Eq. (M199)
  constexpr int num_steps = 200;
  const auto one_half = [](Index p) { return p < Bar::num_cells ? 1 : 0.01; };
  for (const Bar& bar : every_bar()) {
    if (bar.per_cell != 2) continue;
    for (const auto& share :
         {std::function<double(Index)>{one_half}, std::function<double(Index)>{any_share}}) {
      const PatchyBar patchy{bar, points_of(bar), share};
      EXPECT_GE(patchy.grown(1.03 * patchy.unstable_sum(), num_steps), std::pow(1.03, num_steps) / 10)
          << name_of(bar);
      EXPECT_LE(patchy.grown(0.97 * patchy.critical_sum(), num_steps), 2) << name_of(bar);
    }
  }
}

/// Filtered velocities, under every shape and order.
[[nodiscard]] std::vector<Bar> every_filtered_bar() {
  std::vector<Bar> bars;
  for (const AnyShape& shape : every_shape_for(2)) {
    for (const Order order : {Order::usl, Order::musl, Order::usf}) {
      for (const int xpic_order : {1, 2, 3, 8}) {
        bars.push_back({.shape = shape,
                        .transfer = PicFlip{1},
                        .order = order,
                        .per_cell = 2,
                        .viscous = 0.5,
                        .xpic_order = xpic_order});
      }
    }
  }
  return bars;
}

TEST(UnstableStep, IsWhereFilteredWavesBeginToGrowInCellsThatAreAlike) {  // Eqs. (M182), (M199)
  constexpr int num_steps = 200;
  for (const Bar& bar : every_filtered_bar()) {
    const PatchyBar patchy{bar, uneven_points(), uneven_share};
    const double sum = patchy.unstable_sum();
    EXPECT_LE(patchy.grown(0.97 * sum, num_steps), 2) << name_of(bar);
    EXPECT_GE(patchy.grown(1.03 * sum, num_steps), std::pow(1.03, num_steps) / 10) << name_of(bar);
  }
}

/// Under `apic` and `usl` it is derived for any places and masses of points; under FLIP, filtered too, it is
/// found.
TEST(UnstableStep, IsOneBeyondWhichWavesGrowWhereverPointsAre) {  // Eq. (M199)
  constexpr int num_steps = 200;
  std::vector<Bar> bars = every_filtered_bar();
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& transfer : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
      bars.push_back({.shape = shape, .transfer = transfer});
    }
  }
  const auto points = scattered<1>(cube<1>(Bar::num_cells, Bar::spacing, true), 2 * Bar::num_cells, 0);
  for (const Bar& bar : bars) {
    const PatchyBar patchy{bar, points, any_share};
    EXPECT_GE(patchy.grown(1.03 * patchy.unstable_sum(), num_steps), std::pow(1.03, num_steps) / 10)
        << name_of(bar);
  }
}

/// Those of two cells in a pair about every other node. Under orders whose fraction is by 1/P the mean of
/// this is more than that of the mean P, and pairs bear 1.5 times as much and more; under `usl` they do not.
TEST(UnstableStep, MayBeOneThatPointsInPairsBearUnderOtherOrders) {  // Eq. (M199)
  constexpr int num_steps = 200;
  for (const int xpic_order : {0, 2}) {
    for (const Order order : {Order::usl, Order::musl, Order::usf}) {
      const Bar bar{.shape = Linear{}, .transfer = PicFlip{1}, .order = order, .xpic_order = xpic_order};
      auto points = points_of(bar);
      double* const x = points.position.component(0);
      for (Index p = 0; p < points.size(); ++p) {
        x[p] = (static_cast<double>(p) + (p % 2 == 0 ? 7 : 1) / 8.0) * Bar::spacing;
      }
      const PatchyBar paired{bar, points, [](Index) { return 1.0; }};
      const double sum = paired.unstable_sum();
      if (order == Order::usl) {
        EXPECT_GE(paired.grown(1.03 * sum, num_steps), std::pow(1.03, num_steps) / 10) << name_of(bar);
      } else {
        EXPECT_LE(paired.grown(1.5 * sum, num_steps), 2) << name_of(bar) << " " << sum;
      }
    }
  }
}

TEST(UnstableStep, IsTheCriticalOneOfEqualRates) {
  for (const Bar& bar : every_bar()) {
    const PatchyBar patchy{bar, points_of(bar), [](Index) { return 1.0; }};
    EXPECT_NEAR(patchy.unstable_sum() / patchy.critical_sum(), 1, 100 * round_off) << name_of(bar);
  }
}

/// In the middle of hat functions all points see as much of a wave: of the speed of sound counts the mean
/// square, by mass, with 3/4 of the mass at 2 m/s and the rest at 1 m/s. What has no mass only fills blocks.
TEST(UnstableStep, IsByMass) {
  auto particles = points_of({.shape = Linear{}, .transfer = Apic{}});
  const std::size_t column = particles.add_column({"share", "s", "-"}, 1);
  for (Index p = 0; p < particles.size(); ++p) {
    const Index kind = p % 4;
    particles.mass.component(0)[p] = kind == 0 ? 1 : kind == 2 ? 3 : 0;
    particles.column(column).component(0)[p] = kind == 0 ? 1 : kind == 2 ? 4 : 1e9;
  }
  const StressUpdateBy<1, 1, Patchwork> stress{Patchwork{{1000, 1000, 0}}, particles};

  const double dt = unstable_step(particles, stress, cube<1>(Bar::num_cells, Bar::spacing, true), Linear{},
                                  Apic{}, Order::usl);

  EXPECT_NEAR(dt, Bar::spacing / std::sqrt(3.25), 100 * round_off * Bar::spacing);
}

}  // namespace
}  // namespace scree::mpm
