// Steps with passes of their own: stress in another order, means over cells, filtered velocities.

#include "bodies.hpp"
#include "messages.hpp"
#include "same_bits.hpp"
#include "schemes.hpp"

#include <scree/mpm/cell_sort.hpp>

#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr Fluid mud{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 2};

/// A transfer, and what a step does beside its own passes.
struct Extra {
  AnyTransfer rule;
  Order order = Order::usl;
  Averaging averaging = {};
  int xpic_order = 0;
};

/// Each extra pass alone, and all of them.
const std::vector<Extra> every_extra{
    {Apic{}, Order::musl},
    {PicFlip{1}, Order::musl},
    {Apic{}, Order::usf},
    {PicFlip{1}, Order::usf},
    {Apic{}, Order::usl, {.volume_change = true}},
    {Apic{}, Order::usl, {.pressure = true}},
    {PicFlip{1}, Order::usl, {}, 3},
    {PicFlip{1}, Order::musl, {.volume_change = true, .pressure = true}, 2},
};

template <int D>
[[nodiscard]] Stages<D, D> stages_with(const Extra& extra, Particles<D>& particles) {
  auto stages = stages_of<D, D>(particles, Quadratic{}, extra.rule, mud);
  stages.order = extra.order;
  stages.averaging = extra.averaging;
  if (extra.xpic_order > 0) stages.xpic = make_xpic<D, D>(Quadratic{}, extra.xpic_order);
  return stages;
}

/// Points that cross cells and blocks of a periodic mesh.
class Stirred {
 public:
  explicit Stirred(const Extra& extra) {
    auto particles = scattered<2>(grid, 1000, 0);
    fill_at_random(particles.velocity, 1.0);
    stages = stages_with(extra, particles);
    state = std::make_unique<State<2, 2>>(start(std::move(particles), grid, stages, one_thread));
  }
  void advance(int num_steps, Threads threads) {
    for (int n = 0; n < num_steps; ++n) step(*state, stages, dt, threads);
  }

  static constexpr double dt = 2e-3;  // [s]
  CartesianGrid<2> grid = cube<2>(25, 0.1, true);
  Stages<2, 2> stages;
  std::unique_ptr<State<2, 2>> state;
};

TEST(EveryExtraPass, KeepsMomentumUnderItsOwnForces) {  // Eqs. (M126)-(M132)
  constexpr int num_steps = 30;
  for (const Extra& extra : every_extra) {
    Stirred stirred{extra};
    std::array<Momentum, 2> before;
    for (int i = 0; i < 2; ++i) {
      before[static_cast<std::size_t>(i)] = momentum_of(stirred.state->particles, i);
    }

    stirred.advance(num_steps, one_thread);

    const auto& particles = stirred.state->particles;
    double impulse = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      impulse += Stirred::dt / 0.1 * particles.mass.component(0)[p] / 1000 * largest(particles.stress);
    }
    const double rounding = rounding_of(2, 3, num_steps * (1 + extra.xpic_order));
    for (int i = 0; i < 2; ++i) {
      const Momentum& initial = before[static_cast<std::size_t>(i)];
      EXPECT_NEAR(momentum_of(particles, i).total, initial.total, rounding * (initial.size + impulse));
    }
  }
}

TEST(EveryExtraPass, GivesTheSameBitsForAnyNumberOfThreads) {
  for (const Extra& extra : every_extra) {
    Stirred one{extra};
    one.advance(6, {1});
    for (const int threads : {2, 3, 4}) {
      Stirred several{extra};

      several.advance(6, {threads});

      expect_same_bits(one.state->particles, several.state->particles);
      EXPECT_EQ(one.state->rates.advection_rate, several.state->rates.advection_rate);
    }
  }
}

TEST(EveryExtraPass, GoesOnFromStoredColumnsAndBlocksAsIfNeverStopped) {
  for (const Extra& extra : every_extra) {
    Stirred whole{extra};
    whole.advance(15, one_thread);
    Stirred restarted{extra};
    const State<2, 2>& left = *whole.state;
    restarted.state->particles = left.particles;
    restarted.state->blocks = left.blocks;
    restarted.state->block_results = left.block_results;
    restarted.state->nodes = left.nodes;

    whole.advance(15, one_thread);
    restarted.advance(15, one_thread);

    expect_same_bits(whole.state->particles, restarted.state->particles);
  }
}

TEST(Step, TakesNoMemoryForPassesThatItDoesNotMake) {
  Stirred stirred{Extra{Apic{}}};

  stirred.advance(1, one_thread);

  const Spare& spare = stirred.state->spare;
  for (const auto* values : {&spare.position, &spare.velocity, &spare.velocity_gradient, &spare.density,
                             &spare.smooth, &spare.filtered}) {
    EXPECT_EQ(values->capacity(), 0U);
  }
}

TEST(StressLast, IsTheSameInAPassOfItsOwn) {
  // One point a cell is the mean of its cell. The law of a fluid without viscosity knows no past: stress at
  // the end of a step is that at the start of the next.
  const auto run = [](const Averaging& averaging) {
    const auto grid = cube<2>(8, 0.1, true);
    auto particles = filled<2>(grid, 1);
    fill_at_random(particles.velocity, 0.1);
    auto stages = stages_of<2, 2>(particles, Quadratic{}, Apic{},
                                  {.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0});
    stages.averaging = averaging;
    auto state = start(std::move(particles), grid, stages, one_thread);
    for (int n = 0; n < 20; ++n) step(state, stages, 2e-3, one_thread);
    return state.particles;
  };

  const auto by_the_way = run({});
  const auto in_a_pass = run({.volume_change = true});

  // Accelerations of c^2/h times the rounding of density, 10^4 m/s^2 of it, in each of 20 steps of 2e-3 s.
  const double tolerance = 20 * 2e-3 * 1e4 * rounding_of(2, 3, 20);
  for (std::size_t i = 0; i < by_the_way.velocity.values().size(); ++i) {
    EXPECT_NEAR(in_a_pass.velocity.values()[i], by_the_way.velocity.values()[i], tolerance);
  }
  EXPECT_GT(largest(by_the_way.velocity), 0.01);
}

