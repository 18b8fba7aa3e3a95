// Columns under their own weight: at rest for ever, and loaded slowly from nothing.

#include "bodies.hpp"
#include "neo_hookean.hpp"

#include <scree/mpm/geostatic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr double height = 1;      // [m]
constexpr double density = 1000;  // [kg/m^3]

/// A column of 1 m on a rough base, an empty cell above it.
[[nodiscard]] CartesianGrid<1> column_grid(Index num_cells) {
  return {Vector<1>{0.0}, Vector<1>{height / static_cast<double>(num_cells)}, {num_cells + 1}, {false}};
}

/// A solid whose weight grows slowly from nothing to rho g H = strain (K + 4/3 G).
class LoadedColumn {
 public:
  LoadedColumn(const AnyShape& shape, const AnyTransfer& rule, Index num_cells, double strain)
      : num_cells_{num_cells}, strain_{strain} {
    const auto grid = column_grid(num_cells);
    auto particles = seed_box<1, 1>(grid, Vector<1>{0.0}, Vector<1>{height}, {2}, density);
    stages_.stress = std::make_unique<StressUpdateBy<1, 1, NeoHookean>>(solid, particles);
    stages_.transfer = make_transfer<1, 1>(shape, rule);
    stages_.boundaries.push_back(make_wall<1>(NoSlip{}, 0, Side::low));
    const auto position = particles.position.values();
    origins_.assign(position.begin(), position.end());
    state_ = std::make_unique<State<1, 1>>(start(std::move(particles), grid, stages_, one_thread));
    load();
  }

  /// Of the load, in twenty of its slowest periods 4 H/c: what still swings is no more than 1/(4 N^2) of it.
  static constexpr int num_periods = 20;
  static constexpr double still_swings = 1.0 / (4 * num_periods * num_periods);

  /// Calls visit(X, x, stress over rho g H) for every point.
  template <class Visit>
  void for_each_point(Visit&& visit) const {
    const auto& particles = state_->particles;
    for (Index p = 0; p < particles.size(); ++p) {
      if (!(particles.mass.component(0)[p] > 0)) continue;
      visit(origins_[static_cast<std::size_t>(particles.id.component(0)[p])],
            particles.position.component(0)[p], particles.stress.component(0)[p] / (strain_ * modulus()));
    }
  }

  /// Mean over the points of |sigma - exact| over rho g H: -(1 - X/H) whatever the law.  Eq. (M90)
  [[nodiscard]] double stress_error() const {
    double sum = 0;
    for_each_point([&](double X, double, double stress) { sum += std::abs(stress + 1 - X / height); });
    return sum / static_cast<double>(origins_.size());
  }

  /// The same of the means of cells.
  [[nodiscard]] double cell_stress_error() const {
    std::vector<double> sums(static_cast<std::size_t>(num_cells_), 0.0);
    for_each_point([&](double X, double, double stress) {
      sums[static_cast<std::size_t>(X / height * static_cast<double>(num_cells_))] +=
          (stress + 1 - X / height) / 2;
    });
    double sum = 0;
    for (const double error : sums) sum += std::abs(error);
    return sum / static_cast<double>(num_cells_);
  }

  /// Modulus that the mean settlement tells: rho g H^2/(3 u) over K + 4/3 G [-].
  [[nodiscard]] double modulus_told() const {
    double settlement = 0;
    double expected = 0;
    for_each_point([&](double X, double x, double) {
      settlement += X - x;
      expected += strain_ * (X - X * X / (2 * height));
    });
    return expected / settlement;
  }

  static constexpr NeoHookean solid{.lambda = 5e5, .mu = 2.5e5, .density = density};
  /// K + 4/3 G, K = lambda + 2/3 mu.
  [[nodiscard]] static double modulus() { return solid.lambda + 2 * solid.mu; }

