#include "bodies.hpp"
#include "messages.hpp"
#include "same_bits.hpp"
#include "schemes.hpp"

#include <scree/mpm/cell_sort.hpp>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr Fluid mud{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 2};
/// Where points at random make nodes of nearly no mass, pressure does not throw them so far that none of a
/// volume is left in a step.
constexpr Fluid soft_mud{.bulk_modulus = 1e4, .reference_density = 1000, .viscosity = 2};

template <class Dimension>
class EveryStep : public ::testing::Test {};
TYPED_TEST_SUITE(EveryStep, Dimensions);

TYPED_TEST(EveryStep, KeepsMomentumUnderItsOwnForces) {  // Eq. (M10): the forces on the nodes sum to zero
  constexpr int D = TypeParam::value;
  for (const Scheme& scheme : every_scheme()) {
    SCOPED_TRACE(scheme.name());
    const auto grid = cube<D>(6, 0.1, true);
    auto particles = scattered<D>(grid, 200 * D, 0);
    fill_at_random(particles.velocity, 1.0);
    const auto stages = stages_of<D, D>(particles, scheme.shape, scheme.rule, mud);
    auto state = start(std::move(particles), grid, stages, one_thread);
    std::array<Momentum, D> before;
    for (int i = 0; i < D; ++i) before[static_cast<std::size_t>(i)] = momentum_of(state.particles, i);

    constexpr int num_steps = 50;
    constexpr double dt = 1e-3;
    for (int n = 0; n < num_steps; ++n) step(state, stages, dt, one_thread);

    // Each step adds impulses dt V sigma/h of either sign, which cancel up to their rounding.
    double impulse = 0;
    for (Index p = 0; p < state.particles.size(); ++p) {
      impulse += dt / 0.1 * state.particles.mass.component(0)[p] / 1000 * largest(state.particles.stress);
    }
    for (int i = 0; i < D; ++i) {
      const Momentum& initial = before[static_cast<std::size_t>(i)];
      const double rounding = rounding_of(D, scheme.support(), num_steps);
      EXPECT_NEAR(momentum_of(state.particles, i).total, initial.total, rounding * (initial.size + impulse));
    }
  }
}

TYPED_TEST(EveryStep, KeepsEveryMassExactly) {
  constexpr int D = TypeParam::value;
  for (const Scheme& scheme : every_scheme()) {
    SCOPED_TRACE(scheme.name());
    const auto grid = cube<D>(6, 0.1, true);
    auto particles = scattered<D>(grid, 60, 0);
    fill_at_random(particles.velocity, 5.0);
    const std::vector<double> masses{particles.mass.values().begin(), particles.mass.values().end()};
    const auto stages = stages_of<D, D>(particles, scheme.shape, scheme.rule);
    auto state = start(std::move(particles), grid, stages, one_thread);

    // Velocities that differ by 10 m/s over a cell leave points some volume in steps below 0.01 s.
    for (int n = 0; n < 400; ++n) step(state, stages, 2.5e-3, one_thread);

    std::vector<double> left(masses.size(), 0);
    for (Index p = 0; p < state.particles.size(); ++p) {
      left[static_cast<std::size_t>(state.particles.id.component(0)[p])] +=
          state.particles.mass.component(0)[p];
    }
    EXPECT_EQ(left, masses);
  }
}

/// Points that cross cells and blocks of a periodic mesh.
template <int D>
struct StirredUnder {
  StirredUnder(const Scheme& scheme, Index num_points) {
    auto particles = scattered<D>(grid, num_points, 0);
    fill_at_random(particles.velocity, 1.0);
    stages = stages_of<D, D>(particles, scheme.shape, scheme.rule, soft_mud);
    state = std::make_unique<State<D, D>>(start(std::move(particles), grid, stages, one_thread));
  }
  void advance(int num_steps, Threads threads) {
    for (int n = 0; n < num_steps; ++n) step(*state, stages, 2e-3, threads);
  }
  CartesianGrid<D> grid = cube<D>(D == 1 ? 320 : D == 2 ? 80 : 20, 0.1, true);  // several blocks of a colour
  Stages<D, D> stages;
  std::unique_ptr<State<D, D>> state;
};
struct Stirred : StirredUnder<2> {
  Stirred() : StirredUnder{{Quadratic{}, Apic{}}, 10000} {}
};

