// Walls with friction, by their keys in a scene: every law of the list, and flows with exact solutions.

#include "scenes.hpp"
#include "scree/run/restart.hpp"
#include "scree/run/simulation.hpp"

#include <scree/mpm/boundaries/wall_lines.hpp>
#include <scree/mpm/terrain/bed_nodes.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <typed_lists.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace scree::app::testing {
namespace {

constexpr double gravity = 9.81;  // [m/s^2]
constexpr double degree = std::numbers::pi / 180;
constexpr double depth = 0.1;  // [m]

/// A layer one cell deep down a slope, so viscous that it slides as a block, over the wall of this table.
[[nodiscard]] Scene block_over(const std::string& wall, double slope_degrees, int dimensions = 1) {
  const bool is_plane = dimensions == 2;
  return parse_scene(fmt::format(R"([mesh]
dimensions = {}
velocity_components = 2
size = [{}0.3]
cells = 3
[boundaries]
{}
y_low = {}
y_high = "slip"
[material]
low = [{}0.0]
high = [{}0.1]
points_per_cell = 2
[gravity]
slope_degrees = {}
)",
                                 dimensions, is_plane ? "0.2, " : "", is_plane ? "x = \"periodic\"" : "",
                                 wall, is_plane ? "0.0, " : "", is_plane ? "0.2, " : "", slope_degrees) +
                         viscous_block(),
                     "scene.toml")
      .scene;
}

template <int D>
void run_until(Simulation<D, 2>& simulation, double time) {
  while (simulation.clock.time < time) simulation.step();
}

/// Mass of all points [kg per area beyond D dimensions].
template <int D>
[[nodiscard]] double mass_of(const Simulation<D, 2>& simulation) {
  double sum = 0;
  for (const double mass : simulation.state.particles.mass.values()) sum += mass;
  return sum;
}

/// Mean of a velocity component [m/s].
template <int D>
[[nodiscard]] double mean_velocity(const Simulation<D, 2>& simulation, int component) {
  const auto& particles = simulation.state.particles;
  double momentum = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    momentum += particles.mass.component(0)[p] * particles.velocity.component(component)[p];
  }
  return momentum / mass_of(simulation);
}

template <class Law>
class EveryWallLaw : public ::testing::Test {};
TYPED_TEST_SUITE(EveryWallLaw, scree::testing::Each<rheology::AnyWallLaw>, scree::testing::EntryName);

/// The wall's table, of typical parameters; the material rubs as the wall of Coulomb typically does.
template <class Law>
[[nodiscard]] std::string typical_table() {
  std::string table = fmt::format("{{law = \"{}\"", Law::name);
  for (const auto& parameter : Law::parameters) {
    table += fmt::format(", {} = {}", parameter.name, parameter.typical);
  }
  for (const InputColumn& column : Law::inputs) {
    table += fmt::format(", {} = {}", column.name, column.unit == "m" ? 0.01 : 0.4);
  }
  return table + "}";
}

TYPED_TEST(EveryWallLaw, SlowsWhatSlidesAndHoldsWhatItCan) {
  constexpr double steep = 40;  // [degrees]: every law lets go, tan 40 = 0.84
  Simulation<1, 2> smooth{block_over("\"slip\"", steep), {1}};
  Simulation<1, 2> rough{block_over(typical_table<TypeParam>(), steep), {1}};
  Simulation<1, 2> held{block_over(typical_table<TypeParam>(), 5), {1}};  // tan 5 = 0.09

  for (auto* simulation : {&smooth, &rough, &held}) run_until(*simulation, 0.2);

  EXPECT_LT(mean_velocity(rough, 1), 0.95 * mean_velocity(smooth, 1));
  EXPECT_GT(mean_velocity(rough, 1), 0);
  // Held, the block creeps as a fluid of its viscosity, below the speed of its surface, rho g sin h^2/(2 mu).
  EXPECT_LT(mean_velocity(held, 1), 1000 * gravity * std::sin(5 * degree) * depth * depth / (2 * 2e4));
}

/// What a block slides on: a wall at the end of the mesh, or, a cell above it, ground or a body at rest.
const std::array<std::string, 3> bases{"wall", "[terrain]", "[[bodies]]"};