 private:
  void load() {
    const double dt = 0.3 * height / static_cast<double>(num_cells_) / solid.wave_speed();
    const double duration = num_periods * 4 * height / solid.wave_speed();
    const auto num_steps = static_cast<int>(duration / dt);
    const double gravity = strain_ * modulus() / (density * height);
    for (int n = 0; n < num_steps; ++n) {
      stages_.gravity[0] = -gravity * (1 - std::cos(std::numbers::pi * (n + 0.5) / num_steps)) / 2;
      step(*state_, stages_, dt, one_thread);
    }
  }

  Index num_cells_;
  double strain_;
  Stages<1, 1> stages_;
  std::unique_ptr<State<1, 1>> state_;
  std::vector<double> origins_;  // by id [m]
};

constexpr double small_strain = 1e-4;

TEST(SelfWeight, HasTheErrorOfStressOfAPointsPlaceInItsCell) {  // Eqs. (M90), (M91)
  // The gradient that a point sees is off by v'' times its distance from the place where it would be exact,
  // and so is the stress, by rho g times it: a quarter of a cell with hat functions, whose gradient is that
  // of the middle; m_3/(2 M) = 3/32 of a cell with the affine weights of quadratic ones.
  for (const auto& [shape, distance] : {std::pair{AnyShape{Linear{}}, 1.0 / 4}, {Quadratic{}, 3.0 / 32}}) {
    for (const Index num_cells : {10, 20}) {
      const LoadedColumn column{shape, Apic{}, num_cells, small_strain};

      const double h = height / static_cast<double>(num_cells);
      // The topmost cell has no material above to see, and counts h/H.
      EXPECT_NEAR(column.stress_error(), distance * h, distance * h * h + LoadedColumn::still_swings);
      EXPECT_LE(column.cell_stress_error(), h * h / 2 + LoadedColumn::still_swings);
    }
  }
}

TEST(SelfWeight, SettlesByTheOedometricModulus) {  // K + 4/3 G
  for (const AnyShape& shape : {AnyShape{Linear{}}, AnyShape{Quadratic{}}}) {
    for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
      for (const Index num_cells : {10, 20}) {
        const LoadedColumn column{shape, rule, num_cells, small_strain};

        const double h = height / static_cast<double>(num_cells);
        EXPECT_NEAR(column.modulus_told(), 1, h * h / 2 + LoadedColumn::still_swings + small_strain);
      }
    }
  }
}

TEST(SelfWeight, IsLostUnderLinearShapesOncePointsCrossCells) {
  // The top settles by half the strain, 0.01 m: more than a quarter of a cell from 25 cells on.
  constexpr double strain = 0.02;
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const double before = LoadedColumn{Linear{}, rule, 20, strain}.stress_error();
    const double after = LoadedColumn{Linear{}, rule, 40, strain}.stress_error();

    EXPECT_LE(before, 1.0 / (4 * 20) + strain / 2);
    EXPECT_GT(after, 2 * before);
    // The remedy: quadratic shapes.
    EXPECT_LT(LoadedColumn(Quadratic{}, rule, 40, strain).stress_error(), before / 4);
  }
}

/// A fluid at rest in a periodic basin after 1e4 steps: speeds and pressures.
struct Basin {
  double largest_speed;   ///< ever, over the speed of sound [-]
  double pressure_error;  ///< of the means of cells, largest, over rho g H [-]
};

constexpr double compression = 1e-4;  // rho g H/K
constexpr Index num_layers = 10;

