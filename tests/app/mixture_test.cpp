// What laws read of a mix of grains: columns that follow the fractions of a run.

#include "scenes.hpp"
#include "scree/run/restart.hpp"
#include "scree/run/simulation.hpp"
#include "scree/run/summary.hpp"
#include "scree/scene/material_columns.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

namespace scree::app::testing {
namespace {

constexpr const char* fine_and_coarse = R"(law = "mixture_mu_of_i"
mu_s_fine = 0.35
mu_s_coarse = 0.45
mu_2_fine = 0.6
mu_2_coarse = 0.7
I_0_fine = 0.3
I_0_coarse = 0.3
grain_density = 2500
shear_rate_floor = 0.1
bulk_modulus = 1e7
density = 1500
)";

constexpr const char* slurry = R"(law = "suspension"
liquid_viscosity = 1
intrinsic_viscosity = 2.5
solid_fraction = 0.55
jammed_viscosity = 1e3
bulk_modulus = 1e7
density = 1900
)";

/// The small scene with this law and these grains, on a slope, segregating every fifth step.
[[nodiscard]] std::string slope_of(const std::string& law, const std::string& grains) {
  std::string text = small_scene();
  const std::size_t at = text.find("law = ");
  text.replace(at, text.find("[segregation]") - at, law + "[grains]\n" + grains);
  text.replace(text.find("end = 0.01"), 10, "end = 0.1");
  return text + "[gravity]\nslope_degrees = 28\n";
}

constexpr const char* two_sizes = "diameters = [0.5e-3, 4e-3]\nfractions = [0.5, 0.5]\n";

[[nodiscard]] Simulation<1, 2> simulation_of(const std::string& text) {
  return {parse_scene(text, "scene.toml", {"segregation.every=5"}).scene, {1}};
}

[[nodiscard]] const mpm::Column& column_of(const Simulation<1, 2>& simulation, std::string_view name) {
  const auto& particles = simulation.state.particles;
  return particles.column(particles.find_column(name, "the test"));
}

/// How far the finest fraction has come from a half, at most.
[[nodiscard]] double largest_change(const Simulation<1, 2>& simulation) {
  const mpm::Column& fractions = column_of(simulation, fraction_column);
  double change = 0;
  for (Index p = 0; p < fractions.size(); ++p) {
    change = std::max(change, std::abs(fractions.component(0)[p] - 0.5));
  }
  return change;
}

TEST(CoarseFraction, IsThatOfTheCoarserOfTwoClassesThroughoutARun) {  // Eqs. (R76), (G23)
  Simulation<1, 2> slope = simulation_of(slope_of(fine_and_coarse, two_sizes));

  while (!slope.is_finished()) slope.step();

  EXPECT_GT(largest_change(slope), 0.01);
  const mpm::Column& fractions = column_of(slope, fraction_column);
  for (Index p = 0; p < fractions.size(); ++p) {
    EXPECT_EQ(column_of(slope, coarse_fraction_column).component(0)[p], fractions.component(1)[p]);
  }
}

TEST(CoarseFraction, TakesAPartOfAClassThatItsSizeCuts) {  // Eq. (G23)
  const Simulation<1, 2> slope =
      simulation_of(slope_of(fine_and_coarse,
                             "distribution = \"histogram\"\nedges = [1e-3, 2e-3, 4e-3, 5e-3]\nfractions = "
                             "[0.2, 0.4, 0.4]\ncoarse_size "
                             "= 3.5e-3\n"));

  for (const double c : column_of(slope, coarse_fraction_column).values()) {
    EXPECT_NEAR(c, 0.25 * 0.4 + 0.4, 8 * round_off);  // four operations of numbers up to 5/2
  }
}