/// Such a block in the plane, over a base with the contact of this table.
[[nodiscard]] Scene block_on(const std::string& base, const std::string& table, double slope_degrees) {
  if (base == "wall") return block_over(table, slope_degrees, 2);
  return parse_scene(fmt::format(R"([mesh]
dimensions = 2
size = [0.2, 0.4]
cells = 4
[boundaries]
x = "periodic"
y_low = "slip"
y_high = "slip"
[material]
low = [0.0, 0.1]
high = [0.2, 0.2]
points_per_cell = 2
[gravity]
slope_degrees = {}
{}
surface = "plane"
point = [0, 0.1]
normal = [0, 1]
contact = {}
)",
                                 slope_degrees, base, table) +
                         viscous_block(),
                     "scene.toml")
      .scene;
}

/// Ground and bodies hold nodes as a wall there does: the same flow, but for the rounding of 2000 steps of
/// about 100 sums, of speeds up to 1 m/s, and of places of nodes that are differenced over each step.
TYPED_TEST(EveryWallLaw, DoesTheSameOnAWallOnGroundAndOnABody) {
  for (const double slope_degrees : {40, 5}) {
    Simulation<2, 2> wall{block_on("wall", typical_table<TypeParam>(), slope_degrees), {1}};
    run_until(wall, 0.2);

    for (const std::string base : {"[terrain]", "[[bodies]]"}) {
      Simulation<2, 2> other{block_on(base, typical_table<TypeParam>(), slope_degrees), {1}};
      run_until(other, 0.2);

      for (const int axis : {0, 1})
        EXPECT_NEAR(mean_velocity(other, axis), mean_velocity(wall, axis), 2000 * 100 * round_off) << base;
    }
  }
}

/// A layer of 0.1 m on a bed of Pouliquen and Forterre, and its speed there.
struct LayerThatMayStop {
  static constexpr double slope_degrees = 26.5;
  static constexpr double slowest = 0.0136;  // beta, a tenth of an ordinary one, so that the end comes soon
  static constexpr double mu_1 = 0.382;
  static constexpr double mu_2 = 0.644;

  /// @param share of h_stop that its depth is, by the size of the grains  @param speed at the start [m/s]
  LayerThatMayStop(const std::string& base, double share, double speed)
      : height{base == "wall" ? 0 : 0.1}, layer{block_on(base, table(share), slope_degrees), {1}} {
    auto& particles = layer.state.particles;
    for (Index p = 0; p < particles.size(); ++p) particles.velocity.component(0)[p] = speed;
  }
  [[nodiscard]] static std::string table(double share) {
    const double slope = std::tan(slope_degrees * degree);
    const double length = depth / share * (slope - mu_1) / (mu_2 - slope);  // L, Eq. (R168)
    return fmt::format(
        "{{law = \"pouliquen_forterre\", mu_1 = {}, mu_2 = {}, mu_3 = 0.415, beta = {}, length_per_size = 1, "
        "weakening = 1e-3, gravity = 9.81, depth = {}, grain_size = {:.17g}}}",
        mu_1, mu_2, slowest, depth, length);
  }
  /// Of its nodes on the bed [m/s].
  [[nodiscard]] std::vector<double> speeds() const {
    std::vector<double> found;
    const auto& nodes = layer.state.nodes;
    for (Index n = 0; n < nodes.num_nodes(); ++n) {
      const bool is_on_bed = std::abs(mpm::node_position(nodes, n)[1] - height) < 0.01;
      if (is_on_bed && nodes[n][mpm::NodeRecord::mass] > 0)
        found.push_back(nodes[n][mpm::NodeRecord::momentum]);
    }
    return found;
  }
  double height;  ///< of the bed [m]
  Simulation<2, 2> layer;
};

/// At the depth h > h_stop a flow comes to the speed beta sqrt(g h) h/h_stop, with a rate of 29/s that rises
/// to 40/s: less than exp(-29) is left after 1 s, beside the rounding of 10^4 steps of 100 sums. At h <
/// h_stop it is slowed by g cos (mu_stop(h) - tan), 0.029 m/s^2, at least, and stops before 1 s. What rests
/// stays if the thicker layer flows too, as its slope is below mu_start.
TEST(PouliquenForterreScene, ALayerFlowsAboveAndStopsBelowItsStoppingDepth) {  // Eqs. (R168)-(R171)
  const double slowest = LayerThatMayStop::slowest * std::sqrt(gravity * depth);
  for (const std::string& base : bases) {
    LayerThatMayStop thick{base, 1.05, 2 * slowest};
    LayerThatMayStop thin{base, 0.95, 2 * slowest};
    LayerThatMayStop resting{base, 1.05, 0};

    run_until(thick.layer, 1);
    run_until(thin.layer, 1);
    run_until(resting.layer, 0.1);

    ASSERT_GE(thick.speeds().size(), 2U);
    for (const double speed : thick.speeds()) EXPECT_NEAR(speed, 1.05 * slowest, 1e6 * round_off) << base;
    for (const double speed : thin.speeds()) EXPECT_NEAR(speed, 0, 4 * round_off / 1e-4) << base;
    for (const double speed : resting.speeds()) EXPECT_NEAR(speed, 0, 4 * round_off / 1e-4) << base;
  }
}

