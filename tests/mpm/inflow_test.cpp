#include "dry_wall.hpp"
#include "messages.hpp"
#include "streams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace scree::mpm {
namespace {

constexpr double jet_dt = 0.009;  // [s]: a layer of 1/32 m enters every third or fourth step

/// Sound in it is five times as fast as the jet.
constexpr Fluid jet_fluid{.bulk_modulus = 25e3, .reference_density = 1000, .viscosity = 0};
constexpr double jet_dt_of_sound = 0.003;  // [s], C = 0.34 in (M17)

TEST(Inflow, BringsRhoVATimesTheTimeWithinALayer) {  // Eq. (M160)
  Passage<2> jet{jet_stream(), jet_grid(), jet_end(), Quadratic{}, Apic{}};
  const double rate = 1000 * 1 * 0.25;              // [kg/s]
  const double layer = 1000 * 0.25 * jet_cell / 2;  // [kg]

  for (int n = 0; n < 200; ++n) {
    jet.advance(1, jet_dt);
    const double missing = rate * jet.time - jet.inflow->entered().mass;
    EXPECT_GE(missing, -200 * round_off * rate);
    EXPECT_LT(missing, layer * (1 + 200 * round_off));
  }
  EXPECT_EQ(jet.inflow->entered().count, 8 * 57);  // 1.8 s at 32 layers a second, of 8 points
}

/// Nothing acts on the jet: each point has the velocity and the density that it came with, and lies on the
/// lattice, whatever carries it from nodes to points.
TEST(Inflow, GivesAUniformStream) {
  constexpr int num_steps = 150;
  const std::vector<AnyShape> shapes{Linear{}, Quadratic{}, Cubic{}, Gimp{2}};
  const std::vector<AnyTransfer> rules{Apic{}, PicFlip{1}, PicFlip{0}, Tpic{}, Aflip{1}};
  for (const AnyShape& shape : shapes) {
    for (const AnyTransfer& rule : rules) {
      Passage<2> jet{jet_stream(), jet_grid(), jet_end(), shape, rule};

      jet.advance(num_steps, jet_dt);

      const auto& particles = jet.state->particles;
      const double rounding = rounding_of(2, 4, num_steps);
      ASSERT_GT(jet.taken.count, 100);
      for (Index p = 0; p < particles.size(); ++p) {
        if (!(particles.mass.component(0)[p] > 0)) continue;
        EXPECT_NEAR(particles.velocity.component(0)[p], 1, rounding);
        EXPECT_NEAR(particles.velocity.component(1)[p], 0, rounding);
        EXPECT_NEAR(particles.density.component(0)[p], 1000, 1000 * rounding * jet_dt / jet_cell * num_steps);
        const double layers = (particles.position.component(0)[p] - jet.time) / (jet_cell / 2) - 0.5;
        EXPECT_NEAR(layers, std::round(layers), num_steps * rounding / jet_cell);
      }
    }
  }
}

/// Under pressure too: what rounding there is rings with the impedance of sound, five times the speed.
TEST(Inflow, GivesAUniformStreamOfAFluid) {
  constexpr int num_steps = 450;
  Passage<2> jet{jet_stream(), jet_grid(), jet_end(), Quadratic{}, Apic{}, jet_fluid};

  jet.advance(num_steps, jet_dt_of_sound);

  const auto& particles = jet.state->particles;
  ASSERT_GT(jet.taken.count, 100);
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    EXPECT_NEAR(particles.velocity.component(0)[p], 1, 5 * rounding_of(2, 3, num_steps));
    EXPECT_NEAR(particles.density.component(0)[p], 1000, 1000 * 5 * rounding_of(2, 3, num_steps));
  }
}

TEST(Inflow, ComesToASteadyMassBetweenItsFaces) {
  Passage<2> jet{jet_stream(), jet_grid(), jet_end(), Linear{}, Apic{}};
  const double between = 1000 * 0.25 * (0.75 - 0.125);
  const double layer = 1000 * 0.25 * jet_cell / 2;

  jet.advance(80, jet_dt);  // 0.72 s; the first layer needs 0.5 s
  for (int n = 0; n < 100; ++n) {
    jet.advance(1, jet_dt);
    EXPECT_NEAR(jet.mass(), between, layer);
  }
}

template <int D>
void expect_balance_of(Passage<D> jet) {
  constexpr int num_steps = 150;

  jet.advance(num_steps, jet_dt);

  const Passed<D> entered = jet.inflow->entered();
  const double all = jet.first_mass + entered.mass;
  const double sums = static_cast<double>(entered.count + jet.state->particles.size()) * round_off;
  ASSERT_GT(jet.taken.count, 100);
  EXPECT_NEAR(jet.mass() + jet.taken.mass, all, sums * all);
  EXPECT_NEAR(momentum_of(jet.state->particles, 0).total + jet.taken.momentum[0],
              jet.first_mass + entered.momentum[0], (sums + rounding_of(D, 3, num_steps)) * all);
  for (int axis = 1; axis < D; ++axis) EXPECT_EQ(entered.momentum[axis], 0);
}