TYPED_TEST(EveryStep, GivesTheSameBitsForAnyNumberOfThreads) {
  constexpr int D = TypeParam::value;
  for (const Scheme& scheme : every_scheme()) {
    SCOPED_TRACE(scheme.name());
    constexpr Index num_points = D == 2 ? 8000 : Index{1000} * D;
    constexpr int num_steps = 4;
    StirredUnder<D> one{scheme, num_points};
    one.advance(num_steps, {1});
    for (const int threads : {2, 3, 4}) {
      StirredUnder<D> several{scheme, num_points};

      several.advance(num_steps, {threads});

      expect_same_bits(one.state->particles, several.state->particles);
    }
  }
}

TEST(Step, GivesTheSameBitsForAnyNumberOfThreadsThroughManySorts) {
  Stirred one;
  one.advance(40, {1});
  for (const int threads : {2, 3, 4}) {
    Stirred several;

    several.advance(40, {threads});

    expect_same_bits(one.state->particles, several.state->particles);
    EXPECT_EQ(one.state->rates.advection_rate, several.state->rates.advection_rate);
  }
}

/// Solves nothing, but might: so that all nodes stay in use.
class NothingToSolve final : public NodeSolve<2, 2> {
 public:
  void solve(const Particles<2>&, Nodes<2>&, double, double) override {}
};

TEST(Step, NeedsNoOtherNodesThanThoseNearPoints) {
  const auto thrown = [](bool with_all_nodes, int num_steps) {
    const auto grid = cube<2>(100, 0.1, false);
    auto particles = scattered<2>(grid, 300, 4.6);  // [m]: eight cells of a hundred
    for (Index p = 0; p < particles.size(); ++p) particles.velocity.component(0)[p] = 1;
    auto stages = stages_of<2, 2>(particles, Quadratic{}, PicFlip{}, mud);
    stages.gravity = {0, -2};
    for (const int axis : {0, 1}) {
      stages.boundaries.push_back(make_wall<2>(NoSlip{}, axis, Side::low));
      stages.boundaries.push_back(make_wall<2>(Slip{}, axis, Side::high));
    }
    if (with_all_nodes) stages.node_solve = std::make_unique<NothingToSolve>();
    auto state = start(std::move(particles), grid, stages, one_thread);
    for (int n = 0; n < num_steps; ++n) step(state, stages, 2e-3, one_thread);
    return state;
  };

  const auto count = [](const State<2, 2>& state) {
    Index nodes = 0;
    for (Index b = 0; b < state.nodes.num_batches(); ++b) {
      for (const NodeRun& run : state.nodes.batch(b)) nodes += run.end - run.begin;
    }
    return nodes;
  };
  EXPECT_LT(count(thrown(false, 0)),
            count(thrown(true, 0)) / 4);  // four blocks with their halo, 38^2 nodes at most, of 103^2

  const auto some = thrown(false, 1500);  // it flies, lands and slides
  const auto all = thrown(true, 1500);
  expect_same_bits(some.particles, all.particles);
}

TEST(Step, GoesOnFromStoredColumnsAndBlocksAsIfNeverStopped) {
  Stirred whole;
  whole.advance(30, one_thread);
  State<2, 2> restarted{whole.state->particles, Nodes<2>{whole.grid, whole.stages.transfer->record()}};
  restarted.blocks.blocks = whole.state->blocks.blocks;
  colour_blocks(restarted.blocks, whole.grid);
  restarted.block_results.resize(restarted.blocks.blocks.size());
  restarted.mass_floor = whole.state->mass_floor;
  restarted.needs_sort = false;

  whole.advance(30, one_thread);
  for (int n = 0; n < 30; ++n) step(restarted, whole.stages, 2e-3, one_thread);

  expect_same_bits(whole.state->particles, restarted.particles);
}

TEST(Start, FindsWhatBoundsTheFirstStep) {
  const auto grid = cube<2>(4, 0.1, true);
  auto particles = filled<2>(grid, 2);
  for (double& v : particles.velocity.values()) v = -3;
  const auto stages = stages_of<2, 2>(particles, Linear{}, Apic{}, mud);

  const auto state = start(std::move(particles), grid, stages, one_thread);

  EXPECT_EQ(state.rates.wave_speed, 10);
  EXPECT_EQ(state.rates.kinematic_viscosity, 2.0 / 1000);
  EXPECT_NEAR(state.rates.advection_rate, 2 * 3 / 0.1, 60 * 4 * round_off);
}

