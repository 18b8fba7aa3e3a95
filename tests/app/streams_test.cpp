// Streams that enter and leave, as a scene says.

#include "scenes.hpp"
#include "scree/run/restart.hpp"
#include "scree/run/summary.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace scree::app::testing {
namespace {

/// Two streams along a smooth floor, 10 cm deep and of unlike grains, that meet in the middle, where a box
/// takes what rises.
const std::string meeting = open_channel() + stream_of_1_m_per_s() + R"(fractions = [0.25, 0.75]
[[inflow]]
low = [0.9, 0.0]
high = [1.0, 0.1]
velocity = [-1.0, 0.0]
points_per_cell = 2
start = 0.05
stop = 0.5
[[outflow]]
low = [0.0, 0.15]
high = [1.0, 0.5]
)" + fluid_of_streams() + R"([grains]
diameters = [1e-3, 2e-3]
fractions = [1.0, 0.0]
[time]
end = 2
)";

/// The first stream alone, which runs through to the open end.
[[nodiscard]] std::string passing() {
  const auto from = meeting.find("[[inflow]]", meeting.find("[[inflow]]") + 1);
  return meeting.substr(0, from) + meeting.substr(meeting.find("[rheology]"));
}

[[nodiscard]] Simulation<2, 2> simulation_of(const std::string& text, Threads threads = {1}) {
  return {parse_scene(text, "scene.toml").scene, threads};
}

void step_to(Simulation<2, 2>& simulation, double time) {
  while (simulation.clock.time < time) simulation.step();
}

void expect_same_bits(const Simulation<2, 2>& a, const Simulation<2, 2>& b) {
  std::vector<const mpm::Column*> columns;
  a.state.particles.for_each_column([&](const mpm::Column& column) { columns.push_back(&column); });
  std::size_t i = 0;
  b.state.particles.for_each_column([&](const mpm::Column& column) {
    EXPECT_TRUE(std::ranges::equal(columns[i]->values(), column.values())) << column.quantity().name;
    ++i;
  });
  EXPECT_EQ(a.streams.taken[0].mass, b.streams.taken[0].mass);
  EXPECT_EQ(a.streams.taken[0].momentum, b.streams.taken[0].momentum);
  EXPECT_EQ(a.streams.taken[0].carried, b.streams.taken[0].carried);
}

/// Every class is balanced: what is there and what was taken is what began and what entered.
TEST(Streams, BalanceTheMassOfEachClass) {
  auto streams = simulation_of(meeting);

  step_to(streams, 0.7);

  ASSERT_GT(streams.streams.taken[0].count, 10);
  ASSERT_EQ(streams.streams.inflows[1].num_layers(), 18);  // 0.45 m
  EXPECT_LE(mass_drift(streams), 1e-12);                   // sums of some thousand points
  EXPECT_LE(class_mass_drift(streams), 1e-12);
}

TEST(Streams, BalanceWhatIsAbsorbed) {
  auto stream = simulation_of(passing());

  step_to(stream, 1.2);

  ASSERT_GT(stream.state.absorbed.count, 10);
  EXPECT_NEAR(stream.state.absorbed.carried[1], 0.75 * stream.state.absorbed.mass,
              1e-12 * stream.state.absorbed.mass);
  EXPECT_LE(mass_drift(stream), 1e-12);
  EXPECT_LE(class_mass_drift(stream), 1e-12);
}

/// Where a balance fails: mass that somebody takes on the way is missing.
TEST(Streams, MissWhatNobodyHasCounted) {
  auto stream = simulation_of(passing());
  step_to(stream, 0.1);
  double& mass = stream.state.particles.mass.component(0)[0];
  const double share = mass / (stream.tally.first_mass + stream.streams.inflows[0].entered().mass);

  mass = 0;

  EXPECT_NEAR(mass_drift(stream), share, 1e-12);
}

/// A layer is as dense below as the weight of the stream makes it: rho_0 (1 + rho_0 g d/K), but for the
/// square.
TEST(Streams, BearTheirOwnWeight) {
  const auto stream = simulation_of(passing());
  const auto& layer = stream.streams.inflows[0].layer();
  const double compression = 1000 * 9.81 * 0.1 / 1e5;

  ASSERT_EQ(layer.size(), 4);
  for (Index p = 0; p < layer.size(); ++p) {
    const double depth = 0.1 - layer.position.component(1)[p];
    EXPECT_NEAR(layer.density.component(0)[p], 1000 * (1 + compression * depth / 0.1),
                1000 * compression * compression);
  }
}

