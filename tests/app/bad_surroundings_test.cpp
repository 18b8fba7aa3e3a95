// What a person gets wrong in the surroundings of a scene, and what they are told.

#include "scenes.hpp"
#include "surroundings.hpp"

#include <fmt/format.h>

namespace scree::app::testing {
namespace {

const std::string box = "[material]\nlow = [0.0, 0.75, 0.0]\nhigh = [2.0, 1.0, 1.5]\n";

/// The message, without the folder that files are in.
template <class Action>
[[nodiscard]] std::string message_of(Action&& action) {
  std::string message = "no error";
  try {
    action();
  } catch (const InputError& error) {
    message = error.what();
  }
  const std::string folder = (folder_with_maps() / "").string();
  for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
    message.erase(at, folder.size());
  }
  return message;
}

[[nodiscard]] std::string message_on_map(const std::string& terrain, const std::string& material = box) {
  return message_of([&] { static_cast<void>(read_on_map(terrain, material)); });
}

[[nodiscard]] std::string tilted_with(const std::string& part, const std::string& instead) {
  return with(tilted_ground, part, instead);
}

TEST(SceneOnAMap, IsSound) {
  EXPECT_EQ(message_on_map(tilted_ground), "no error");
}

TEST(BadTerrain, UnknownNameIsAnsweredWithTheKnownOnes) {
  EXPECT_EQ(
      message_on_map(tilted_with("\"raster\"", "\"map\"")),
      "scene.toml:13: [terrain] surface = \"map\": expected one of plane, profile, raster, stl (how the "
      "ground is given)\n"
      "scene.toml:14: [terrain] file: unknown key, known here: surface, contact, friction_file\n"
      "scene.toml:15: [terrain] origin: unknown key, known here: surface, contact, friction_file\n"
      "scene.toml:16: [terrain] datum: unknown key, known here: surface, contact, friction_file");
}

/// Of ground that is not known, the map of friction is not looked at.
TEST(BadTerrain, UnknownNameIsTheOnlyFaultBesideAMapOfFriction) {
  EXPECT_EQ(
      message_on_map("[terrain]\nsurface = \"map\"\ncontact = {law = \"material_friction\", share = 1, "
                     "friction = 0.5}\nfriction_file = \"friction.asc\"\n"),
      "scene.toml:13: [terrain] surface = \"map\": expected one of plane, profile, raster, stl (how the "
      "ground is given)");
}

TEST(BadTerrain, UnknownKeyIsNamed) {
  EXPECT_EQ(message_on_map(tilted_with("datum", "dattum")),
            "scene.toml:16: [terrain] dattum: unknown key, did you mean 'datum'?");
}

TEST(BadTerrain, FileThatIsNotThereIsNamed) {
  EXPECT_EQ(message_on_map(tilted_with("tilted.asc", "tilted.txt")),
            "scene.toml:14: [terrain] file = \"tilted.txt\": tilted.txt: cannot be read: No such file or "
            "directory");
}

TEST(BadTerrain, FileAboveTheSceneIsRefused) {
  EXPECT_EQ(
      message_on_map(tilted_with("tilted.asc", "../tilted.asc")),
      "scene.toml:14: [terrain] file = \"../tilted.asc\": must lie beside the scene or below it, or be an "
      "absolute path: it is kept with the results");
}

TEST(BadTerrain, MapSmallerThanTheMeshIsNamed) {
  EXPECT_EQ(message_on_map(tilted_with("origin = [100, 50]", "origin = [100.5, 50]")),
            "scene.toml:14: [terrain] file = \"tilted.asc\": the map reaches from 100 to 102 m to the east, "
            "and the "
            "mesh from 100.5 to 102.5 m");
}

TEST(BadTerrain, MissingDataIsNamedWithItsPlace) {
  EXPECT_EQ(
      message_on_map(tilted_with("tilted.asc", "holed.asc")),
      "scene.toml:14: [terrain] file = \"holed.asc\": the map has no value at (101.75, 51.25) m, under the "
      "mesh: in its row 1 from the north, column 4");
}

/// What the reader of maps finds is put down to the key.
TEST(BadTerrain, FaultsOfTheMapItselfAreShown) {
  const auto message_of_map = [](const std::string& text) {
    std::ofstream{folder_with_maps() / "bad.asc"} << text;
    return message_on_map(tilted_with("tilted.asc", "bad.asc"));
  };
  const std::string place = "scene.toml:14: [terrain] file = \"bad.asc\": bad.asc: ";

  EXPECT_EQ(
      message_of_map("ncols 1\nnrows 1\nxllcorner 0\nyllcenter 0\ncellsize 1\n5\n"),
      place +
          "the header must have either xllcorner and yllcorner, of the outermost corner, or xllcenter and "
          "yllcenter, of the outermost cell's centre");
  EXPECT_EQ(message_of_map("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize -1\n5\n"),
            place + "cellsize must be positive and finite");
  EXPECT_EQ(message_of_map("ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n"),
            place + "holds 1 values, and ncols x nrows is 2");
}

TEST(BadTerrain, MapOfFrictionIsOfPositiveNumbersForALawThatReadsThem) {
  const std::string contact = "{law = \"material_friction\", share = 1, friction = 0.5}\n";
  std::ofstream{folder_with_maps() / "smooth.asc"}
      << "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n0\n";

  EXPECT_EQ(message_on_map(tilted_with("\"slides\"\n", contact + "friction_file = \"smooth.asc\"\n")),
            "scene.toml:18: [terrain] friction_file = \"smooth.asc\": has a value of 0, and must exceed 0");
  EXPECT_EQ(message_on_map(tilted_ground + "friction_file = \"friction.asc\"\n"),
            "scene.toml:18: [terrain] friction_file = \"friction.asc\": needs a contact whose law reads a "
            "friction, "
            "as \"material_friction\" does");
}

TEST(BadTerrain, FrictionWithoutParametersIsShownItsTable) {
  EXPECT_EQ(message_on_map(tilted_with("\"slides\"", "\"coulomb\"")),
            "scene.toml:17: [terrain] contact = \"coulomb\": a law of friction is a table: contact = {law = "
            "\"coulomb\", friction = ..}");
  EXPECT_EQ(message_on_map(tilted_with("\"slides\"", "{law = \"coulomb\", friction = -1}")),
            "scene.toml:17: [terrain.contact] friction = -1: must be at least 0 (shear traction over normal "
            "pressure [-])");
}

/// A wall across an axis has the depth of the material along it; ground and bodies have none.
TEST(BadTerrain, FrictionThatReadsTheDepthMustBeToldIt) {
  const std::string law =
      "{law = \"pouliquen_forterre\", mu_1 = 0.3, mu_2 = 0.6, mu_3 = 0.4, beta = 0.1, length_per_size = 2, "
      "weakening = 1e-3, gravity = 9.81, grain_size = 1e-3";
  const auto with_contact = [](const std::string& contact) { return tilted_with("\"slides\"", contact); };

  EXPECT_EQ(
      message_on_map(with_contact(law + "}")),
      "scene.toml:17: [terrain.contact] depth: missing, expected a number (what the law of the wall reads "
      "[m])");
  EXPECT_EQ(message_on_map(with_contact(law + ", depth = 0.5}")), "no error");
}

[[nodiscard]] std::string message_of_block(const std::string& surroundings,
                                           const std::vector<std::string>& overrides = {}) {
  return message_of([&] {
    const Simulation<2, 2> block{parse_scene(block_scene(surroundings, 0), "scene.toml", overrides).scene,
                                 {1}};
  });
}

TEST(BadTerrain, GroundThatCutsTheMaterialIsRefused) {
  EXPECT_EQ(message_of_block("[terrain]\nsurface = \"plane\"\npoint = [0, 0.2]\nnormal = [0, 1]\n"
                             "contact = \"sticks\"\n"),
            "the bed cuts the material: material point 0 at (0.025, 0.175) m is 0.025 m below it");
}

TEST(BadTerrain, GroundThatDiffersBetweenTheEndsOfAPeriodicAxisIsRefused) {
  EXPECT_EQ(
      message_of_block("[terrain]\nsurface = \"profile\"\nheights = [0.0, 0.1]\ncontact = \"sticks\"\n"),
      "[terrain] and [boundaries] x = \"periodic\": the ground must be the same at both ends of x, and "
      "differs by 0.097 m");
}

TEST(BadTerrain, GroundOutsideTheMeshIsRefused) {
  EXPECT_EQ(message_of_block("[terrain]\nsurface = \"plane\"\npoint = [0, -1]\nnormal = [0, 1]\n"
                             "contact = \"sticks\"\n"),
            "bed_nodes: the bed reaches no node of the mesh");
}

TEST(BadTerrain, NormalWithoutADirectionIsNamed) {
  EXPECT_EQ(message_of_block("[terrain]\nsurface = \"plane\"\npoint = [0, 0.1]\nnormal = [0, 0]\n"
                             "contact = \"sticks\"\n"),
            "scene.toml:27: [terrain] normal = [0, 0]: must have a direction");
}

TEST(BadTerrain, OfOtherDimensionsIsNamed) {
  EXPECT_EQ(message_of_block("[terrain]\nsurface = \"profile\"\nheights = [0.1]\ncontact = \"sticks\"\n"),
            "scene.toml:26: [terrain] heights = [0.1]: must be at least two");
  EXPECT_EQ(message_on_map("[terrain]\nsurface = \"profile\"\nheights = [0.1, 0.2]\ncontact = \"sticks\"\n"),
            "scene.toml:13: [terrain] surface = \"profile\": is for meshes of 2 dimensions");
}

const std::string ball =
    "[[bodies]]\nsurface = \"ball\"\ncentre = [0.2, 0.1]\nradius = 0.04\ncontact = \"sticks\"\n";

TEST(BadBody, ValuesAreNamedWithTheirBody) {
  EXPECT_EQ(message_of_block(with(ball, "0.04", "0")),
            "scene.toml:27: [bodies 1] radius = 0: must exceed 0 (of the ball [m])");
  EXPECT_EQ(message_of_block(ball + "speed = 1\n"),
            "scene.toml:29: [bodies 1] speed: unknown key, known here: surface, centre, radius, is_hollow, "
            "contact, "
            "velocity, angular_velocity, pivot, times, x, y, start, stop, may_overlap");
  EXPECT_EQ(message_of_block(ball + "start = 2\nstop = 1\n"),
            "scene.toml:30: [bodies 1] stop = 1: must not come before start = 2");
}

TEST(BadBody, WayIsOfAsManyPlacesAsTimesThatIncrease) {
  const auto message_of_way = [](const std::string& way) { return message_of_block(ball + way); };

  EXPECT_EQ(message_of_way("times = [0, 1]\nx = [0.2, 0.3, 0.2]\n"),
            "scene.toml:30: [bodies 1] x = [0.2, 0.3, 0.2]: must be as many as times, which are 2");
  EXPECT_EQ(message_of_way("times = [1, 1]\nx = [0.2, 0.3]\n"),
            "scene.toml:29: [bodies 1] times = [1, 1]: must increase");
  EXPECT_EQ(message_of_way("times = [0, nan]\nx = [0.2, 0.3]\n"),
            "scene.toml:29: [bodies 1] times = [0, nan]: element 2: must be finite (at which the pivot is at "
            "the places x, y, z [s])");
  EXPECT_EQ(message_of_way("times = [1]\nx = [0.2]\n"),
            "scene.toml:29: [bodies 1] times = [1]: must be at least two");
  EXPECT_EQ(message_of_way("times = [0, 1]\ny = [0.2, 0.3]\n"),
            "scene.toml:30: [bodies 1] y = [0.2, 0.3]: must begin at the pivot, 0.1");
}

TEST(BadBody, WayIsToldByTimesAndPlacesInPlaceOfAVelocity) {
  EXPECT_EQ(message_of_block(ball + "velocity = [1, 0]\ntimes = [0, 1]\nx = [0.2, 0.3]\n"),
            "scene.toml:30: [bodies 1] times = [0, 1]: stand in place of a velocity: leave one out");
  EXPECT_EQ(message_of_block(ball + "times = [0, 1]\n"),
            "scene.toml:29: [bodies 1] times = [0, 1]: need the places of the pivot along one axis at least");
  EXPECT_EQ(message_of_block(ball + "x = [0.2, 0.3]\n"),
            "scene.toml:29: [bodies 1] x = [0.2, 0.3]: needs the times at which the pivot is there");
}

/// Read back as it is printed: that of six digits would not begin there.
TEST(BadBody, WayBeginsAtThePivotToTheBit) {
  const std::string precise = with(ball, "[0.2, 0.1]", "[0.2, 0.12345678]");

  EXPECT_EQ(message_of_block(precise + "times = [0, 1]\ny = [0.123457, 0.2]\n"),
            "scene.toml:30: [bodies 1] y = [0.123457, 0.2]: must begin at the pivot, 0.12345678");
}

/// Whose pivot is then not known.
TEST(BadBody, WayOfAFaultyShapeIsNotBlamed) {
  const std::string way = "times = [0, 1]\nx = [0.2, 0.3]\n";

  EXPECT_EQ(
      message_of_block(with(ball, "\"ball\"\ncentre = [0.2, 0.1]\nradius = 0.04", "\"bal\"") + way),
      "scene.toml:25: [bodies 1] surface = \"bal\": expected one of ball, plane, stl (form of the body), "
      "did you mean 'ball'?");
  EXPECT_EQ(message_of_block(with(ball, "[0.2, 0.1]", "[0.2]") + way),
            "scene.toml:26: [bodies 1] centre = [0.2]: expected 2 values (of the ball [m]), got 1");
}

TEST(BadBody, StartAndStopBesideAWayAreOfATurn) {
  const std::string way = ball + "times = [0, 1]\nx = [0.2, 0.3]\n";

  EXPECT_EQ(message_of_block(way + "start = 0.5\n"),
            "scene.toml:31: [bodies 1] start = 0.5: is of the turn alone beside times: give an "
            "angular_velocity, or leave it out");
  EXPECT_EQ(message_of_block(way + "stop = 0.5\n"),
            "scene.toml:31: [bodies 1] stop = 0.5: is of the turn alone beside times: give an "
            "angular_velocity, or leave it out");
  EXPECT_NO_THROW(static_cast<void>(
      parse_scene(block_scene(way + "start = 0.5\nstop = 0.7\nangular_velocity = 1\n", 0), "scene.toml")));
}

TEST(BadBody, InsideTheMaterialIsRefused) {
  EXPECT_EQ(message_of_block(with(ball, "0.04", "0.085")),
            "[[bodies]] 1: as the bed cuts the material: material point 3 at (0.175, 0.175) m is 0.00594306 "
            "m below "
            "it");
}

TEST(BadBody, ImplicitViscosityKnowsNone) {
  EXPECT_EQ(message_of_block(ball, {"numerics.viscosity=implicit"}),
            "--set numerics.viscosity=implicit: viscosity is implicit without terrain and bodies only");
}

TEST(BadBoundary, WallOnAPeriodicAxisIsRefused) {
  EXPECT_EQ(
      message_of_block("", {"boundaries.x_low=slip"}),
      "--set boundaries.x_low=slip: x is periodic, so that no wall can stand there; leave out x_low, or x");
}

TEST(BadBoundary, LeavingIsOneOfThree) {
  EXPECT_EQ(
      message_of_block("", {"boundaries.leaving=ignore"}),
      "--set boundaries.leaving=ignore: expected one of stop, absorb, reflect (what becomes of a point that "
      "leaves the mesh)");
}

const std::string release = "[material]\n[[material.regions]]\nshape = \"release\"\nfile = \"depths.asc\"\n";

TEST(BadRegion, ReleaseNeedsGroundToLieOn) {
  EXPECT_EQ(
      message_on_map("", release),
      "scene.toml:14: [material.regions 1] shape = \"release\": needs the table [terrain], on which it lies");
}

TEST(BadRegion, FaultsAreNamed) {
  const auto message_of_region = [](const std::string& region) {
    return message_on_map(tilted_ground, "[material]\n[[material.regions]]\n" + region);
  };

  EXPECT_EQ(
      message_of_region("shape = \"sphere\"\n"),
      "scene.toml:20: [material.regions 1] shape = \"sphere\": expected one of box, polygon, layer, release "
      "(of the region)");
  EXPECT_EQ(message_of_region("shape = \"layer\"\nbottom = 0.5\ntop = 0.25\n"),
            "scene.toml:22: [material.regions 1] top = 0.25: must exceed bottom = 0.5");
  EXPECT_EQ(
      message_of_region("shape = \"layer\"\ntop = 2\n"),
      "scene.toml:21: [material.regions 1] top = 2: reaches out of the mesh, which ends at 1 m along y");
  EXPECT_EQ(message_of_region("shape = \"polygon\"\nx = [0, 1, 1]\ny = [0, 1]\n"),
            "scene.toml:22: [material.regions 1] y = [0, 1]: must be as many as x, which are 3");
}

TEST(BadRegion, CornersOfABoxBesideRegionsAreUnknown) {
  EXPECT_EQ(
      message_on_map(tilted_ground, with(release, "[material]\n", "[material]\nlow = [0, 0, 0]\n")),
      "scene.toml:19: [material] low: unknown key, known here: checkpoint, regions, points_per_cell, layout, "
      "surface_pressure");
}

TEST(BadRegion, MaterialInTheGroundIsRefused) {
  const auto message = message_of([] {
    const Simulation<3, 3> simulation{
        read_on_map(tilted_ground, "[material]\nlow = [0.0, 0.0, 0.0]\nhigh = [2.0, 0.5, 1.5]\n"), {1}};
  });

  // The lowest and furthest up the slope: the ground is at 0.5625 m there, 0.520833 m above it, over
  // sqrt(1.05).
  EXPECT_EQ(message,
            "the bed cuts the material: material point 2471 at (1.95833, 0.0416667, 1.45833) m is 0.508281 m "
            "below it");
}

}  // namespace
}  // namespace scree::app::testing
