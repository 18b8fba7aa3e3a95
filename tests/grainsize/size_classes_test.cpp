#include "message_of.hpp"

#include <scree/grainsize/size_classes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace scree::grainsize {
namespace {

using test::message_of;
using testing::ElementsAre;

TEST(SizeClasses, KeepsItsDiametersAndEdges) {
  const SizeClasses classes{{0.5e-3, 1e-3}, {0.4e-3, 0.7e-3, 1.2e-3}};

  EXPECT_EQ(classes.size(), 2U);
  EXPECT_THAT(classes.diameters(), ElementsAre(0.5e-3, 1e-3));
  EXPECT_THAT(classes.edges(), ElementsAre(0.4e-3, 0.7e-3, 1.2e-3));
  EXPECT_EQ(classes.smallest(), 0.5e-3);
  EXPECT_EQ(classes.largest(), 1e-3);
}

TEST(SizeClasses, HasNoEdgesUnlessGiven) {
  EXPECT_TRUE(SizeClasses{{1e-3}}.edges().empty());
}

TEST(SizeClasses, RefusesToBeEmpty) {
  EXPECT_EQ(message_of([] { SizeClasses{std::vector<double>{}}; }),
            "SizeClasses: there must be at least one diameter");
}

TEST(SizeClasses, RefusesDiametersThatAreNotPositiveAndFinite) {
  EXPECT_EQ(message_of([] { SizeClasses{{-1e-3}}; }),
            "SizeClasses: diameter 1 is -0.001 m, but must be positive and finite");
  EXPECT_EQ(message_of([] {
              SizeClasses{{1e-3, std::numeric_limits<double>::quiet_NaN()}};
            }),
            "SizeClasses: diameter 2 is nan m, but must be positive and finite");
}

TEST(SizeClasses, RefusesDiametersThatDoNotIncrease) {
  EXPECT_EQ(message_of([] {
              SizeClasses{{1e-3, 1e-3}};
            }),
            "SizeClasses: diameter 2 is 0.001 m, but must exceed the one before, 0.001 m");
}

TEST(SizeClasses, RefusesEdgesThatDoNotFit) {
  EXPECT_EQ(message_of([] {
              SizeClasses{{1e-3}, {1e-3}};
            }),
            "SizeClasses: 1 classes have 2 edges, but 1 are given");
  EXPECT_EQ(message_of([] {
              SizeClasses{{1e-3}, {2e-3, 1e-3}};
            }),
            "SizeClasses: edge 2 is 0.001 m, but must exceed the one before, 0.002 m");
  EXPECT_EQ(message_of([] {
              SizeClasses{{1e-3}, {2e-3, 3e-3}};
            }),
            "SizeClasses: diameter 1 is 0.001 m, but must lie between the edges 0.002 m and 0.003 m");
}

}  // namespace
}  // namespace scree::grainsize
