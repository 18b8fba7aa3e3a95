// What material is at the start: the memory of its law, and the pressure on its top.

#include "scenes.hpp"
#include "scree/run/simulation.hpp"
#include "scree/scene/chosen.hpp"
#include "scree/scene/law_columns.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/grainsize/breakage.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scree::app::testing {
namespace {

/// A column, full up to this height [m] of 1 m, without gravity, of a law with its keys and what follows it.
[[nodiscard]] std::string column_of(double height, const std::string& law, const std::string& rest = "") {
  return fmt::format(R"([mesh]
dimensions = 1
velocity_components = 2
size = [1.0]
cells = 8
[boundaries]
y_low = "slip"
y_high = "slip"
[material]
low = [0.0]
high = [{}]
surface_pressure = 0
[gravity]
magnitude = 0
[time]
end = 0.1
[rheology]
{})",
                     height, law) +
         rest;
}

/// For some steps of any law.
const std::string long_enough = "time.end=100";

[[nodiscard]] Simulation<1, 2> simulation_of(const std::string& text,
                                             const std::vector<std::string>& overrides = {}) {
  return {parse_scene(text, "scene.toml", overrides).scene, {1}};
}

[[nodiscard]] std::string message_of(const std::string& text,
                                     const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(simulation_of(text, overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

[[nodiscard]] const mpm::Column& values_of(const Simulation<1, 2>& simulation, std::string_view name) {
  const auto& particles = simulation.state.particles;
  return particles.column(particles.find_column(name, "the test"));
}

/// The keys of a law, with the typical values, and of grains that fit it.
template <class Law>
[[nodiscard]] std::string typical_law() {
  std::string text = fmt::format("law = \"{}\"\n", Law::name);
  for (const auto& parameter : Law::parameters) {
    text += fmt::format("{} = {}\n", parameter.name, parameter.typical);
  }
  return text;
}

template <class Law>
[[nodiscard]] std::string typical_grains() {
  std::string text =
      "[grains]\ndistribution = \"histogram\"\nedges = [1e-4, 3e-4, 1e-3]\nfractions = [0.1, 0.9]\n";
  if (reads(Law{}, maximum_packing_column)) text += "packing_of_one_size = 0.64\ncompaction = 9\n";
  return text;
}

TEST(EveryLawInAScene, TakesStepsFromTheMemoryItIsGiven) {
  for_each_entry<rheology::AnyLaw>([](auto entry) {
    using Law = typename decltype(entry)::type;
    std::string initial;
    const auto given = [](const StateColumn& state) {
      return std::isfinite(state.start->upper) ? 0.5 * (state.start->lower + state.start->upper)
                                               : 2 * state.initial;
    };
    for (const StateColumn& state : Law::states) {
      if (state.start) initial += fmt::format("initial.{} = {}\n", state.name, given(state));
    }
    SCOPED_TRACE(typical_law<Law>() + initial);
    Simulation<1, 2> column =
        simulation_of(column_of(1, typical_law<Law>() + initial, typical_grains<Law>()), {long_enough});

    for (const StateColumn& state : Law::states) {
      const double expected = state.start ? given(state) : state.initial;
      for (const double value : values_of(column, state.name).values()) EXPECT_EQ(value, expected);
    }
    for (int i = 0; i < 3; ++i) column.step();
    EXPECT_EQ(column.clock.step, 3);
  });
}

/// A gas at rest in a full box cools by Haff's law, T^(-1/2) growing at a rate of its density alone: alike
/// from any temperature at the start.
TEST(InitialState, IsWhatAGasCoolsFrom) {  // Eq. (R107)
  const std::string gas =
      column_of(1, typical_law<rheology::KineticTheory>() + "initial.granular_temperature = ",
                "\n[grains]\ndiameters = [1e-3]\nfractions = [1.0]\n");
  const auto grown = [&](const std::string& temperature) {
    std::string text = gas;
    const std::string key = "granular_temperature = ";
    text.insert(text.find(key) + key.size(), temperature);
    Simulation<1, 2> column = simulation_of(text);
    while (!column.is_finished()) column.step();
    return 1 / std::sqrt(values_of(column, "granular_temperature").component(0)[0]) -
           1 / std::sqrt(std::stod(temperature));
  };

  const double of_cold = grown("1e-4");
  const double of_hot = grown("1e-2");

  EXPECT_GT(of_cold, 0);
  // A step rounds T, of which 1/sqrt(T) up to 100 is, by about 20 operations: so many steps, 1e4 at most.
  EXPECT_NEAR(of_hot, of_cold, 1e4 * 20 * round_off * (100 + of_cold));
}

/// (G21): the grains of the scene are those before any broke.
TEST(InitialState, HasGrainsAsFineAsItsBreakage) {
  const Simulation<1, 2> column =
      simulation_of(column_of(1, typical_law<rheology::Breakage>() + "initial.breakage = 0.25\n",
                              typical_grains<rheology::Breakage>() + "ultimate_fractal_dimension = 2.7\n"));

  const auto& grains = *column.scene().grains;
  const auto ultimate = grainsize::ultimate_fractions(grains.classes, grains.fractions, 2.7);
  const auto& fractions = values_of(column, fraction_column);
  const double expected = std::lerp(grains.fractions[0], ultimate[0], 0.25);
  for (Index p = 0; p < fractions.size(); ++p) {
    EXPECT_NEAR(fractions.component(0)[p], expected, 8 * round_off);  // a few roundings
  }
}

/// Ground that was made dense or loose rests under its weight from the density on at which its grains touch:
/// dp/dz = rho(p) g lies between the weights of that and of the densest point.
template <class Law>
void expect_ground(const std::string& key, double value, double touching) {
  SCOPED_TRACE(key);
  Simulation<1, 2> ground =
      simulation_of(column_of(0.5, typical_law<Law>() + fmt::format("initial.{} = {}\n", key, value),
                              typical_grains<Law>()),
                    {"gravity.magnitude=9.81", long_enough});
  const auto& particles = ground.state.particles;
  std::vector<double> pressures(static_cast<std::size_t>(particles.size()));
  ground.stages().stress->pressure(particles, pressures);
  const double densest = std::ranges::max(particles.density.values());

  for (Index p = 0; p < particles.size(); ++p) {
    const double depth = 0.5 - particles.position.component(0)[p];
    const double pressure = pressures[static_cast<std::size_t>(p)];
    EXPECT_GT(pressure, touching * 9.81 * depth);
    EXPECT_LT(pressure, densest * 9.81 * depth);
  }
  for (int i = 0; i < 100; ++i) ground.step();
  EXPECT_EQ(ground.clock.step, 100);
}

TEST(InitialState, IsGroundAsDenseAsItWasMade) {
  expect_ground<rheology::MohrCoulomb>("dilation", -0.05, 1500 * std::exp(0.05));
  expect_ground<rheology::MohrCoulomb>("dilation", 0.05, 1500 * std::exp(-0.05));
  expect_ground<rheology::Breakage>("compaction", 0.05, 1600 * std::exp(0.05));
  expect_ground<rheology::MuPhiOfI>("unloaded_volume", 0.97, 1500 / 0.97);
}

TEST(InitialState, OfAnUnknownNameIsRefused) {
  EXPECT_EQ(
      message_of(column_of(
          1, typical_law<rheology::ModifiedCamClay>() + "[rheology.initial]\npreconsolidatoin = 2\n")),
      "scene.toml:27: [rheology.initial] preconsolidatoin: unknown key, did you mean 'preconsolidation'?");
  EXPECT_EQ(message_of(column_of(1, typical_law<rheology::ModifiedCamClay>() +
                                        "[rheology.initial]\nelastic_strain_xx "
                                        "= 2\n")),
            "scene.toml:27: [rheology.initial] elastic_strain_xx: unknown key, known here: preconsolidation");
}

TEST(InitialState, OutOfItsRangeIsRefused) {
  EXPECT_EQ(message_of(column_of(
                1, typical_law<rheology::ModifiedCamClay>() + "[rheology.initial]\npreconsolidation = 0\n")),
            "scene.toml:27: [rheology.initial] preconsolidation = 0: must exceed 0 (at the start [-])");
  EXPECT_EQ(message_of(column_of(1, typical_law<rheology::Breakage>() + "[rheology.initial]\nbreakage = 1\n",
                                 typical_grains<rheology::Breakage>())),
            "scene.toml:27: [rheology.initial] breakage = 1: must lie in (0, 1) (at the start [-])");
}

/// A gas presses at any density: it must be told what rests on it.
TEST(SurfacePressure, IsAskedForWhereALawHasNoDensityWithout) {
  EXPECT_EQ(message_of(column_of(0.5, typical_law<rheology::KineticTheory>(),
                                 "[grains]\ndiameters = [1e-3]\nfractions = [1.0]\n"),
                       {"gravity.magnitude=9.81"}),
            "[material] surface_pressure = 0: the law 'kinetic_theory' has no density at which it bears this "
            "pressure [Pa], as the top of the material does at the start; give another");
}

/// dp/dz = rho(p) g lies between the weights of the thinnest and of the densest clay there is. Without load
/// the thinnest, at the top, is where clay lets go, (R67): p = 1e-9 p_c.
void expect_clay_under_its_weight(double load) {
  const double kappa = rheology::typical<rheology::ModifiedCamClay>().kappa;
  Simulation<1, 2> clay = simulation_of(
      column_of(0.5, typical_law<rheology::ModifiedCamClay>()),
      {"gravity.magnitude=9.81", long_enough, fmt::format("material.surface_pressure={}", load)});
  const auto& particles = clay.state.particles;
  std::vector<double> pressures(static_cast<std::size_t>(particles.size()));
  clay.stages().stress->pressure(particles, pressures);
  const auto [least, densest] = std::ranges::minmax(particles.density.values());
  const double thinnest = least * std::pow(1e-10, kappa);

  for (Index p = 0; p < particles.size(); ++p) {
    const double depth = 0.5 - particles.position.component(0)[p];
    const double pressure = pressures[static_cast<std::size_t>(p)];
    EXPECT_GT(pressure, load + thinnest * 9.81 * depth);
    EXPECT_LT(pressure, load + densest * 9.81 * depth);
  }
  for (int i = 0; i < 100; ++i) clay.step();
  EXPECT_EQ(clay.clock.step, 100);
}

TEST(SurfacePressure, MayBeNoneOnClay) {  // Eq. (M24)
  expect_clay_under_its_weight(0);
}

TEST(SurfacePressure, RestsOnClay) {
  expect_clay_under_its_weight(1000);
}

TEST(OutputFields, AreWhatTheLawReadsAndKeepsToo) {
  const std::string text = column_of(1, typical_law<rheology::MixtureMuOfI>(),
                                     typical_grains<rheology::MixtureMuOfI>() + "[output]\nfields = [");
  EXPECT_EQ(message_of(text + "\"coarse_fraction\"]\n"), "no error");
  EXPECT_EQ(message_of(column_of(1, typical_law<rheology::ModifiedCamClay>(),
                                 "[output]\nfields = [\"preconsolidation\"]\n")),
            "no error");
}

}  // namespace
}  // namespace scree::app::testing