TEST(Inflow, BalancesMassAndMomentumWithWhatIsTakenOut) {
  expect_balance_of<2>({jet_stream(), jet_grid(), jet_end(), Quadratic{}, PicFlip{1}});
}

/// A jet of a square of 1/4 m x 1/4 m.
TEST(Inflow, BalancesMassAndMomentumInSpace) {
  const Stream<3> stream{.low = {0.125, 0.375, 0.375},
                         .high = {0.25, 0.625, 0.625},
                         .velocity = {1, 0, 0},
                         .density = 1000,
                         .per_cell = {2, 2, 2}};
  const double infinity = std::numeric_limits<double>::infinity();
  const Outflow<3> end{.low = {0.75, -infinity, -infinity}, .high = {infinity, infinity, infinity}};

  expect_balance_of<3>({stream, cube<3>(16, jet_cell, false), end, Quadratic{}, PicFlip{1}});
}

TEST(Inflow, RunsEitherWayAlongEachAxis) {
  for (const int axis : {0, 1}) {
    for (const double sense : {1.0, -1.0}) {
      Stream<2> stream{.low = {0.375, 0.375}, .high = {0.625, 0.625}, .density = 1000, .per_cell = {2, 2}};
      stream.velocity[static_cast<std::size_t>(axis)] = sense;
      Outflow<2> nowhere{.low = {0, 0}, .high = {jet_cell, jet_cell}};
      Passage<2> jet{stream, jet_grid(), nowhere, Linear{}, Apic{}};

      jet.advance(30, jet_dt);

      EXPECT_EQ(jet.inflow->num_layers(), 8);  // 0.27 m
      double furthest = 0;
      const auto& particles = jet.state->particles;
      for (Index p = 0; p < particles.size(); ++p) {
        if (!(particles.mass.component(0)[p] > 0)) continue;
        furthest = std::max(furthest, sense * (particles.position.component(axis)[p] - 0.5));
        EXPECT_NEAR(particles.velocity.component(axis)[p], sense, rounding_of(2, 2, 30));
      }
      EXPECT_NEAR(furthest, 0.125 + 0.27 - jet_cell / 4, rounding_of(2, 2, 30));
    }
  }
}

TEST(Inflow, HasTheSameBitsForAnyNumberOfThreads) {
  const auto bits = [](int num_threads) {
    Passage<2> jet{jet_stream(), jet_grid(), jet_end(), Quadratic{}, Apic{}, jet_fluid, Threads{num_threads}};
    jet.stages.gravity = {1, -3};
    jet.advance(300, jet_dt_of_sound);
    const auto values = jet.state->particles.position.values();
    std::vector<double> all{values.begin(), values.end()};
    all.insert(all.end(), {jet.taken.mass, jet.taken.momentum[0], jet.taken.momentum[1]});
    return all;
  };
  const std::vector<double> one = bits(1);

  for (const int num_threads : {2, 3, 4}) EXPECT_EQ(bits(num_threads), one) << num_threads;
}

/// Gravity acts on what has left the box only, and on all once the stream has ended.
TEST(Inflow, HoldsItsBoxWhileItEnters) {
  Stream<2> stream = jet_stream();
  stream.stop = 0.2;
  Passage<2> jet{stream, jet_grid(), jet_end(), Quadratic{}, PicFlip{1}};
  jet.stages.gravity = {0, -2};
  const auto falls_in_box = [&] {
    double speed = 0;
    const auto& particles = jet.state->particles;
    for (Index p = 0; p < particles.size(); ++p) {
      const bool is_held = particles.position.component(0)[p] < 0.25 - jet_cell / 2;
      if (is_held) speed = std::max(speed, std::abs(particles.velocity.component(1)[p]));
    }
    return speed;
  };

  jet.advance(20, jet_dt);
  EXPECT_EQ(falls_in_box(), 0);
  jet.advance(6, jet_dt);  // to 0.234 s

  EXPECT_GT(falls_in_box(), 0.05);
  EXPECT_EQ(jet.inflow->num_layers(), 6);  // 0.2 m
}

/// New points are numbered on; those of the box were 0 to 31.
TEST(Inflow, NumbersItsPoints) {
  Passage<2> jet{jet_stream(), jet_grid(), jet_end(), Linear{}, Apic{}};

  jet.advance(30, jet_dt);  // 8 layers of 8

  std::vector<bool> seen(32 + 64, false);
  const auto& particles = jet.state->particles;
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    const auto id = static_cast<std::size_t>(particles.id.component(0)[p]);
    ASSERT_LT(id, seen.size());
    EXPECT_FALSE(seen[id]);
    seen[id] = true;
  }
}

