#include "points.hpp"
#include "zigzag.hpp"

#include <scree/rheology/laws/newtonian.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

constexpr Newtonian law{.viscosity = 750, .bulk_modulus = 1e7, .density = 1000};

TEST(Newtonian, IsExactInSimpleShear) {  // Eq. (R3)
  Tensor<double> shear;
  shear(0, 1) = 4;  // [1/s]

  const auto sigma = stress(law, shear, 1000.0);

  Tensor<double> expected;
  expected(0, 1) = expected(1, 0) = 750 * 4;
  EXPECT_EQ(sigma.components, expected.components);
}

/// Trouton (1906): a thread that is drawn out bears three times the viscosity times the rate, a sheet that is
/// kept from narrowing four times.
TEST(Newtonian, HasTroutonsRatios) {  // Eq. (R3)
  const double rate = 4;              // [1/s]
  const Tensor<double> thread{{rate, 0, 0, 0, -rate / 2, 0, 0, 0, -rate / 2}};
  const Tensor<double> sheet{{rate, 0, 0, 0, -rate, 0, 0, 0, 0}};

  for (const auto& [gradient, ratio] : {std::pair{thread, 3}, std::pair{sheet, 4}}) {
    const auto sigma = stress(law, gradient, 1001.0);

    // Of stresses that are differences of the pressure, K/1000.
    EXPECT_NEAR(sigma(0, 0) - sigma(1, 1), ratio * 750 * rate, 10 * round_off * 1e4);
  }
}

TEST(Newtonian, BearsNoTension) {  // Eq. (R5)
  for (const auto& gradient : velocity_gradients()) {
    EXPECT_EQ(largest(stress(law, gradient, 999.9)), 0);
    EXPECT_GT(largest(stress(law, gradient, 1000.1)), 0);
  }
}

TEST(Newtonian, TellsItsStiffness) {  // Eq. (R2)
  const auto stiffness = law.stiffness(Deformation<double>{}, {}, {});

  EXPECT_EQ(stiffness.wave_speed, 100);
  EXPECT_EQ(stiffness.viscosity, 750);
}

TEST(Newtonian, ExplicitStepsBlowUpAboveTheViscousLimit) {  // Eq. (R7)
  const double dx = 0.02;                                   // [m]
  const double limit = law.density * dx * dx / (2 * law.stiffness(Deformation<double>{}, {}, {}).viscosity);

  // A step of f times the limit multiplies the zigzag by 1 - 2 f: by -0.98 and by -1.02.
  // Each of the 100 steps makes some ten roundings.
  EXPECT_NEAR(zigzag_after(law, 100, 0.99 * limit, dx), std::pow(0.98, 100), 1000 * round_off);
  EXPECT_NEAR(zigzag_after(law, 100, 1.01 * limit, dx), std::pow(1.02, 100),
              1000 * round_off * std::pow(1.02, 100));
}

}  // namespace
}  // namespace scree::rheology
