// Steps and moduli with which points would fly are refused before a run begins.

#include "scree/run/stability.hpp"

#include "scenes.hpp"
#include "scree/run/restart.hpp"
#include "scree/run/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>

namespace scree::app::testing {
namespace {

/// A column of cells of 0.125 m, in which sound runs at 10 m/s.
[[nodiscard]] std::string column_text(const std::string& numerics, double viscosity, double gravity = 0,
                                      double bulk_modulus = 1e5, int points_per_cell = 1,
                                      double surface_pressure = 0) {
  return R"([mesh]
dimensions = 1
size = [1.0]
cells = 8
[boundaries]
y_low = "slip"
y_high = "slip"
[material]
low = [0.0]
high = [0.75]
points_per_cell = )" +
         std::to_string(points_per_cell) + "\nsurface_pressure = " + std::to_string(surface_pressure) +
         R"(
[time]
end = 1
[rheology]
law = "newtonian"
density = 1000
viscosity = )" +
         std::to_string(viscosity) + "\nbulk_modulus = " + std::to_string(bulk_modulus) +
         "\n[gravity]\nmagnitude = " + std::to_string(gravity) + "\n[numerics]\n" + numerics;
}

[[nodiscard]] Simulation<1, 1> simulation_of(const std::string& text) {
  return {parse_scene(text, "scene.toml").scene, {1}};
}

template <class... Keys>
[[nodiscard]] Simulation<1, 1> column(Keys... keys) {
  return simulation_of(column_text(keys...));
}

