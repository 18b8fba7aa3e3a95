#include "lines.hpp"

#include <scree/transport/laws/euler.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace scree::transport {
namespace {

TEST(Euler, KeepsAMovingContactsPressureAndVelocity) {
  const Lattice<1> lattice = test::line(50, 0, 1);
  const Euler<1> gas;
  std::vector<double> u;
  for (Index i = 0; i < 50; ++i) {
    const auto cell = gas.state(i < 25 ? 1 : 0.3, Vector<1>{0.7}, 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  Solver solver{Cartesian<1>{lattice}, gas, PiecewiseLinear{Minmod{}}};

  solver.advance(u, 0.5);

  // Density, momentum and energy stay linear in each other under one limiter and one speed.
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_NEAR(u[3 * i + 1] / u[3 * i], 0.7, 1e-12);
    EXPECT_NEAR(gas.pressure({u[3 * i], u[3 * i + 1], u[3 * i + 2]}), 1, 1e-12);
  }
}

TEST(Euler, HasNoSpeedForAStateThatCannotBe) {  // negative density and pressure have a positive quotient
  const Euler<1> gas;
  const auto fine = gas.state(1, Vector<1>{0.0}, 1);
  const auto impossible = gas.state(-1, Vector<1>{0.0}, -1);
  const Vector<1> normal{1.0};
  EXPECT_TRUE(std::isnan(gas.max_speed(fine, impossible, normal)));
  EXPECT_TRUE(std::isnan(gas.speed_range(impossible, fine, normal).highest));
  EXPECT_FALSE(gas.is_admissible(impossible));
}

TEST(Euler, AdmitsPositiveDensityAndPressureOnly) {
  const Euler<2> gas;
  EXPECT_TRUE(gas.is_admissible(gas.state(1e-150, Vector<2>{0, 0}, 1e-150)));   // their product: 2.5e-300
  EXPECT_FALSE(gas.is_admissible(gas.state(1e-170, Vector<2>{0, 0}, 1e-170)));  // underflows
  EXPECT_FALSE(gas.is_admissible({0, 0, 0, 1}));
  EXPECT_FALSE(gas.is_admissible({1, 1, 1, 1}));     // all energy is motion: no pressure
  EXPECT_TRUE(gas.is_admissible({1, 1, 1, 1.001}));  // a little more
}

TEST(Euler, RefusesGammaOfOne) {
  EXPECT_EQ(test::message_of<InputError>([] { Euler<2>{1}; }),
            "Euler: the ratio of specific heats must exceed 1");
}

}  // namespace
}  // namespace scree::transport
