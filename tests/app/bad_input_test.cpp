// What a person gets wrong in a scene, and what they are told: all of it, whole.

#include "scenes.hpp"
#include "scree/run/run.hpp"
#include "scree/run/simulation.hpp"
#include "scree/scene/scene.hpp"

#include <gtest/gtest.h>

namespace scree::app::testing {
namespace {

/// The small scene with one line in place of another.
[[nodiscard]] std::string with(const std::string& line, const std::string& instead) {
  std::string text = small_scene();
  const std::size_t at = text.find(line + "\n");
  if (at == std::string::npos) throw std::runtime_error{"the small scene has no line '" + line + "'"};
  return text.replace(at, line.size(), instead);
}

[[nodiscard]] std::string message_of(const std::string& text,
                                     const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(parse_scene(text, "scene.toml", overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SmallScene, IsSound) {
  EXPECT_EQ(message_of(small_scene()), "no error");
}

TEST(BadScene, UnknownKeyIsNamedWithTheNearestKnownOne) {
  EXPECT_EQ(message_of(with("cells = 8", "cels = 8")),
            "scene.toml:1: [mesh] cells: missing, expected an integer (number of cells along y)\n"
            "scene.toml:5: [mesh] cels: unknown key, did you mean 'cells'?");
}

TEST(BadScene, WrongTypeIsNamed) {
  EXPECT_EQ(
      message_of(with("cells = 8", "cells = \"many\"")),
      "scene.toml:5: [mesh] cells = \"many\": expected an integer (number of cells along y), got a string");
}

TEST(BadScene, ValueOutOfRangeIsNamed) {
  EXPECT_EQ(message_of(with("density = 1000", "density = -1000")),
            "scene.toml:16: [rheology] density = -1000: must exceed 0 (density without pressure [kg/m^3])");
}

TEST(BadScene, MassFloorOfAWholePointIsRefused) {
  EXPECT_EQ(
      message_of(small_scene() + "[numerics]\nmass_floor = 1\n"),
      "scene.toml:27: [numerics] mass_floor = 1: must lie in [0, 1) (mass of the lightest node that moves, "
      "over that of the heaviest point [-])");
}

TEST(SmallScene, HasTheLibrarysMassFloorUnlessTold) {  // Eq. (M196)
  EXPECT_EQ(parse_scene(small_scene(), "scene.toml").scene.mass_floor, (mpm::Stages<1, 2>{}.mass_floor));
}

TEST(SmallScene, TakesItsMassFloorToTheSteps) {  // Eq. (M20)
  const auto floor_of = [](const std::string& share) {
    return Simulation<1, 2>{
        parse_scene(small_scene() + "[numerics]\nmass_floor = " + share + "\n", "scene.toml").scene, {1}}
        .state.mass_floor;
  };
  EXPECT_EQ(floor_of("0"), 0);
  EXPECT_EQ(floor_of("0.25"), 2 * floor_of("0.125"));  // powers of two: exact
  EXPECT_GT(floor_of("0.125"), 0);
}

TEST(BadScene, FilterOfVelocitiesThatDoesNotSuitTheTransferIsNamed) {
  EXPECT_EQ(
      message_of(small_scene() + "[numerics]\nxpic_order = 2\n"),
      "scene.toml:27: [numerics] xpic_order = 2: velocities are filtered for transfer = \"pic_flip\" with "
      "increment_share = 1 only");
  EXPECT_EQ(message_of(small_scene() +
                       "[numerics]\ntransfer = \"pic_flip\"\nincrement_share = 1\nxpic_order = 2\n"),
            "no error");
  EXPECT_EQ(
      message_of(small_scene() + "[numerics]\norder = \"last\"\n"),
      "scene.toml:27: [numerics] order = \"last\": expected one of usl, musl, usf (when in a step stress is "
      "brought up to date)");
}

TEST(SmallScene, TakesEveryOrderAndEveryExtraPass) {
  for (const std::string order : {"usl", "musl", "usf"}) {
    const std::string text = small_scene() + "[numerics]\norder = \"" + order +
                             "\"\naveraged_volume_change = true\naveraged_pressure = true\n";
    Simulation<1, 2> simulation{parse_scene(text, "scene.toml").scene, {1}};

    for (int n = 0; n < 10; ++n) simulation.step();

    EXPECT_EQ(mpm::order_names[static_cast<std::size_t>(simulation.stages().order)], order);
    EXPECT_TRUE(simulation.stages().averaging.volume_change && simulation.stages().averaging.pressure);
  }
}

/// The small scene with another law.
[[nodiscard]] std::string with_law(const std::string& law) {
  std::string text = small_scene();
  const std::size_t at = text.find("law = ");
  return text.replace(at, text.find("[grains]") - at, law);
}

TEST(BadScene, ParametersThatContradictEachOtherAreNamed) {
  EXPECT_EQ(message_of(with_law(R"(law = "granular_elastoviscoplastic"
mu_s = 0.38
mu_2 = 0.3
I_0 = 0.279
grain_density = 2500
shear_modulus = 1e6
bulk_modulus = 1e6
density = 1500
)")),
            "scene.toml:15: [rheology] mu_2 = 0.3: must exceed mu_s = 0.38");
}

TEST(BadScene, ParameterAboveItsUpperBoundIsNamed) {
  EXPECT_EQ(
      message_of(with_law(R"(law = "regularised_mu_of_i"
mu_s = 0.342
mu_2 = 0.557
mu_inf = 0.05
alpha = 2
I_0 = 0.069
I_1 = 0.004
grain_density = 2500
shear_rate_floor = 1e-3
bulk_modulus = 1e6
density = 1500
)")),
      "scene.toml:17: [rheology] alpha = 2: must lie in (0, 2) (decay of friction in very slow flow [-])");
}

TEST(BadScene, NanIsRefused) {
  EXPECT_EQ(message_of(with("c = 0.05", "c = nan")),
            "scene.toml:22: [segregation] c = nan: must be finite (strength of segregation [m^2])");
}

TEST(BadScene, UnknownNameIsAnsweredWithTheKnownOnes) {
  EXPECT_EQ(message_of(with("closure = \"shear_rate\"", "closure = \"shear\"")),
            "scene.toml:21: [segregation] closure = \"shear\": expected one of shear_rate, "
            "size_weighted_shear_rate, gravity (what drives segregation)");
}

TEST(BadScene, FractionsThatDoNotSumToOneAreNamed) {
  EXPECT_EQ(message_of(with("fractions = [0.5, 0.5]", "fractions = [0.5, 0.6]")),
            "scene.toml:19: [grains] fractions = [0.5, 0.6]: fractions: their sum is 1.1, but must be 1");
}

TEST(BadScene, MaterialOutsideTheMeshIsNamed) {
  EXPECT_EQ(message_of(with("high = [0.75]", "high = [1.5]")),
            "scene.toml:11: [material] high = [1.5]: reaches out of the mesh, which ends at 1 m along y");
}

TEST(BadScene, WallThatLeavesAGapIsNamed) {
  EXPECT_EQ(message_of(with("y_high = \"slip\"", "")),
            "scene.toml:6: [boundaries] y_high: missing, expected a string (wall at the high end)");
}

TEST(BadScene, ModelsOwnObjectionIsPutDownToItsKey) {
  EXPECT_EQ(message_of(with("c = 0.05", "c = 0.05\ntheta = 3")),
            "scene.toml:23: [segregation] theta = 3: Minmod: theta must lie in [1, 2]");
}

TEST(BadScene, MeshThatIsNoWholeNumberOfCellsIsNamed) {
  std::string text = with("size = [1.0]", "size = [0.33, 1.0]");
  text.replace(text.find("dimensions = 1"), 14, "dimensions = 2");
  text.replace(text.find("low = [0.0]"), 11, "low = [0.0, 0.0]");
  text.replace(text.find("high = [0.75]"), 13, "high = [0.1, 0.75]");
  text.replace(text.find("y_low"), 5, "x = \"periodic\"\ny_low");
  EXPECT_EQ(message_of(text),
            "scene.toml:4: [mesh] size = [0.33, 1.0]: each edge must be a whole number of cells, whose edge "
            "is 0.125 m");
}

TEST(BadScene, OverrideIsNamedAsTheCommandLineHasIt) {
  EXPECT_EQ(message_of(small_scene(), {"mesh.cells=none"}),
            "--set mesh.cells=none: expected an integer (number of cells along y), got a string");
}

TEST(BadScene, AllFaultsAreReportedAtOnceInTheOrderOfTheFile) {
  std::string text = with("cells = 8", "cells = 0");
  text.replace(text.find("end = 0.01"), 10, "end = -1");
  EXPECT_EQ(message_of(text),
            "scene.toml:5: [mesh] cells = 0: must lie in [1, 1e+06] (number of cells along y)\n"
            "scene.toml:25: [time] end = -1: must exceed 0 (simulated time at which the run ends [s])");
}

TEST(BadScene, SegregationWithoutGrainsIsNamed) {
  std::string text = small_scene();
  const std::size_t at = text.find("[grains]");
  text.erase(at, text.find("[segregation]") - at);
  EXPECT_EQ(message_of(text), "scene.toml:17: segregation: needs the table [grains]");
}

TEST(BadScene, LawThatNeedsGrainsFindsNone) {
  std::string text = small_scene();
  const std::size_t at = text.find("[grains]");
  text.erase(at, text.find("[time]") - at);
  const Scene scene = parse_scene(text, "scene.toml").scene;

  std::string message;
  try {
    static_cast<void>(cost_of(scene));
  } catch (const InputError& error) {
    message = error.what();
  }

  EXPECT_EQ(
      message,
      "the law 'size_dependent_newtonian' needs the column 'grain_size', which no part of this run provides");
}

/// A NaN in any field reaches the velocities in a step and the positions in the next, and is then named.
TEST(FailedRun, NanIsNamedWithItsPoint) {
  for (const std::string_view field : {"velocity", "density", "fraction"}) {
    Simulation<1, 2> column{scene_of("inclined_plane_column", {"segregation.every=1"}), {1}};
    column.state.particles.for_each_column([&](mpm::Column& column_of_field) {
      if (column_of_field.quantity().name == field) column_of_field.component(0)[10] = std::nan("");
    });

    std::string message = "no error";
    try {
      for (int i = 0; i < 5; ++i) column.step();
    } catch (const RunError& error) {
      message = error.what();
    }

    EXPECT_NE(message, "no error") << field;
  }
}

TEST(FailedRun, PointOutsideTheMeshIsNamedWithItsPlace) {
  Simulation<1, 2> column{scene_of("inclined_plane_column"), {1}};
  auto& particles = column.state.particles;
  const Index last = particles.size() - 1;
  particles.position.component(0)[last] = 1.0199;
  for (Index p = 0; p < particles.size(); ++p) particles.velocity.component(0)[p] = 1e6;

  std::string message = "no error";
  try {
    column.step();
  } catch (const RunError& error) {
    message = error.what();
  }

  EXPECT_EQ(message.rfind("material point ", 0), 0U) << message;
  EXPECT_NE(message.find(") m is outside the mesh [0, 1.02] m"), std::string::npos) << message;
}

/// A step past the end would be of no length, and all rates by it no numbers.
TEST(FinishedRun, HasNoStepLeft) {
  Simulation<1, 2> column{scene_of("inclined_plane_column", {"time.end=0.001"}), {1}};
  while (!column.is_finished()) column.step();

  std::string message = "no error";
  try {
    column.step();
  } catch (const InputError& error) {
    message = error.what();
  }

  EXPECT_EQ(message, "the run has reached its end, [time] end = 0.001: no step is left");
}

}  // namespace
}  // namespace scree::app::testing
