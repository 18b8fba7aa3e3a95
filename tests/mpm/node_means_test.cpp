// What points carry, on the nodes that walls hold: the means themselves, and walls whose friction they are.

#include "bodies.hpp"
#include "dry_wall.hpp"
#include "messages.hpp"
#include "rubber.hpp"
#include "schemes.hpp"

#include <scree/mpm/boundaries/bed.hpp>
#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/mpm/boundaries/rigid_body.hpp>
#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/node_means.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <string>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // [m/s^2]

/// A column of friction, a value for each point by its place.
template <int D, int V>
std::size_t rub(Particles<D, V>& particles, const std::function<double(double)>& friction_at) {
  const std::size_t column = particles.add_column({"friction", "mu", "-"}, 1);
  for (Index p = 0; p < particles.size(); ++p) {
    particles.column(column).component(0)[p] = friction_at(particles.position.component(0)[p]);
  }
  return column;
}

/// Reads the first mean of every node, and does nothing with it.
template <int D>
class ReadsEverywhere final : public Boundary<D> {
 public:
  [[nodiscard]] Index num_means() const noexcept override { return 1; }
  void mark_read(const Nodes<D>& /*nodes*/, std::span<std::uint8_t> is_read) const noexcept override {
    std::ranges::fill(is_read, std::uint8_t{1});
  }
  void fold(Nodes<D>& /*nodes*/, const double* /*gravity*/, double /*dt*/) const noexcept override {}
  void hold(Nodes<D>& /*nodes*/, double /*dt*/) const noexcept override {}
  void reflect(Nodes<D>& /*nodes*/) const noexcept override {}
};

/// The means of the column `friction` on all nodes of a mesh.
template <int D>
struct Carried {
  Carried(Particles<D> points, const CartesianGrid<D>& grid, const AnyShape& shape)
      : particles{std::move(points)}, nodes{grid, {D, true}} {
    const auto transfer = make_transfer<D, D>(shape, PicFlip{0});
    NodeMeans<D, D> means{shape};
    means.add(particles, "friction", Rubs::inputs[0], Rubs::name);
    nodes.carry(means.size());
    const auto blocks = cell_sort(particles, grid, transfer->stencil_shift(), one_thread);
    for (const auto& block : blocks.blocks) transfer->scatter(particles, block, nodes, 0);
    std::array<std::unique_ptr<Boundary<D>>, 1> reader{std::make_unique<ReadsEverywhere<D>>()};
    ReadNodes<D> read;
    read.find(reader, nodes, blocks, transfer->tile_edge());
    std::vector<Extremes> memory;
    means.bring(particles, blocks, read, nodes, memory, one_thread);
  }
  Particles<D> particles;
  Nodes<D> nodes;
};

/// Points that move as fast as they rub give nodes the means as velocities: those of momentum over mass.
template <int D>
void expect_means_of_momentum(const AnyShape& shape) {
  const auto grid = cube<D>(5, 0.1, false);
  auto particles = scattered<D>(grid, 200, 0);
  std::size_t p = 0;
  const std::size_t column = rub(particles, [&](double) { return 0.1 + static_cast<double>(p++ % 7); });
  std::ranges::copy(particles.column(column).values(), particles.velocity.component(0));

  Carried<D> carried{std::move(particles), grid, shape};

  for (Index n = 0; n < carried.nodes.num_nodes(); ++n) {
    const double* node = carried.nodes[n];
    const double mean = carried.nodes.means(n)[0];
    if (node[NodeRecord::mass] == 0) {
      EXPECT_EQ(mean, 0);
      continue;
    }
    // Two quotients of sums of up to 200 products, of five factors each, up to 7.
    EXPECT_NEAR(mean, node[NodeRecord::momentum] / node[NodeRecord::mass], 7 * 2 * 2 * 205 * round_off);
    EXPECT_NEAR(carried.nodes.carried(n)[0], node[NodeRecord::mass],
                2 * 205 * round_off * node[NodeRecord::mass]);
  }
}

TEST(NodeMeans, AreWeightedAsMomentumIs) {  // Eq. (M170)
  for (const AnyShape& shape : every<AnyShape>()) {
    expect_means_of_momentum<1>(shape);
    expect_means_of_momentum<2>(shape);
    expect_means_of_momentum<3>(shape);
  }
}