TEST(Streams, RestartGoesOnBitForBit) {
  const auto file = std::filesystem::path{::testing::TempDir()} / "scree_streams.h5";
  auto unbroken = simulation_of(meeting);
  step_to(unbroken, 0.45);
  ASSERT_GT(unbroken.streams.taken[0].count, 0);
  write_checkpoint(unbroken, file, "");
  step_to(unbroken, 0.65);

  auto restarted = simulation_of(meeting);
  read_checkpoint_into(restarted, file);
  step_to(restarted, 0.65);

  expect_same_bits(unbroken, restarted);
  EXPECT_LE(class_mass_drift(restarted), 1e-12);
  EXPECT_EQ(restarted.streams.inflows[1].num_layers(), unbroken.streams.inflows[1].num_layers());
}

TEST(Streams, RestartRefusesOtherStreams) {
  const auto file = std::filesystem::path{::testing::TempDir()} / "scree_stream.h5";
  write_checkpoint(simulation_of(passing()), file, "");
  auto other = simulation_of(meeting);

  try {
    read_checkpoint_into(other, file);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string{error.what()},
              file.string() + ": is of another scene: it has 1 [[inflow]], the scene has 2");
  }
}

/// The first stream ends, and has been taken out before the second one begins.
[[nodiscard]] std::string emptied_between() {
  std::string text = with(meeting, "points_per_cell = 2\n", "points_per_cell = 2\nstop = 0.05\n");
  text = with(text, "start = 0.05\nstop = 0.5\n", "start = 1.5\n");
  text = with(text, "low = [0.0, 0.15]\nhigh = [1.0, 0.5]", "low = [0.3, 0.0]\nhigh = [0.6, 0.5]");
  return with(text, "[rheology]", "[gravity]\nmagnitude = 0\n[rheology]");
}

/// When all have left, steps go from layer to layer.
TEST(Streams, BeginAgainInAnEmptyMesh) {
  auto streams = simulation_of(emptied_between());

  step_to(streams, 1.4);
  ASSERT_EQ(streams.num_points(), 0);
  step_to(streams, 2);

  EXPECT_EQ(streams.streams.inflows[1].num_layers(), 20);  // 0.5 m
  EXPECT_EQ(streams.num_points(), 4 * 16);                 // in the 16 layers between 0.6 m and 1 m
  EXPECT_LE(mass_drift(streams), 1e-12);
}

/// On the step after which no point is left, too: the next one sorts.
TEST(Streams, RestartGoesOnBitForBitWhileTheMeshEmpties) {
  const auto file = std::filesystem::path{::testing::TempDir()} / "scree_empty_streams.h5";
  const std::string text = emptied_between();
  auto unbroken = simulation_of(text);
  while (unbroken.num_points() > 0) unbroken.step();
  write_checkpoint(unbroken, file, "");
  step_to(unbroken, 1.7);

  auto restarted = simulation_of(text);
  read_checkpoint_into(restarted, file);
  step_to(restarted, 1.7);

  EXPECT_EQ(restarted.clock.step, unbroken.clock.step);
  expect_same_bits(unbroken, restarted);
}

TEST(Streams, AreInTheSummary) {
  auto streams = simulation_of(meeting);
  streams.step();

  const std::string summary = summary_json(streams, 1, "finished");

  EXPECT_NE(summary.find("\"inflow\": [\n    {\n      \"points\": 0,\n      \"mass\": 0.0,"),
            std::string::npos);
  EXPECT_NE(summary.find("\"outflow\": [\n    {\n      \"points\": 0,"), std::string::npos);
  EXPECT_NE(summary.find("\"mass_drift\": 0.0"), std::string::npos);
}

TEST(Streams, WarnOfASinglePointPerAxis) {
  EXPECT_EQ(simulation_of(meeting).too_few_points(), "");
  EXPECT_EQ(simulation_of(with(meeting, "points_per_cell = 2", "points_per_cell = 1")).too_few_points(),
            "[[inflow]] 1 has a single point along each axis of a cell, and comes apart as soon as it speeds "
            "up: give it more points_per_cell");
}

/// A pipe of 1 m that a stream of 1 m/s fills from a box of 0.1 m on. Sound in it runs at 100 m/s.
[[nodiscard]] std::string pipe(const std::string& end) {
  std::string text = with(open_channel(), "size = [1.0, 0.5]\ncells = 10", "size = [1.0, 0.1]\ncells = 2");
  text = with(text, "x_high = \"open\"\ny_low = \"slip\"\ny_high = \"open\"",
              "x_high = \"" + end + "\"\ny_low = \"slip\"\ny_high = \"slip\"");
  return text + stream_of_1_m_per_s() + with(fluid_of_streams(), "1e5", "1e7") +
         "[gravity]\nmagnitude = 0\n[time]\nend = 1.3\n";
}

