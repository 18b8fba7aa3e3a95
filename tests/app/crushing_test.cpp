// A law that crushes grains, and the size classes that follow it.

#include "scenes.hpp"
#include "scree/run/simulation.hpp"
#include "scree/run/summary.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/grainsize/breakage.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace scree::app::testing {
namespace {

/// A layer so heavy for its soft grains that its lower half is crushed: p_cr is 5 kPa, the base bears 12 kPa.
[[nodiscard]] std::string crushed_layer(const std::string& grains, const std::string& rest = "") {
  return R"([mesh]
dimensions = 1
velocity_components = 2
size = [1.0]
cells = 8
[boundaries]
y_low = "no_slip"
y_high = "slip"
[material]
low = [0.0]
high = [0.75]
[rheology]
law = "breakage"
bulk_modulus = 1e6
shear_modulus = 4e5
grading = 0.85
critical_energy = 10.6
critical_stress_ratio = 1.2
coupling_angle = 70
density = 1600
)" + grains +
         rest + R"([time]
end = 0.3
)";
}

constexpr const char* sand = R"([grains]
distribution = "histogram"
edges = [1e-4, 3e-4, 1e-3]
fractions = [0.1, 0.9]
)";

[[nodiscard]] double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Crushing, MovesTheVolumeOfEveryPointByItsBreakage) {  // Eq. (G21)
  const Scene scene = parse_scene(crushed_layer(sand), "test").scene;
  const auto ultimate = grainsize::ultimate_fractions(scene.grains->classes, scene.grains->fractions);
  Simulation<1, 2> layer{scene, {1}};
  const auto before = class_masses(layer.state.particles);

  while (!layer.is_finished()) layer.step();

  const auto& particles = layer.state.particles;
  const double* breakage = particles.column(particles.find_column("breakage", "the test")).component(0);
  const auto& fractions = particles.column(particles.find_column(fraction_column, "the test"));
  const double steps = static_cast<double>(layer.clock.step);
  double most = 0;
  double least = 1;
  for (Index p = 0; p < particles.size(); ++p) {
    if (particles.mass.component(0)[p] == 0) continue;
    most = std::max(most, breakage[p]);
    least = std::min(least, breakage[p]);
    for (int k = 0; k < 2; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double expected = std::lerp(scene.grains->fractions[i], ultimate[i], breakage[p]);
      EXPECT_NEAR(fractions.component(k)[p], expected, 8 * steps * round_off) << p;  // a few roundings a step
    }
  }
  EXPECT_GT(most, 0.1);
  EXPECT_EQ(least, 0);  // the upper part is not crushed
  const auto after = class_masses(particles);
  EXPECT_GT(after[0], 1.05 * before[0]);
  EXPECT_LE(class_mass_drift(layer), 1e-12);
  EXPECT_LE(layer.tally.fractions.sum_error, 1e-13);
}

TEST(Crushing, KeepsTheSumWhereGrainsSegregateToo) {
  const std::string segregation =
      "[segregation]\nclosure = \"shear_rate\"\nc = 0.05\nremixing = 0.1\nevery = 5\n";
  Simulation<1, 2> layer{parse_scene(crushed_layer(sand, segregation), "test").scene, {1}};
  const double before = sum(class_masses(layer.state.particles));

  while (!layer.is_finished()) layer.step();

  EXPECT_LE(std::abs(sum(class_masses(layer.state.particles)) - before), 1e-12 * before);
  EXPECT_GT(layer.tally.segregation_steps, 0);
  EXPECT_LE(layer.tally.fractions.sum_error, 1e-13);
  EXPECT_GE(layer.tally.fractions.lowest, -1e-14);
  EXPECT_LE(layer.tally.fractions.highest, 1 + 1e-14);
}

TEST(Crushing, NeedsClassesWithEdges) {
  const std::string sieved = "[grains]\ndiameters = [0.5e-3, 1e-3]\nfractions = [0.1, 0.9]\n";
  const Scene scene = parse_scene(crushed_layer(sieved), "test").scene;

  try {
    const Simulation<1, 2> layer{scene, {1}};
    ADD_FAILURE() << "no InputError was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "ultimate_fractions: the size classes must have edges");
  }
}

}  // namespace
}  // namespace scree::app::testing