TEST(NodeMeans, OfEqualValuesAreThatValueToTheBit) {  // Eq. (M171)
  const auto grid = cube<2>(5, 0.1, false);
  auto particles = scattered<2>(grid, 200, 0);
  rub(particles, [](double) { return 0.1; });

  const Carried<2> carried{std::move(particles), grid, Quadratic{}};

  for (Index n = 0; n < carried.nodes.num_nodes(); ++n) {
    EXPECT_EQ(carried.nodes.means(n)[0], carried.nodes[n][NodeRecord::mass] > 0 ? 0.1 : 0);
  }
}

TEST(NodeMeans, OneColumnIsCarriedOnceForAllWhoReadIt) {
  auto particles = scattered<2>(cube<2>(5, 0.1, false), 10, 0);
  rub(particles, [](double) { return 0.3; });
  const InputColumn size{"grain_size", "m", 1e-3};
  particles.column(particles.add_column({"grain_size", "s", "m"}, 1)).component(0)[0] = 0.001;
  std::ranges::fill(particles.column(1).values(), 0.001);
  NodeMeans<2, 2> means{Linear{}};

  EXPECT_EQ(means.add(particles, "friction", Rubs::inputs[0], "rubs"), 0U);
  EXPECT_EQ(means.add(particles, "grain_size", size, "rubs"), 1U);
  EXPECT_EQ(means.add(particles, "friction", Rubs::inputs[0], "rubs too"), 0U);
  EXPECT_EQ(means.size(), 2);
}

/// A node beside points of two materials has one friction, that of neither. So two bodies rub each as it does
/// alone only with a cell between them that neither is in: then no hat reaches both.
TEST(NodeMeans, MixWhatLiesWithinACellAndRemedyIsAFinerMesh) {
  const auto friction_of_nodes = [](Index cells) {
    const auto grid = cube<1>(cells, 0.4 / static_cast<double>(cells), false);
    Particles<1> particles;
    particles.resize(2);
    for (Index p = 0; p < 2; ++p) {
      particles.position.component(0)[p] = p == 0 ? 0.04 : 0.16;  // [m]
      particles.mass.component(0)[p] = 1;
      particles.density.component(0)[p] = 1000;
    }
    rub(particles, [](double x) { return x < 0.1 ? 0.25 : 0.75; });
    const Carried<1> carried{std::move(particles), grid, Linear{}};
    std::vector<double> found;
    for (Index n = 0; n < carried.nodes.num_nodes(); ++n) {
      if (carried.nodes[n][NodeRecord::mass] > 0) found.push_back(carried.nodes.means(n)[0]);
    }
    return found;
  };

  // In cells 0 and 1 they share node 1, by 0.4 each: two sums of two and a quotient round it.
  const auto shared = friction_of_nodes(4);
  ASSERT_EQ(shared.size(), 3U);
  EXPECT_EQ(shared[0], 0.25);
  EXPECT_NEAR(shared[1], 0.5, 8 * round_off);
  EXPECT_EQ(shared[2], 0.75);
  EXPECT_EQ(friction_of_nodes(8), (std::vector<double>{0.25, 0.25, 0.75, 0.75}));
}

/// Gives what holds blocks on a slope: its law, what it reads itself, and what is carried.
using MakeBase = std::function<std::unique_ptr<Boundary<2>>(
    const CartesianGrid<2>&, const Rubs::Input<double>&, const CarriedInput<Rubs>&)>;
struct Base {
  double height;  ///< of what it holds material on [m]
  MakeBase make;
};

/// A wall, a bed that cuts cells, and a body, which stands still.
[[nodiscard]] std::vector<Base> every_base() {
  constexpr double up = 0.15;
  const PlaneSurface<2> plane{Vector<2>{0, up}, Vector<2>::Unit(1)};
  const auto wall = [](const CartesianGrid<2>&, const auto& own, const auto& carried) {
    return make_frictional_wall<2>(Rubs{}, own, Hold::pushes, 1, Side::low, Symmetry::plane, carried);
  };
  const auto bed = [plane](const CartesianGrid<2>& grid, const auto& own, const auto& carried) {
    return make_bed<2, Rubs>(
        Contact<Rubs>{}, [own](const Vector<2>&) { return own; }, grid, plane, Symmetry::plane, carried);
  };
  const auto body = [plane](const CartesianGrid<2>&, const auto& own, const auto& carried) {
    return make_rigid_body<2, Rubs>(Contact<Rubs>{}, plane, RigidMotion<2>{}, 0, own, Symmetry::plane,
                                    carried);
  };
  return {{0, wall}, {up, bed}, {up, body}};
}

