// Path files: those that people run, what they get for them, and what they are told of a wrong one.

#include "scree/run/run_path.hpp"

#include <scree/error.hpp>
#include <scree/rheology/path/paths.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

namespace scree::app::testing {
namespace {

/// A small path as text, for tests that spoil it.
[[nodiscard]] std::string small_path() {
  return R"([rheology]
law = "mu_of_i"
mu_s = 0.38
mu_2 = 0.64
I_0 = 0.28
grain_density = 2500
shear_rate_floor = 1e-3
bulk_modulus = 1e6
density = 1500
[inputs]
grain_size = 1e-3
[start]
pressure = 1e3
[[stages]]
name = "by name"
path = "simple_shear_at_constant_pressure"
rate = 2
duration = 0.5
steps = 5
[[stages]]
duration = 0.5
steps = 5
strain_rates = { zz = 0.25, xy = 1.0 }
stress_rates = { xx = -10, yy = 20 }
spin = { xz = 3 }
simple_shear = ["xy"]
)";
}

/// The small path with one text in place of another.
[[nodiscard]] std::string with(const std::string& text, const std::string& instead) {
  std::string path = small_path();
  const std::size_t at = path.find(text);
  if (at == std::string::npos) throw std::runtime_error{"the small path has no '" + text + "'"};
  return path.replace(at, text.size(), instead);
}

[[nodiscard]] std::string message_of(const std::string& text) {
  try {
    static_cast<void>(parse_path_file(text, "path.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

[[nodiscard]] std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

TEST(Paths, EachFileReadsAndRunsToItsEnd) {
  int num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator{SCREE_TEST_PATHS}) {
    SCOPED_TRACE(entry.path());
    const PathFile file = read_path_file(entry.path());
    const auto point = start_of(file);

    const auto records = drive(*point, file.stages);

    std::size_t num_steps = 0;
    for (const auto& stage : file.stages) num_steps += static_cast<std::size_t>(stage.num_steps);
    EXPECT_EQ(records.size(), num_steps + 1);
    EXPECT_FALSE(file.title.empty());
    ++num_files;
  }
  EXPECT_GE(num_files, 4);
}

TEST(PathFile, SaysWhatEachStageImposes) {
  using rheology::Control;
  const PathFile file = parse_path_file(small_path(), "path.toml");

  ASSERT_EQ(file.stages.size(), 2U);
  EXPECT_EQ(file.stages[0].name, "by name");
  EXPECT_EQ(file.stages[0].controls.on[3].rate, 1);  // half of the shear rate
  EXPECT_EQ(file.stages[0].controls.on[1].of, Control::Of::stress_rate);
  const auto& second = file.stages[1];
  EXPECT_EQ(second.name, "2");
  const std::array rates{-10.0, 20.0, 0.25, 1.0, 0.0, 0.0};
  for (std::size_t k = 0; k < rates.size(); ++k) {
    EXPECT_EQ(second.controls.on[k].rate, rates[k]);
    EXPECT_EQ(second.controls.on[k].of == Control::Of::stress_rate, k < 2);
  }
  EXPECT_EQ(second.controls.spin, (std::array{0.0, 3.0, 0.0}));
  EXPECT_EQ(second.controls.is_simple_shear, (std::array{true, false, false}));
  EXPECT_EQ(file.inputs, std::vector{1e-3});
}

TEST(PathFile, BeginsAtItsPressureOrItsDensity) {
  const auto pressed = start_of(parse_path_file(small_path(), "path.toml"));
  const auto packed = start_of(parse_path_file(with("pressure = 1e3", "density = 1503"), "path.toml"));

  EXPECT_NEAR(-pressed->now.stress(0, 0), 1e3, 8 * round_off * 1e6);  // of a density, met by K
  EXPECT_NEAR(-packed->now.stress(0, 0), 2e3, 8 * round_off * 1e6);
}

/// The small path of another law, with what its table ends with.
template <class Law>
[[nodiscard]] std::string path_of(const std::string& keys) {
  std::string text = fmt::format("[rheology]\nlaw = \"{}\"\n", Law::name);
  for (const auto& parameter : Law::parameters) {
    text += fmt::format("{} = {}\n", parameter.name, parameter.typical);
  }
  text += keys + "[inputs]\n";
  for (const InputColumn& input : Law::inputs) text += fmt::format("{} = {}\n", input.name, input.typical);
  return text + small_path().substr(small_path().find("[start]"));
}

TEST(PathFile, BeginsWithTheMemoryItIsGiven) {
  const PathFile file =
      parse_path_file(path_of<rheology::MuPhiOfI>("initial.unloaded_volume = 0.98\n"), "path.toml");
  const PathFile without = parse_path_file(path_of<rheology::MuPhiOfI>(""), "path.toml");

  EXPECT_EQ(start_of(file)->state(), std::vector{0.98});
  EXPECT_EQ(start_of(without)->state(), std::vector{1.0});
  EXPECT_GT(start_of(file)->now.density, start_of(without)->now.density);  // at one pressure
}

/// Ground that shear has loosened, or crushing compacted, touches at another density.  Eqs. (R57), (R113)
TEST(PathFile, BeginsAtTheDensityOfItsMemory) {
  const auto density_of = [](std::string text) {
    text.replace(text.find("pressure = 1e3"), 14, "pressure = 0");
    return start_of(parse_path_file(text, "path.toml"))->now.density;
  };

  for (const double dilation : {-0.05, 0.0, 0.05}) {
    const double expected = 1500 * std::exp(-dilation);
    EXPECT_NEAR(density_of(path_of<rheology::MohrCoulomb>(fmt::format("initial.dilation = {}\n", dilation))),
                expected, 16 * round_off * expected);  // a logarithm of a ratio near one
  }
  for (const double compaction : {0.0, 0.05}) {
    const double expected = 1600 * std::exp(compaction);
    EXPECT_NEAR(density_of(path_of<rheology::Breakage>(fmt::format("initial.compaction = {}\n", compaction))),
                expected, 16 * round_off * expected);
  }
}

/// A gas four times as hot presses four times as much at one density.  Eq. (R100)
TEST(PathFile, BeginsWithAStressOfItsMemory) {
  const auto pressure_at = [](const std::string& temperature) {
    std::string gas =
        path_of<rheology::KineticTheory>("initial.granular_temperature = " + temperature + "\n");
    gas.replace(gas.find("pressure = 1e3"), 14, "density = 1000");
    const auto point = start_of(parse_path_file(gas, "path.toml"));
    return -point->now.stress(0, 0);
  };

  EXPECT_NEAR(pressure_at("4e-4") / pressure_at("1e-4"), 4, 8 * round_off);  // two products
}

TEST(BadPathFile, MemoryOutOfItsRangeIsNamed) {
  EXPECT_EQ(message_of(path_of<rheology::MuPhiOfI>("[rheology.initial]\nunloaded_volume = 0\n")),
            "path.toml:13: [rheology.initial] unloaded_volume = 0: must exceed 0 (at the start [-])");
}

TEST(BadPathFile, MemoryOfGroundOutOfItsRangeIsNamed) {
  EXPECT_EQ(message_of(path_of<rheology::MohrCoulomb>("[rheology.initial]\ndilation = -1\n")),
            "path.toml:11: [rheology.initial] dilation = -1: must lie in (-1, 1) (at the start [-])");
  EXPECT_EQ(message_of(path_of<rheology::Breakage>("[rheology.initial]\ncompaction = -0.1\n")),
            "path.toml:11: [rheology.initial] compaction = -0.1: must lie in [0, 1] (at the start [-])");
}

TEST(BadPathFile, MemoryThatIsNotForAPersonToTellIsNamed) {
  const std::string message = message_of(
      path_of<rheology::GranularElastoviscoplastic>("[rheology.initial]\ndeviatoric_stress_xx = 1\n"));
  EXPECT_EQ(message, "path.toml:11: [rheology.initial] deviatoric_stress_xx: unknown key");
}

TEST(PathCsv, HasAColumnWithItsUnitForAllThatTheLawHas) {
  const PathFile file = parse_path_file(small_path(), "path.toml");
  const auto point = start_of(file);
  const auto records = drive(*point, file.stages);

  const std::string csv = csv_of(*point, records);

  EXPECT_EQ(first_line(csv),
            "time [s],stage [-],strain_xx [-],strain_yy [-],strain_zz [-],strain_xy [-],strain_xz [-],"
            "strain_yz [-],volumetric_strain [-],density [kg/m^3],stress_xx [Pa],stress_yy [Pa],"
            "stress_zz [Pa],stress_xy [Pa],stress_xz [Pa],stress_yz [Pa],pressure [Pa],"
            "deviatoric_stress [Pa],lode_angle [rad],velocity_gradient_xx [1/s],velocity_gradient_xy [1/s],"
            "velocity_gradient_xz [1/s],velocity_gradient_yx [1/s],velocity_gradient_yy [1/s],"
            "velocity_gradient_yz [1/s],velocity_gradient_zx [1/s],velocity_gradient_zy [1/s],"
            "velocity_gradient_zz [1/s],shear_rate [1/s],inertial_number [-],dissipation [W/m^3],"
            "stability_number [-],iterations [-]");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 12);
  EXPECT_EQ(csv.find("nan"), std::string::npos);
}

TEST(PathCsv, HasTheLawsMemoryAndNoColumnThatItLacks) {
  const PathFile file = read_path_file(std::filesystem::path{SCREE_TEST_PATHS} / "triaxial_drained.toml", {});
  const auto point = start_of(file);

  const std::string header = first_line(csv_of(*point, drive(*point, file.stages)));

  EXPECT_NE(header.find(",elastic_strain_xx [-],"), std::string::npos) << header;
  EXPECT_EQ(header.find("inertial_number"), std::string::npos);
  EXPECT_EQ(header.find("stability_number"), std::string::npos);
}

TEST(BadPathFile, UnknownKeysAreNamed) {
  EXPECT_EQ(message_of(with("duration = 0.5", "durration = 0.5")),
            "path.toml:14: [stages 1] duration: missing, expected a number (of the stage [s])\n"
            "path.toml:18: [stages 1] durration: unknown key, did you mean 'duration'?");
}

TEST(BadPathFile, StageWithARateOfANameAndOfAComponentIsNamed) {
  EXPECT_EQ(
      message_of(with("rate = 2", "rate = 2\nstrain_rates = { xx = 1 }")),
      "path.toml:18: [stages 1] strain_rates: unknown table, known here: name, duration, steps, path, rate");
}

TEST(BadPathFile, ComponentControlledTwiceIsNamed) {
  EXPECT_EQ(message_of(with("xx = -10", "xy = -10")),
            "path.toml:24: [stages 2.stress_rates] xy = -10: has a strain rate too: give one of them");
}

TEST(BadPathFile, UnknownComponentIsNamed) {
  EXPECT_EQ(message_of(with("xx = -10", "yx = -10")),
            "path.toml:24: [stages 2.stress_rates] yx: unknown key, did you mean 'xx'?");
}

TEST(BadPathFile, UnknownPlaneIsNamed) {
  EXPECT_EQ(message_of(with("[\"xy\"]", "[\"yx\"]")),
            "path.toml:26: [stages 2] simple_shear = [\"yx\"]: 'yx' is none of xy, xz, yz");
}

TEST(BadPathFile, UnknownPathIsAnsweredWithTheKnownOnes) {
  EXPECT_EQ(message_of(with("simple_shear_at_constant_pressure", "shear")),
            "path.toml:16: [stages 1] path = \"shear\": expected one of isotropic_compression, oedometric, "
            "triaxial_drained, triaxial_undrained, simple_shear_at_constant_pressure, "
            "simple_shear_at_constant_volume, rotation (ready-made path)");
}

TEST(BadPathFile, MissingInputIsNamed) {
  EXPECT_EQ(message_of(with("grain_size = 1e-3", "")),
            "path.toml:10: [inputs] grain_size: missing, expected a number (what the law reads [m])");
}

TEST(BadPathFile, SizeThatIsNoneIsNamed) {
  EXPECT_EQ(message_of(with("grain_size = 1e-3", "grain_size = -1e-3")),
            "path.toml:11: [inputs] grain_size = -1e-3: must exceed 0 (what the law reads [m])");
}

TEST(BadPathFile, FractionThatIsNoneIsNamed) {
  const std::string text = R"([rheology]
law = "suspension"
liquid_viscosity = 1
intrinsic_viscosity = 2.5
solid_fraction = 0.5
jammed_viscosity = 1e3
bulk_modulus = 1e7
density = 1800
[inputs]
maximum_packing = 64
)" + small_path().substr(small_path().find("[start]"));

  EXPECT_EQ(message_of(text),
            "path.toml:10: [inputs] maximum_packing = 64: must lie in (0, 1) (what the law reads [-])");
}

TEST(BadPathFile, LawsOwnInequalityIsNamed) {
  EXPECT_EQ(message_of(with("mu_2 = 0.64", "mu_2 = 0.3")),
            "path.toml:4: [rheology] mu_2 = 0.3: must exceed mu_s = 0.38");
}

TEST(BadPathFile, StartGivenTwiceIsNamed) {
  EXPECT_EQ(message_of(with("pressure = 1e3", "pressure = 1e3\ndensity = 1500")),
            "path.toml:13: [start] pressure = 1e3: give a density or a pressure, not both");
}

TEST(BadPathFile, PathWithoutStagesIsNamed) {
  const std::string text = small_path();
  EXPECT_EQ(message_of(text.substr(0, text.find("[[stages]]"))),
            "path.toml: stages: missing, expected at least one table [[stages]]");
}

}  // namespace
}  // namespace scree::app::testing