/// Momentum along the wall, and mu times that across, change by the weight alone as soon as the block slides.
/// It does after h^2/nu = 5e-4 s.
TEST(CoulombScene, LetsABlockSlideAtItsAcceleration) {  // Eq. (R163)
  Simulation<1, 2> block{block_over("{law = \"coulomb\", friction = 0.1}", 30), {1}};
  run_until(block, 0.02);
  const double start = block.clock.time;
  const double before = mean_velocity(block, 1) + 0.1 * mean_velocity(block, 0);

  run_until(block, 0.22);

  const double gained = mean_velocity(block, 1) + 0.1 * mean_velocity(block, 0) - before;
  const double time = block.clock.time - start;
  const double acceleration = gravity * (std::sin(30 * degree) - 0.1 * std::cos(30 * degree));
  // 2000 steps of about 100 sums, of speeds up to 1 m/s
  EXPECT_NEAR(gained, time * acceleration, 2000 * 100 * round_off);
}

/// v = sqrt(xi h (sin - mu cos)), reached as tanh(t/t_inf); after 12 of these times 2 exp(-24) is left, here
/// bound by 2 exp(-20) for what the block's own shear takes of them. Density makes h of the mass.
template <int D>
void expect_voellmys_terminal_speed() {  // Eq. (R166)
  constexpr double friction = 0.2;
  constexpr double turbulence = 10;  // [m/s^2]: so low that the end comes soon
  Simulation<D, 2> layer{
      block_over("{law = \"voellmy\", friction = 0.2, turbulence = 10, density = 1000, gravity = 9.81}", 30,
                 D),
      {1}};
  const double slope = std::sin(30 * degree) - friction * std::cos(30 * degree);
  const double length = D == 2 ? 0.2 : 1;
  const double terminal = std::sqrt(turbulence * mass_of(layer) / (1000 * length) * slope);

  run_until(layer, 12 * terminal / (gravity * slope));

  const auto axis = static_cast<std::size_t>(D - 1);
  const int along = D == 1 ? 1 : 0;
  mpm::for_each_wall_line(
      layer.state.nodes, axis, mpm::Side::low, [&](double*, const double* wall, double*, Index) {
        if (wall[mpm::NodeRecord::mass] == 0) return;
        EXPECT_NEAR(wall[mpm::NodeRecord::momentum + along], terminal, 2 * std::exp(-20) * terminal);
      });
}

TEST(VoellmyScene, TakesAColumnToItsTerminalSpeed) {
  expect_voellmys_terminal_speed<1>();
}

TEST(VoellmyScene, TakesALayerToItsTerminalSpeed) {
  expect_voellmys_terminal_speed<2>();
}

[[nodiscard]] FrictionScene low_wall_of(const std::string& text) {
  return std::get<FrictionScene>(parse_scene(text, "scene.toml").scene.axes[0].low);
}

/// The small scene with another base.
[[nodiscard]] std::string with_base(const std::string& wall) {
  std::string text = small_scene();
  const std::string base = "\"no_slip\"";
  return text.replace(text.find(base), base.size(), wall);
}

TEST(WallScene, ReadsWhatItsLawReadsFromTheScene) {
  const std::string law =
      "law = \"pouliquen_forterre\", mu_1 = 0.3, mu_2 = 0.6, mu_3 = 0.4, beta = 0.1, length_per_size = 2, "
      "weakening = 1e-3, gravity = 9.81";

  EXPECT_EQ(low_wall_of(with_base("{" + law + "}")).inputs, (std::vector<double>{0.75, 0.75e-3}));
  EXPECT_EQ(low_wall_of(with_base("{" + law + ", depth = 0.5, grain_size = 0.001}")).inputs,
            (std::vector<double>{0.5, 0.001}));
}

