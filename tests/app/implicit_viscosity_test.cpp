// The paper's flow with its viscosity solved for on the nodes.

#include "incline.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>

namespace scree::app::testing {
namespace {

const std::string implicit = "numerics.viscosity=implicit";

[[nodiscard]] std::int64_t steps_bound_by(const Tally& tally, mpm::Limit limit) {
  return tally.steps_by_limit[static_cast<std::size_t>(limit)];
}

TEST(ImplicitInclinedPlane, AgreesWithTheReferenceAtEveryTime) {
  Simulation<1, 2> column{scene_of("inclined_plane_column_a", {implicit}), {1}};

  const InclineErrors errors = errors_of(column, 'A');

  EXPECT_LE(errors.largest_size(), 0.010);  // the bounds of the explicit run
  EXPECT_LE(errors.velocity, 0.015);
  EXPECT_EQ(steps_bound_by(column.tally, mpm::Limit::viscous), 0);
}

/// Velocity at the surface after `end` [s], steps and CPU time [s].
struct StartUp {
  double surface;
  double steps;
  double seconds;
};

[[nodiscard]] StartUp start_up(const std::string& viscosity, Index cells) {
  Simulation<1, 2> column{
      scene_of("inclined_plane_column_a", {"rheology.viscosity=1e4", "time.end=0.05", "output.every=0.05",
                                           "numerics.viscosity=" + viscosity, "mesh.size=[1.25]",
                                           "mesh.cells=" + std::to_string(cells)}),
      {1}};
  const std::clock_t start = std::clock();
  while (!column.is_finished()) column.step();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return {profile_of(column, 20).velocity.back(), static_cast<double>(column.clock.step), seconds};
}

TEST(ImplicitInclinedPlane, StartsUpAsTheExplicitRunDoesInFewerSteps) {
  for (const Index cells : {50, 200}) {
    const StartUp exact = start_up("explicit", cells);
    const StartUp quick = start_up("implicit", cells);

    std::printf(
        "start-up at 1e4 Pa s, %td cells: explicit %.0f steps, %.3f s; implicit %.0f steps, %.3f s: %.1f "
        "times\n",
        cells, exact.steps, exact.seconds, quick.steps, quick.seconds, exact.seconds / quick.seconds);
    // The limits of sound, 0.5 h/c, and of viscosity, 0.5 h^2/(2 nu), are 2 nu/(c h) = 8 times apart for
    // h = 0.025 m, c = 100 m/s, nu = 10 m^2/s.
    const double ratio = 8 * static_cast<double>(cells) / 50;
    EXPECT_NEAR(exact.steps / quick.steps, ratio, 0.05 * ratio);
    // Backward Euler is late by half a step, as explicit Euler is early: 1.25e-4 s of the rise in 0.04 s.
    EXPECT_NEAR(quick.surface / exact.surface, 1, 0.005);
  }
}

TEST(ImplicitSlope, EqualsTheColumn) {
  const std::vector<std::string> keys{implicit, "time.end=0.02", "output.every=0.02",
                                      "numerics.maximum_dt=5e-5"};
  Simulation<1, 2> column{scene_of("inclined_plane_column", keys), {1}};
  Simulation<2, 2> slope{scene_of("inclined_plane", keys), {1}};

  while (!column.is_finished()) column.step();
  while (!slope.is_finished()) slope.step();

  EXPECT_EQ(slope.clock.step, column.clock.step);
  const Profile expected = profile_of(column, 20);
  const Profile profile = profile_of(slope, 20);
  // Each step is solved to 1e-8 of the largest velocity, and not to the last digit in one dimension either.
  const double tolerance = 2e-8 * static_cast<double>(column.clock.step) * expected.velocity.back();
  for (std::size_t i = 0; i < 20; ++i) EXPECT_NEAR(profile.velocity[i], expected.velocity[i], tolerance) << i;
}

TEST(AutomaticViscosity, ChoosesByTheRatioOfSteps) {
  const auto note = [](const std::string& viscosity) {
    const Simulation<1, 2> column{
        scene_of("inclined_plane_column_a", {"rheology.viscosity=" + viscosity, "numerics.viscosity=auto"}),
        {1}};
    return column.viscosity_note();
  };
  // 0.02 m cells: sound allows 1e-4 s, viscosity 0.1/mu.
  EXPECT_EQ(note("750"),
            "viscosity is explicit: the step of 0.0001 s is 0.75 times the viscous limit of 0.000133 s, not "
            "above 3");
  EXPECT_EQ(note("2900").substr(0, 21), "viscosity is explicit");  // 2.9
  EXPECT_EQ(note("3100").substr(0, 21), "viscosity is implicit");
  EXPECT_EQ(
      note("1e6"),
      "viscosity is implicit: the step of 0.0001 s is 1e+03 times the viscous limit of 1e-07 s, above 3");
}

TEST(ImplicitViscosityKey, NeedsHatFunctions) {
  std::string message = "no error";
  try {
    static_cast<void>(scene_of("inclined_plane_column_a", {implicit, "numerics.shape=quadratic"}));
  } catch (const InputError& error) {
    message = error.what();
  }

  EXPECT_EQ(message, "--set numerics.viscosity=implicit: viscosity is implicit for shape = \"linear\" only");
}

}  // namespace
}  // namespace scree::app::testing