/// Two blocks of rubber of 0.4 m x 0.2 m beside each other on a slope of 30 degrees, far enough apart.
struct TwoBlocks {
  static constexpr double h = 0.1;        // [m]
  static constexpr double dt = 1e-4;      // [s]
  static constexpr double midway = 0.85;  // [m], between them
  static constexpr double friction_left = 0.1;

  TwoBlocks(const Base& base, double friction_right, bool is_carried = true,
            const AnyShape& shape = Quadratic{}, const AnyTransfer& transfer = Apic{})
      : frictions{friction_left, friction_right} {
    const CartesianGrid<2> grid{Vector<2>::Zero(), Vector<2>{h, h}, {18, 5}, {true, false}};
    auto particles = filled<2>(grid, 2);
    std::vector<Index> kept;
    for (Index p = 0; p < particles.size(); ++p) {
      const double x = particles.position.component(0)[p];
      double& y = particles.position.component(1)[p];
      if (y < 2 * h && ((0.2 < x && x < 0.6) || (1.1 < x && x < 1.5))) kept.push_back(p);
      y += base.height;
    }
    particles.for_each_column([&](Column& column) { column.reorder(kept); });
    std::fill_n(particles.velocity.component(0), particles.size(), 1.0);  // it slides
    rub(particles, [&](double x) { return frictions[x < midway ? 0 : 1]; });
    stages.stress = std::make_unique<StressUpdateBy<2, 2, Rubber>>(Rubber{1e6, 6e5, 1000}, particles);
    stages.transfer = make_transfer<2, 2>(shape, transfer);
    stages.gravity = {gravity * std::sin(30 * degree), -gravity * std::cos(30 * degree)};
    CarriedInput<Rubs> carried;
    if (is_carried) {
      stages.node_means = std::make_unique<NodeMeans<2, 2>>(shape);
      carried.read(0, stages.node_means->add(particles, "friction", Rubs::inputs[0], Rubs::name));
    }
    stages.boundaries.push_back(base.make(grid, {friction_left}, carried));
    state = std::make_unique<State<2, 2>>(start(std::move(particles), grid, stages, one_thread));
  }
  void advance(int num_steps) {
    for (int n = 0; n < num_steps; ++n) step(*state, stages, dt, one_thread);
  }
  /// Velocity along the slope and mu times that across, the mean of one block [m/s].
  [[nodiscard]] double slid(std::size_t block) const {
    const Particles<2>& particles = state->particles;
    double mass = 0;
    double sum = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      if (particles.column(0).component(0)[p] != frictions[block]) continue;
      const double m = particles.mass.component(0)[p];
      mass += m;
      sum += m * (particles.velocity.component(0)[p] + frictions[block] * particles.velocity.component(1)[p]);
    }
    return sum / mass;
  }

  std::array<double, 2> frictions;
  Stages<2, 2> stages;
  std::unique_ptr<State<2, 2>> state;
};

/// Of each block momentum along the slope, and mu times that across, change by its weight alone, to
/// round-off, whatever waves run through it: g (sin - mu cos) with the mu that it carries.
TEST(CarriedFriction, LetsEachBlockSlideAtItsOwnAcceleration) {
  for (const Base& base : {every_base()[1], every_base()[2]}) {  // light nodes spoil free edges on a wall
    for (const AnyShape& shape : {AnyShape{Quadratic{}}, AnyShape{Cubic{}}}) {
      TwoBlocks blocks{base, 0.5, true, shape};
      const std::array<double, 2> before{blocks.slid(0), blocks.slid(1)};

      constexpr int num_steps = 1000;
      blocks.advance(num_steps);

      for (const std::size_t block : {0U, 1U}) {
        const double mu = blocks.frictions[block];
        const double acceleration = gravity * (std::sin(30 * degree) - mu * std::cos(30 * degree));
        // Rounding of speeds of up to 1.5 m/s at each step, and of stresses of 1 kPa that add up to nothing.
        const double rounding =
            rounding_of(2, 3, num_steps) * (1.5 + TwoBlocks::dt * 1e3 / (1000 * TwoBlocks::h));
        EXPECT_NEAR(blocks.slid(block) - before[block], num_steps * TwoBlocks::dt * acceleration, rounding);
      }
    }
  }
}