TEST(WallScene, IsAsRoughAsTheMaterial) {
  std::string text = with_base("{law = \"material_friction\", share = 0.5}");
  const std::string fluid = "law = \"size_dependent_newtonian\"\nviscosity_per_size = 1e6\n";
  text.replace(text.find(fluid), fluid.size(),
               "law = \"drucker_prager\"\nfriction = 0.6\nshear_modulus = 1e6\n");

  EXPECT_EQ(low_wall_of(text).inputs, (std::vector<double>{0.6}));
}

TEST(WallScene, IsAsRoughAsGrainsThatBeginToFlow) {
  std::string text = with_base("{law = \"material_friction\", share = 0.5}");
  const std::string fluid = "law = \"size_dependent_newtonian\"\nviscosity_per_size = 1e6\n";
  text.replace(text.find(fluid), fluid.size(),
               "law = \"mu_of_i\"\nmu_s = 0.35\nmu_2 = 0.6\nI_0 = 0.3\ngrain_density = 2500\n"
               "shear_rate_floor = 1\n");

  EXPECT_EQ(low_wall_of(text).inputs, (std::vector<double>{0.35}));
}

TEST(WallScene, ReadsAColumnOfTheMaterialByItsName) {
  const FrictionScene wall = low_wall_of(
      with_base("{law = \"pouliquen_forterre\", mu_1 = 0.3, mu_2 = 0.6, mu_3 = 0.4, beta = 0.1, "
                "length_per_size = 2, weakening = 1e-3, gravity = 9.81, grain_size = \"grain_size\"}"));

  EXPECT_EQ(wall.of_material, (std::vector<std::string>{"", "grain_size"}));
  EXPECT_EQ(wall.inputs[0], 0.75);
}

/// Fine and coarse grains that rub unlike each other, a layer down a slope over a wall as rough as they are.
[[nodiscard]] Scene mixed_layer(const std::string& friction, const std::string& segregation,
                                const std::string& material = "low = [0.0]\nhigh = [0.2]") {
  return parse_scene(R"([mesh]
dimensions = 1
velocity_components = 2
size = [0.4]
cells = 8
[boundaries]
y_low = {law = "material_friction", share = 1)" +
                         friction + R"(}
y_high = "slip"
[material]
)" + material + R"(
[gravity]
slope_degrees = 30
[rheology]
law = "mixture_mu_of_i"
mu_s_fine = 0.3
mu_s_coarse = 0.5
mu_2_fine = 0.644
mu_2_coarse = 0.781
I_0_fine = 0.279
I_0_coarse = 0.279
grain_density = 2500
shear_rate_floor = 1
bulk_modulus = 1e5
density = 1500
[grains]
diameters = [1e-3, 2e-3]
fractions = [0.5, 0.5]
[numerics]
maximum_dt = 5e-4
[time]
end = 100
)" + segregation,
                     "scene.toml")
      .scene;
}

const std::string segregates = "[segregation]\nclosure = \"shear_rate\"\nc = 0.05\nevery = 1\n";

/// mu of the mix that the law of the layer has at a coarse fraction, Eq. (R76), as the wall node should have
/// it by linear shapes, Eq. (M170).
[[nodiscard]] double friction_at_wall(const mpm::Particles<1, 2>& particles) {
  const mpm::Column& fractions = particles.column(particles.find_column("fraction", "the test"));
  double mass = 0;
  double sum = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double hat = std::max(0.0, 1 - particles.position.component(0)[p] / 0.05);
    mass += hat * particles.mass.component(0)[p];
    sum += hat * particles.mass.component(0)[p] * (0.3 + 0.2 * fractions.component(1)[p]);
  }
  return sum / mass;
}

/// When grains have segregated the wall rubs as those do that have come to it: in each step momentum along it
/// and that mu times the one across change by the weight alone.
TEST(MaterialFrictionScene, IsThatOfTheGrainsAtTheWall) {
  Simulation<1, 2> layer{mixed_layer("", segregates), {1}};
  run_until(layer, 0.5);

  for (int n = 0; n < 20; ++n) {
    const double mu = friction_at_wall(layer.state.particles);
    const double before = mean_velocity(layer, 1) + mu * mean_velocity(layer, 0);
    const double moved = layer.clock.moved;
    layer.step();

    EXPECT_GT(std::abs(mu - 0.4), 1e-3);  // of the mix at the start
    EXPECT_NEAR(layer.state.nodes.means(1)[0], mu, 100 * round_off);
    const double gained = mean_velocity(layer, 1) + mu * mean_velocity(layer, 0) - before;
    const double slope = gravity * (std::sin(30 * degree) - mu * std::cos(30 * degree));
    // A step of about 100 sums, of speeds up to 5 m/s
    EXPECT_NEAR(gained, (layer.clock.moved - moved) * slope, 100 * 5 * round_off);
  }
}

