// Every scene that people run, and every part that a scene can name.

#include "scenes.hpp"

#include "scree/run/run.hpp"
#include "scree/run/simulation.hpp"
#include "scree/run/stability.hpp"
#include "scree/scene/chosen.hpp"
#include "scree/scene/output_fields.hpp"
#include "scree/scene/with_dimensions.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <type_traits>

namespace scree::app::testing {
namespace {

TEST(Scenes, EachReadsAndTakesTenSteps) {
  int num_scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator{SCREE_TEST_SCENES}) {
    if (file.path().extension() != ".toml") continue;
    const Scene scene = scene_of(file.path().stem());
    with_dimensions(scene, [&](auto dimensions, auto components) {
      Simulation<dimensions(), components()> simulation{scene, {2}};
      EXPECT_EQ(softness_warning(simulation), "") << file.path();
      for (int i = 0; i < 10; ++i) simulation.step();
      EXPECT_EQ(simulation.clock.step, 10) << file.path();
      EXPECT_NO_THROW(simulation.require_stable()) << file.path();
    });
    ++num_scenes;
  }
  EXPECT_GE(num_scenes, 5);
}

TEST(Scenes, OneKeyRefinesEverything) {
  const Simulation<2, 2> coarse{scene_of("inclined_plane"), {1}};
  const Simulation<2, 2> fine{scene_of("inclined_plane", {"mesh.cells=102"}), {1}};

  EXPECT_EQ(coarse.num_points(), 2 * 50 * 9);
  EXPECT_EQ(fine.num_points(), 4 * 100 * 9);
  EXPECT_EQ(fine.grid().num_cells(), (Indices<2>{4, 102}));
}

/// A column has a sixth of the plane's points: one row of three in place of two cells' three rows.
TEST(Scenes, ColumnIsASixthOfThePlane) {
  const Simulation<2, 2> plane{scene_of("inclined_plane"), {1}};
  const Simulation<1, 2> column{scene_of("inclined_plane_column"), {1}};

  EXPECT_EQ(plane.num_points(), 6 * column.num_points());
}

/// What a scene leaves out costs nothing: no grains, no columns for them.
TEST(Scenes, WithoutGrainsNoPointCarriesThem) {
  const std::string without_grains = R"([mesh]
dimensions = 2
size = [1.0, 1.0]
cells = 4
[boundaries]
x = "periodic"
y_low = "slip"
y_high = "slip"
[material]
low = [0.0, 0.0]
high = [1.0, 0.5]
[rheology]
law = "newtonian"
viscosity = 1
bulk_modulus = 1e5
density = 1000
[time]
end = 0.1
)";
  const Simulation<2, 2> simulation{parse_scene(without_grains, "scene.toml").scene, {1}};

  constexpr std::size_t doubles = 2 + 2 + 4 + 4 + 1 + 1 + 1;  // x, v, L, sigma, m, rho, id
  EXPECT_EQ(simulation.state.particles.bytes_per_particle(), doubles * sizeof(double));
}

TEST(ListOfParts, NamesEveryPartOnALine) {
  const std::string list = list_of_parts();

  for (const char* name : {"size_dependent_newtonian",
                           "shear_rate",
                           "gravity",
                           "kurganov_tadmor",
                           "minmod",
                           "van_leer",
                           "ssp_rk3",
                           "quadratic",
                           "apic",
                           "no_slip",
                           "open",
                           "coulomb",
                           "sticks",
                           "slides",
                           "pushes_and_pulls",
                           "absorb",
                           "axisymmetric",
                           "periodic",
                           "profile",
                           "raster",
                           "stl",
                           "ball",
                           "polygon",
                           "release",
                           "random",
                           "musl",
                           "implicit",
                           "auto",
                           "log_normal",
                           "power_law",
                           "histogram",
                           "nodes",
                           "increments",
                           "oedometric"}) {
    EXPECT_NE(list.find(std::string{"\n  "} + name + " "), std::string::npos) << name;
  }
}

TEST(ListOfParts, NamesEveryFieldOfAFrame) {
  const std::string list = list_of_parts();

  for_each_entry<rheology::AnyLaw>([&]<class Law>(std::type_identity<Law>) {
    for (const std::string_view field : known_fields(true, Law{})) {
      EXPECT_TRUE(std::regex_search(list, std::regex{"[ ,;]" + std::string{field} + "( |,|\n)"}))
          << Law::name << ' ' << field;
    }
  });
}

}  // namespace
}  // namespace scree::app::testing