/// A column of two cells whose points rub unlike each other: the wall has the friction of the mean. In each
/// step momentum along it, and mu times that across, change by the weight alone.
TEST(CarriedFriction, OfAWallIsThatOfTheMean) {
  const CartesianGrid<1> grid{Vector<1>::Zero(), Vector<1>{0.1}, {4}, {false}};
  auto particles = seed_box<1, 2>(grid, Vector<1>{0.0}, Vector<1>{0.2}, {2}, 1000);
  std::fill_n(particles.velocity.component(1), particles.size(), 1.0);  // it slides
  rub(particles, [](double y) { return 0.1 + y; });
  auto stages = stages_of<1, 2>(particles, Quadratic{}, Apic{}, {1e5, 1000, 10});
  stages.gravity = {-gravity * std::cos(30 * degree), gravity * std::sin(30 * degree)};
  stages.node_means = std::make_unique<NodeMeans<1, 2>>(Quadratic{});
  CarriedInput<Rubs> carried;
  carried.read(0, stages.node_means->add(particles, "friction", Rubs::inputs[0], Rubs::name));
  stages.boundaries.push_back(
      make_frictional_wall<1>(Rubs{}, {0}, Hold::pushes, 0, Side::low, Symmetry::plane, carried));
  auto state = start(std::move(particles), grid, stages, one_thread);
  const auto mean_velocity = [&](int component) {
    return momentum_of(state.particles, component).total / 200;  // of 200 kg/m^2
  };

  constexpr double dt = 1e-4;  // [s]
  for (int n = 0; n < 100; ++n) {
    const std::array<double, 2> before{mean_velocity(0), mean_velocity(1)};
    step(state, stages, dt, one_thread);
    const double mu = state.nodes.means(Nodes<1>::num_images)[0];
    const double along = mean_velocity(1) - before[1] - dt * stages.gravity[1];
    const double across = mean_velocity(0) - before[0] - dt * stages.gravity[0];
    // Rounding of speeds of up to 1.1 m/s, and of stresses of 2 kPa that add up to nothing.
    EXPECT_NEAR(along, -mu * across, rounding_of(1, 3, 1) * (1.1 + dt * 2e3 / (1000 * 0.1)));
    EXPECT_GT(mu, 0.125);  // the points' beside the wall; those next to it have 0.175
    EXPECT_LT(mu, 0.175);
  }
}

template <int D>
void expect_same_bits(const Particles<D>& a, const Particles<D>& b) {
  std::vector<const Column*> columns;
  a.for_each_column([&](const Column& column) { columns.push_back(&column); });
  std::size_t i = 0;
  b.for_each_column([&](const Column& column) {
    EXPECT_TRUE(std::ranges::equal(columns[i]->values(), column.values())) << column.quantity().name;
    ++i;
  });
}

TEST(CarriedFriction, ThatIsUniformIsThatOfTheWallToTheBit) {
  for (const Base& base : every_base()) {
    TwoBlocks carried{base, TwoBlocks::friction_left};
    TwoBlocks constant{base, TwoBlocks::friction_left, false};

    carried.advance(300);
    constant.advance(300);

    expect_same_bits(carried.state->particles, constant.state->particles);
  }
}

/// Walls hold in the extra passes too.
TEST(CarriedFriction, IsReadInPassesThatOnlyMapVelocities) {
  for (const Order order : {Order::musl, Order::usf}) {
    TwoBlocks carried{every_base()[0], TwoBlocks::friction_left, true, Quadratic{}, PicFlip{1}};
    TwoBlocks constant{every_base()[0], TwoBlocks::friction_left, false, Quadratic{}, PicFlip{1}};
    for (TwoBlocks* blocks : {&carried, &constant}) {
      blocks->stages.order = order;
      blocks->stages.xpic = make_xpic<2, 2>(Quadratic{}, 2);
      blocks->advance(100);
    }

    expect_same_bits(carried.state->particles, constant.state->particles);
  }
}

