// From which step on waves grow in two and three dimensions, and under filtered velocities.

#include "periodic_bar.hpp"
#include "schemes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Index num_cells = Bar::num_cells;
constexpr double spacing = Bar::spacing;
constexpr double dt = 0.01;  // [s]

/// A bar along an axis of a mesh, two cells across, whose points move along it and all alike in each place.
template <int D>
[[nodiscard]] double growth_along(int axis, const Bar& bar, double sum, int num_steps) {
  Indices<D> count{};
  count.fill(2);
  count[static_cast<std::size_t>(axis)] = num_cells;
  const CartesianGrid<D> grid{Vector<D>::Zero(), Vector<D>::Constant(spacing), count,
                              cube<D>(1, 1, true).is_periodic()};
  auto particles = filled<D>(grid, bar.per_cell);
  auto line = points_of(bar);
  disturb(line, dt);
  for (Index p = 0; p < particles.size(); ++p) {
    const double place = particles.position.component(axis)[p] / spacing * static_cast<double>(bar.per_cell);
    const auto same = static_cast<Index>(place);
    particles.velocity.component(axis)[p] = line.velocity.component(0)[same];
    particles.velocity_gradient.component(axis + D * axis)[p] = line.velocity_gradient.component(0)[same];
  }
  for (double& x : particles.position.values()) x += bar.offset * spacing;
  EXPECT_NEAR(critical_sums(particles, grid, bar.shape, bar.transfer, bar.order)[axis] / critical_sum_of(bar),
              1, 100 * round_off)
      << name_of(bar);
  auto stages = stages_of<D, D>(particles, bar.shape, bar.transfer, fluid_of(sum, bar.viscous, dt));
  stages.order = bar.order;
  return growth_of(std::move(particles), grid, stages, dt, num_steps);
}

template <int D>
void expect_growth_beyond_the_sum_of_an_axis() {
  constexpr int num_steps = 200;
  for (const Bar& bar : {Bar{.shape = Linear{}, .transfer = Apic{}, .viscous = 0.5},
                         Bar{.shape = Quadratic{}, .transfer = Apic{}, .per_cell = 2, .offset = 0.1},
                         Bar{.shape = Linear{}, .transfer = PicFlip{1}, .per_cell = 2}}) {
    const double sum = critical_sum_of(bar);
    for (int axis = 0; axis < D; ++axis) {
      EXPECT_LE(growth_along<D>(axis, bar, 0.97 * sum, num_steps), 2)
          << axis << " of " << D << " " << name_of(bar);
      EXPECT_GE(growth_along<D>(axis, bar, 1.03 * sum, num_steps), std::pow(1.03, num_steps) / 10)
          << axis << " of " << D << " " << name_of(bar);
    }
  }
}

TEST(CriticalSum, IsWhereWavesAlongAnyAxisOfAMeshBeginToGrow) {  // Eqs. (M173), (M174)
  expect_growth_beyond_the_sum_of_an_axis<2>();
  expect_growth_beyond_the_sum_of_an_axis<3>();
}

/// A mesh of so many cells along each axis, disturbed in all directions.
template <int D>
[[nodiscard]] double growth_in(Index cells, const Bar& bar, double sum, int num_steps,
                               const Averaging& averaging = {}) {
  const auto grid = cube<D>(cells, spacing, true);
  auto particles = filled<D>(grid, bar.per_cell);
  for (double& x : particles.position.values()) x += bar.offset * spacing;
  disturb(particles, dt);
  auto stages = stages_of<D, D>(particles, bar.shape, bar.transfer, fluid_of(sum, bar.viscous, dt));
  stages.order = bar.order;
  stages.averaging = averaging;
  if (bar.xpic_order > 0) stages.xpic = make_xpic<D, D>(bar.shape, bar.xpic_order);
  return growth_of(std::move(particles), grid, stages, dt, num_steps);
}

/// In the middle of hat functions the wave u exp(i kappa x) has a stiffness of 4 (a + b - 2 a b), a and b the
/// squares of sin(kappa h/2) along the axes, and alike in space: never more than that along an axis, 4.
/// (M17) has sqrt(D) times less.
template <int D>
void expect_the_limit_of_one_dimension(Index cells) {
  constexpr int num_steps = 200;
  const Bar bar{.shape = Linear{}, .transfer = Apic{}};
  EXPECT_LE(growth_in<D>(cells, bar, 0.97, num_steps), 2);
  EXPECT_GE(growth_in<D>(cells, bar, 1.03, num_steps), std::pow(1.03, num_steps) / 10);

  const double limit = stable_time_step(cube<D>(cells, spacing, true), {.wave_speed = 1}, {.acoustic = 1}).dt;
  EXPECT_NEAR(limit, spacing / std::sqrt(D), 4 * round_off);
}