/// Where it fails: a stream that speeds up to more than `per_cell` times the speed it came with leaves cells
/// empty, its layers further apart than a cell. Falling from the face of its box at v_0 it does so from
/// (n^2 - 1) v_0^2/2g on.  Eq. (M162)  @returns how far from the face the first empty cell begins [m]
constexpr double fall_cell = 0.01;  // [m]
constexpr double fall_dt = 5e-4;    // [s]; v_0 = 1 m/s

[[nodiscard]] double first_gap(Index per_cell) {
  constexpr double cell = fall_cell;
  const CartesianGrid<1> grid{Vector<1>{0.0}, Vector<1>{cell}, {60}, {false}};
  const Stream<1> stream{.low = Vector<1>{0.02},
                         .high = Vector<1>{0.05},
                         .velocity = {1},
                         .density = 1000,
                         .per_cell = {per_cell}};
  const Outflow<1> end{.low = Vector<1>{0.35}, .high = Vector<1>{1}};
  Passage<1> fall{stream, grid, end, Linear{}, Apic{}};
  fall.stages.gravity = {10};
  fall.advance(600, fall_dt);  // 0.3 s: the front is past the end
  std::vector<bool> has_gap(30, false);
  for (int n = 0; n < 60; ++n) {  // three layers' time
    fall.advance(1, fall_dt);
    std::vector<bool> is_filled(60, false);
    const auto& particles = fall.state->particles;
    for (Index p = 0; p < particles.size(); ++p) {
      if (!(particles.mass.component(0)[p] > 0)) continue;
      is_filled[static_cast<std::size_t>(particles.position.component(0)[p] / cell)] = true;
    }
    for (std::size_t i = 0; i < has_gap.size(); ++i) has_gap[i] = has_gap[i] || !is_filled[5 + i];
  }
  const auto gap = std::find(has_gap.begin(), has_gap.end(), true) - has_gap.begin();
  return static_cast<double>(gap) * cell;
}

TEST(Inflow, ComesApartWhereItIsFasterThanItsPointsPerCellAllow) {
  // A cell is seen to be empty if it is for a step at least: layers h v/(2 v_0) apart leave h free and v dt.
  const double seen = 1 / (1.0 / 2 - fall_dt / fall_cell);  // v/v_0
  const double begins = (4 - 1) / (2 * 10.0);               // [m]
  const double shows = (seen * seen - 1) / (2 * 10.0);      // [m]

  const double gap = first_gap(2);

  EXPECT_GE(gap, begins - fall_cell);
  EXPECT_LE(gap, shows + fall_cell);
}

TEST(Inflow, StaysWholeWithMorePointsPerCell) {
  EXPECT_GE(first_gap(4), 0.3);  // all of its way; it would come apart at 0.75 m
}

/// A stream of 1 m/s on 32 cells of 1/32 m whose box is the first four. It runs to a wall at 1 m, if it is
/// blocked, or is taken out before, 28 cells from its box.
struct Blocked {
  static constexpr double cell = 1.0 / 32;     // [m]
  static constexpr double length = 28 * cell;  // [m]
  /// Sound in it is ten times as fast.
  static constexpr Fluid fluid{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};

  explicit Blocked(bool is_blocked) {
    if (!is_blocked) {
      passage.outflow.low = Vector<1>{1 - 2 * cell};
      return;
    }
    auto& boundaries = passage.stages.boundaries;
    boundaries.insert(boundaries.begin(), make_wall<1>(NoSlip{}, 0, Side::high));
  }
  void advance_to(double time) {
    while (passage.time < time) passage.advance(1, 0.4 * cell / (10 + 1));
  }
  /// Mean pressure of what has left the box, by volume [Pa].
  [[nodiscard]] double mean_pressure() const {
    const auto& particles = passage.state->particles;
    double work = 0;
    double volumes = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      const double density = particles.density.component(0)[p];
      if (!(particles.mass.component(0)[p] > 0) || particles.position.component(0)[p] < 4 * cell) continue;
      const double volume = particles.mass.component(0)[p] / density;
      work += volume * fluid.bulk_modulus * (density / 1000 - 1);
      volumes += volume;
    }
    return work / volumes;
  }

  Passage<1> passage{
      {.low = Vector<1>{0.0}, .high = Vector<1>{4 * cell}, .velocity = {1}, .density = 1000, .per_cell = {2}},
      {Vector<1>{0.0}, Vector<1>{cell}, {32}, {false}},
      {.low = Vector<1>{1 - cell / 100}, .high = Vector<1>{2.0}},
      Quadratic{},
      Apic{},
      fluid};
};