/// Who goes on with the points of a run means by its own words what is coarse: a quarter of the middle class
/// and all of the coarse one, or three quarters.
TEST(CoarseFraction, IsThatOfTheSceneThatGoesOn) {  // Eq. (G23)
  const auto file = std::filesystem::path{::testing::TempDir()} / "scree_coarse_fraction.h5";
  const auto slope_with = [](const std::string& coarse_size) {
    return slope_of(fine_and_coarse,
                    "distribution = \"histogram\"\nedges = [1e-3, 2e-3, 4e-3, 5e-3]\nfractions = "
                    "[0.2, 0.4, 0.4]\ncoarse_size = " +
                        coarse_size + "\n");
  };
  write_checkpoint(simulation_of(slope_with("3.5e-3")), file, "");

  Simulation<1, 2> restarted = simulation_of(slope_with("2.5e-3"));
  read_checkpoint_into(restarted, file);
  const Simulation<1, 2> begun = simulation_of(
      with(slope_with("2.5e-3"), "low = [0.0]\nhigh = [0.75]", "checkpoint = \"" + file.string() + "\""));

  for (const Simulation<1, 2>* slope : {&std::as_const(restarted), &begun}) {
    for (const double c : column_of(*slope, coarse_fraction_column).values()) {
      EXPECT_NEAR(c, 0.75 * 0.4 + 0.4, 8 * round_off);  // four operations of numbers up to 5/2
    }
  }
}

TEST(MaximumPacking, IsThatOfTheMixThroughoutARun) {  // Eqs. (G30) to (G32)
  Simulation<1, 2> slope =
      simulation_of(slope_of(slurry, std::string{two_sizes} + "packing_of_one_size = 0.6\ncompaction = 9\n"));

  while (!slope.is_finished()) slope.step();

  EXPECT_GT(largest_change(slope), 0.01);
  const grainsize::CompressiblePacking packing{slope.scene().grains->classes, 0.6, 9};
  const mpm::Column& fractions = column_of(slope, fraction_column);
  for (Index p = 0; p < fractions.size(); ++p) {
    const std::array<double, 2> phi{fractions.component(0)[p], fractions.component(1)[p]};
    EXPECT_EQ(column_of(slope, maximum_packing_column).component(0)[p], packing.maximum_fraction(phi));
  }
}

/// The viscosity of a run at its start is that of its mix, (R74).
TEST(MaximumPacking, IsWhatTheLawReads) {
  const auto viscosity_of = [](const std::string& fractions) {
    const Simulation<1, 2> slope =
        simulation_of(slope_of(slurry, "diameters = [0.5e-3, 4e-3]\nfractions = " + fractions +
                                           "\npacking_of_one_size = 0.6\ncompaction = 9\n"));
    return slope.stages()
        .stress->stiffness(slope.state.particles, 0, slope.state.particles.size())
        .kinematic_viscosity;
  };

  EXPECT_LT(viscosity_of("[0.4, 0.6]"), 0.5 * viscosity_of("[1.0, 0.0]"));
  // One size: (1 - 0.55/0.6)^(-2.5 x 0.6) = 41.57, at the density of no pressure; up to 0.1 % more at the
  // base.
  EXPECT_NEAR(viscosity_of("[1.0, 0.0]") * 1900, 41.57, 0.02 * 41.57);
}

TEST(Mixture, OfALawThatReadsNoneCarriesNone) {
  const Simulation<1, 2> slope = simulation_of(small_scene());
  const Simulation<1, 2> mixed = simulation_of(slope_of(fine_and_coarse, two_sizes));

  EXPECT_EQ(mixed.state.particles.bytes_per_particle(),
            slope.state.particles.bytes_per_particle() + sizeof(double));  // the coarse fraction
}