TEST(CellMeans, AreOfTheTraceWeightedByVolume) {  // Eqs. (M131), (M132)
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{1, 1}, {2, 1}, {true, false}};
  Particles<2> particles;
  particles.resize(3);  // two in the first cell, one of them on its upper end and a period away
  const std::array<double, 3> x{0.25, 2.5, 1.5};
  const std::array<double, 3> y{0.5, 1, 0.5};
  for (Index p = 0; p < 3; ++p) {
    const auto i = static_cast<std::size_t>(p);
    particles.position.component(0)[p] = x[i];
    particles.position.component(1)[p] = y[i];
    particles.mass.component(0)[p] = 1;
    particles.density.component(0)[p] = p == 1 ? 0.5 : 1;  // volumes 1, 2, 1
    for (int c = 0; c < 4; ++c) particles.velocity_gradient.component(c)[p] = static_cast<double>(10 * p + c);
  }
  ParticleBlocks<2> blocks;
  blocks.blocks.push_back({.first_cell = {}, .begin = 0, .end = 3});
  blocks.colours = {{0}};
  CellMeans<2> means;
  means.prepare(grid, 3);

  means.average_trace(particles, particles.velocity_gradient, blocks, grid, one_thread);

  // Traces 3, 23 and 43: the mean of the first cell is (3 + 2 * 23)/3 = 49/3.
  const auto component = [&](int c, Index p) { return particles.velocity_gradient.component(c)[p]; };
  constexpr double tolerance = 50 * 8 * round_off;  // eight operations
  EXPECT_NEAR(component(0, 0), 20.0 / 3, tolerance);
  EXPECT_NEAR(component(3, 0), 3 + 20.0 / 3, tolerance);
  EXPECT_NEAR(component(0, 1), 10 - 10.0 / 3, tolerance);
  EXPECT_NEAR(component(3, 1), 13 - 10.0 / 3, tolerance);
  for (const Index p : {0, 1, 2}) {
    EXPECT_EQ(component(1, p), static_cast<double>(10 * p + 1));
    EXPECT_EQ(component(2, p), static_cast<double>(10 * p + 2));
  }
  EXPECT_EQ(component(0, 2), 20);
  EXPECT_EQ(component(3, 2), 23);
}

/// +1 and -1 m/s on the two points of each cell: what no node sees. The largest velocity after each of some
/// steps under no force.
double null_mode_left(const Extra& extra, int num_steps) {
  const auto grid = cube<1>(6, 0.1, true);
  auto particles = filled<1>(grid, 2);
  for (Index p = 0; p < particles.size(); ++p) particles.velocity.component(0)[p] = p % 2 == 0 ? 1 : -1;
  auto stages = stages_of<1, 1>(particles, Linear{}, extra.rule);
  if (extra.xpic_order > 0) stages.xpic = make_xpic<1, 1>(Linear{}, extra.xpic_order);
  auto state = start(std::move(particles), grid, stages, one_thread);
  for (int n = 0; n < num_steps; ++n) step(state, stages, 1e-3, one_thread);
  return largest(state.particles.velocity);
}

TEST(Xpic, DropsInOneStepWhatNodesCannotSee) {  // Eq. (M130), where FLIP keeps it for ever, Eq. (M9)
  EXPECT_EQ(null_mode_left({PicFlip{1}}, 100), 1);
  for (const int order : {1, 2, 5}) {
    EXPECT_LE(null_mode_left({PicFlip{1}, Order::usl, {}, order}, 1), rounding_of(1, 2, order));
  }
}

TEST(Xpic, OfFirstOrderIsParticleInCell) {
  const auto run = [](const Extra& extra) {
    Stirred stirred{extra};
    stirred.advance(10, one_thread);
    return stirred.state->particles;
  };

  const auto pic = run({PicFlip{0}});
  const auto xpic = run({PicFlip{1}, Order::usl, {}, 1});

  // Velocities of 1 m/s and accelerations of c^2/h, 10^3 m/s^2, in each of 10 steps of 2e-3 s.
  const double tolerance = (1 + 10 * Stirred::dt * 1e3) * rounding_of(2, 3, 10);
  for (std::size_t i = 0; i < pic.velocity.values().size(); ++i) {
    EXPECT_NEAR(xpic.velocity.values()[i], pic.velocity.values()[i], tolerance);
  }
}

TEST(Xpic, RefusesWhatItDoesNotSuit) {
  EXPECT_EQ(message_of<InputError>([] { static_cast<void>(make_xpic<1, 1>(Linear{}, 0)); }),
            "make_xpic: the order must be at least 1");
  EXPECT_EQ(message_of<InputError>([] {
              Stirred{Extra{Apic{}, Order::usl, {}, 2}};
            }),
            "xpic filters the velocities of points that take increments: its transfer must be pic_flip");
}

}  // namespace
}  // namespace scree::mpm