/// Until something is said, or the end.
[[nodiscard]] std::string step_to_warning(Simulation<2, 2>& simulation) {
  while (!simulation.is_finished()) {
    simulation.step();
    std::string warning = simulation.take_warning();
    if (!warning.empty()) return warning;
  }
  return {};
}

/// The stream comes to the wall after 0.9 s. By (M188) what has entered since is a tenth of what has room
/// 0.09 s later; (M189) asks for v/c = 0.01 more of the place, which differs by as much from the mean: 0.09
/// to 0.108 s. Where the stream ends is known to a cell, 0.05 s, and it is looked at when a layer enters,
/// every 0.025 s.
TEST(Streams, ThatAreBlockedAreSaidToBeOnce) {  // Eqs. (M188), (M189)
  auto blocked = simulation_of(pipe("slip"));

  const std::string warning = step_to_warning(blocked);

  const double time = blocked.clock.time;
  EXPECT_GE(time, 0.99 - 0.05);
  EXPECT_LE(time, 1.008 + 0.05 + 0.025);
  const auto& particles = blocked.state.particles;
  double mass = 0;
  double volume = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double x = particles.position.component(0)[p];
    if (!(particles.mass.component(0)[p] > 0) || x < 0.1 || x > 0.15) continue;
    mass += particles.mass.component(0)[p];
    volume += particles.mass.component(0)[p] / particles.density.component(0)[p];
  }
  const double compression = mass / volume / 1000 - 1;
  EXPECT_GE(compression, 0.11);
  EXPECT_EQ(warning,
            fmt::format(
                "[[inflow]] 1: at t = {:.4g} s the material before its box, at (0.125, 0.05) m, is {:.0f} % "
                "denser than the stream: it is blocked, and all that enters is squeezed into the room that "
                "there is: let it out, by an [[outflow]] or an end that is open, or stop the stream before",
                time, 100 * compression));
  EXPECT_EQ(step_to_warning(blocked), "");
}

/// Nor one that meets another and rises, to be taken out above.
TEST(Streams, ThatAreNotBlockedAreNotSaidToBe) {
  auto open = simulation_of(pipe("open"));
  auto rising = simulation_of(meeting);

  EXPECT_EQ(step_to_warning(open), "");
  EXPECT_EQ(step_to_warning(rising), "");
}

/// Grains speed up and thin out on a chute that does not hold them; what enters is rho v A t within a layer.
TEST(Streams, FeedTheChuteOfTheScene) {
  Simulation<2, 2> chute{scene_of("fed_chute", {"mesh.cells=8"}), {1}};

  step_to(chute, 0.9);

  const auto& inflow = chute.streams.inflows[0];
  double layer = 0;
  for (const double m : inflow.layer().mass.values()) layer += m;
  const double due = layer * 0.4 * chute.clock.time / (0.01 / 3);
  EXPECT_GE(due - inflow.entered().mass, -1e-9 * due);
  EXPECT_LE(due - inflow.entered().mass, layer * (1 + 1e-9));
  const auto& taken = chute.streams.taken[0];
  ASSERT_GT(taken.count, 100);
  EXPECT_GT(taken.momentum[0] / taken.mass, 1.0);  // [m/s]: from 0.4 on, by 0.9 m/s^2 on 0.7 m
  EXPECT_LE(mass_drift(chute), 1e-12);
}

struct BadStream {
  std::string part;
  std::string instead;
  std::string message;
};

