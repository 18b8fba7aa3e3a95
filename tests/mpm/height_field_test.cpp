#include "messages.hpp"

#include <scree/mpm/terrain/height_field.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace scree::mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A raster of `height(x, y)` with n cells of edge 1/n along each axis, its corner in the origin.
template <class Height>
[[nodiscard]] Raster raster_of(Index n, Height&& height) {
  const double edge = 1 / static_cast<double>(n);
  Raster raster{n, n, Vector<2>{edge / 2, edge / 2}, edge, {}};
  for (Index row = 0; row < n; ++row) {
    for (Index column = 0; column < n; ++column) {
      raster.values.push_back(
          height((static_cast<double>(column) + 0.5) * edge, (static_cast<double>(row) + 0.5) * edge));
    }
  }
  return raster;
}

TEST(HeightField, IsExactForAPlaneUpToTheEdgeOfTheRaster) {  // Eq. (M64)
  const HeightField<3> bed{map_field(raster_of(4, [](double x, double y) { return 1 + 2 * x - 2 * y; }))};

  for (const double x : {0.0, 0.1, 0.5, 1.0}) {
    const auto seen = bed(Vector<3>{x, 0.3, 2});

    EXPECT_NEAR(seen.distance, (2 - (1 + 2 * x - 0.6)) / 3, 16 * round_off);  // sqrt(1 + 4 + 4) = 3
    EXPECT_NEAR((seen.normal - Vector<3>{-2, 2, 1} / 3).norm(), 0, 64 * round_off);
  }
}

/// Of the height, by linear interpolation: at most h^2/8 times the second derivative along each axis.
TEST(HeightField, IsOfSecondOrderOnSmoothGround) {
  const auto height = [](double x, double y) { return 0.1 * std::sin(5 * x) * std::cos(5 * y); };
  double before = 0;
  for (const Index n : {20, 40, 80}) {
    const MapField<2> bed = map_field(raster_of(n, height));
    double worst = 0;
    for (double x = 0.1; x < 0.9; x += 0.0137) {
      for (double y = 0.1; y < 0.9; y += 0.0173) {
        worst = std::max(worst, std::abs(bed(Vector<2>{x, y}).value - height(x, y)));
      }
    }
    const double h = 1 / static_cast<double>(n);
    EXPECT_LE(worst, 2 * h * h / 8 * 0.1 * 25);
    if (before > 0) {
      EXPECT_GT(std::log2(before / worst), 1.9);
    }
    before = worst;
  }
}

TEST(HeightField, OfAProfileIsALineInTwoDimensions) {
  const HeightField<2> bed{MapField<1>{{.count = {3}, .spacing = Vector<1>{2.0}, .first = Vector<1>{0.0}},
                                       std::vector<double>{0, 1.5, 1.5}}};

  EXPECT_NEAR((bed(Vector<2>{1, 2}).distance), 1.25 * 0.8, 4 * round_off);
  EXPECT_NEAR((bed(Vector<2>{3, 2}).distance), 0.5, 4 * round_off);
}

TEST(HeightField, KnowsNothingBesideMissingDataAndBeyondTheRaster) {
  Raster raster = raster_of(4, [](double, double) { return 1.0; });
  raster.values[5] = nan;  // centre (0.375, 0.375)
  const HeightField<3> bed{map_field(raster)};

  EXPECT_TRUE(std::isnan(bed(Vector<3>{0.5, 0.5, 2}).distance));
  EXPECT_FALSE(std::isnan(bed(Vector<3>{0.65, 0.5, 2}).distance));
  EXPECT_TRUE(std::isnan(bed(Vector<3>{1.01, 0.9, 2}).distance));
  EXPECT_FALSE(std::isnan(bed(Vector<3>{0.99, 0.9, 2}).distance));
  EXPECT_EQ(bed(Vector<3>{0.5, 0.5, 2}).normal, (Vector<3>{0, 0, 1}));
}

TEST(MapField, RefusesWhatIsNoMap) {
  EXPECT_EQ(message_of<InputError>([] {
              static_cast<void>(map_field({1, 2, Vector<2>{0, 0}, 1, {1, 2}}));
            }),
            "MapField: needs at least two sites along each axis");
  EXPECT_EQ(message_of<InputError>([] {
              static_cast<void>(map_field({2, 2, Vector<2>{0, 0}, 1, {1, 2}}));
            }),
            "MapField: has 2 values for 4 sites");
  EXPECT_EQ(message_of<InputError>([] {
              static_cast<void>(map_field({2, 2, Vector<2>{0, 0}, 0, {1, 2, 3, 4}}));
            }),
            "MapField: the spacing must be positive and finite");
  EXPECT_EQ(message_of<InputError>([] {
              static_cast<void>(map_field({2, 2, Vector<2>{0, nan}, 1, {1, 2, 3, 4}}));
            }),
            "MapField: the first site must be finite");
}

}  // namespace
}  // namespace scree::mpm
