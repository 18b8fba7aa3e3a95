#include "messages.hpp"

#include <scree/mpm/terrain/bed_nodes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace scree::mpm {
namespace {

template <int D>
[[nodiscard]] CartesianGrid<D> box(Index num_cells, double spacing) {
  Indices<D> count{};
  count.fill(num_cells);
  return {Vector<D>::Zero(), Vector<D>::Constant(spacing), count, {}};
}

TEST(PlaneSurface, IsAsFarAsItsNormalSays) {
  const PlaneSurface<2> plane{Vector<2>{1, 1}, Vector<2>{3, 4}};

  EXPECT_NEAR(plane(Vector<2>{2, 1}).distance, 0.6, 4 * round_off);
  EXPECT_NEAR(plane(Vector<2>{1, 0}).distance, -0.8, 4 * round_off);
  EXPECT_NEAR((plane(Vector<2>{0, 0}).normal - Vector<2>{0.6, 0.8}).norm(), 0, 4 * round_off);
}

TEST(BallSurface, HasMaterialInsideOrOutside) {
  using Material = BallSurface<3>::Material;
  const Vector<3> centre{1, 0, 0};
  const Vector<3> x{1, 0, 3};

  const auto pit = BallSurface<3>{centre, 5, Material::inside}(x);
  const auto hill = BallSurface<3>{centre, 5, Material::outside}(x);

  EXPECT_EQ(pit.distance, 2);
  EXPECT_EQ(pit.normal, (Vector<3>{0, 0, -1}));
  EXPECT_EQ(hill.distance, -2);
  EXPECT_EQ(hill.normal, (Vector<3>{0, 0, 1}));
}

/// F/|grad F| is wrong by the square of the distance times the curvature over two, here of F = r^2 - 1.
TEST(LevelSurface, IsExactToTheSquareOfTheDistance) {  // Eq. (M60)
  const LevelSurface<2> circle{[](const Vector<2>& x) { return x.squaredNorm() - 1; }, 1e-4};
  for (const double distance : {0.1, 0.05, -0.05}) {
    const auto seen = circle(Vector<2>{1 + distance, 0});

    EXPECT_NEAR(seen.distance, distance - distance * distance / 2, std::pow(std::abs(distance), 3));
    EXPECT_NEAR(seen.normal[0], 1, 1e-8);  // the square of the step
  }
}

/// Those with a place below the bed inside the cells around them; a plane is lowest in a corner.
TEST(BedNodes, AreThoseWhoseHatFeelsTheBed) {  // Eq. (M61)
  const auto grid = box<2>(10, 0.1);
  const PlaneSurface<2> plane{Vector<2>{0.03, 0.41}, Vector<2>{-1, 3}};

  const std::vector<BedNode> held = bed_nodes<2>(grid, plane);

  const Nodes<2> nodes{grid, {.num_velocities = 1, .has_increment = false}};
  std::vector<Index> expected;
  for (Index n = 0; n < nodes.num_nodes(); ++n) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const double dx : {-0.1, 0.1}) {
      for (const double dy : {-0.1, 0.1}) {
        lowest = std::min(lowest, plane(node_position(nodes, n) + Vector<2>{dx, dy}).distance);
      }
    }
    if (lowest < 0) expected.push_back(n);
  }
  std::vector<Index> actual;
  actual.reserve(held.size());
  for (const BedNode& node : held) actual.push_back(node.node);
  EXPECT_EQ(actual, expected);
}

TEST(BedNodes, OfABedThroughNodesAreNoneAboveIt) {
  const auto grid = box<2>(10, 0.1);

  for (const BedNode& node : bed_nodes<2>(grid, PlaneSurface<2>{Vector<2>{0, 0.3}, Vector<2>{0, 1}})) {
    const Nodes<2> nodes{grid, {.num_velocities = 1, .has_increment = false}};
    EXPECT_LE(node_position(nodes, node.node)[1], 0.3 + 4 * round_off);
  }
}

/// Sum of what the nodes stand for.
template <int D>
[[nodiscard]] double area_of(const CartesianGrid<D>& grid, const AnySurface<D>& surface) {
  double sum = 0;
  for (const BedNode& node : bed_nodes<D>(grid, surface)) sum += node.area;
  return sum;
}

TEST(BedNodes, StandForAllOfAPlane) {  // Eq. (M62)
  EXPECT_NEAR((area_of<1>(box<1>(10, 0.1), PlaneSurface<1>{Vector<1>{0.333}, Vector<1>{1.0}})), 1, 1e-8);
  // A length is cut at the sides of the mesh to a sample, an eighth of a cell, at both ends.
  for (const double slope : {0.0, 0.2, 0.5, 1.0, 3.0}) {
    const double length = std::sqrt(1 + slope * slope) * std::min(1.0, 1 / std::max(slope, 1e-9));
    const PlaneSurface<2> line{Vector<2>{0.5, 0.5}, Vector<2>{-slope, 1}};
    EXPECT_NEAR((area_of<2>(box<2>(10, 0.1), line)), length, 2 * 0.1 / 8) << slope;
  }
}

/// A ball is smooth: its area comes with the error of the samples, h/4 along each axis, squared over its
/// radius.
TEST(BedNodes, StandForAllOfABall) {
  const BallSurface<3> ball{Vector<3>{0.5, 0.47, 0.52}, 0.3, BallSurface<3>::Material::outside};

  const double area = 4 * std::numbers::pi * 0.3 * 0.3;
  EXPECT_NEAR((area_of<3>(box<3>(10, 0.1), ball)), area, area * std::pow(0.1 / 4 / 0.3, 2) * 3);
}

TEST(BedNodes, KnowNothingWhereTheSurfaceDoesNot) {
  const auto grid = box<1>(10, 0.1);
  const auto half_known = [](const Vector<1>& x) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return FromSurface<1>{x[0] < 0.15 ? nan : x[0] - 0.52, Vector<1>{1.0}};
  };

  EXPECT_EQ((bed_nodes<1>(grid, half_known).size()), 5);  // 0.2 to 0.6; the hat of the last reaches 0.5
}

TEST(BedNodes, RefuseABedOutsideOfTheMesh) {
  EXPECT_EQ(
      message_of<InputError>([] {
        static_cast<void>(bed_nodes<2>(box<2>(4, 0.1), PlaneSurface<2>{Vector<2>{0, -1}, Vector<2>{0, 1}}));
      }),
      "bed_nodes: the bed reaches no node of the mesh");
}

TEST(Surfaces, RefuseWhatIsNoSurface) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of<InputError>([] {
              PlaneSurface<2>{Vector<2>{0, 0}, Vector<2>{0, 0}};
            }),
            "PlaneSurface: the normal must have a direction");
  EXPECT_EQ(message_of<InputError>([nan] {
              PlaneSurface<2>{Vector<2>{0, nan}, Vector<2>{0, 1}};
            }),
            "PlaneSurface: the point must be finite");
  EXPECT_EQ(message_of<InputError>([] {
              BallSurface<2>{Vector<2>{0, 0}, 0, BallSurface<2>::Material::inside};
            }),
            "BallSurface: the radius must be positive and finite");
  EXPECT_EQ(message_of<InputError>([nan] {
              BallSurface<2>{Vector<2>{nan, 0}, 1, BallSurface<2>::Material::inside};
            }),
            "BallSurface: the centre must be finite");
  EXPECT_EQ(message_of<InputError>([] {
              LevelSurface<2>{[](const Vector<2>&) { return 0.0; }, 0};
            }),
            "LevelSurface: the step must be positive and finite");
}

}  // namespace
}  // namespace scree::mpm