/// A layer of 9 x 3 blocks of cells.
TEST(CarriedFriction, HasTheSameBitsForAnyNumberOfThreads) {
  const CartesianGrid<2> grid{Vector<2>::Zero(), Vector<2>{0.1, 0.1}, {128, 32}, {true, false}};
  const auto made_by = [&](Threads threads) {
    auto particles = filled<2>(grid, 2);
    fill_at_random(particles.velocity, 1.0);
    rub(particles, [](double x) { return 0.5 + 0.4 * std::sin(7 * x); });
    auto stages = stages_of<2, 2>(particles, Quadratic{}, Apic{}, {1e5, 1000, 2});
    stages.node_means = std::make_unique<NodeMeans<2, 2>>(Quadratic{});
    CarriedInput<Rubs> carried;
    carried.read(0, stages.node_means->add(particles, "friction", Rubs::inputs[0], Rubs::name));
    stages.boundaries.push_back(
        make_frictional_wall<2>(Rubs{}, {0}, Hold::pushes, 1, Side::low, Symmetry::plane, carried));
    stages.boundaries.push_back(make_wall<2>(Slip{}, 1, Side::high));
    auto state = start(std::move(particles), grid, stages, threads);
    for (int n = 0; n < 3; ++n) step(state, stages, 1e-3, threads);
    return state;
  };
  const State<2, 2> one = made_by(one_thread);

  for (const int count : {2, 3, 4}) {
    const State<2, 2> many = made_by({count});
    for (Index n = 0; n < one.nodes.num_nodes(); ++n) {
      EXPECT_EQ(many.nodes.means(n)[0], one.nodes.means(n)[0]);
    }
    expect_same_bits(one.particles, many.particles);
  }
}

/// A body of any form, which goes on along each axis and, where it can, turns.
template <int D>
[[nodiscard]] std::unique_ptr<Boundary<D>> moving_ball(const CarriedInput<Rubs>& carried) {
  const BallSurface<D> ball{Vector<D>::Constant(0.3), 0.22, BallSurface<D>::Material::outside};
  RigidMotion<D> motion;
  motion.pivot = Vector<D>::Constant(0.2);
  motion.place = [](double time) { return Vector<D>{Vector<D>::Constant(0.2 + 0.5 * time)}; };
  if (D > 1) motion.angle = [](double time) { return time; };
  return make_rigid_body<D, Rubs>(Contact<Rubs>{}, ball, motion, 0, {0}, Symmetry::plane, carried);
}

/// Only blocks that give to nodes that are read are visited: points then move as if all were.
template <int D>
void expect_the_bits_of_means_everywhere(const AnyShape& shape) {
  const auto grid = cube<D>(D == 1 ? 96 : 24, 0.1, false);
  const auto run = [&](bool reads_everywhere) {
    auto particles = scattered<D>(grid, D == 3 ? 20000 : 4000, 0);
    fill_at_random(particles.velocity, 1.0);
    rub(particles, [](double x) { return 0.5 + 0.4 * std::sin(7 * x); });
    auto stages = stages_of<D, D>(particles, shape, Apic{}, {1e5, 1000, 2});
    stages.node_means = std::make_unique<NodeMeans<D, D>>(shape);
    CarriedInput<Rubs> carried;
    carried.read(0, stages.node_means->add(particles, "friction", Rubs::inputs[0], Rubs::name));
    stages.leaving = Leaving::reflect;
    stages.boundaries.push_back(moving_ball<D>(carried));
    stages.boundaries.push_back(
        make_frictional_wall<D>(Rubs{}, {0}, Hold::pushes, D - 1, Side::low, Symmetry::plane, carried));
    if (reads_everywhere) stages.boundaries.push_back(std::make_unique<ReadsEverywhere<D>>());
    auto state = start(std::move(particles), grid, stages, one_thread);
    for (int n = 0; n < 12; ++n) step(state, stages, 1e-3, one_thread);
    return state;
  };
  const State<D, D> few = run(false);
  const State<D, D> all = run(true);

  const auto num_visited = [](const State<D, D>& state) {
    std::size_t count = 0;
    for (const auto& colour : state.read.colours()) count += colour.size();
    return count;
  };
  EXPECT_EQ(num_visited(all), all.blocks.blocks.size());
  EXPECT_LT(num_visited(few), all.blocks.blocks.size());
  ASSERT_GT(few.read.nodes().size(), 0U);
  for (const Index n : few.read.nodes()) EXPECT_EQ(few.nodes.means(n)[0], all.nodes.means(n)[0]);
  expect_same_bits(few.particles, all.particles);
}

TEST(CarriedFriction, HasTheBitsOfMeansAtAllNodes) {
  for (const AnyShape& shape : {AnyShape{Linear{}}, AnyShape{Quadratic{}}, AnyShape{Cubic{}}}) {
    expect_the_bits_of_means_everywhere<1>(shape);
    expect_the_bits_of_means_everywhere<2>(shape);
  }
  expect_the_bits_of_means_everywhere<3>(Quadratic{});
}