TEST(ApicOnHatFunctions, HasTheSoundLimitOfOneDimensionInTwoAndThree) {  // Eq. (M17)
  expect_the_limit_of_one_dimension<1>(32);
  expect_the_limit_of_one_dimension<2>(16);
  expect_the_limit_of_one_dimension<3>(8);
}

/// (M174) of waves along the diagonal of D dimensions with as many halves of a mesh along each axis, of
/// points on nodes under FLIP and `usl`: P and Lambda are products of what the axes see.
template <class S>
[[nodiscard]] double sum_of_diagonal(const S& shape, double on_node, int D, int num_waves) {
  double least = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= num_waves; ++n) {
    std::complex<double> velocity = 0;
    std::complex<double> gradient = 0;
    for (std::size_t i = 0; i < S::support; ++i) {
      const auto wave = std::polar(1.0, n * std::numbers::pi / num_waves * static_cast<double>(i));
      velocity += shape.weights(on_node)[i] * wave;
      gradient += shape.gradients(on_node)[i] * wave;
    }
    const double P = std::pow(std::norm(velocity), D);
    const double Lambda = D * std::norm(gradient) * std::pow(std::norm(velocity), D - 1);
    if (Lambda > 0) least = std::min(least, 4 / (Lambda * (2 - P)));
  }
  return least;
}

/// Of all waves that of the diagonal is the first to grow there.
template <int D>
void expect_growth_along_the_diagonal(double sum, Index cells) {
  constexpr int num_steps = 200;
  const Bar bar{.shape = Quadratic{}, .transfer = PicFlip{1}, .offset = 0.5};
  EXPECT_NEAR(sum_of_diagonal(Quadratic{}, 1, D, 1000), sum, 0.005);  // as printed
  EXPECT_NEAR(sum_of_diagonal(Linear{}, 0, D, 1000), 1.0 / D, 100 * round_off);

  const double of_mesh = sum_of_diagonal(Quadratic{}, 1, D, static_cast<int>(cells) / 2);
  EXPECT_LE(growth_in<D>(cells, bar, 0.97 * of_mesh, num_steps), 2);
  EXPECT_GE(growth_in<D>(cells, bar, 1.03 * of_mesh, num_steps), std::pow(1.03, num_steps) / 10);
}

TEST(FlipOnQuadraticShapes, GrowsWavesAlongTheDiagonalSooner) {  // Eq. (M174)
  expect_growth_along_the_diagonal<1>(2.74, 32);
  expect_growth_along_the_diagonal<2>(2.04, 16);
  expect_growth_along_the_diagonal<3>(1.87, 16);
}

/// Below the sum no wave grows, and beyond it one does by that factor per step: see
/// CriticalSum.IsWhereWavesBeginToGrow.
TEST(FilteredVelocities, HaveACriticalSumOfTheirOwn) {  // Eq. (M182)
  constexpr int num_steps = 200;
  for (const int xpic_order : {1, 2, 3, 8}) {
    for (const Index per_cell : {1, 2, 3}) {
      for (const AnyShape& shape : every_shape_for(static_cast<double>(per_cell))) {
        for (const Order order : {Order::usl, Order::musl, Order::usf}) {
          const Bar bar{.shape = shape,
                        .transfer = PicFlip{1},
                        .order = order,
                        .per_cell = per_cell,
                        .offset = per_cell == 2 ? 0.1 : 0,
                        .viscous = 0.5,
                        .xpic_order = xpic_order};
          const double sum = critical_sum_of(bar);
          EXPECT_LE(growth_in<1>(num_cells, bar, 0.97 * sum, num_steps), 2) << name_of(bar);
          EXPECT_GE(growth_in<1>(num_cells, bar, 1.03 * sum, num_steps), std::pow(1.03, num_steps) / 10)
              << name_of(bar);
        }
      }
    }
  }
}

/// PIC is the filter of order 1.
TEST(FilteredVelocities, HaveTheSumOfPicAtOrderOne) {  // Eq. (M182)
  for (const AnyShape& shape : every_shape_for(2)) {
    for (const Order order : {Order::usl, Order::musl, Order::usf}) {
      const Bar filtered{
          .shape = shape, .transfer = PicFlip{1}, .order = order, .per_cell = 2, .xpic_order = 1};
      const Bar pic{.shape = shape, .transfer = PicFlip{0}, .order = order, .per_cell = 2};
      EXPECT_NEAR(critical_sum_of(filtered), critical_sum_of(pic), 100 * round_off) << name_of(filtered);
    }
  }
}

