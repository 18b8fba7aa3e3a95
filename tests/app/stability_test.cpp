// Steps and moduli with which points would fly are refused before a run begins.

#include "scree/simulation.hpp"

#include <gtest/gtest.h>

#include <string>

namespace scree::app::testing {
namespace {

/// A column of cells of 0.125 m, in which sound runs at 10 m/s.
[[nodiscard]] std::string message_of(const std::string& numerics, double viscosity, double gravity = 0,
                                     double bulk_modulus = 1e5) {
  const std::string text = R"([mesh]
dimensions = 1
size = [1.0]
cells = 8
[boundaries]
y_low = "slip"
y_high = "slip"
[material]
low = [0.0]
high = [0.75]
[time]
end = 1
[rheology]
law = "newtonian"
density = 1000
viscosity = )" + std::to_string(viscosity) +
                           "\nbulk_modulus = " + std::to_string(bulk_modulus) +
                           "\n[gravity]\nmagnitude = " + std::to_string(gravity) + "\n[numerics]\n" +
                           numerics;
  try {
    const Simulation<1, 1> simulation{parse_scene(text, "scene.toml").scene, {1}};
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// C = 1/sqrt(2) for hat functions, and for others of up to three nodes; the share is rounded down.
TEST(StableStep, OfFlipEndsAtACourantNumberOfOneOverRootTwo) {
  const std::string flip = "transfer = \"pic_flip\"\nshape = ";
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

/// (c dt/h)^2 + 8/3 nu dt/h^2 = 1 at 0.008257 s, where either limit alone allows 0.0125 s or more.
TEST(StableStep, LeavesRoomForSoundAndViscosityTogether) {
  EXPECT_EQ(
      message_of("acoustic = 1\nviscous = 1", 400),
      "[numerics] acoustic = 1: must be at most 0.6605: it allows steps of 0.0125 s, and from the "
      "critical one, 0.008257 s, on waves of sound and viscosity grow under transfer = \"apic\", shape = "
      "\"linear\", order = \"usl\"");
  EXPECT_EQ(message_of("acoustic = 0.66\nviscous = 1", 400), "no error");
  EXPECT_EQ(message_of("acoustic = 1\nviscous = 1\nmaximum_dt = 0.008", 400), "no error");
}

/// The deepest point lies 0.729 m under the surface: 7153 Pa.
TEST(StiffLaw, MustBearTheWeightOfItsMaterial) {
  EXPECT_EQ(
      message_of("", 1, 9.81, 500),
      "[rheology] bulk_modulus = 500: the material bears 7153 Pa at the start, 14.3 times as much, and "
      "would be compressed beyond sense: give more than that, and ten times that to keep it below a tenth "
      "[Pa]");
  EXPECT_EQ(message_of("", 1, 9.81, 7154), "no error");
}

}  // namespace
}  // namespace scree::app::testing
