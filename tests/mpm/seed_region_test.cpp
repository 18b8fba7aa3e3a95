#include "bodies.hpp"
#include "messages.hpp"

#include <scree/mpm/seed_region.hpp>
#include <scree/mpm/terrain/height_field.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace scree::mpm {
namespace {

[[nodiscard]] double mass_of(const auto& particles) {
  double sum = 0;
  for (const double m : particles.mass.values()) sum += m;
  return sum;
}

/// A box [0, 0.5] of a mesh [0, 1]^2 with eight cells along each axis.
[[nodiscard]] double in_low_half(const Vector<2>& x) {
  return x[1] < 0.5 ? 1000 : 0;
}

TEST(SeedRegion, LaysThePointsOfABoxAsSeedBoxDoes) {
  const auto grid = cube<2>(8, 0.125, false);

  const auto region = seed_region<2, 2>(grid, {.per_cell = {2, 3}}, in_low_half);
  const auto box = seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{1, 0.5}, {2, 3}, 1000);

  ASSERT_EQ(region.size(), box.size());
  for (Index p = 0; p < box.size(); ++p) {
    EXPECT_NEAR(region.position.component(0)[p], box.position.component(0)[p], 4 * round_off);
    EXPECT_NEAR(region.position.component(1)[p], box.position.component(1)[p], 4 * round_off);
    EXPECT_NEAR(region.mass.component(0)[p], box.mass.component(0)[p], 16 * round_off);
  }
}

TEST(SeedRegion, LaysLayersOfTheirDensities) {
  const auto particles = seed_region<1, 1>(cube<1>(10, 0.1, false), {.per_cell = {2}},
                                           [](const Vector<1>& x) { return x[0] < 0.3 ? 2000.0 : 1000.0; });

  EXPECT_NEAR(mass_of(particles), 2000 * 0.3 + 1000 * 0.7, 20 * 1300 * round_off);
}

/// The area of a triangle is met by shares that lie in it to half a share along its edges.
TEST(SeedRegion, FillsAPolygon) {
  const std::array<Vector<2>, 3> triangle{Vector<2>{0.1, 0.1}, Vector<2>{0.9, 0.2}, Vector<2>{0.3, 0.8}};
  const auto particles =
      seed_region<2, 2>(cube<2>(16, 0.0625, false), {.per_cell = {4, 4}},
                        [&](const Vector<2>& x) { return is_in_polygon(triangle, x) ? 1.0 : 0.0; });

  const double area = (0.8 * 0.7 - 0.2 * 0.1) / 2;
  EXPECT_NEAR(mass_of(particles), area, 2.3 * 0.0625 / 4 / 2);  // its edges are 2.3 m long
}

TEST(IsInPolygon, KnowsTheNotchOfOneThatIsNotConvex) {
  const std::array<Vector<2>, 5> notched{Vector<2>{0, 0}, Vector<2>{4, 0}, Vector<2>{4, 4}, Vector<2>{2, 1},
                                         Vector<2>{0, 4}};

  EXPECT_TRUE(is_in_polygon(notched, Vector<2>{0.5, 2}));
  EXPECT_TRUE(is_in_polygon(notched, Vector<2>{3.5, 2}));
  EXPECT_FALSE(is_in_polygon(notched, Vector<2>{2, 2}));
  EXPECT_FALSE(is_in_polygon(notched, Vector<2>{5, 0}));
}

TEST(SeedRegion, DrawsPlacesInTheirSharesTheSameEachTime) {
  const auto grid = cube<2>(8, 0.125, false);
  const auto regular = seed_region<2, 2>(grid, {.per_cell = {2, 2}}, in_low_half);
  const auto drawn = seed_region<2, 2>(grid, {.per_cell = {2, 2}, .random_seed = 5}, in_low_half);
  const auto again = seed_region<2, 2>(grid, {.per_cell = {2, 2}, .random_seed = 5}, in_low_half);
  const auto other = seed_region<2, 2>(grid, {.per_cell = {2, 2}, .random_seed = 6}, in_low_half);

  ASSERT_EQ(drawn.size(), regular.size());
  for (Index p = 0; p < drawn.size(); ++p) {
    const double x = drawn.position.component(0)[p];
    EXPECT_EQ(x, again.position.component(0)[p]);
    EXPECT_NE(x, other.position.component(0)[p]);
    EXPECT_LE(std::abs(x - regular.position.component(0)[p]), 0.0625 / 2 * (1 + 4 * round_off));
  }
  // 64-bit Mersenne twister with seed 5: its first number is fixed by the standard.
  std::mt19937_64 random{5};
  EXPECT_EQ(drawn.position.component(0)[0],
            0.03125 + (static_cast<double>(random() >> 11) / 9007199254740992.0 - 0.5) * 0.0625);
}

/// A release is a depth over each place of a map, on the ground: what lies between both heights.
TEST(SeedRegion, LaysAReleaseOnTerrain) {
  const auto plane = [](double low, double slope) {
    return MapField<1>{{.count = {2}, .spacing = Vector<1>{1.0}, .first = Vector<1>{0.0}},
                       {low, low + slope}};
  };
  const auto ground = plane(0.1, 0.3);
  const auto depth = plane(0.2, 0.1);
  const auto particles =
      seed_region<2, 2>(cube<2>(16, 0.0625, false), {.per_cell = {4, 4}}, [&](const Vector<2>& x) {
        const double height = x[1] - ground(x.head<1>()).value;
        return 0 < height && height < depth(x.head<1>()).value ? 1.0 : 0.0;
      });

  EXPECT_NEAR(mass_of(particles), 0.25, 2 * 1.05 * 0.0625 / 4 / 2);  // two edges, half a share
}

TEST(CellFilling, TellsOfCellsWithTooFewPoints) {
  const auto grid = cube<2>(8, 0.125, false);
  const auto cut = seed_region<2, 2>(grid, {.per_cell = {2, 2}},
                                     [](const Vector<2>& x) { return x[1] < 0.3125 ? 1.0 : 0.0; });

  const CellFilling filling = cell_filling(cut, grid, 4);

  EXPECT_EQ(filling.num_filled, 8 * 3);
  EXPECT_EQ(filling.num_too_few, 8);  // the half filled ones on top
  EXPECT_EQ(filling.fewest, 2);
}

TEST(SeedRegion, RefusesWhatHoldsNoMaterial) {
  const auto grid = cube<1>(4, 0.25, false);
  const auto fault = [&](Index per_cell, double density) {
    return message_of<InputError>([&] {
      static_cast<void>(
          seed_region<1, 1>(grid, {.per_cell = {per_cell}}, [=](const Vector<1>&) { return density; }));
    });
  };
  EXPECT_EQ(fault(0, 1), "seed_region: each cell must get at least one point along each axis");
  EXPECT_EQ(fault(1, std::nan("")), "seed_region: no place of the mesh lies in the region");
  EXPECT_EQ(fault(1, std::numeric_limits<double>::infinity()), "seed_region: the density must be finite");
}

}  // namespace
}  // namespace scree::mpm