/// (M174) of FLIP and `usl` with the mean of g over the points of a cell in place of g.
[[nodiscard]] double sum_of_means(Index per_cell) {
  constexpr Quadratic shape{};
  constexpr int num_waves = 32;
  double least = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= num_waves; ++n) {
    double P = 0;
    std::complex<double> gradient = 0;
    for (Index p = 0; p < per_cell; ++p) {
      const double place = (static_cast<double>(p) + 0.5) / static_cast<double>(per_cell);
      const double base = std::floor(place - Quadratic::shift);
      std::complex<double> velocity = 0;
      for (std::size_t i = 0; i < Quadratic::support; ++i) {
        const auto wave = std::polar(1.0, n * std::numbers::pi / num_waves * (base + static_cast<double>(i)));
        velocity += shape.weights(place - base)[i] * wave;
        gradient += shape.gradients(place - base)[i] * wave / static_cast<double>(per_cell);
      }
      P += std::norm(velocity) / static_cast<double>(per_cell);
    }
    if (std::norm(gradient) > 0) least = std::min(least, 4 / (std::norm(gradient) * (2 - P)));
  }
  return least;
}

TEST(MeansOverCells, BearMoreThanTheCriticalSum) {  // Eqs. (M131), (M132), (M174)
  constexpr int num_steps = 200;
  const Bar bar{.shape = Quadratic{}, .transfer = PicFlip{1}, .per_cell = 3};
  const double sum = sum_of_means(3);
  EXPECT_NEAR(critical_sum_of(bar), 1.31, 0.005);
  EXPECT_NEAR(sum, 1.72, 0.005);

  for (const Averaging& averaging : {Averaging{.volume_change = true}, Averaging{.pressure = true}}) {
    EXPECT_LE(growth_in<1>(num_cells, bar, 0.97 * sum, num_steps, averaging), 2);
    EXPECT_GE(growth_in<1>(num_cells, bar, 1.03 * sum, num_steps, averaging), std::pow(1.03, num_steps) / 10);
  }
}

/// A mesh of cells that are alike and of 2^D points each, of which the first has 19 times the sum of another,
/// disturbed in all directions.
template <int D>
class PatchyMesh {
 public:
  explicit PatchyMesh(const Bar& bar) : bar_{bar}, particles_{filled<D>(grid_, 2)} {
    const std::size_t column = particles_.add_column({"share", "s", "-"}, 1);
    for (Index p = 0; p < particles_.size(); ++p) {
      bool is_first = true;
      for (int axis = 0; axis < D; ++axis) {
        double& x = particles_.position.component(axis)[p];
        is_first = is_first && x / spacing - std::floor(x / spacing) < 0.5;
        x += bar.offset * spacing;
      }
      particles_.column(column).component(0)[p] = is_first ? 1 : 1.0 / 19;
    }
  }
  /// The sum of points of share 1 from which on waves grow, by (M199): the step at which it is 1 is one of
  /// `dt` times r, and the parts of sound and viscosity have r^2 and r of it.
  [[nodiscard]] double unstable_sum() const {
    auto points = particles_;
    const auto stages = stages_with(points, 1);
    const double r = unstable_step(points, *stages.stress, grid_, bar_.shape, bar_.transfer, bar_.order) / dt;
    return (1 - bar_.viscous) * r * r + bar_.viscous * r;
  }
  /// @param sum of points of share 1
  [[nodiscard]] double grown(double sum, int num_steps, const Averaging& averaging) const {
    auto points = particles_;
    disturb(points, dt);
    auto stages = stages_with(points, sum);
    stages.averaging = averaging;
    return growth_of(std::move(points), grid_, stages, dt, num_steps);
  }

  /// The points after some steps.
  [[nodiscard]] Particles<D> after(int num_steps, double sum, const Averaging& averaging) const {
    auto points = particles_;
    disturb(points, dt);
    auto stages = stages_with(points, sum);
    stages.averaging = averaging;
    auto state = start(std::move(points), grid_, stages, {1});
    for (int n = 0; n < num_steps; ++n) step(state, stages, dt, {1});
    return std::move(state.particles);
  }