/// Blocks of 16 x 16 cells, of which the first begins one before the mesh, so that 9 x 3 have points of 128 x
/// 32 cells. The lowest row reaches the wall; the next, from cell 15 on, down to node 13 with its skin.
TEST(ReadNodes, OfAWallAreGivenToByTheBlocksBesideIt) {
  const CartesianGrid<2> grid{Vector<2>::Zero(), Vector<2>{0.1, 0.1}, {128, 32}, {true, false}};
  auto particles = filled<2>(grid, 2);
  rub(particles, [](double) { return 0.5; });
  auto stages = stages_of<2, 2>(particles, Linear{}, Apic{}, {1e5, 1000, 2});
  stages.node_means = std::make_unique<NodeMeans<2, 2>>(Linear{});
  CarriedInput<Rubs> carried;
  carried.read(0, stages.node_means->add(particles, "friction", Rubs::inputs[0], Rubs::name));
  stages.boundaries.push_back(
      make_frictional_wall<2>(Rubs{}, {0}, Hold::pushes, 1, Side::low, Symmetry::plane, carried));

  const auto state = start(std::move(particles), grid, stages, one_thread);

  EXPECT_EQ(state.blocks.blocks.size(), 9U * 3);
  std::size_t num_visited = 0;
  for (const auto& colour : state.read.colours()) num_visited += colour.size();
  EXPECT_EQ(num_visited, 9U);
  ASSERT_EQ(state.read.nodes().size(), 128U);
  for (const Index n : state.read.nodes()) EXPECT_EQ(n / state.nodes.stride(1), 1);  // past the images
}

TEST(CarriedFriction, IsRefusedWithoutTheMeansThatItReads) {
  TwoBlocks blocks{every_base()[0], 0.5};
  const std::string message =
      "a boundary reads 1 means of what points carry, but the stages bring 0 to the nodes: "
      "Stages::node_means "
      "must be those that gave it their places";
  blocks.stages.node_means = nullptr;

  const auto anew = [&] {
    static_cast<void>(start(blocks.state->particles, blocks.state->nodes.grid(), blocks.stages, one_thread));
  };
  EXPECT_EQ(message_of<InputError>(anew), message);
  EXPECT_EQ(message_of<InputError>([&] { resume(*blocks.state, blocks.stages); }), message);
}

TEST(CarriedFriction, IsReadOnWhenARunGoesOn) {
  TwoBlocks whole{every_base()[1], 0.5, true, Quadratic{}};
  whole.advance(5);
  const State<2, 2>& stored = *whole.state;
  State<2, 2> resumed{stored.particles, Nodes<2>{stored.nodes.grid(), whole.stages.transfer->record()}};
  resumed.blocks.blocks = stored.blocks.blocks;
  resumed.mass_floor = stored.mass_floor;
  resume(resumed, whole.stages);

  whole.advance(5);
  for (int n = 0; n < 5; ++n) step(resumed, whole.stages, TwoBlocks::dt, one_thread);

  expect_same_bits(resumed.particles, whole.state->particles);
}

TEST(NodeMeans, RefuseWhatPointsDoNotCarry) {
  auto particles = scattered<2>(cube<2>(5, 0.1, false), 10, 0);
  particles.add_column({"fractions", "phi", "-"}, 2);
  particles.add_column({"friction", "mu", "-"}, 1);
  std::ranges::fill(particles.column(1).values(), 0.5);
  NodeMeans<2, 2> means{Linear{}};
  const auto message = [&](std::string_view column, const InputColumn& input) {
    return message_of<InputError>([&] { means.add(particles, column, input, "rubs"); });
  };

  EXPECT_EQ(message("cohesion", {"cohesion", "Pa", 1}),
            "the law 'rubs' of a wall needs the column 'cohesion', which no part of this run provides");
  EXPECT_EQ(message("fractions", {"friction", "-", 1}),
            "the law 'rubs' of a wall reads the column 'fractions' as one number, but it has 2");
  EXPECT_EQ(message("friction", {"depth", "m", 1}),
            "the law 'rubs' of a wall reads the column 'friction' in m, but it is in -");
  particles.column(1).component(0)[3] = -0.5;
  EXPECT_EQ(
      message("friction", Rubs::inputs[0]),
      "the law 'rubs' reads friction = -0.5 of material point 3 at (0.444854, 0.356881) m: must be finite "
      "and above 0");
  EXPECT_EQ(means.size(), 0);
}

}  // namespace
}  // namespace scree::mpm
