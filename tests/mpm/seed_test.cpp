#include "bodies.hpp"
#include "messages.hpp"

#include <scree/mpm/seed.hpp>

#include <limits>
#include <set>

namespace scree::mpm {
namespace {

CartesianGrid<2> box() {
  return {Vector<2>{1, -1}, Vector<2>{0.1, 0.2}, {10, 10}, {false, false}};
}

TEST(SeedBox, PutsThePointsOfEachCellWhereTheyShareItEvenly) {
  const auto particles = seed_box<2, 2>(box(), Vector<2>{1, -1}, Vector<2>{1.1, -0.8}, {2, 1}, 1000);

  ASSERT_EQ(particles.size(), 2);
  EXPECT_NEAR(particles.position.component(0)[0], 1.025, 4 * round_off);
  EXPECT_NEAR(particles.position.component(0)[1], 1.075, 4 * round_off);
  EXPECT_NEAR(particles.position.component(1)[0], -0.9, 4 * round_off);
}

TEST(SeedBox, CountsThePointsOfAllCellsInTheBox) {
  const auto particles = seed_box<2, 3>(box(), Vector<2>{1, -1}, Vector<2>{1.7, 0.2}, {3, 2}, 1000);

  EXPECT_EQ(particles.size(), 7 * 3 * 6 * 2);
  std::set<double> ids{particles.id.values().begin(), particles.id.values().end()};
  EXPECT_EQ(ids.size(), static_cast<std::size_t>(particles.size()));
}

TEST(SeedBox, FillsTheBoxWithItsMass) {
  const auto particles = seed_box<2, 2>(box(), Vector<2>{1, -1}, Vector<2>{2, 1}, {3, 3}, 800);

  double mass = 0;
  for (const double m : particles.mass.values()) mass += m;
  const double expected = 800 * 1.0 * 2.0;  // [kg per metre of thickness]
  EXPECT_NEAR(mass, expected, (static_cast<double>(particles.size()) + 8) * round_off * expected);
  for (const double density : particles.density.values()) EXPECT_EQ(density, 800);
}

TEST(SeedBox, LeavesThePointsAtRest) {
  const auto particles = seed_box<2, 2>(box(), Vector<2>{1, -1}, Vector<2>{2, 1}, {1, 1}, 800);

  for (const double v : particles.velocity.values()) EXPECT_EQ(v, 0);
}

TEST(SeedBox, RefusesABoxThatReachesOutOfTheMesh) {
  EXPECT_EQ(message_of<InputError>([] {
              static_cast<void>(seed_box<2, 2>(box(), Vector<2>{1, -1}, Vector<2>{2, 1.5}, {1, 1}, 1000));
            }),
            "the material from -1.000000 to 1.500000 m along axis 1 reaches out of the mesh, which goes from "
            "-1.000000 to 1.000000 m");
}

TEST(SeedBox, RefusesABoxThatHoldsNoPoint) {
  EXPECT_EQ(message_of<InputError>([] {
              static_cast<void>(seed_box<2, 2>(box(), Vector<2>{1, -1}, Vector<2>{1.02, 1}, {1, 1}, 1000));
            }),
            "seed_box: the box is too thin to hold a point");
  EXPECT_EQ(message_of<InputError>([] {
              static_cast<void>(seed_box<2, 2>(box(), Vector<2>{1, -1}, Vector<2>{2, 1}, {1, 0}, 1000));
            }),
            "seed_box: each cell must get at least one point along each axis");
}

TEST(SeedBox, RefusesADensityThatIsNotPositive) {
  for (const double density : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(message_of<InputError>([&] {
                static_cast<void>(seed_box<2, 2>(box(), Vector<2>{1, -1}, Vector<2>{2, 1}, {1, 1}, density));
              }),
              "seed_box: density must be positive and finite");
  }
}

}  // namespace
}  // namespace scree::mpm
