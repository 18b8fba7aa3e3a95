// Runs that begin with the points of another run's checkpoint.

#include "scree/assemble/stored_points.hpp"

#include "scenes.hpp"
#include "scree/run/restart.hpp"
#include "surroundings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

namespace scree::app::testing {
namespace {

namespace fs = std::filesystem;

/// A place of its own for each test.
[[nodiscard]] std::string scratch(const std::string& name) {
  const fs::path folder = fs::path{::testing::TempDir()} / "scree_stored_points";
  fs::create_directories(folder);
  return (folder / name).string();
}

/// Grains of two sizes on a steep smooth floor, which they slide along. Steps are the user's.
const std::string sliding = with(open_channel(), "x_low = \"open\"", "x_low = \"slip\"") + R"([material]
low = [0.1, 0.0]
high = [0.4, 0.2]
[gravity]
slope_degrees = 30
[rheology]
law = "drucker_prager"
friction = 0.5
shear_modulus = 1e6
bulk_modulus = 1e6
density = 1500
[grains]
diameters = [1e-3, 2e-3]
fractions = [0.25, 0.75]
[segregation]
closure = "shear_rate"
c = 1e-3
every = 10
[numerics]
shape = "quadratic"
maximum_dt = 2e-4
[time]
end = 10
)";

/// The same with the points of a checkpoint.
[[nodiscard]] std::string from(const std::string& file) {
  return with(sliding, "low = [0.1, 0.0]\nhigh = [0.4, 0.2]", "checkpoint = \"" + file + "\"");
}

[[nodiscard]] Simulation<2, 2> simulation_of(const std::string& text) {
  return {parse_scene(text, "scene.toml").scene, {1}};
}

void take_steps(Simulation<2, 2>& simulation, int count) {
  for (int i = 0; i < count; ++i) simulation.step();
}

/// A run that has slid for 0.06 s, and its checkpoint.
[[nodiscard]] Simulation<2, 2> slid(const std::string& file) {
  auto run = simulation_of(sliding);
  take_steps(run, 299);
  run.state.needs_sort = true;  // a run that begins sorts its points: so does this one in its next step
  run.step();
  write_checkpoint(run, file, "");
  return run;
}

/// What each point that weighs something carries, by its id.
[[nodiscard]] std::map<double, std::vector<double>> points_of(const Simulation<2, 2>& simulation) {
  const auto& particles = simulation.state.particles;
  std::map<double, std::vector<double>> points;
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    auto& numbers = points[particles.id.component(0)[p]];
    particles.for_each_column([&](const mpm::Column& column) {
      for (int c = 0; c < column.num_components(); ++c) numbers.push_back(column.component(c)[p]);
    });
  }
  return points;
}

/// On the same mesh, with steps of the same length and points sorted when the other run sorts them, there is
/// nothing to tell the two runs by: position, velocity, stress, memory and grains, bit for bit.
TEST(StoredPoints, GoOnAsTheirOwnRunWould) {
  const std::string file = scratch("sliding.h5");
  auto run = slid(file);
  auto other = simulation_of(from(file));
  EXPECT_EQ(other.clock.time, 0);
  EXPECT_EQ(points_of(other), points_of(run));
  const auto first = points_of(run);

  take_steps(run, 200);
  take_steps(other, 200);

  EXPECT_EQ(points_of(other), points_of(run));
  EXPECT_NE(points_of(run), first);
}

/// Without that sorting it is the order of sums that differs. They are rounded by a few eps, 200 times; a
/// step turns a change of density into one of velocity c times as large over rho, and back: no growth.
TEST(StoredPoints, GoOnToRoundOffWhateverTheOrder) {
  const std::string file = scratch("unsorted.h5");
  auto run = simulation_of(sliding);
  take_steps(run, 301);
  write_checkpoint(run, file, "");
  auto other = simulation_of(from(file));

  take_steps(run, 200);
  take_steps(other, 200);

  const auto a = points_of(run);
  const auto b = points_of(other);
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [id, numbers] : a) {
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(numbers[i], b.at(id)[i], 200 * 16 * round_off);  // [m]
  }
}

/// On a mesh twice as fine, longer and with an open floor: all that points carry is kept.
TEST(StoredPoints, BeginOnAnotherMesh) {
  const std::string file = scratch("refined.h5");
  const auto run = slid(file);
  const std::string fine = with(with(from(file), "cells = 10", "cells = 20"), "[1.0, 0.5]", "[2.0, 0.5]");

  auto other = simulation_of(fine);
  EXPECT_EQ(points_of(other), points_of(run));
  const double mass = mass_of(other);
  take_steps(other, 100);

  EXPECT_EQ(other.num_points(), run.num_points());
  EXPECT_EQ(mass_of(other), mass);
  const double fall = 9.81 * 0.5 * 100 * 2e-4;  // [m/s]: a smooth floor does not hold it back
  EXPECT_NEAR(mean_velocity(other, 0), mean_velocity(run, 0) + fall, 100 * 16 * round_off);
}