 private:
  [[nodiscard]] Stages<D, D> stages_with(Particles<D>& points, double sum) const {
    Stages<D, D> stages;
    stages.stress =
        std::make_unique<StressUpdateBy<D, D, Patchwork>>(Patchwork{fluid_of(sum, bar_.viscous, dt)}, points);
    stages.transfer = make_transfer<D, D>(bar_.shape, bar_.transfer);
    stages.order = bar_.order;
    return stages;
  }

  Bar bar_;
  CartesianGrid<D> grid_ = cube<D>(16, spacing, true);
  Particles<D> particles_;
};

/// On hat functions means leave waves along an axis as they are, and with both no other grows sooner. With
/// one alone waves grow that are none of (M199): what does not is at most twice as large in twice the time.
TEST(MeansOverCells, BearTheCriticalSumOnHatFunctions) {  // Eqs. (M131), (M132), (M199)
  constexpr int num_steps = 200;
  constexpr Averaging both{.volume_change = true, .pressure = true};
  std::vector<AnyTransfer> transfers = every<AnyTransfer>();
  transfers.emplace_back(PicFlip{0.5});
  for (const AnyTransfer& transfer : transfers) {
    for (const Order order : {Order::usl, Order::musl, Order::usf}) {
      for (const double viscous : {0.0, 0.5}) {
        const Bar bar{.shape = Linear{},
                      .transfer = transfer,
                      .order = order,
                      .per_cell = 2,
                      .offset = 0.1,
                      .viscous = viscous};
        const PatchyMesh<2> mesh{bar};
        const double sum = mesh.unstable_sum();
        EXPECT_LE(mesh.grown(0.97 * sum, num_steps, both), 2) << name_of(bar);
        EXPECT_GE(mesh.grown(1.03 * sum, num_steps, both), std::pow(1.03, num_steps) / 10) << name_of(bar);
        EXPECT_GT(mesh.grown(0.6 * sum, num_steps, {.volume_change = true}), 2) << name_of(bar);
        EXPECT_GT(mesh.grown(0.6 * sum, num_steps, {.pressure = true}), 2) << name_of(bar);
      }
    }
  }
}

/// Points of a cell all see the same strain there and weigh stress alike, whatever their stiffness.
TEST(MeansOverCells, AreNoChangeOnHatFunctionsInOneDimension) {  // Eqs. (M131), (M132)
  constexpr int num_steps = 200;
  // Velocities are those of a disturbance, 1e-10 h/dt. Densities and stresses stand beside 1 and K: some
  // fifty roundings of those in a step change a velocity by as many of h/dt, times the sum, at most 1.
  constexpr double rounding = num_steps * 50 * round_off * spacing / dt;
  static_assert(rounding < 0.02 * disturbance * spacing / dt);
  for (const AnyTransfer& transfer : every<AnyTransfer>()) {
    for (const Order order : {Order::usl, Order::musl, Order::usf}) {
      const Bar bar{.shape = Linear{}, .transfer = transfer, .order = order, .per_cell = 2, .offset = 0.1};
      const PatchyMesh<1> mesh{bar};
      const double sum = std::min(0.5 * mesh.unstable_sum(), 1.0);
      const auto expected = mesh.after(num_steps, sum, {});
      for (const Averaging& averaging : {Averaging{.volume_change = true}, Averaging{.pressure = true}}) {
        const auto points = mesh.after(num_steps, sum, averaging);
        for (Index p = 0; p < points.size(); ++p) {
          EXPECT_NEAR(points.velocity.component(0)[p], expected.velocity.component(0)[p], rounding)
              << name_of(bar);
          EXPECT_NEAR(points.position.component(0)[p], expected.position.component(0)[p],
                      num_steps * rounding * dt)
              << name_of(bar);
        }
      }
    }
  }
}

/// So they grow from the same step on.
TEST(MeansOverCells, HaveTheCriticalSumOfNoneOnHatFunctionsInOneDimension) {  // Eq. (M199)
  constexpr int num_steps = 200;
  const PatchyMesh<1> mesh{{.shape = Linear{}, .transfer = PicFlip{1}, .per_cell = 2, .offset = 0.1}};
  const double sum = mesh.unstable_sum();

  for (const Averaging& averaging : {Averaging{.volume_change = true}, Averaging{.pressure = true}}) {
    EXPECT_LE(mesh.grown(0.97 * sum, num_steps, averaging), 2);
    EXPECT_GE(mesh.grown(1.03 * sum, num_steps, averaging), std::pow(1.03, num_steps) / 10);
  }
}

}  // namespace
}  // namespace scree::mpm