[[nodiscard]] Basin basin_at_rest(const AnyShape& shape, const AnyTransfer& rule,
                                  const Averaging& averaging = {}) {
  constexpr double gravity = 9.81;
  constexpr double h = height / num_layers;
  const Fluid fluid{
      .bulk_modulus = density * gravity * height / compression, .reference_density = density, .viscosity = 0};
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{h, h}, {2, num_layers + 1}, {true, false}};
  auto particles = seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{2 * h, height}, {2, 2}, density);
  auto stages = stages_of<2, 2>(particles, shape, rule, fluid);
  stages.boundaries.push_back(make_wall<2>(NoSlip{}, 1, Side::low));
  stages.gravity[1] = -gravity;
  stages.averaging = averaging;
  set_geostatic(particles, *stages.stress, 1, height, gravity);
  auto state = start(std::move(particles), grid, stages, one_thread);
  const double dt = stable_time_step(grid, state.rates, {}).dt;
  Basin basin{};
  for (int n = 0; n < 10000; ++n) {
    step(state, stages, dt, one_thread);
    basin.largest_speed =
        std::max(basin.largest_speed, largest(state.particles.velocity) / state.rates.wave_speed);
  }
  std::array<double, num_layers> sums{};
  std::array<double, num_layers> counts{};
  for (Index p = 0; p < state.particles.size(); ++p) {
    if (!(state.particles.mass.component(0)[p] > 0)) continue;
    const auto layer = static_cast<std::size_t>(state.particles.position.component(1)[p] / h);
    sums[layer] -= state.particles.stress.component(3)[p];
    ++counts[layer];
  }
  for (std::size_t i = 0; i < num_layers; ++i) {
    const double depth = 1 - (static_cast<double>(i) + 0.5) / num_layers;
    basin.pressure_error =
        std::max(basin.pressure_error, std::abs(sums[i] / counts[i] / (density * gravity * height) - depth));
  }
  return basin;
}

TEST(Basin, RestsUnderLinearShapes) {
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const Basin basin = basin_at_rest(Linear{}, rule);

    // What forces leave out of balance is the square of the compression over a cell; densities are off by all
    // of it.
    EXPECT_LE(basin.largest_speed, compression * compression / num_layers);
    EXPECT_LE(basin.pressure_error, compression / 2);
  }
}

TEST(Basin, MovesUnderQuadraticShapesUntilTheTopmostCellBearsItself) {
  // Nodes above the surface see a part of their points only: the topmost cell is out of balance by a part of
  // its own weight, rho g h, which sets out as waves of pressure. That it is of the topmost cell says the
  // size; the same with ten times the compression.
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const Basin basin = basin_at_rest(Quadratic{}, rule);

    EXPECT_GT(basin.pressure_error, compression);
    EXPECT_LE(basin.pressure_error, 0.5 / num_layers);
    EXPECT_LE(basin.largest_speed, 0.5 / num_layers * compression);
  }
}

TEST(Basin, IsNotMendedByMeansOverCells) {  // Eqs. (M131), (M132)
  // What is out of balance is the weight of the topmost cell, not the noise of points within one: means
  // leave it, and that of pressure misses the slope of pressure over that cell as well.
  const double without = basin_at_rest(Quadratic{}, Apic{}).pressure_error;

  EXPECT_GT(basin_at_rest(Quadratic{}, Apic{}, {.volume_change = true}).pressure_error, without / 2);
  EXPECT_GT(basin_at_rest(Quadratic{}, Apic{}, {.pressure = true}).pressure_error, without);
}

TEST(Basin, IsShakenByMeansOverCellsUnderFlip) {  // Eqs. (M131), (M132)
  // Means see no motion that keeps the volume of cells but not of points, so nothing resists it, and FLIP
  // keeps what of it the nodes do not see. APIC, the remedy, loses it: what moves is the topmost cell's part,
  // as without means.
  constexpr double of_topmost_cell = 0.5 / num_layers * compression;
  for (const Averaging& averaging : {Averaging{.volume_change = true}, Averaging{.pressure = true}}) {
    EXPECT_GT(basin_at_rest(Quadratic{}, PicFlip{1}, averaging).largest_speed, 10 * of_topmost_cell);
    EXPECT_LE(basin_at_rest(Quadratic{}, Apic{}, averaging).largest_speed, of_topmost_cell);
  }
}

}  // namespace
}  // namespace scree::mpm