TEST(Step, ReportsWhatBoundsTheNextOne) {
  const auto grid = cube<2>(4, 0.1, true);
  auto particles = filled<2>(grid, 2);
  for (double& v : particles.velocity.values()) v = -3;
  const auto stages = stages_of<2, 2>(particles, Linear{}, Apic{}, mud);
  auto state = start(std::move(particles), grid, stages, one_thread);
  const Rates first = state.rates;

  step(state, stages, 1e-4, one_thread);

  const double tolerance = rounding_of(2, 2, 1);
  EXPECT_EQ(state.rates.wave_speed, first.wave_speed);
  EXPECT_NEAR(state.rates.kinematic_viscosity, first.kinematic_viscosity, tolerance);
  EXPECT_NEAR(state.rates.advection_rate, first.advection_rate, tolerance * first.advection_rate);
}

TEST(Start, RefusesARunWithoutPoints) {
  const auto grid = cube<1>(4, 0.1, false);
  Particles<1> none;
  const auto stages = stages_of<1, 1>(none, Linear{}, Apic{});

  EXPECT_EQ(
      message_of<InputError>([&] { static_cast<void>(start(Particles<1>{}, grid, stages, one_thread)); }),
      "a run needs at least one material point");
}

/// The message of a step of one point at 0.25 m that moves with `velocity`.
std::string message_of_a_step(double velocity) {
  const auto grid = cube<1>(4, 0.125, false);
  Particles<1> particles;
  particles.resize(1);
  particles.id.component(0)[0] = 7;
  particles.mass.component(0)[0] = 1;
  particles.density.component(0)[0] = 1000;
  particles.position.component(0)[0] = 0.25;
  particles.velocity.component(0)[0] = velocity;
  const auto stages = stages_of<1, 1>(particles, Quadratic{}, Apic{});
  auto state = start(std::move(particles), grid, stages, one_thread);
  return message_of<RunError>([&] { step(state, stages, 0.5, one_thread); });
}

TEST(Step, NamesAPointThatLeavesTheMesh) {
  EXPECT_EQ(message_of_a_step(1), "material point 7 at (0.75) m is outside the mesh [0, 0.5] m");
  EXPECT_EQ(message_of_a_step(-1), "material point 7 at (-0.25) m is outside the mesh [0, 0.5] m");
}

TEST(Step, NamesAPointWhoseMotionIsNotANumber) {
  EXPECT_EQ(message_of_a_step(std::numeric_limits<double>::quiet_NaN()),
            "material point 7 at (nan) m has no finite position");
}

/// The message of a step of 1 s of points without stress in the middle of each cell of 1 m, in a uniform
/// velocity gradient of 2D with these diagonal elements, or in one dimension with the first; empty if there
/// is none.
template <int D>
std::string message_of_a_step_in(const std::array<double, static_cast<std::size_t>(D)>& gradient,
                                 Order order = Order::usl, const Averaging& averaging = {}) {
  const auto grid = cube<D>(2, 1, false);
  auto particles = filled<D>(grid, 1);
  for (Index p = 0; p < particles.size(); ++p) {
    for (int i = 0; i < D; ++i) {
      const double rate = gradient[static_cast<std::size_t>(i)];
      particles.velocity.component(i)[p] = rate * (particles.position.component(i)[p] - 1);
      particles.velocity_gradient.component(i + D * i)[p] = rate;
    }
  }
  auto stages = stages_of<D, D>(particles, Linear{}, Apic{});
  stages.order = order;
  stages.averaging = averaging;
  auto state = start(std::move(particles), grid, stages, one_thread);
  try {
    step(state, stages, 1, one_thread);
  } catch (const RunError& error) {
    return error.what();
  }
  return {};
}

TEST(Step, NamesAPointThatIsLeftWithoutVolume) {  // Eqs. (M13), (M125)
  constexpr double little = 1.0 / (1 << 10);      // all numbers are exact
  const auto of_point_0 = [](const std::string& place, const std::string& density) {
    std::ostringstream message;
    message << "material point 0 at (" << place
            << ") m has no volume left after a step of 1 s: its density is " << density
            << " kg/m^3; a shorter step, by smaller shares of its limits, may help";
    return message.str();
  };
  for (const Order order : {Order::usl, Order::musl, Order::usf}) {
    const bool has_moved = order != Order::usf;
    for (const Averaging& averaging : {Averaging{}, Averaging{.volume_change = true}}) {
      EXPECT_EQ(message_of_a_step_in<1>({-1 + little}, order, averaging), "");
      EXPECT_EQ(message_of_a_step_in<1>({-1}, order, averaging), of_point_0(has_moved ? "1" : "0.5", "inf"));
      EXPECT_EQ(message_of_a_step_in<1>({-1 - little}, order, averaging),
                of_point_0(has_moved ? "1.00049" : "0.5", "-1.024e+06"));
    }
  }
  EXPECT_EQ(message_of_a_step_in<2>({-0.75, -0.75}), "");  // dt tr L < -1, but a volume is left
  EXPECT_EQ(message_of_a_step_in<2>({-2, 0.25}), of_point_0("1.5, 0.375", "-800"));
}

