#include "bodies.hpp"

#include <scree/mpm/nodes.hpp>

#include <gtest/gtest.h>

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