[[nodiscard]] std::string message_of(const std::string& text) {
  try {
    static_cast<void>(parse_scene(text, "scene.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(BadMixture, OfThreeClassesSaysWhichAreCoarse) {
  EXPECT_EQ(
      message_of(slope_of(fine_and_coarse, "diameters = [1e-3, 2e-3, 3e-3]\nfractions = [0.2, 0.4, 0.4]\n")),
      "scene.toml:24: [grains] coarse_size: missing, expected a number (size from which "
      "grains "
      "are coarse [m])");
}

TEST(BadMixture, OfASuspensionSaysHowItPacks) {
  EXPECT_EQ(message_of(slope_of(slurry, two_sizes)),
            "scene.toml:20: [grains] packing_of_one_size: missing, expected a number (solid "
            "fraction of packed grains of one size [-])\n"
            "scene.toml:20: [grains] compaction: missing, expected a number (index K of how they "
            "are packed [-])");
  EXPECT_EQ(
      message_of(slope_of(slurry, std::string{two_sizes} + "packing_of_one_size = 0.6\ncompaction = 1\n")),
      "scene.toml:24: [grains] compaction = 1: CompressiblePacking: the compaction is 1, but must be "
      "finite and exceed 1.5, where one size would fill all space");
}

TEST(BadMixture, KeysThatTheLawDoesNotReadAreUnknown) {
  std::string text = small_scene();
  text.insert(text.find("[segregation]"), "coarse_size = 1e-3\n");
  EXPECT_EQ(
      message_of(text),
      "scene.toml:20: [grains] coarse_size: unknown key, known here: distribution, diameters, fractions");
}

TEST(RunningMixture, StopsWhenThePaperMapLeavesAPointNoSizeThatItsLawKnows) {
  Simulation<1, 2> column{scene_of("inclined_plane_column", {"segregation.map=increments"}), {1}};
  mpm::Particles<1, 2>& particles = column.state.particles;
  mpm::Column& fractions = particles.column(particles.find_column(fraction_column, "the test"));
  fractions.component(0)[1] = 2.2;  // 2.2 (0.5 mm) - 1.2 (1 mm) = -0.1 mm
  fractions.component(1)[1] = -1.2;

  std::string message;
  try {
    while (!column.is_finished() && column.tally.segregation_steps == 0) column.step();
  } catch (const RunError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, ::testing::StartsWith("the law 'size_dependent_newtonian' reads grain_size = -"));
  EXPECT_THAT(message, ::testing::HasSubstr(" m of material point "));
  EXPECT_THAT(message,
              ::testing::EndsWith(": must be finite and above 0; the grains of this point have become "
                                  "none that the law knows"));
}

/// Segregation under a shear rate of y^2 1/(m^2 s): B = c d(y^2)/dy is largest at the topmost face between
/// cells with material, 0.625 m up, of whose sides the lower is the first. Means over cells differ by
/// (0.6875^2 - 0.5625^2)/s there, and s_h/s_min - 1 = 1/3 of half and half 0.5 and 1 mm.
TEST(RunningMixture, TellsWhichCellBoundsTheStepsOfSegregation) {  // Eqs. (G10), (G18)
  const Scene scene =
      parse_scene(small_scene(), "scene.toml", {"segregation.remixing=0", "gravity.magnitude=0"}).scene;
  Simulation<1, 2> column{scene, {1}};
  const auto& particles = column.state.particles;
  for (Index p = 0; p < particles.size(); ++p) {
    const double y = particles.position.component(0)[p];
    column.state.particles.velocity_gradient.component(1)[p] = y * y;
  }
  Coupling<1, 2> coupling{*scene.segregation, scene.grains->classes, column.grid(), scene.shape,
                          Vector<1>{-1.0},    Symmetry::plane,       Threads{1}};

  EXPECT_FALSE(coupling.last_limit());
  const auto report = coupling.advance(column.state, 7);
  const auto limit = coupling.last_limit();

  const double speed = 0.05 * (0.6875 * 0.6875 - 0.5625 * 0.5625) / 0.125 / 3;  // c = 0.05 m^2
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->dt, 0.5 * 0.125 / speed, 20 * round_off * limit->dt);  // 3 s, of some twenty operations
  EXPECT_NEAR(limit->position[0], 0.5625, 4 * round_off);
  EXPECT_GE(report.substeps, 3);
}

/// Remixing that is a thousand times as fast never shortens the step of momentum: a run tells both.
TEST(RunningMixture, SegregatesInStepsOfItsOwn) {
  Simulation<1, 2> column{
      parse_scene(small_scene(), "scene.toml", {"segregation.remixing=100", "segregation.every=20"}).scene,
      {1}};
  EXPECT_FALSE(column.segregation_limit());
  while (column.tally.segregation_steps == 0) column.step();

  const auto limit = column.segregation_limit();
  ASSERT_TRUE(limit);
  EXPECT_LT(limit->dt, column.next_step().dt);
  EXPECT_GT(column.tally.segregation_substeps, 20);
  EXPECT_THAT(summary_json(column, 1, "finished"),
              ::testing::HasSubstr("\"segregation_limit\": {\n    \"dt\": "));
}

}  // namespace
}  // namespace scree::app::testing