[[nodiscard]] std::string message_of(const std::string& text) {
  try {
    static_cast<void>(simulation_of(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(BadStoredPoints, OfAnotherKindAreRefusedAtTheKey) {
  const std::string file = scratch("kind.h5");
  static_cast<void>(slid(file));
  const std::string text = from(file);
  const std::string place = "scene.toml:12: [material] checkpoint = \"" + file + "\": ";
  const std::string kind = place + file + ": holds points of another kind: ";

  EXPECT_EQ(message_of(with(text, "law = \"drucker_prager\"\nfriction = 0.5\nshear_modulus = 1e6",
                            "law = \"newtonian\"\nviscosity = 1")),
            kind + "[rheology] law is drucker_prager there and newtonian in the scene");
  EXPECT_EQ(message_of(with(text, "[1e-3, 2e-3]", "[1e-3, 3e-3]")),
            kind + "diameters of [grains] is [0.001, 0.002] there and [0.001, 0.003] in the scene");
  EXPECT_EQ(message_of(with(text, "dimensions = 2", "dimensions = 2\nvelocity_components = 3")),
            with(kind, ":12:", ":13:") + "[mesh] velocity_components is 2 there and 3 in the scene");
}

TEST(BadStoredPoints, OfNoCheckpointAreRefusedAtTheKey) {
  const std::string missing = scratch("never_written.h5");
  const std::string place = "scene.toml:12: [material] checkpoint = \"";

  EXPECT_EQ(message_of(from(missing)), "scene.toml:12: [material] checkpoint: " + missing +
                                           ": cannot be read: No such file or directory");
  EXPECT_EQ(message_of(from("../other/checkpoint.h5")),
            place +
                "../other/checkpoint.h5\": must lie beside the scene or below it, or be an absolute path: it "
                "is kept with the results");
}

/// However it is spelt: a run would write its own over it.
TEST(BadStoredPoints, OfTheNameOfTheRunsOwnCheckpointAreRefusedAtTheKey) {
  const fs::path folder = scratch("own");
  fs::create_directories(folder);
  static_cast<void>(slid((folder / "checkpoint.h5").string()));
  const std::string scene = (folder / "scene.toml").string();

  for (const std::string own : {"checkpoint.h5", "./checkpoint.h5"}) {
    std::ofstream{scene} << from(own);
    std::string message = "no error";
    try {
      static_cast<void>(read_scene(scene, {}));
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_EQ(message,
              scene + ":12: [material] checkpoint = \"" + own +
                  "\": is the name that this run gives its own, which it writes over the copy: rename "
                  "the file, or put it into a folder");
  }
}

/// What says again what the points bring with them.
TEST(BadStoredPoints, DoNotGoWithOtherWordsOnTheStart) {
  const std::string file = scratch("words.h5");
  static_cast<void>(slid(file));
  const std::string text = from(file);

  EXPECT_EQ(message_of(with(text, "checkpoint =", "points_per_cell = 2\ncheckpoint =")),
            "scene.toml:12: [material] points_per_cell: unknown key, known here: checkpoint");
  EXPECT_EQ(message_of(with(text, "[grains]", "[rheology.initial]\n[grains]")),
            "scene.toml:21: [rheology] initial: the points of [material] checkpoint bring the law's memory "
            "with them");
  EXPECT_EQ(message_of(with(text, "x_low = \"slip\"", "x_low = \"open\"") +
                       "[[inflow]]\nlow = [0.0, 0.0]\nhigh = [0.1, 0.1]\nvelocity = [1.0, 0.0]\n"),
            "scene.toml:33: inflow = [[inflow]]: with [material] checkpoint none may have start = 0");
  EXPECT_EQ(message_of(with(text, "shape = \"quadratic\"", "shape = \"gimp\"\npoints_per_axis = 3")),
            "scene.toml:29: [numerics] shape = \"gimp\": the boxes of points of [material] checkpoint have "
            "another size: [numerics] shape is quadratic there and gimp in the scene; [numerics] "
            "points_per_axis is not set there and 3 in the scene");
}

/// The place of a point that is named, in one text with the message.
void expect_like(const std::string& message, const std::string& start, const std::string& end) {
  EXPECT_EQ(message.rfind(start, 0), 0U) << message;
  EXPECT_EQ(message.substr(message.size() - std::min(message.size(), end.size())), end) << message;
}

TEST(BadStoredPoints, OutsideTheMeshOrInWhatIsSolidAreNamed) {
  const std::string file = scratch("outside.h5");
  static_cast<void>(slid(file));
  const std::string text = from(file);

  expect_like(message_of(with(text, "[1.0, 0.5]", "[0.2, 0.5]")),
              "[material] checkpoint: " + file + ": its point ",
              ") m lies outside the mesh, which is 0.2 m long along x: make the mesh larger ([mesh] size)");
  const std::string plane = "surface = \"plane\"\nnormal = [0, 1]\ncontact = \"slides\"\npoint = ";
  expect_like(message_of("[terrain]\n" + plane + "[0, 0.1]\n" + text),
              "[material] checkpoint: the bed cuts the material: material point ", " m below it");
  expect_like(message_of("[[bodies]]\n" + plane + "[0, 0.1]\n" + text),
              "[material] checkpoint: [[bodies]] 1: as the bed cuts the material: material point ",
              " m below it");
  EXPECT_EQ(message_of("[terrain]\n" + plane + "[0, 0.02]\n" + text), "no error");  // cells are of 0.05 m
}

/// Columns that other programs have added, or taken away.
TEST(BadStoredPoints, WithOtherColumnsAreRefused) {
  const std::string file = scratch("columns.h5");
  auto run = simulation_of(sliding);
  run.state.particles.add_column({"age", "t", "s"}, 1);
  write_checkpoint(run, file, "");

  EXPECT_EQ(message_of(from(file)), "[material] checkpoint: " + file +
                                        ": its points have a column 'age', which those of the scene lack");

  auto here = simulation_of(sliding);
  write_checkpoint(here, file, "");
  const Scene scene = parse_scene(from(file), "scene.toml").scene;
  mpm::Particles<2, 2> particles = here.state.particles;
  particles.add_column({"age", "t", "s"}, 1);
  try {
    take_stored(scene, particles);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string{error.what()},
              "[material] checkpoint: " + file +
                  ": its points have no column 'age', which those of the scene have");
  }
}

}  // namespace
}  // namespace scree::app::testing
