// Columns under their own weight: at rest for ever, and loaded slowly from nothing.

#include "bodies.hpp"
#include "neo_hookean.hpp"
#include "schemes.hpp"

#include <scree/mpm/geostatic.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
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

  /// Of the load, in twelve of its slowest periods 4 H/c, as (1 - cos)^2: what still swings is no more of it
  /// than twice the jump of its fifth derivative, 4 (2 pi)^4/T^5, over omega^5.
  static constexpr int num_periods = 12;
  static constexpr double still_swings =
      4 / (std::numbers::pi * (1.0 * num_periods * num_periods * num_periods * num_periods * num_periods));

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

  /// Largest distance of a point from where it belongs, over the strain and H.
  [[nodiscard]] double place_error() const {
    double worst = 0;
    for_each_point([&](double X, double x, double) {
      worst = std::max(worst, std::abs((X - x) / (strain_ * height) - X / height * (1 - X / (2 * height))));
    });
    return worst;
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
      const double turn = 2 * std::numbers::pi * (n + 0.5) / num_steps;
      const double share =
          (1.5 * turn - 2 * std::sin(turn) + std::sin(2 * turn) / 4) / (3 * std::numbers::pi);
      stages_.gravity[0] = -gravity * share;
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

/// log2 of errors on 10 and on 20 cells; what still swings may change it by so much.
struct Rate {
  double value;
  double tolerance;
};
[[nodiscard]] Rate rate_of(double coarse, double fine) {
  // And the next order, 1 + h/H and less.
  const double tolerance =
      LoadedColumn::still_swings * (1 / coarse + 1 / fine) + (1.0 / 10 - 1.0 / 20) / height;
  return {std::log2(coarse / fine), tolerance / std::numbers::ln2};
}

TEST(SelfWeight, SettlesWithSecondOrderUnderEveryShapeAndTransfer) {  // Eq. (M194)
  constexpr double tiny_strain = 1e-6;                                // the next order in it is as small
  for (const AnyShape& shape : every_shape_for(2)) {
    const bool is_spline = std::holds_alternative<Quadratic>(shape) || std::holds_alternative<Cubic>(shape);
    for (const AnyTransfer& rule : every<AnyTransfer>()) {
      const LoadedColumn coarse{shape, rule, 10, tiny_strain};
      const LoadedColumn fine{shape, rule, 20, tiny_strain};

      const Rate of_place = rate_of(coarse.place_error(), fine.place_error());
      EXPECT_NEAR(of_place.value, 2, of_place.tolerance);
      if (is_spline) {  // of hat functions the means of cells have no such error
        const Rate of_stress = rate_of(coarse.cell_stress_error(), fine.cell_stress_error());
        EXPECT_NEAR(of_stress.value, 2, of_stress.tolerance);
      } else {
        // Nodes are where they belong, points between them by hat functions: off by u'' h^2/2 xi (1 - xi).
        EXPECT_NEAR(fine.place_error(), 3.0 / 32 / (20 * 20), LoadedColumn::still_swings + tiny_strain);
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

constexpr double compression = 1e-4;  // rho g H/K
constexpr Index num_layers = 10;      // cells of height h that make up H
using Layers = std::array<double, num_layers>;

/// What a basin holds: points along each axis of a cell, and its depth [h].
struct Filling {
  Index per_axis = 2;
  double depth = num_layers;
};

/// A fluid at rest in a periodic basin after 1e4 steps: speeds and pressures.
struct Basin {
  double largest_speed = 0;   ///< ever, over the speed of sound [-]
  double pressure_error = 0;  ///< of the means of cells at the end, largest, over rho g H [-]
  Layers mean_error{};  ///< of cells over the last half of the time, over rho g h, from the floor up [-]
};

/// Means over the points of each cell of p - rho g z, z their depth, over rho g h.
[[nodiscard]] Layers pressure_errors(const Particles<2>& particles, const Filling& filling, double weight) {
  Layers sums{};
  Layers counts{};
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    const double place = particles.position.component(1)[p] / height * num_layers;
    const auto layer = static_cast<std::size_t>(place);
    sums[layer] += -particles.stress.component(3)[p] / weight - (filling.depth - place);
    ++counts[layer];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
  return sums;
}

[[nodiscard]] double largest_of(const Layers& errors) {
  double result = 0;
  for (const double error : errors) result = std::max(result, std::abs(error));
  return result;
}

[[nodiscard]] Basin basin_at_rest(const AnyShape& shape, const AnyTransfer& rule,
                                  const Averaging& averaging = {}, const Filling& filling = {}) {
  constexpr double gravity = 9.81;
  constexpr double h = height / num_layers;
  const Fluid fluid{
      .bulk_modulus = density * gravity * height / compression, .reference_density = density, .viscosity = 0};
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{h, h}, {2, num_layers + 1}, {true, false}};
  auto particles = seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{2 * h, filling.depth * h},
                                  {filling.per_axis, filling.per_axis}, density);
  auto stages = stages_of<2, 2>(particles, shape, rule, fluid);
  stages.boundaries.push_back(make_wall<2>(NoSlip{}, 1, Side::low));
  stages.gravity[1] = -gravity;
  stages.averaging = averaging;
  set_geostatic(particles, *stages.stress, 1, filling.depth * h, gravity);
  auto state = start(std::move(particles), grid, stages, one_thread);
  const double dt = stable_time_step(grid, state.rates, {}).dt;
  Basin basin;
  constexpr int num_steps = 10000;
  for (int n = 0; n < num_steps; ++n) {
    step(state, stages, dt, one_thread);
    basin.largest_speed =
        std::max(basin.largest_speed, largest(state.particles.velocity) / state.rates.wave_speed);
    if (n < num_steps / 2) continue;
    const Layers errors = pressure_errors(state.particles, filling, density * gravity * h);
    for (std::size_t i = 0; i < errors.size(); ++i) basin.mean_error[i] += 2 * errors[i] / num_steps;
    basin.pressure_error = largest_of(errors) / num_layers;
  }
  return basin;
}

using Row = std::vector<double>;  // one number for each node that moves, or for each point

/// Solves a symmetric positive system by Gauss's elimination.
[[nodiscard]] Row solve(std::vector<Row> matrix, Row right) {
  const std::size_t size = right.size();
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = k + 1; i < size; ++i) {
      const double factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < size; ++j) matrix[i][j] -= factor * matrix[k][j];
      right[i] -= factor * right[k];
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    for (std::size_t j = k + 1; j < size; ++j) right[k] -= matrix[k][j] * right[j];
    right[k] /= matrix[k][k];
  }
  return right;
}

/// A column of points of one mass whose pressures balance their weight on the mesh: what that adds to
/// rho g z, by strains as nodes that move make them. Lengths over h, pressures over rho g h.  Eq. (M193)
class BalanceOfTheMesh {
 public:
  BalanceOfTheMesh(const Scheme& scheme, const Filling& filling) {
    const double volume = 1 / static_cast<double>(filling.per_axis);
    // The node of the floor is held; the last is that of the stencil of the topmost point.
    const auto num_nodes =
        static_cast<std::size_t>(filling.depth - volume / 2 - scheme.shift()) + scheme.support() - 1;
    imbalance_.assign(num_nodes, 0);
    std::vector<Row> stiffness(num_nodes, Row(num_nodes, 0.0));
    std::vector<Row> slopes;
    double mass_of_last = 0;
    for (double place = volume / 2; place < filling.depth; place += volume) {
      places_.push_back(place);
      slopes.emplace_back(num_nodes, 0.0);
      Row& b = slopes.back();
      Row weights(num_nodes, 0.0);
      std::visit([&](const auto& shape) { see_nodes(shape, scheme, place, weights, b); }, scheme.shape);
      mass_of_last += volume * weights.back();
      for (std::size_t i = 0; i < num_nodes; ++i) {
        imbalance_[i] += volume * (b[i] * (filling.depth - place) - weights[i]);
        for (std::size_t j = 0; j < num_nodes; ++j) stiffness[i][j] += volume * b[i] * b[j];
      }
    }
    if (!(mass_of_last > Stages<2, 2>{}.mass_floor * volume)) leave_out_last(slopes, stiffness);
    const Row displacement = solve(stiffness, imbalance_);
    for (const Row& b : slopes) {
      added_.push_back(-std::inner_product(b.begin(), b.end(), displacement.begin(), 0.0));
    }
  }

  /// Of rho g z: the force that is left on nodes, from the one above the floor up, over rho g h.
  [[nodiscard]] const Row& imbalance() const { return imbalance_; }
  [[nodiscard]] bool is_that_of_the_fluid(double tolerance) const {
    return std::ranges::all_of(imbalance_, [&](double force) { return std::abs(force) <= tolerance; });
  }
  [[nodiscard]] Layers means_of_cells() const {
    Layers sums{};
    Layers counts{};
    for (std::size_t p = 0; p < places_.size(); ++p) {
      sums[static_cast<std::size_t>(places_[p])] += added_[p];
      ++counts[static_cast<std::size_t>(places_[p])];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    return sums;
  }
  /// Root of the sum of squares over the points: what they would have, all the energy of one.
  [[nodiscard]] double size() const {
    return std::sqrt(std::inner_product(added_.begin(), added_.end(), added_.begin(), 0.0));
  }

 private:
  /// Boxes that end at a node leave the next one no mass but rounding.  Eq. (M20)
  void leave_out_last(std::vector<Row>& slopes, std::vector<Row>& stiffness) {
    imbalance_.back() = 0;
    for (Row& b : slopes) b.back() = 0;
    for (Row& row : stiffness) row.back() = 0;
    std::fill(stiffness.back().begin(), stiffness.back().end(), 0.0);
    stiffness.back().back() = 1;
  }
  /// Forces that come home from the image of a node are turned round, weight too.  Eqs. (M14), (M200)
  template <class S>
  static void see_nodes(const S& shape, const Scheme& scheme, double place, Row& weights, Row& slopes) {
    const double base = std::floor(place - S::shift);
    const auto w = shape.weights(place - base);
    const auto b = scheme.has_affine_gradient() ? shape.affine(place - base) : shape.gradients(place - base);
    for (std::size_t j = 0; j < S::support; ++j) {
      const int node = static_cast<int>(base) + static_cast<int>(j);
      if (node == 0) continue;
      const auto moved = static_cast<std::size_t>(std::abs(node) - 1);
      weights[moved] += node < 0 ? -w[j] : w[j];
      slopes[moved] += node < 0 ? -b[j] : b[j];
    }
  }

  Row places_;
  Row imbalance_;
  Row added_;
};

/// Of a force that is none.
[[nodiscard]] double rounding_of_balance(const Filling& filling) {
  return 16 * round_off * num_layers * static_cast<double>(filling.per_axis);
}

/// Of a basin that starts beside its balance on the mesh and swings about it: means of cells, and speeds of
/// no more than that energy and what rounding of densities leaves, the square of the compression over a cell.
/// Where no force is left it does not swing: the pressure at the end is that of the fluid but for densities.
void expect_rest(const Scheme& scheme, const Filling& filling) {
  const BalanceOfTheMesh balance{scheme, filling};
  const Layers expected = balance.means_of_cells();

  const Basin basin = basin_at_rest(scheme.shape, scheme.rule, {}, filling);

  // Densities are off by the compression. Of waves, the slowest of 4 H/c = 80 steps, a mean over 5000
  // leaves 80/(5000 pi).
  const double tolerance = num_layers * compression / 2 + balance.size() * 80 / (5000 * std::numbers::pi);
  for (std::size_t i = 0; i < num_layers; ++i) {
    EXPECT_NEAR(basin.mean_error[i], expected[i], tolerance) << scheme.name() << " in cell " << i;
  }
  EXPECT_LE(basin.largest_speed, (balance.size() + compression) / num_layers * compression) << scheme.name();
  if (balance.is_that_of_the_fluid(rounding_of_balance(filling))) {
    EXPECT_LE(basin.pressure_error, compression / 2) << scheme.name();
  }
}

TEST(Basin, RestsAtThePressureOfTheMeshsOwnBalanceUnderEveryShapeAndTransfer) {  // Eq. (M193)
  std::vector<AnyTransfer> transfers = every<AnyTransfer>();
  transfers.emplace_back(PicFlip{1});
  for (const AnyShape& shape : every_shape_for(2)) {
    for (const AnyTransfer& rule : transfers) expect_rest({shape, rule}, {});
  }
}

/// Three points a cell, and a surface midway between nodes.
TEST(Basin, RestsAtThePressureOfTheMeshsOwnBalanceHoweverItIsFilled) {  // Eq. (M193)
  for (const Filling& filling : {Filling{3}, Filling{2, num_layers - 0.5}}) {
    for (const AnyShape& shape : every_shape_for(static_cast<double>(filling.per_axis))) {
      for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
        expect_rest({shape, rule}, filling);
      }
    }
  }
}

/// No force is left of rho g z under hat functions, nor under GIMP whose boxes fill the cells: the balance of
/// the mesh is that of the fluid.
TEST(Basin, IsInBalanceUnderHatFunctionsAndBoxesThatFillCells) {  // Eqs. (M111), (M193)
  for (const Filling& filling : {Filling{2}, Filling{3}, Filling{2, num_layers - 0.5}}) {
    const Gimp boxes{static_cast<double>(filling.per_axis)};
    for (const AnyTransfer& rule : every<AnyTransfer>()) {
      for (const AnyShape& shape : {AnyShape{Linear{}}, AnyShape{boxes}}) {
        const BalanceOfTheMesh balance{{shape, rule}, filling};
        EXPECT_TRUE(balance.is_that_of_the_fluid(rounding_of_balance(filling)));
      }
    }
  }
}

TEST(Basin, IsOutOfBalanceUnderQuadraticShapesTwiceAsMuchAtItsFloorAsAtItsSurface) {  // Eq. (M193)
  // Where material ends midpoints miss a part of what is cut off, and affine weights are no gradient.
  struct Case {
    AnyTransfer rule;
    Index per_axis;
    double of_floor;
    double tolerance = 0;  // beside rounding
  };
  for (const Case& at : {Case{Apic{}, 2, -1.0 / 128}, Case{Apic{}, 3, 2.0 / 243},
                         Case{Apic{}, 100, 1.0 / 60, 1.0 / (100 * 100)},  // midpoints: second order
                         Case{PicFlip{1}, 2, -1.0 / (8 * 2 * 2)}, Case{PicFlip{1}, 4, -1.0 / (8 * 4 * 4)},
                         Case{PicFlip{1}, 3, 0}, Case{PicFlip{1}, 5, 0}}) {
    const Row imbalance = BalanceOfTheMesh{{Quadratic{}, at.rule}, Filling{at.per_axis}}.imbalance();

    const double rounding = 16 * round_off * num_layers * static_cast<double>(at.per_axis);
    EXPECT_NEAR(imbalance[0], at.of_floor, at.tolerance + rounding);
    EXPECT_NEAR(imbalance[num_layers - 2], at.of_floor / 2, at.tolerance + rounding);
    EXPECT_NEAR(imbalance[num_layers], -at.of_floor / 2, at.tolerance + rounding);
    for (std::size_t i = 1; i < imbalance.size(); ++i) {
      const bool is_beside_surface = i + 2 == num_layers || i == num_layers;
      if (!is_beside_surface) {
        EXPECT_NEAR(imbalance[i], 0, rounding);
      }
    }
  }
}

TEST(Basin, RestsUnderQuadraticShapesWithOnePointACellOrThreeUnderTrueGradients) {  // Eq. (M193)
  // The remedies: in the middle of its cell a point has the weights and slopes of hat functions, and what
  // three miss where material ends they miss at the kinks of shapes, too.
  for (const auto& [rule, per_axis] :
       {std::pair{AnyTransfer{Apic{}}, Index{1}}, {PicFlip{1}, 1}, {PicFlip{1}, 3}, {Tpic{}, 3}}) {
    const Basin basin = basin_at_rest(Quadratic{}, rule, {}, Filling{per_axis});

    EXPECT_LE(basin.largest_speed, compression * compression / num_layers);  // as under linear shapes
    EXPECT_LE(basin.pressure_error, compression / 2);
  }
}

TEST(Basin, IsNotMendedByMeansOverCells) {  // Eqs. (M131), (M132)
  // What is out of balance are nodes beside floor and surface, not points within a cell: means leave that,
  // and that of pressure misses its slope over the lowest and topmost cell as well.
  const double without = basin_at_rest(Quadratic{}, Apic{}).pressure_error;

  EXPECT_GT(basin_at_rest(Quadratic{}, Apic{}, {.volume_change = true}).pressure_error, without / 2);
  EXPECT_GT(basin_at_rest(Quadratic{}, Apic{}, {.pressure = true}).pressure_error, without);
}

TEST(Basin, IsShakenByMeansOverCellsUnderFlip) {  // Eqs. (M131), (M132)
  // Means see no motion that keeps the volume of cells but not of points, so nothing resists it, and FLIP
  // keeps what of it the nodes do not see: more than ten times what half the weight of a cell would move.
  // APIC, the remedy, loses it, and moves no faster than by the energy of what is out of balance without
  // means, Eq. (M193).
  constexpr double of_a_cell = 0.5 / num_layers * compression;
  const double out_of_balance = BalanceOfTheMesh{{Quadratic{}, Apic{}}, {}}.size() / num_layers * compression;
  for (const Averaging& averaging : {Averaging{.volume_change = true}, Averaging{.pressure = true}}) {
    EXPECT_GT(basin_at_rest(Quadratic{}, PicFlip{1}, averaging).largest_speed, 10 * of_a_cell);
    EXPECT_LE(basin_at_rest(Quadratic{}, Apic{}, averaging).largest_speed, out_of_balance);
  }
}

}  // namespace
}  // namespace scree::mpm