[[nodiscard]] std::string message_of(const std::string& text) {
  try {
    static_cast<void>(simulation_of(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(BadStream, IsNamedWithItsPlaceAndWhatWasExpected) {
  const std::vector<BadStream> cases{
      {"velocity = [1.0, 0.0]", "velocity = [1.0, 0.5]",
       "scene.toml:14: [inflow 1] velocity = [1.0, 0.5]: must lie along one axis of the mesh"},
      {"high = [0.1, 0.1]", "high = [0.12, 0.1]",
       "scene.toml:13: [inflow 1] high = [0.12, 0.1]: along the velocity the box must end on nodes, "
       "multiples of 0.05 m"},
      {"high = [0.1, 0.1]", "high = [0.05, 0.1]",
       "scene.toml:13: [inflow 1] high = [0.05, 0.1]: along the velocity the box must be at least two "
       "cells long, 0.1 m"},
      {"x_low = \"open\"", "x_low = \"slip\"",
       "scene.toml:12: [inflow 1] low = [0.0, 0.0]: the stream comes through a wall: make [boundaries] "
       "x_low = \"open\", or leave two cells behind the box"},
      {"fractions = [0.25, 0.75]", "fractions = [0.25, 0.7]",
       "scene.toml:16: [inflow 1] fractions = [0.25, 0.7]: must add up to 1, and add up to 0.95"},
      {"stop = 0.5", "stop = 0.05", "scene.toml:23: [inflow 2] stop = 0.05: must come after start = 0.05"},
      {"low = [0.0, 0.15]", "low = [0.96, 0.15]",
       "scene.toml:26: [outflow 1] high = [1.0, 0.5]: must exceed low by at least a cell, 0.05 m, along x"},
      {"low = [0.0, 0.15]\nhigh = [1.0, 0.5]", "low = [0.0, 0.5]\nhigh = [1.0, 1.5]",
       "scene.toml:25: [outflow 1] low = [0.0, 0.5]: lies beyond the mesh, which ends at 0.5 m along y"},
      {"low = [0.9, 0.0]\nhigh = [1.0, 0.1]", "low = [0.0, 0.05]\nhigh = [0.1, 0.15]",
       "scene.toml:18: [inflow 2] low = [0.0, 0.05]: the box overlaps that of [[inflow]] 1"},
      {"low = [0.9, 0.0]\nhigh = [1.0, 0.1]\nvelocity = [-1.0, 0.0]",
       "low = [0.0, 0.11]\nhigh = [0.1, 0.15]\nvelocity = [1.0, 0.0]",
       "scene.toml:18: [inflow 2] low = [0.0, 0.11]: the box is less than two cells, 0.1 m, from that of "
       "[[inflow]] 1, "
       "which moves otherwise"},
      {"low = [0.0, 0.15]\nhigh = [1.0, 0.5]", "low = [0.0, 0.05]\nhigh = [1.0, 0.5]",
       "scene.toml:25: [outflow 1] low = [0.0, 0.05]: the box meets that of [[inflow]] 1"},
      {"points_per_cell = 2\nfractions", "start = 0.01\nfractions",
       "scene.toml:11: inflow: without [material] one must have start = 0"}};
  for (const BadStream& bad : cases) {
    EXPECT_EQ(message_of(with(meeting, bad.part, bad.instead)), bad.message);
  }
}

TEST(BadStream, MaterialInItsBoxIsRefused) {
  const std::string text =
      "[material]\nlow = [0.05, 0.0]\nhigh = [0.3, 0.05]\npoints_per_cell = 1\n" + meeting;

  EXPECT_EQ(message_of(text),
            "[[inflow]] 1: [material] begins in its box, at (0.075, 0.025) m: leave the box to the stream");
}

/// The second stream, which begins later, has no coarse grains: the floor is as rough as there are.
TEST(BadStream, OfWhatAWallCannotReadIsRefusedBeforeTheRun) {
  std::string text =
      with(with(meeting, "start = 0.05", "fractions = [1.0, 0.0]\nstart = 0.05"), "y_low = \"slip\"",
           "y_low = {law = \"material_friction\", share = 1, friction = \"coarse_fraction\"}");
  text = with(text, "law = \"newtonian\"\nviscosity = 1\n",
              "law = \"mixture_mu_of_i\"\nmu_s_fine = 0.3\nmu_s_coarse = 0.5\nmu_2_fine = 0.644\n"
              "mu_2_coarse = 0.781\nI_0_fine = 0.279\nI_0_coarse = 0.279\ngrain_density = 2500\n"
              "shear_rate_floor = 1\n");

  EXPECT_EQ(message_of(text),
            "[[inflow]] 2: the law 'material_friction' reads friction = 0 of material point 0 at "
            "(0.9875, 0.0125) m: must be finite and above 0");
}

TEST(BadStream, ABodyInItsBoxIsRefused) {
  const std::string ball =
      "[[bodies]]\nsurface = \"ball\"\ncentre = [0.025, 0.025]\nradius = 0.03\ncontact = \"slides\"\n";

  EXPECT_EQ(
      message_of(ball + meeting),
      "[[inflow]] 1: [[bodies]] 1: as the bed cuts the material: material point 0 at (0.0125, 0.0125) m "
      "is 0.0123223 m below it");
}

}  // namespace
}  // namespace scree::app::testing