/// What is said when this is done.
template <class Error, class Action>
[[nodiscard]] std::string message_when(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

template <class... Keys>
[[nodiscard]] std::string message_of(Keys... keys) {
  return message_when<InputError>([&] { static_cast<void>(column(keys...)); });
}

/// C = 1/sqrt(2) for a point in the middle of each cell and up to three nodes; the share is rounded down.
TEST(StableStep, OfFlipEndsAtACourantNumberOfOneOverRootTwo) {
  const std::string flip = "transfer = \"pic_flip\"\nincrement_share = 1\nshape = ";
  const auto message = [](const std::string& shape) {
    return "[numerics] acoustic = 0.9: must be at most 0.7071: it allows steps of 0.01125 s, and from the "
           "critical one, 0.008839 s, on waves of sound and viscosity grow under transfer = \"pic_flip\", "
           "shape = \"" +
           shape + "\", order = \"usl\"";
  };

  EXPECT_EQ(message_of(flip + "\"linear\"\nacoustic = 0.9", 1e-3), message("linear"));
  EXPECT_EQ(message_of(flip + "\"quadratic\"\nacoustic = 0.9", 1e-3), message("quadratic"));
  EXPECT_EQ(message_of(flip + "\"linear\"\nacoustic = 0.707", 1e-3), "no error");
  EXPECT_EQ(message_of(flip + "\"cubic\"\nacoustic = 0.9", 1e-3), "no error");
  EXPECT_EQ(message_of(flip + "\"linear\"\norder = \"usf\"\nacoustic = 0.9", 1e-3), "no error");
  EXPECT_EQ(message_of("acoustic = 0.999", 1e-3), "no error");
}

/// With three points in a cell the limit of FLIP on hat functions is (c dt/h)^2 = 27/46, (M174); quadratic
/// shapes see more of the wave, and have 1.31.
TEST(StableStep, OfFlipIsThatOfThePointsAsTheyLie) {
  const auto message = [](const std::string& shape) {
    return message_of("transfer = \"pic_flip\"\nincrement_share = 1\nacoustic = 0.9\nshape = " + shape, 1e-3,
                      0, 1e5, 3);
  };

  EXPECT_EQ(message("\"linear\""),
            "[numerics] acoustic = 0.9: must be at most 0.7661: it allows steps of 0.01125 s, and from the "
            "critical one, 0.009577 s, on waves of sound and viscosity grow under transfer = \"pic_flip\", "
            "shape = \"linear\", order = \"usl\"");
  EXPECT_EQ(message("\"quadratic\""), "no error");
}

/// With P = 8/27 of the shortest wave 368/729 of it are kept: (c dt/h)^2 = 1097/1762, (M182).
TEST(StableStep, OfFilteredVelocitiesIsThatOfTheFilter) {
  EXPECT_EQ(message_of("transfer = \"pic_flip\"\nincrement_share = 1\nacoustic = 0.9\nxpic_order = 2\n"
                       "shape = \"linear\"",
                       1e-3, 0, 1e5, 3),
            "[numerics] acoustic = 0.9: must be at most 0.789: it allows steps of 0.01125 s, and from the "
            "critical one, 0.009863 s, on waves of sound and viscosity grow under transfer = \"pic_flip\", "
            "shape = \"linear\", order = \"usl\", xpic_order = 2");
}

/// Half the viscous limit is 8/3 nu dt/h^2 = 2/3 in one dimension, which is more than 27/46.
TEST(StableStep, OfViscosityUnderFlipIsLessThanTheDefaultShareInOneDimension) {
  const auto message = [](const std::string& shape) {
    return message_of("transfer = \"pic_flip\"\nincrement_share = 1\nshape = " + shape, 1e4, 0, 1e5, 3);
  };

  EXPECT_EQ(message("\"linear\""),
            "[numerics] viscous = 0.5: must be at most 0.4396: it allows steps of 0.0003906 s, and from the "
            "critical one, 0.0003435 s, on waves of sound and viscosity grow under transfer = \"pic_flip\", "
            "shape = \"linear\", order = \"usl\"");
  EXPECT_EQ(message("\"quadratic\""), "no error");
}

/// (c dt/h)^2 + 8/3 nu dt/h^2 = 1 at 0.008257 s, where either limit alone allows 0.0125 s or more.
TEST(StableStep, LeavesRoomForSoundAndViscosityTogether) {
  EXPECT_EQ(
      message_of("acoustic = 1\nviscous = 1", 400),
      "[numerics] acoustic = 1: must be at most 0.6605: it allows steps of 0.0125 s, and from the "
      "critical one, 0.008257 s, on waves of sound and viscosity grow under transfer = \"apic\", shape = "
      "\"linear\", order = \"usl\"");
  EXPECT_EQ(message_of("acoustic = 0.66\nviscous = 1", 400), "no error");
  EXPECT_EQ(message_of("acoustic = 1\nviscous = 1\nmaximum_dt = 0.008", 400), "no error");
  EXPECT_EQ(
      message_of("acoustic = 1\nviscous = 1\nmaximum_dt = 0.0083", 400),
      "[numerics] maximum_dt = 0.0083: must be at most 0.008256: it allows steps of 0.0083 s, and from the "
      "critical one, 0.008257 s, on waves of sound and viscosity grow under transfer = \"apic\", shape = "
      "\"linear\", order = \"usl\"");
}

/// Three points a cell under FLIP, whose sum under quadratic shapes is 1.31; at 0.9 of the acoustic limit
/// steps have 0.81.
const std::string flip_of_threes = column_text(
    "transfer = \"pic_flip\"\nincrement_share = 1\nshape = \"quadratic\"\nacoustic = 0.9", 1e-3, 0, 1e5, 3);

/// Brings all points to the middle of their cells, where the sum is 1/2: C = 1/sqrt(2).
void huddle(Simulation<1, 1>& simulation) {
  for (double& y : simulation.state.particles.position.values()) y = (std::floor(y / 0.125) + 0.5) * 0.125;
}

const std::string as_they_huddle =
    "[numerics] acoustic = 0.9: allows steps of 0.01125 s, and from 0.008839 s on, the critical one in the "
    "mean of all points, waves of sound and viscosity grow under transfer = \"pic_flip\", shape = "
    "\"quadratic\", order = \"usl\": give at most 0.7071";

TEST(StableRun, IsThatOfThePointsAsTheyLieByThen) {
  auto run = simulation_of(flip_of_threes);
  EXPECT_EQ(message_when<RunError>([&] { run.require_stable(); }), "no error");

  huddle(run);

  EXPECT_EQ(message_when<RunError>([&] { run.require_stable(); }),
            "the run has become unstable: " + as_they_huddle +
                "; it is material point 0 at (0.0625) m that bounds the step");
}

/// Steps are by the fastest point, and 0.9 of its limit is beyond its critical step, 0.71; of points a
/// quarter as fast, as all are here but one that has left since, they have 0.9/4.
TEST(StableRun, IsNotStoppedForAFewPointsThatAreFast) {
  auto run = simulation_of(flip_of_threes);
  huddle(run);
  run.state.rates.wave_speed *= 4;

  EXPECT_EQ(message_when<RunError>([&] { run.require_stable(); }), "no error");
}

/// What a run bears under means over cells is known on hat functions alone, with both of them: others are not
/// looked at, not even those whose waves grow, as here, where the points of a cell lie in one place and means
/// leave all as it is.  Eq. (M199)
TEST(StableRun, IsNotLookedAtUnderMeansButWithBothOnHatFunctions) {
  const std::string volume = "\naveraged_volume_change = true";
  const std::string pressure = "\naveraged_pressure = true";
  const auto message = [](const std::string& text, const std::string& means) {
    auto run = simulation_of(text + means);
    huddle(run);
    return message_when<RunError>([&] { run.require_stable(); }).substr(0, 27);
  };
  const std::string hats =
      with(flip_of_threes, "shape = \"quadratic\"\nacoustic = 0.9", "shape = \"linear\"\nacoustic = 0.76");

  EXPECT_EQ(message(flip_of_threes, ""), "the run has become unstable");
  EXPECT_EQ(message(flip_of_threes, volume), "no error");
  EXPECT_EQ(message(flip_of_threes, pressure), "no error");
  EXPECT_EQ(message(flip_of_threes, volume + pressure), "no error");
  EXPECT_EQ(message(hats, ""), "the run has become unstable");
  EXPECT_EQ(message(hats, volume), "no error");
  EXPECT_EQ(message(hats, volume + pressure), "the run has become unstable");
}

/// Of a column in one dimension, or of a layer in two.
[[nodiscard]] std::string warning_of_means(const std::string& means, const std::string& shape,
                                           bool is_column = false) {
  std::string text = column_text("shape = \"" + shape + "\"\n" + means, 1);
  if (!is_column) {
    text = with(text, "dimensions = 1\nsize = [1.0]", "dimensions = 2\nsize = [1.0, 1.0]");
    text = with(text, "low = [0.0]\nhigh = [0.75]", "low = [0.0, 0.0]\nhigh = [1.0, 0.75]");
    text = with(text, "[boundaries]", "[boundaries]\nx = \"periodic\"");
  }
  return one_mean_warning(parse_scene(text, "scene.toml").scene);
}

/// On hat functions in one dimension a mean of what is equal is no change.
TEST(OneMeanOverCells, IsWarnedOfUnlessItIsAnIdentity) {
  const std::string volume = "averaged_volume_change = true\n";
  const std::string pressure = "averaged_pressure = true\n";
  const std::string effect =
      ": where the points of a cell differ in stiffness, waves may grow at steps far below the critical one, "
      "and the run is not stopped for them: give both, or none";

  for (const std::string shape : {"linear", "quadratic"}) {
    EXPECT_EQ(warning_of_means("", shape), "");
    EXPECT_EQ(warning_of_means(volume + pressure, shape), "");
    EXPECT_EQ(warning_of_means(volume, shape),
              "[numerics] averaged_volume_change = true without averaged_pressure" + effect);
    EXPECT_EQ(warning_of_means(pressure, shape),
              "[numerics] averaged_pressure = true without averaged_volume_change" + effect);
  }
  for (const std::string& mean : {volume, pressure}) {
    EXPECT_EQ(warning_of_means(mean, "linear", true), "");
    EXPECT_NE(warning_of_means(mean, "quadratic", true), "");
  }
}

TEST(StableRun, IsAnyWhereAllHaveLeft) {
  auto run = simulation_of(flip_of_threes);
  huddle(run);
  for (double& mass : run.state.particles.mass.values()) mass = 0;

  EXPECT_EQ(message_when<RunError>([&] { run.require_stable(); }), "no error");
}

[[nodiscard]] std::string scratch_file(const std::string& name) {
  return (std::filesystem::path{::testing::TempDir()} / ("scree_stability_" + name)).string();
}

/// A restart is refused where the run that goes on would be stopped.
TEST(StableRestart, IsThatOfThePointsOfTheCheckpoint) {
  const std::string file = scratch_file("restart.h5");
  auto run = simulation_of(flip_of_threes);
  write_checkpoint(run, file, "");
  auto restarted = simulation_of(flip_of_threes);
  EXPECT_EQ(message_when<InputError>([&] { read_checkpoint_into(restarted, file); }), "no error");

  huddle(run);
  write_checkpoint(run, file, "");

  EXPECT_EQ(message_when<InputError>([&] { read_checkpoint_into(restarted, file); }), as_they_huddle);
}

/// Under a hundred times the modulus sound is ten times as fast: steps of the checkpoint's own rates would be
/// 0.00625 s, of a critical 0.00125 s. Under twice the modulus they hold, and the first of them is taken.
TEST(StableRestart, StepsByTheConstantsOfItsOwnScene) {
  const std::string file = scratch_file("stiffer.h5");
  write_checkpoint(column("", 1e-3), file, "");
  const auto first_step = [&](double bulk_modulus) {
    auto restarted = column("", 1e-3, 0.0, bulk_modulus);
    read_checkpoint_into(restarted, file);
    return restarted.next_step().dt;
  };

  EXPECT_NEAR(first_step(1e5), 0.00625, 0.00625 * 10 * round_off);
  EXPECT_NEAR(first_step(2e5), 0.00625, 0.00625 * 10 * round_off);
  EXPECT_NEAR(first_step(1e7), 0.000625, 0.000625 * 10 * round_off);
}

/// The column with the points of a checkpoint.
[[nodiscard]] std::string from(const std::string& file, const std::string& text) {
  const auto begin = text.find("low = [0.0]");
  const auto end = text.find("[time]");
  return text.substr(0, begin) + "checkpoint = \"" + file + "\"\n" + text.substr(end);
}

/// Another run that begins with them is refused on the safe side, as any that begins.
TEST(StableStep, OfStoredPointsIsThatOfThePointsAsTheyLie) {
  const std::string file = scratch_file("stored.h5");
  auto run = simulation_of(flip_of_threes);
  huddle(run);
  write_checkpoint(run, file, "");

  EXPECT_EQ(message_when<InputError>([&] { static_cast<void>(simulation_of(from(file, flip_of_threes))); }),
            "[numerics] acoustic = 0.9: must be at most 0.7071: it allows steps of 0.01125 s, and from the "
            "critical one, 0.008839 s, on waves of sound and viscosity grow under transfer = \"pic_flip\", "
            "shape = \"quadratic\", order = \"usl\"");
}

/// What a step says of a point, by what its message ends with from `part` on.
template <class Spoil>
[[nodiscard]] std::string message_of_step(const std::string& numerics, const Spoil& spoil,
                                          const std::string& part) {
  auto run = column(numerics, 1e-3);
  spoil(run.state.particles);
  const std::string message = message_when<RunError>([&] { run.step(); });
  const auto begin = message.find(part);
  return begin == std::string::npos ? message : message.substr(begin);
}

/// Sound bounds steps to 0.00625 s, before the scene does.
TEST(FailedStep, NamesTheKeyThatBoundsSteps) {
  const auto lose_volume = [](auto& particles) { particles.density.component(0)[2] = -1000; };
  const auto lose_place = [](auto& particles) { particles.velocity.component(0)[2] = std::nan(""); };
  const std::string without_volume =
      "; a shorter step, by smaller shares of its limits, may help ([numerics] ";
  const std::string without_place = " has no finite position ([numerics] ";

  EXPECT_EQ(message_of_step("acoustic = 0.4", lose_volume, "; "),
            without_volume + "acoustic = 0.4 bounds steps: give less)");
  EXPECT_EQ(message_of_step("maximum_dt = 0.001", lose_volume, "; "),
            without_volume + "maximum_dt = 0.001 bounds steps: give less)");
  EXPECT_EQ(message_of_step("", lose_place, " has"),
            without_place + "acoustic = 0.5 bounds steps: give less)");
}

/// The deepest point lies 0.729 m under the surface: 7153 Pa.
TEST(StiffLaw, MustBearTheWeightOfItsMaterial) {
  EXPECT_EQ(
      message_of("", 1, 9.81, 500, 3),
      "[rheology] bulk_modulus = 500: the material bears 7153 Pa at the start, 14.3 times as much, and "
      "would be compressed beyond sense: give more than that, and ten times that to keep it to about a tenth "
      "[Pa]");
  EXPECT_EQ(message_of("", 1, 9.81, 7154, 3), "no error");
}

[[nodiscard]] std::string warning_of(double bulk_modulus, double surface_pressure = 0) {
  return softness_warning(column("", 1, 9.81, bulk_modulus, 3, surface_pressure));
}

/// The deepest point bears 7153 Pa, 0.358 of 20 kPa: exp(0.358) = 1.43. On the base 7358 Pa press, r = 0.368:
/// (exp(r) - 1)/r = 1.209.  Eq. (M187)
TEST(SoftLaw, IsWarnedOf) {
  EXPECT_EQ(
      warning_of(2e4),
      "[rheology] bulk_modulus = 20000: at the start the material is up to 43 % denser, and 21 % heavier in "
      "all, than where nothing presses, and will swell and sink by as much as it spreads and heaps up: "
      "give 7.16e+04 or more to keep the first to about a tenth [Pa]");
  EXPECT_NE(warning_of(7.15e4), "");
  EXPECT_EQ(warning_of(7.16e4), "");
}

/// 20 kPa on the surface: (1 + 20/40) exp(7153/40000) = 1.79, and of all 2.71531e5 Pa ten times that are
/// asked for, with which it is (1 + 20/272) exp(7153/272000) = 1.102 at the deepest point.
TEST(SoftLaw, IsWarnedOfNoMoreOnceTheAdviceIsFollowed) {
  EXPECT_EQ(
      warning_of(4e4, 2e4),
      "[rheology] bulk_modulus = 40000: at the start the material is up to 79 % denser, and 65 % "
      "heavier in all, than where nothing presses, and will swell and sink by as much as it spreads and "
      "heaps up: give 2.72e+05 or more to keep the first to about a tenth [Pa]");
  EXPECT_EQ(warning_of(2.72e5, 2e4), "");
}

/// Points that a stiff law has left are as dense as that makes them; what they weigh is 9.81 m/s^2 of 753 kg,
/// 0.37 of 20 kPa. exp(0.1) - 1 = 0.1052 is asked for.
TEST(SoftLaw, IsWarnedOfByTheWeightOfStoredPoints) {
  const std::string file = scratch_file("weight.h5");
  const auto stiff = column("", 1, 9.81, 1e6, 3);
  write_checkpoint(stiff, file, "");
  const auto masses = stiff.state.particles.mass.values();
  ASSERT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0), 752.8, 0.05);
  const auto warning = [&](double bulk_modulus) {
    return softness_warning(simulation_of(from(file, column_text("", 1, 9.81, bulk_modulus, 3))));
  };

  EXPECT_EQ(
      warning(2e4),
      "[rheology] bulk_modulus = 20000: the points of [material] checkpoint weigh up to 7385 Pa on what "
      "is below them, which makes it 37 % denser than where nothing presses, and it will swell and sink "
      "by as much as it spreads and heaps up: give 7.03e+04 or more to keep that to about a tenth [Pa]");
  EXPECT_NE(warning(7.02e4), "");
  EXPECT_EQ(warning(7.03e4), "");
}

/// It is exp(r) times as dense at the deepest point, r by its own depth, and (exp(r) - 1)/r times as heavy.
TEST(SoftLaw, MakesAColumnHeavierThanItsVolumeTells) {  // Eq. (M187)
  const double whole = 1000 * 9.81 * 0.75 / 2e4;
  const double at_point = whole * 35 / 36;  // 18 points
  const Simulation<1, 1> soft = column("", 1, 9.81, 2e4, 3);

  const auto density = soft.state.particles.density.values();
  const auto mass = soft.state.particles.mass.values();

  const double of_four_steps = 4 * std::pow(whole / 4, 5) / 120 * std::exp(whole);  // of the Runge-Kutta rule
  EXPECT_NEAR(*std::max_element(density.begin(), density.end()) / 1000, std::exp(at_point), of_four_steps);
  const double of_midpoints = whole * whole / (24 * 18 * 18) * std::exp(whole);
  EXPECT_NEAR(std::accumulate(mass.begin(), mass.end(), 0.0) / 750, std::expm1(whole) / whole,
              of_midpoints + of_four_steps);
}

}  // namespace
}  // namespace scree::app::testing
