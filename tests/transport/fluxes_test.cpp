#include "lists.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/buckley_leverett.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/laws/user_law.hpp>

#include <cmath>

namespace scree::transport {
namespace {

template <class F>
class EveryFlux : public ::testing::Test {};
TYPED_TEST_SUITE(EveryFlux, test::Types<FluxList>);

TYPED_TEST(EveryFlux, IsConsistent) {  // F(u, u) = f(u), Eq. (T3)
  const Vector<1> normal{1.0};
  for (const double u : {-0.7, 0.0, 0.3, 1.0}) {
    EXPECT_DOUBLE_EQ(TypeParam{}(Burgers{}, {u}, {u}, normal).value[0], u * u / 2);
  }
  const Euler<1> gas;
  const auto u = gas.state(1.2, Vector<1>{0.4}, 0.9);
  EXPECT_EQ(TypeParam{}(gas, u, u, normal).value, gas.flux(u, normal));
}

TYPED_TEST(EveryFlux, TakesFromOneSideWhatItGivesTheOther) {
  const Vector<2> normal{0.6, 0.8};
  const Euler<2> gas;
  const auto left = gas.state(1, Vector<2>{0.3, -0.2}, 1);
  const auto right = gas.state(0.5, Vector<2>{-0.1, 0.4}, 0.3);

  const auto forth = TypeParam{}(gas, left, right, normal);
  const auto back = TypeParam{}(gas, right, left, Vector<2>{-normal});

  for (std::size_t k = 0; k < 4; ++k) EXPECT_DOUBLE_EQ(forth.value[k], -back.value[k]);
}

TYPED_TEST(EveryFlux, IsMonotone) {  // rises with the left state, falls with the right one
  const Vector<1> normal{1.0};
  const TypeParam flux{};
  const auto value = [&](double left, double right) {
    return flux(Burgers{}, {left}, {right}, normal).value[0];
  };
  const double step = 0.125;
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const double left = step * i;
      const double right = step * j;
      EXPECT_GE(value(left + step, right), value(left, right) - 4 * round_off);
      EXPECT_LE(value(left, right + step), value(left, right) + 4 * round_off);
    }
  }
}

TEST(KurganovTadmor, IsUpwindForAdvection) {
  const Advection<2> law{Vector<2>{2, -1}};
  EXPECT_DOUBLE_EQ(KurganovTadmor{}(law, {3}, {5}, Vector<2>{1, 0}).value[0], 6);
  EXPECT_DOUBLE_EQ(KurganovTadmor{}(law, {3}, {5}, Vector<2>{0, 1}).value[0], -5);
}

TEST(KurganovNoellePetrova, IsUpwindWhereAllWavesGoOneWay) {  // Eq. (T16)
  const Vector<1> normal{1.0};
  EXPECT_DOUBLE_EQ(KurganovNoellePetrova{}(Burgers{}, {1.0}, {2.0}, normal).value[0], 0.5);
  EXPECT_DOUBLE_EQ(KurganovNoellePetrova{}(Burgers{}, {-2.0}, {-1.0}, normal).value[0], 0.5);
}

TEST(KurganovNoellePetrova, IsKurganovTadmorForALawThatBoundsItsSpeedAlone) {
  const BuckleyLeverett flow;
  const auto law =
      make_law<1, 1>([&](const std::array<double, 1>& u, const Vector<1>& n) { return flow.flux(u, n); },
                     [&](const std::array<double, 1>& left, const std::array<double, 1>& right,
                         const Vector<1>& n) { return flow.max_speed(left, right, n); });
  const Vector<1> normal{1.0};
  const auto one = KurganovNoellePetrova{}(law, {0.2}, {0.7}, normal);
  const auto other = KurganovTadmor{}(law, {0.2}, {0.7}, normal);
  EXPECT_NEAR(one.value[0], other.value[0], 8 * round_off);  // six operations on numbers below 2
  EXPECT_EQ(one.speed, other.speed);
}

TEST(KurganovNoellePetrova, IsCentralAtRest) {  // no wave at all: no quotient of zeros
  const Advection<1> still{Vector<1>{0.0}};
  EXPECT_EQ(KurganovNoellePetrova{}(still, {3}, {5}, Vector<1>{1.0}).value[0], 0);
}

TEST(KurganovNoellePetrova, PassesOnANaN) {
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(KurganovNoellePetrova{}(Burgers{}, {nan}, {1.0}, Vector<1>{1.0}).speed));
  EXPECT_TRUE(std::isnan(KurganovNoellePetrova{}(Burgers{}, {1.0}, {nan}, Vector<1>{1.0}).speed));
}

/// The largest rise of the flux per state between two states, over `parts` equal parts.
double steepest_part(const BuckleyLeverett& law, double low, double high, int parts) {
  const Vector<1> normal{1.0};
  double steepest = 0;
  const double du = (high - low) / parts;
  for (int part = 0; part < parts; ++part) {
    const double u = low + part * du;
    steepest = std::max(steepest, (law.flux({u + du}, normal)[0] - law.flux({u}, normal)[0]) / du);
  }
  return steepest;
}

TEST(BuckleyLeverett, BoundsTheSpeedOverTheWholeInterval) {  // Eq. (T14)
  constexpr int parts = 500;
  constexpr double curvature = 40;  // |f''| of these ratios is below
  for (const double ratio : {0.25, 1.0, 5.0}) {
    const BuckleyLeverett law{ratio};
    for (int i = 0; i < 10; ++i) {
      for (int j = i + 1; j <= 10; ++j) {
        const double steepest = steepest_part(law, 0.1 * i, 0.1 * j, parts);
        const double bound = law.max_speed({0.1 * i}, {0.1 * j}, Vector<1>{1.0});
        EXPECT_GE(bound, steepest - 1e-11);  // quotients of numbers below 1, rounded, over 1e-4
        EXPECT_LE(bound, steepest + curvature * 0.1 * (j - i) / parts);
      }
    }
  }
}

TEST(Euler, SpeedBoundsTheEigenvalues) {  // v - c, v, v + c
  const Euler<2> gas{1.4};
  const auto slow = gas.state(1, Vector<2>{0.1, 5}, 1);
  const auto fast = gas.state(0.25, Vector<2>{-3, 0}, 1);
  EXPECT_DOUBLE_EQ(gas.max_speed(slow, fast, Vector<2>{1, 0}), 3 + std::sqrt(1.4 / 0.25));
  EXPECT_DOUBLE_EQ(gas.max_speed(slow, fast, Vector<2>{0, -1}), 5 + std::sqrt(1.4));
}

TEST(Larger, DoesNotHideNaN) {
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(larger(nan, 1)));
  EXPECT_TRUE(std::isnan(larger(1, nan)));
  EXPECT_EQ(larger(1, 2), 2);
}

}  // namespace
}  // namespace scree::transport
