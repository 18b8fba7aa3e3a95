// A run that goes on from its checkpoint is the unbroken run, bit for bit; and so is one on other threads.

#include "scree/run/restart.hpp"

#include "scenes.hpp"
#include "scree/scene/traits.hpp"

#include <scree/io/bounds.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/mpm/limiting_point.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace scree::app::testing {
namespace {

namespace fs = std::filesystem;

/// A place of its own for each test.
[[nodiscard]] fs::path scratch_file(const std::string& name) {
  const fs::path folder = fs::path{::testing::TempDir()} / "scree_restart";
  fs::create_directories(folder);
  return folder / name;
}

template <int D>
void expect_same_bits(const Simulation<D, 2>& a, const Simulation<D, 2>& b) {
  EXPECT_EQ(a.clock.time, b.clock.time);
  EXPECT_EQ(a.clock.step, b.clock.step);
  EXPECT_EQ(a.tally.fractions.highest, b.tally.fractions.highest);
  std::vector<const mpm::Column*> columns;
  a.state.particles.for_each_column([&](const mpm::Column& column) { columns.push_back(&column); });
  std::size_t i = 0;
  b.state.particles.for_each_column([&](const mpm::Column& column) {
    EXPECT_TRUE(std::ranges::equal(columns[i]->values(), column.values())) << column.quantity().name;
    ++i;
  });
}

/// The plane flows fast from the start, so that points cross cells and are sorted many times.
[[nodiscard]] Simulation<2, 2> moving_plane(Threads threads) {
  Simulation<2, 2> plane{scene_of("inclined_plane", {"segregation.every=7"}), threads};
  auto& particles = plane.state.particles;
  for (Index p = 0; p < particles.size(); ++p) {
    particles.velocity.component(0)[p] = 20 * particles.position.component(1)[p];
    particles.velocity_gradient.component(0 + 2 * 1)[p] = 20;
  }
  return plane;
}

TEST(Restart, GoesOnBitForBit) {
  const fs::path file = scratch_file("plane.h5");
  auto unbroken = moving_plane({1});
  for (int i = 0; i < 333; ++i) unbroken.step();
  write_checkpoint(unbroken, file, "");
  for (int i = 0; i < 333; ++i) unbroken.step();

  Simulation<2, 2> restarted{scene_of("inclined_plane", {"segregation.every=7"}), {1}};
  read_checkpoint_into(restarted, file);
  for (int i = 0; i < 333; ++i) restarted.step();

  expect_same_bits(unbroken, restarted);
}

/// Where the material is by then, other nodes are in use than at the start.
TEST(Restart, GoesOnWhereMaterialHasSpread) {
  const fs::path file = scratch_file("collapse.h5");
  const std::vector<std::string> coarse{"mesh.cells=12"};
  Simulation<2, 2> unbroken{scene_of("granular_column_collapse", coarse), {1}};
  while (unbroken.clock.time < 0.3) unbroken.step();
  write_checkpoint(unbroken, file, "");
  for (int i = 0; i < 50; ++i) unbroken.step();

  Simulation<2, 2> restarted{scene_of("granular_column_collapse", coarse), {1}};
  read_checkpoint_into(restarted, file);
  for (int i = 0; i < 50; ++i) restarted.step();

  expect_same_bits(unbroken, restarted);
}

/// Round an axis points carry their hoop rate, hoop stress and radius too.
TEST(Restart, GoesOnRoundAnAxis) {
  const fs::path file = scratch_file("round.h5");
  const std::vector<std::string> round{"mesh.cells=12", "mesh.symmetry=axisymmetric"};
  Simulation<2, 2> unbroken{scene_of("granular_column_collapse", round), {1}};
  while (unbroken.clock.time < 0.15) unbroken.step();
  const auto& hoop = unbroken.state.particles;
  ASSERT_NE(hoop.column(hoop.find_column("hoop_rate", "the test")).component(0)[0], 0);
  write_checkpoint(unbroken, file, "");
  for (int i = 0; i < 50; ++i) unbroken.step();

  Simulation<2, 2> restarted{scene_of("granular_column_collapse", round), {1}};
  read_checkpoint_into(restarted, file);
  for (int i = 0; i < 50; ++i) restarted.step();

  expect_same_bits(unbroken, restarted);
}

TEST(Restart, WritingACheckpointChangesNothing) {
  auto with = moving_plane({1});
  auto without = moving_plane({1});

  for (int i = 0; i < 100; ++i) {
    with.step();
    without.step();
    if (i % 10 == 0) write_checkpoint(with, scratch_file("often.h5"), "");
  }

  expect_same_bits(with, without);
}

TEST(Threads, GiveTheSameBits) {
  const std::vector<std::string> fine{"mesh.cells=204", "segregation.every=5"};
  Simulation<2, 2> one{scene_of("inclined_plane", fine), {1}};
  Simulation<2, 2> two{scene_of("inclined_plane", fine), {2}};
  ASSERT_GT(one.num_points(), 8000);  // enough for a second thread to be used

  for (int i = 0; i < 40; ++i) {
    one.step();
    two.step();
  }

  expect_same_bits(one, two);
}

[[nodiscard]] std::string message_of_restart(const fs::path& file) {
  Simulation<1, 2> column{scene_of("inclined_plane_column"), {1}};
  try {
    read_checkpoint_into(column, file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(BadCheckpoint, OfAnotherSceneIsRefused) {
  const fs::path file = scratch_file("other.h5");
  write_checkpoint(Simulation<2, 2>{scene_of("inclined_plane"), {1}}, file, "");

  EXPECT_EQ(message_of_restart(file),
            file.string() +
                ": is of a run in 2D with 2 velocity components; the scene is in 1D with 2 velocity "
                "components");
}

/// A collapse at twelve cells, and what is said when it goes on with other keys.
[[nodiscard]] std::string message_of_other_keys(const std::vector<std::string>& other) {
  const fs::path file = scratch_file("keys.h5");
  std::vector<std::string> keys{"mesh.cells=12"};
  write_checkpoint(Simulation<2, 2>{scene_of("granular_column_collapse", keys), {1}}, file, "");
  keys.insert(keys.end(), other.begin(), other.end());
  Simulation<2, 2> restarted{scene_of("granular_column_collapse", keys), {1}};
  try {
    read_checkpoint_into(restarted, file);
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(file.string() + ": ", 0), 0U) << message;
    return message.substr(file.string().size() + 2);
  }
  return "no error";
}

TEST(BadCheckpoint, OfAnotherMeshOrSchemeIsRefusedWithAllThatDiffers) {
  EXPECT_EQ(message_of_other_keys({"mesh.cells=24"}),
            "is of another run: [mesh] cells is 12 there and 24 in the scene");
  EXPECT_EQ(message_of_other_keys({"mesh.size=[0.8, 0.4]"}),
            "is of another run: [mesh] size is [0.8, 0.24] there and [0.8, 0.4] in the scene");
  EXPECT_EQ(message_of_other_keys({"mesh.symmetry=axisymmetric"}),
            "is of another run: [mesh] symmetry is plane there and axisymmetric in the scene");
  EXPECT_EQ(message_of_other_keys({"numerics.shape=linear", "numerics.transfer=tpic", "numerics.order=musl",
                                   "numerics.averaged_pressure=true", "numerics.mass_floor=1e-12"}),
            "is of another run: [numerics] shape is quadratic there and linear in the scene; [numerics] "
            "transfer is apic there and tpic in the scene; [numerics] order is usl there and musl in the "
            "scene; [numerics] averaged_pressure is false there and true in the scene; [numerics] mass_floor "
            "is 1e-10 "
            "there and 1e-12 in the scene");
}

/// What a run without the key had is its default.
TEST(Restart, TakesAMassFloorThatIsNotToldForTheDefault) {
  const std::string line = "[numerics] mass_floor = 1e-10\n";
  Scene scene = scene_of("granular_column_collapse");
  std::string there = traits_text(traits_of_run(scene));
  ASSERT_NE(there.find(line), std::string::npos) << there;
  there.erase(there.find(line), line.size());

  EXPECT_EQ(difference(there, traits_of_run(scene)), "");
  scene.mass_floor = 1e-12;
  EXPECT_EQ(difference(there, traits_of_run(scene)),
            "[numerics] mass_floor is 1e-10 there and 1e-12 in the scene");
}

/// Asked of the scenes, as not every build can begin a run whose viscosity is not explicit.
TEST(BadCheckpoint, OfAnotherViscosityIsRefused) {
  const Scene there = scene_of("granular_column_collapse", {"numerics.shape=linear"});
  Scene here = there;
  here.viscosity = ViscosityScheme::automatic;

  EXPECT_EQ(difference(traits_text(traits_of_run(there)), traits_of_run(here)),
            "[numerics] viscosity is explicit there and auto in the scene");
}

/// Another law, and grains of other sizes or none.
TEST(BadCheckpoint, OfOtherMaterialIsRefused) {
  const fs::path file = scratch_file("material.h5");
  write_checkpoint(Simulation<1, 2>{scene_of("inclined_plane_column_a"), {1}}, file, "");
  EXPECT_EQ(message_of_restart(file), file.string() +
                                          ": is of another run: [rheology] law is newtonian there and "
                                          "size_dependent_newtonian in the scene");

  write_checkpoint(
      Simulation<1, 2>{scene_of("inclined_plane_column", {"grains.diameters=[0.5e-3, 2e-3]"}), {1}}, file,
      "");
  EXPECT_EQ(message_of_restart(file), file.string() +
                                          ": is of another run: diameters of [grains] is [0.0005, 0.002] "
                                          "there and [0.0005, 0.001] in the scene");
}

/// The next frame is the first of the scene that goes on, whatever the run before had.
TEST(Restart, TakesTheFramesOfItsOwnScene) {
  const fs::path file = scratch_file("frames.h5");
  Simulation<2, 2> first{scene_of("granular_column_collapse", {"mesh.cells=12", "output.every=0.01"}), {1}};
  while (!first.step()) continue;
  ASSERT_EQ(first.clock.time, 0.01);
  EXPECT_EQ(first.clock.unsegregated_steps, 0);  // nothing here segregates, nor would it all at once
  write_checkpoint(first, file, "");

  for (const auto& [every, next] : {std::pair{"0.01", 0.02}, {"0.004", 0.012}, {"0.1", 0.1}}) {
    Simulation<2, 2> restarted{
        scene_of("granular_column_collapse", {"mesh.cells=12", "output.every=" + std::string{every}}), {1}};
    read_checkpoint_into(restarted, file);

    EXPECT_EQ(restarted.next_frame_time(), next);
    restarted.step();
    EXPECT_GT(restarted.clock.time, 0.01);
  }
}

/// What the points do not depend on may change: here constants of the law, walls, gravity, shares of the
/// limits, ends and outputs.
TEST(Restart, GoesOnUnderOtherConstants) {
  EXPECT_EQ(
      message_of_other_keys({"rheology.bulk_modulus=2e6", "rheology.mu_s=0.4", "gravity.magnitude=5",
                             "boundaries.y_low=slip", "boundaries.leaving=absorb", "numerics.acoustic=0.3",
                             "numerics.maximum_dt=1e-5", "time.end=2", "output.every=0.5"}),
      "no error");
}

[[nodiscard]] std::string message_of_step(Simulation<2, 2>& simulation) {
  try {
    simulation.step();
  } catch (const RunError& error) {
    return error.what();
  }
  return "no error";
}

/// What the last step found the material to be, 5000 times as stiff: the next step is that much shorter.
TEST(Progress, OfAStepThatFallsByFourDecadesEndsTheRun) {
  const std::vector<std::string> plain{"mesh.cells=12", "numerics.acoustic=0.25"};
  Simulation<2, 2> collapse{scene_of("granular_column_collapse", plain), {1}};
  const double wave_speed = collapse.state.rates.wave_speed;
  const mpm::TimeStep first = collapse.next_step();
  ASSERT_EQ(first.limit, mpm::Limit::acoustic);
  EXPECT_EQ(message_of_step(collapse), "no error");
  EXPECT_EQ(collapse.clock.first_dt, first.dt);

  collapse.state.rates.wave_speed = 5000 * wave_speed;
  EXPECT_EQ(message_of_step(collapse), "no error");
  collapse.state.rates.wave_speed = 20000 * wave_speed;
  const std::string fallen = io::to_text(collapse.next_step().dt);

  const auto& particles = collapse.state.particles;
  const auto point = mpm::limiting_point(particles, *collapse.stages().stress, collapse.grid(), first.limit);
  ASSERT_TRUE(point.has_value());

  EXPECT_EQ(message_of_step(collapse),
            "the stable step has fallen from " + io::to_text(first.dt) + " to " + fallen +
                " s, bound by the acoustic limit of " + mpm::point_name(particles, *point) +
                ": the run has become unstable; use a smaller share of the limits ([numerics])");
}

/// A restart measures from the first step of the run, not from its own.
TEST(Progress, GoesOnFromTheFirstStepOfTheRun) {
  const fs::path file = scratch_file("progress.h5");
  const std::vector<std::string> coarse{"mesh.cells=12"};
  Simulation<2, 2> unbroken{scene_of("granular_column_collapse", coarse), {1}};
  unbroken.step();
  const double wave_speed = unbroken.state.rates.wave_speed;
  unbroken.state.rates.wave_speed = 5000 * wave_speed;
  write_checkpoint(unbroken, file, "");

  Simulation<2, 2> restarted{scene_of("granular_column_collapse", coarse), {1}};
  read_checkpoint_into(restarted, file);

  EXPECT_EQ(restarted.clock.first_dt, unbroken.clock.first_dt);
  EXPECT_EQ(message_of_step(restarted), "no error");
  restarted.state.rates.wave_speed = 20000 * wave_speed;  // four times those of the restart's own first step
  EXPECT_NE(message_of_step(restarted), "no error");
}

TEST(BadCheckpoint, CutOffIsRefused) {
  const fs::path file = scratch_file("cut.h5");
  write_checkpoint(Simulation<1, 2>{scene_of("inclined_plane_column"), {1}}, file, "");
  fs::resize_file(file, fs::file_size(file) / 2);

  const std::string message = message_of_restart(file);

  EXPECT_EQ(message.rfind(file.string() + ": ", 0), 0U) << message;
  EXPECT_NE(message, "no error");
}

TEST(BadCheckpoint, MissingIsRefused) {
  const fs::path file = scratch_file("never_written.h5");

  const std::string message = message_of_restart(file);

  EXPECT_EQ(message.rfind(file.string() + ": ", 0), 0U) << message;
}

}  // namespace
}  // namespace scree::app::testing
