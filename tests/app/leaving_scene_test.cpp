// Points that leave the mesh, as a scene says: stopped, absorbed and counted, or thrown back.

#include "scree/run/restart.hpp"
#include "scree/run/summary.hpp"
#include "surroundings.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <filesystem>

namespace scree::app::testing {
namespace {

/// A block that is carried out of the mesh, 0.4 m x 0.5 m, to the right at 4 m/s, on a belt that goes with
/// it.
[[nodiscard]] Simulation<2, 2> conveyed(const std::string& leaving, Threads threads = {1},
                                        const std::string& shape = "linear") {
  std::string text = block_scene(
      "[[bodies]]\nsurface = \"plane\"\npoint = [0, 0.15]\nnormal = [0, 1]\ncontact = \"sticks\"\n"
      "velocity = [4, 0]\n",
      0);
  text.replace(text.find("end = 100"), 9, "end = 0.5\n[output]\nevery = 0.25");
  text.replace(text.find("[numerics]"), 10, "[numerics]\nshape = \"" + shape + "\"");
  text.replace(text.find("x = \"periodic\""), 14, "x_low = \"open\"\nx_high = \"open\"\n" + leaving);
  Simulation<2, 2> block{parse_scene(text, "scene.toml").scene, threads};
  for (double& v : std::span{block.state.particles.velocity.component(0),
                             static_cast<std::size_t>(block.state.particles.size())}) {
    v = 4;
  }
  return block;
}

void step_to(Simulation<2, 2>& simulation, double time) {
  while (simulation.clock.time < time) simulation.step();
}

TEST(LeavingScene, AbsorbedMassIsCounted) {
  auto block = conveyed("leaving = \"absorb\"");
  const double mass = mass_of(block);

  step_to(block, 0.05);

  const auto& absorbed = block.state.absorbed;
  EXPECT_GT(absorbed.count, 10);  // of 32, half of the way
  EXPECT_LT(absorbed.count, 22);
  EXPECT_NEAR(absorbed.mass + mass_of(block), mass, 32 * round_off * mass);
  EXPECT_NEAR(absorbed.momentum[0], 4 * absorbed.mass,
              0.1 * 4 * absorbed.mass);  // it spreads at its open sides
}

TEST(LeavingScene, SummaryNamesWhatWasAbsorbed) {
  auto block = conveyed("leaving = \"absorb\"");
  auto other = conveyed("leaving = \"reflect\"");

  EXPECT_NE(
      summary_json(block, 1, "finished").find("\"absorbed\": {\n    \"points\": 0,\n    \"mass\": 0.0,"),
      std::string::npos);
  EXPECT_EQ(summary_json(other, 1, "finished").find("absorbed"), std::string::npos);
}

/// Blocks of points, nodes in use, the body and the sums go on where they were.
TEST(LeavingScene, RestartGoesOnBitForBit) {
  const auto file = std::filesystem::path{::testing::TempDir()} / "scree_conveyed.h5";
  auto unbroken = conveyed("leaving = \"absorb\"");
  step_to(unbroken, 0.03);
  ASSERT_GT(unbroken.state.absorbed.count, 0);
  write_checkpoint(unbroken, file, "");
  step_to(unbroken, 0.06);

  auto restarted = conveyed("leaving = \"absorb\"");
  read_checkpoint_into(restarted, file);
  step_to(restarted, 0.06);

  EXPECT_EQ(unbroken.state.absorbed.count, restarted.state.absorbed.count);
  EXPECT_EQ(unbroken.state.absorbed.mass, restarted.state.absorbed.mass);
  EXPECT_EQ(unbroken.state.absorbed.momentum, restarted.state.absorbed.momentum);
  std::vector<const mpm::Column*> columns;
  unbroken.state.particles.for_each_column([&](const mpm::Column& column) { columns.push_back(&column); });
  std::size_t i = 0;
  restarted.state.particles.for_each_column([&](const mpm::Column& column) {
    EXPECT_TRUE(std::ranges::equal(columns[i]->values(), column.values())) << column.quantity().name;
    ++i;
  });
}

/// Without points nothing bounds the step; the run goes on from frame to frame, and to its end.
TEST(LeavingScene, EndsWithAnEmptyMesh) {
  auto block = conveyed("leaving = \"absorb\"");

  while (block.num_points() > 0) block.step();
  while (!block.is_finished()) block.step();

  EXPECT_EQ(block.state.absorbed.count, 32);
  EXPECT_EQ(block.clock.time, 0.5);
  EXPECT_EQ(block.clock.frame, 3);
}

/// What is thrown back runs into what follows; under hat functions a light node would throw a point about so
/// that nothing is left of its volume.
TEST(LeavingScene, ReflectedMassStays) {
  auto block = conveyed("leaving = \"reflect\"", {1}, "quadratic");
  const double mass = mass_of(block);

  step_to(block, 0.05);

  EXPECT_NEAR(mass_of(block), mass, 32 * round_off * mass);
}

/// Two points of one step: the message is of the one without volume, so that what would help it is said.
TEST(LeavingScene, IsNotBlamedForAPointWithoutVolume) {
  auto block = conveyed("");
  block.state.particles.position.component(0)[7] = 0.3999;
  block.state.particles.density.component(0)[3] = -1000;

  std::string message = "no error";
  try {
    block.step();
  } catch (const RunError& error) {
    message = error.what();
  }

  EXPECT_GT(block.state.particles.position.component(0)[7], 0.4);
  EXPECT_THAT(message, ::testing::EndsWith("; a shorter step, by smaller shares of its limits, may help "
                                           "([numerics] viscous = 0.5 bounds steps: give less)"));
}

/// A point that a step takes across the whole mesh and on has no place to be thrown back to: that points may
/// leave is told already, so that a shorter step is the remedy.
TEST(LeavingScene, NamesTheStepWhereThrowingBackDoesNotHelp) {
  auto block = conveyed("leaving = \"reflect\"");
  for (double& v : std::span{block.state.particles.velocity.component(0), 32}) v = 1e5;  // 6 m a step

  std::string message = "no error";
  try {
    block.step();
  } catch (const RunError& error) {
    message = error.what();
  }

  EXPECT_THAT(message, ::testing::EndsWith("is outside the mesh [0, 0.4] x [0, 0.5] m ([numerics] viscous = "
                                           "0.5 bounds steps: give less)"));
}

/// One point, brought to the end by hand.
TEST(LeavingScene, StopsWithAPointItsPlaceAndWhatToChange) {
  auto block = conveyed("");
  block.state.particles.position.component(0)[7] = 0.3999;  // a step takes it on by 2.5e-4 m
  ASSERT_NEAR(block.next_step().dt, 6.25e-5, 1e-8);

  std::string message = "no error";
  try {
    step_to(block, 0.01);
  } catch (const RunError& error) {
    message = error.what();
  }

  const auto& particles = block.state.particles;
  const auto of = [](const mpm::Column& column, int axis) { return column.component(axis)[7]; };
  EXPECT_EQ(
      message,
      fmt::format(
          "material point {:.0f} at ({:.6g}, {:.6g}) m is outside the mesh [0, 0.4] x [0, 0.5] m, past cell "
          "(3, 1), at t = 6.25015e-05 s, with a velocity of ({:.6g}, {:.6g}) m/s: make the mesh larger "
          "([mesh] size), let it leave ([boundaries] leaving = \"absorb\") or throw it back (\"reflect\")",
          of(particles.id, 0), of(particles.position, 0), of(particles.position, 1),
          of(particles.velocity, 0), of(particles.velocity, 1)));
}

}  // namespace
}  // namespace scree::app::testing