[[nodiscard]] std::vector<double> motion_of(const Simulation<1, 2>& simulation) {
  const auto x = simulation.state.particles.position.values();
  const auto v = simulation.state.particles.velocity.values();
  std::vector<double> all{x.begin(), x.end()};
  all.insert(all.end(), v.begin(), v.end());
  return all;
}

TEST(MaterialFrictionScene, OfGrainsThatStayIsTheNumberItIsToTheBit) {
  Simulation<1, 2> carried{mixed_layer("", ""), {1}};
  const auto& particles = carried.state.particles;
  const double mu = particles.column(particles.find_column("friction", "the test")).component(0)[0];
  Simulation<1, 2> constant{mixed_layer(fmt::format(", friction = {:.17g}", mu), ""), {1}};

  for (auto* simulation : {&carried, &constant}) run_until(*simulation, 0.1);

  EXPECT_FALSE(constant.state.particles.column_named("friction"));
  EXPECT_EQ(motion_of(carried), motion_of(constant));
}

TEST(MaterialFrictionScene, GoesOnFromACheckpointBitForBit) {
  const auto file = std::filesystem::path{::testing::TempDir()} / "scree_material_friction.h5";
  Simulation<1, 2> unbroken{mixed_layer("", segregates), {1}};
  run_until(unbroken, 0.1);
  write_checkpoint(unbroken, file, "");
  Simulation<1, 2> restarted{mixed_layer("", segregates), {1}};
  read_checkpoint_into(restarted, file);

  for (auto* simulation : {&unbroken, &restarted}) run_until(*simulation, 0.2);

  EXPECT_EQ(motion_of(unbroken), motion_of(restarted));
}

/// Layers that go on where another was after 0.1 s: by its checkpoint, and with its points as material.
[[nodiscard]] std::array<Simulation<1, 2>, 2> gone_on(const Scene& before, const std::string& friction) {
  const auto file = std::filesystem::path{::testing::TempDir()} / "scree_other_friction.h5";
  Simulation<1, 2> first{before, {1}};
  run_until(first, 0.1);
  write_checkpoint(first, file, "");
  std::array<Simulation<1, 2>, 2> layers{
      {{mixed_layer(friction, ""), {1}},
       {mixed_layer(friction, "", "checkpoint = \"" + file.string() + "\""), {1}}}};
  read_checkpoint_into(layers[0], file);
  return layers;
}

/// What walls read of the material is no state of it. The mix of halves rubs by 0.4, (R76), which the wall
/// node has to round-off of the mean.
TEST(MaterialFrictionScene, FollowsAWallThatHadANumber) {
  for (Simulation<1, 2>& layer : gone_on(mixed_layer(", friction = 0.2", ""), "")) {
    layer.step();

    EXPECT_NEAR(layer.state.nodes.means(1)[0], 0.4, 100 * round_off);
  }
}

TEST(MaterialFrictionScene, IsFollowedByAWallThatHasANumber) {
  for (Simulation<1, 2>& layer : gone_on(mixed_layer("", ""), ", friction = 0.2")) {
    EXPECT_FALSE(layer.state.particles.column_named("friction"));
    const double before = mean_velocity(layer, 1) + 0.2 * mean_velocity(layer, 0);
    const double moved = layer.clock.moved;

    layer.step();

    const double gained = mean_velocity(layer, 1) + 0.2 * mean_velocity(layer, 0) - before;
    const double slope = gravity * (std::sin(30 * degree) - 0.2 * std::cos(30 * degree));
    // A step of about 100 sums, of speeds up to 5 m/s
    EXPECT_NEAR(gained, (layer.clock.moved - moved) * slope, 100 * 5 * round_off);
  }
}

