#include "bodies.hpp"

#include <scree/mpm/nodes.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace scree::mpm {
namespace {

TEST(NodeRecord, HasAFourForMassAndMomentumAndAnotherForForces) {
  for (const int num_velocities : {1, 2, 3}) {
    EXPECT_LE(NodeRecord::momentum + num_velocities, 4);
    EXPECT_EQ((NodeRecord{num_velocities, false}.size()), 4);
    EXPECT_EQ((NodeRecord{num_velocities, true}.increment()), 4);
    EXPECT_EQ((NodeRecord{num_velocities, true}.size()), 8);
  }
}

TEST(Nodes, HaveOneLayerOfImagesPastAWall) {
  const Nodes<2> nodes{cube<2>(5, 0.1, false), {2, false}};

  EXPECT_EQ(nodes.first(0), -1);
  EXPECT_EQ(nodes.count(0), 8);  // six nodes of five cells, two images
  EXPECT_EQ(nodes.num_nodes(), 64);
  EXPECT_EQ(nodes.place(-1, 0), 0);
  EXPECT_EQ(nodes.place(6, 0), 7);
  EXPECT_EQ(nodes.place(-2, 0), -1);
  EXPECT_EQ(nodes.place(7, 0), -1);
}

/// Every node in use, in order.
template <int D>
std::vector<Index> nodes_in_use(const Nodes<D>& nodes) {
  std::vector<Index> result;
  for (Index batch = 0; batch < nodes.num_batches(); ++batch) {
    for (const NodeRun& run : nodes.batch(batch)) {
      for (Index node = run.begin; node < run.end; ++node) result.push_back(node);
    }
  }
  return result;
}

TEST(Nodes, AreAllInUseAtFirst) {
  const Nodes<2> nodes{cube<2>(99, 0.1, false), {2, false}};

  const auto used = nodes_in_use(nodes);

  ASSERT_EQ(static_cast<Index>(used.size()), nodes.num_nodes());
  for (std::size_t n = 0; n < used.size(); ++n) EXPECT_EQ(used[n], static_cast<Index>(n));
  EXPECT_EQ(nodes.num_batches(), 3);  // 102 x 102 nodes, 4096 to a batch
  EXPECT_EQ(nodes.images(1, Side::high).size(), 102U);
}

TEST(Nodes, InUseAreThoseOfTheBoxesAndImagesBesideThem) {
  Nodes<2> nodes{cube<2>(9, 0.1, false), {2, false}};  // places 0 to 11 along an axis, the walls at 1 and 10
  const std::vector<Indices<2>> corners{{3, 0}, {5, 1}};

  nodes.use(corners, 3);

  // Nodes 3 to 5 of rows 0 to 2, with images below row 0; 5 to 7 of rows 1 to 3.
  const std::vector<Index> expected{4,      5,      6,                       // images
                                    12 + 4, 12 + 5, 12 + 6,                  // row 0
                                    24 + 4, 24 + 5, 24 + 6, 24 + 7, 24 + 8,  // row 1
                                    36 + 4, 36 + 5, 36 + 6, 36 + 7, 36 + 8,  // row 2
                                    48 + 6, 48 + 7, 48 + 8};
  EXPECT_EQ(nodes_in_use(nodes), expected);
  const auto images = nodes.images(1, Side::low);
  EXPECT_EQ((std::vector<Index>{images.begin(), images.end()}), (std::vector<Index>{4, 5, 6}));
  EXPECT_TRUE(nodes.images(0, Side::low).empty());
  EXPECT_TRUE(nodes.images(1, Side::high).empty());
}

TEST(Nodes, InUseGoRoundAPeriodicAxis) {
  Nodes<1> nodes{cube<1>(9, 0.1, true), {1, false}};
  const std::vector<Indices<1>> corners{{-2}};

  nodes.use(corners, 4);
  EXPECT_EQ(nodes_in_use(nodes), (std::vector<Index>{0, 1, 7, 8}));

  nodes.use(corners, 12);
  EXPECT_EQ(nodes_in_use(nodes).size(), 9U);
}

TEST(Nodes, OutOfUseAreZero) {
  Nodes<1> nodes{cube<1>(9, 0.1, false), {1, false}};
  for (Index n = 0; n < nodes.num_nodes(); ++n) nodes[n][NodeRecord::mass] = 1;
  const std::vector<Indices<1>> corners{{4}};

  nodes.use(corners, 2);

  for (Index n = 0; n < nodes.num_nodes(); ++n) EXPECT_EQ(nodes[n][NodeRecord::mass], 0);
}

TEST(Nodes, RepeatAlongAPeriodicAxis) {
  const Nodes<2> nodes{cube<2>(5, 0.1, true), {2, false}};

  EXPECT_EQ(nodes.first(1), 0);
  EXPECT_EQ(nodes.count(1), 5);
  for (Index node = -12; node <= 12; ++node) {
    EXPECT_EQ(nodes.place(node, 1), nodes.place(node + 5, 1));
    EXPECT_GE(nodes.place(node, 1), 0);
    EXPECT_LT(nodes.place(node, 1), 5);
  }
}

TEST(Nodes, AreZeroWhenCleared) {
  Nodes<1> nodes{cube<1>(3, 0.1, false), {1, true}};
  nodes[2][NodeRecord::mass] = 1;

  nodes.clear();

  EXPECT_EQ(nodes[2][NodeRecord::mass], 0);
}

}  // namespace
}  // namespace scree::mpm