/// As an outflow leaves them.
TEST(Step, PassesOverPointsWithoutMassThatHaveNoVolume) {
  const auto grid = cube<1>(64, 1, false);
  auto particles = filled<1>(grid, 1);
  auto stages = stages_of<1, 1>(particles, Linear{}, Apic{});
  auto state = start(std::move(particles), grid, stages, one_thread);
  double* const mass = state.particles.mass.component(0);
  double* const density = state.particles.density.component(0);
  for (const Index p : {0, 1, 63}) {
    mass[p] = 0;
    density[p] = -1000;
  }

  EXPECT_NO_THROW(step(state, stages, 1, one_thread));

  density[2] = -1000;
  EXPECT_EQ(
      message_of<RunError>([&] { step(state, stages, 1, one_thread); }),
      "material point 2 at (2.5) m has no volume left after a step of 1 s: its density is -1000 kg/m^3; a "
      "shorter step, by smaller shares of its limits, may help");
}

/// A law that fails where the density is below that of water, by as much.
struct Unsolvable : Fluid {
  static constexpr std::string_view name = "unsolvable";

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& old,
                                                   Real dt) const noexcept {
    auto response = Fluid::update(deformation, input, old, dt);
    response.unsolved = select(deformation.density < 1000, 1 - deformation.density / 1000, Real(0));
    return response;
  }
};

TEST(Step, NamesThePointWhoseLawWasNotSolved) {
  const auto grid = cube<1>(4, 0.125, false);
  Particles<1> particles;
  particles.resize(3);
  for (Index p = 0; p < 3; ++p) {
    particles.id.component(0)[p] = 7 + static_cast<double>(p);
    particles.mass.component(0)[p] = 1;
    particles.density.component(0)[p] = 1000 - 250 * static_cast<double>(p % 2);
    particles.position.component(0)[p] = 0.125 * static_cast<double>(p + 1);
  }
  auto stages = stages_of<1, 1>(particles, Quadratic{}, Apic{});
  stages.stress = std::make_unique<StressUpdateBy<1, 1, Unsolvable>>(Unsolvable{dust}, particles);
  auto state = start(std::move(particles), grid, stages, one_thread);

  EXPECT_EQ(
      message_of<RunError>([&] { step(state, stages, 1e-3, one_thread); }),
      "the law 'unsolvable' was not solved at material point 8 at (0.25) m: its equations are left with a "
      "relative error of 0.25; a shorter step, by smaller shares of its limits, may help");
}

TEST(AdvanceMomentum, LeavesNodesBelowTheFloorAtRest) {  // Eq. (M20)
  Nodes<1> nodes{cube<1>(4, 0.1, false), {1, true}};
  for (Index n = 0; n < 2; ++n) {
    nodes[n][NodeRecord::mass] = n == 0 ? 1e-11 : 1e-9;
    nodes[n][NodeRecord::momentum] = nodes[n][NodeRecord::mass];
    nodes[n][nodes.record().increment()] = 1;  // [N]
  }
  const double gravity = -10;

  advance_momentum(nodes, &gravity, 0.1, 1e-10, one_thread);

  EXPECT_EQ(nodes[0][NodeRecord::momentum], 0);
  EXPECT_EQ(nodes[0][nodes.record().increment()], 0);
  EXPECT_NEAR(nodes[1][NodeRecord::momentum], 1 + 0.1 * (1e9 - 10), 4 * round_off * 1e8);
}

TEST(AdvanceMomentum, GivesTheVelocityAndItsIncrement) {  // Eq. (M11)
  Nodes<1> nodes{cube<1>(4, 0.1, false), {1, true}};
  nodes[2][NodeRecord::mass] = 2;
  nodes[2][NodeRecord::momentum] = 6;
  nodes[2][nodes.record().increment()] = 4;  // [N]
  const double gravity = -10;

  advance_momentum(nodes, &gravity, 0.5, 0, one_thread);

  EXPECT_EQ(nodes[2][nodes.record().increment()], -4);  // 0.5 (4/2 - 10)
  EXPECT_EQ(nodes[2][NodeRecord::momentum], -1);        // 6/2 - 4
}

}  // namespace
}  // namespace scree::mpm