TEST(WallScene, PullsIfTold) {
  EXPECT_EQ(low_wall_of(with_base("{law = \"coulomb\", friction = 0.4}")).hold, mpm::Hold::pushes);
  EXPECT_EQ(low_wall_of(with_base("{law = \"coulomb\", friction = 0.4, hold = \"pushes_and_pulls\"}")).hold,
            mpm::Hold::pushes_and_pulls);
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

TEST(BadWall, UnknownNameIsAnsweredWithTheKnownOnes) {
  EXPECT_EQ(message_of(with_base("\"rough\"")),
            "scene.toml:7: [boundaries] y_low = \"rough\": expected one of no_slip, slip, coulomb, "
            "material_friction, pouliquen_forterre, voellmy, open (wall at the low end)");
  EXPECT_EQ(message_of(with_base("{law = \"no_slip\"}")),
            "scene.toml:7: [boundaries.y_low] law = \"no_slip\": expected one of coulomb, material_friction, "
            "pouliquen_forterre, voellmy (friction of the wall)");
}

TEST(BadWall, FrictionWithoutParametersIsShownItsTable) {
  EXPECT_EQ(message_of(with_base("\"coulomb\"")),
            "scene.toml:7: [boundaries] y_low = \"coulomb\": a wall with friction is a table: y_low = {law = "
            "\"coulomb\", friction = ..}");
}

TEST(BadWall, MissingAndUnknownKeysAreNamed) {
  EXPECT_EQ(
      message_of(with_base("{law = \"coulomb\", fricton = 0.4}")),
      "scene.toml:7: [boundaries.y_low] friction: missing, expected a number (shear traction over normal "
      "pressure [-])\n"
      "scene.toml:7: [boundaries.y_low] fricton: unknown key, did you mean 'friction'?");
}

TEST(BadWall, ValueOutOfRangeIsNamed) {
  EXPECT_EQ(
      message_of(with_base("{law = \"coulomb\", friction = -0.4}")),
      "scene.toml:7: [boundaries.y_low] friction = -0.4: must be at least 0 (shear traction over normal "
      "pressure [-])");
  EXPECT_EQ(message_of(with_base("{law = \"coulomb\", friction = 0.4}"), {"boundaries.y_low.friction=nan"}),
            "--set boundaries.y_low.friction=nan: must be finite (shear traction over normal pressure [-])");
}

TEST(BadWall, ParametersThatContradictEachOtherAreNamed) {
  EXPECT_EQ(message_of(with_base("{law = \"pouliquen_forterre\", mu_1 = 0.4, mu_2 = 0.3, mu_3 = 0.5, beta = "
                                 "0.1, length_per_size = 2, weakening = 1e-3, gravity = 9.81}")),
            "scene.toml:7: [boundaries.y_low] mu_2 = 0.3: must exceed mu_1 = 0.4");
}

TEST(BadWall, InputThatTheSceneDoesNotHaveIsMissing) {
  EXPECT_EQ(message_of(with_base("{law = \"material_friction\", share = 0.5}")),
            "scene.toml:7: [boundaries.y_low] friction: missing, expected a number (what the law of the wall "
            "reads [-])");
  EXPECT_EQ(
      message_of(with_base("{law = \"material_friction\", share = 0.5, friction = 0}")),
      "scene.toml:7: [boundaries.y_low] friction = 0: must exceed 0 (what the law of the wall reads [-])");
}

TEST(BadWall, ColumnThatTheMaterialDoesNotHaveIsAnsweredWithThoseItHas) {
  EXPECT_EQ(
      message_of(with_base("{law = \"pouliquen_forterre\", mu_1 = 0.3, mu_2 = 0.6, mu_3 = 0.4, beta = 0.1, "
                           "length_per_size = 2, weakening = 1e-3, gravity = 9.81, grain_size = \"size\"}")),
      "scene.toml:7: [boundaries.y_low] grain_size = \"size\": expected one of grain_size (a number, or what "
      "the law of the wall reads of the material [m])");
  EXPECT_EQ(
      message_of(with_base("{law = \"material_friction\", share = 0.5, friction = \"friction\"}")),
      "scene.toml:7: [boundaries.y_low] friction = \"friction\": expected a number (what the law of the wall "
      "reads [-]), got a string");
}

TEST(BadWall, ImplicitViscosityKnowsNoFriction) {
  EXPECT_EQ(
      message_of(with_base("{law = \"coulomb\", friction = 0.4}") + "[numerics]\nviscosity = \"auto\"\n"),
      "scene.toml:27: [numerics] viscosity = \"auto\": viscosity is implicit for walls without friction "
      "only");
}

TEST(BadWall, ImplicitViscosityKnowsNoOpenEnd) {
  EXPECT_EQ(message_of(with_base("\"open\"") + "[numerics]\nviscosity = \"implicit\"\n"),
            "scene.toml:27: [numerics] viscosity = \"implicit\": viscosity is implicit without \"open\" ends "
            "only");
}

}  // namespace
}  // namespace scree::app::testing