/// The rate is imposed, so that all that enters after the stream has come to the wall is squeezed into the
/// room before it, however slow it is beside sound. Where the wall begins to press is known to a cell.
TEST(Inflow, IsCompressedByWhatEntersOnceItIsBlocked) {  // Eq. (M188)
  Blocked stream{true};
  for (const double late : {0.1, 0.25, 0.5, 1.0}) {  // of the time to the wall
    stream.advance_to((1 + late) * Blocked::length);

    EXPECT_NEAR(stream.mean_pressure() / Blocked::fluid.bulk_modulus, late, Blocked::cell / Blocked::length);
  }
}

TEST(Inflow, PressesOnNothingThatIsTakenOut) {
  Blocked stream{false};

  stream.advance_to(2 * Blocked::length);

  EXPECT_NEAR(stream.mean_pressure() / Blocked::fluid.bulk_modulus, 0, 10 * rounding_of(1, 3, 2000));
}

struct BadStream {
  std::string what;
  std::function<void(Stream<2>&)> spoil;
  std::string message;
};

TEST(Inflow, RefusesABadStream) {
  const std::vector<BadStream> cases{
      {"none",
       [](auto& s) {
         s.velocity = {0, 0};
       },
       "Stream: the velocity must lie along one axis of the mesh"},
      {"oblique",
       [](auto& s) {
         s.velocity = {1, 1};
       },
       "Stream: the velocity must lie along one axis of the mesh"},
      {"NaN",
       [](auto& s) {
         s.velocity = {1, std::nan("")};
       },
       "Stream: the velocity must be finite"},
      {"between nodes", [](auto& s) { s.high[0] = 0.26; },
       "Stream: along the stream the box must begin and end on nodes"},
      {"thin", [](auto& s) { s.high[0] = 0.1875; },
       "Stream: along the stream the box must be at least two cells long"},
      {"no cells",
       [](auto& s) {
         s.per_cell = {0, 2};
       },
       "Stream: each cell must get at least one point along each axis"},
      {"no density", [](auto& s) { s.density = 0; }, "seed_box: density must be positive and finite"},
      {"late", [](auto& s) { s.start = s.stop = 1; }, "Stream: it must begin before it ends"},
      {"never", [](auto& s) { s.stop = std::nan(""); }, "Stream: it must begin before it ends"},
      {"narrow", [](auto& s) { s.high[1] = 0.376; }, "seed_box: the box is too thin to hold a point"},
      {"out", [](auto& s) { s.high[1] = 1.5; },
       "the material from 0.375000 to 1.500000 m along axis 1 reaches out of the mesh, which goes from "
       "0.000000 to 1.000000 m"}};
  for (const BadStream& bad : cases) {
    Stream<2> stream = jet_stream();
    bad.spoil(stream);
    const auto make = [&] { static_cast<void>(first_layer(stream, jet_grid())); };
    EXPECT_EQ(message_of<InputError>(make), bad.message) << bad.what;
  }
}

TEST(Inflow, RefusesAPeriodicAxis) {
  const auto make = [] { static_cast<void>(fill_box(jet_stream(), cube<2>(16, jet_cell, true))); };

  EXPECT_EQ(message_of<InputError>(make), "Stream: the axis that it runs along must not be periodic");
}

TEST(Inflow, RefusesALayerWithoutTheColumnsOfTheRun) {
  Passage<2> jet{jet_stream(), jet_grid(), jet_end(), Linear{}, Apic{}};
  jet.state->particles.add_column({"label", "l", "-"}, 1);

  EXPECT_EQ(message_of<InputError>([&] { jet.advance(4, jet_dt); }),
            "the points that are added lack the column 'label' in its place");
}

TEST(Inflow, RefusesALayerThatAWallCannotRead) {
  Passage<2> jet{jet_stream(), jet_grid(), jet_end(), Linear{}, Apic{}};
  const auto rub = [](Particles<2>& particles, double friction) {
    std::ranges::fill(particles.column(particles.add_column({"friction", "mu", "-"}, 1)).values(), friction);
  };
  rub(jet.state->particles, 0.5);
  jet.stages.node_means = std::make_unique<NodeMeans<2, 2>>(Linear{});
  jet.stages.node_means->add(jet.state->particles, "friction", Rubs::inputs[0], Rubs::name);
  auto layer = first_layer(jet_stream(), jet_grid());
  rub(layer, 0);
  Inflow<2, 2> inflow{jet_stream(), jet_grid(), layer};
  const Index num_points = jet.state->particles.size();

  EXPECT_EQ(message_of<InputError>([&] { take_in(*jet.state, jet.stages, inflow, 1, {1}); }),
            "the law 'rubs' reads friction = 0 of material point 0 at (0.140625, 0.390625) m: must be finite "
            "and above 0");
  EXPECT_EQ(jet.state->particles.size(), num_points);
  EXPECT_EQ(inflow.num_layers(), 0);
}

}  // namespace
}  // namespace scree::mpm
