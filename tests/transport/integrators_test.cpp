#include <scree/transport/integrators.hpp>
#include <scree/transport/time/stages.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace scree::transport {
namespace {

/// du/dt = -u over one unit of time.
double decay(Stages stages, int steps) {
  const double dt = 1.0 / steps;
  double u = 1;
  for (int step = 0; step < steps; ++step) {
    const double start = u;
    for (const double kept : stages.kept) u = kept * start + (1 - kept) * (u - dt * u);
  }
  return u;
}

double order(Stages stages) {
  const double coarse = std::abs(decay(stages, 50) - std::exp(-1.0));
  const double fine = std::abs(decay(stages, 100) - std::exp(-1.0));
  return std::log2(coarse / fine);
}

TEST(Integrators, HaveTheirOrders) {  // up to dt: 1/100 of the order's size
  EXPECT_NEAR(order(ForwardEuler{}), 1, 0.02);
  EXPECT_NEAR(order(SspRk2{}), 2, 0.03);
  EXPECT_NEAR(order(SspRk3{}), 3, 0.04);
}

TEST(Integrators, AreConvexCombinationsOfEulerSteps) {
  for_each_entry(IntegratorList{}, []<class I>() {
    EXPECT_EQ(I::kept[0], 0) << I::name;
    for (const double kept : I::kept) {
      EXPECT_GE(kept, 0);
      EXPECT_LT(kept, 1);
    }
  });
}

TEST(Integrators, MayBeChosenAtRunTime) {
  const AnyIntegrator chosen{SspRk3{}};
  EXPECT_EQ(Stages{chosen}.kept.size(), 3);
  EXPECT_EQ(Stages{AnyIntegrator{}}.kept.size(), SspRk2::kept.size());
}

}  // namespace
}  // namespace scree::transport
