#include "derivative.hpp"
#include "inclined_layer.hpp"
#include "points.hpp"
#include "zigzag.hpp"

#include <scree/rheology/laws/suspension.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

constexpr Suspension law{.liquid_viscosity = 1,
                         .intrinsic_viscosity = 2.5,
                         .solid_fraction = 0.5,
                         .jammed_viscosity = 1e4,
                         .bulk_modulus = 1e7,
                         .density = 1800};

/// Einstein (1906): 1 + 5/2 phi, and the second term of the power series is [eta] ([eta] + 1/phi_max)/2
/// phi^2.
TEST(Suspension, IsEinsteinsWhereGrainsAreFew) {  // Eq. (R74)
  for (const double packing : {0.5, 0.64, 0.8}) {
    for (const double fraction : {1e-4, 1e-3, 1e-2}) {
      const double second = 2.5 * (2.5 + 1 / packing) / 2 * fraction * fraction;
      const double third = std::pow(3 * fraction / packing, 3);  // of a power of at most 2 of 1/(1 - x)
      EXPECT_NEAR(law.viscosity_at(fraction, packing), 1 + 2.5 * fraction + second, third) << fraction;
    }
  }
  EXPECT_EQ(law.viscosity_at(0.0, 0.64), 1);
}

/// Maron & Pierce (1956), whose power is 2 for any grains: that of Krieger and Dougherty for phi_max = 0.8.
TEST(Suspension, IsMaronAndPiercesWhereThePowerIsTwo) {  // Eq. (R74)
  for (const double fraction : {0.1, 0.4, 0.7, 0.79}) {
    const double room = 1 - fraction / 0.8;
    // log and exp, of a number of at most 9, and the difference in `room`.
    const double tolerance = (4 + 2 * 9 + 4 / room) * round_off;
    EXPECT_NEAR(law.viscosity_at(fraction, 0.8) * room * room, 1, tolerance) << fraction;
  }
}

/// Farris (1968): at the same solid fraction two sizes flow better than one. At phi = 0.6 grains that alone
/// pack to 0.64 are 34 times as viscous as with finer ones in their pores, where they pack to 1 - 0.36^2.
TEST(Suspension, FlowsBetterTheDenserItsSizesPack) {  // Eq. (R74)
  const double dense = 1 - 0.36 * 0.36;
  const double expected = std::pow(1 - 0.6 / 0.64, -2.5 * 0.64) / std::pow(1 - 0.6 / dense, -2.5 * dense);
  EXPECT_NEAR(law.viscosity_at(0.6, 0.64) / law.viscosity_at(0.6, dense), expected,
              expected * (8 + 4 / (1 - 0.6 / 0.64)) * round_off);
}

/// A film of half a metre on a wall: fines below, coarse grains above, or both mixed; the surface of each
/// layer moves on the one beneath, u = G (H y - y^2/2)/eta.
TEST(Suspension, MakesTheFilmOfTwoLayers) {  // Eq. (R3)
  const double drive = 3000;                 // [Pa/m]
  const double height = 0.5;
  const double density = law.density;
  const auto packing_at = [](double y) { return y < 0.25 ? 0.6 : 0.8; };
  const double low = law.viscosity_at(0.5, 0.6);
  const double high = law.viscosity_at(0.5, 0.8);
  const double exact = drive * ((height * 0.25 - 0.03125) / low + 0.03125 / high);
  const int num_parts = 100;  // one bound of them at the interface
  double speed = 0;
  for (int i = 0; i < num_parts; ++i) {
    const double y = height * (i + 0.5) / num_parts;
    speed += height / num_parts * shear_rate_at(law, drive * (height - y), density, 1e5, packing_at(y));
  }
  EXPECT_NEAR(speed, exact,
              (num_parts + 100) * round_off * exact);  // linear in y: the midpoint rule is exact
}

/// Compressed, grains come closer, and the suspension stiffens by the power's own derivative.
TEST(Suspension, StiffensAsItIsCompressed) {  // Eq. (R74)
  using testing::Dual;
  const double packing = 0.64;
  const auto sigma = stress<Suspension, Dual>(
      law,
      [] {
        Tensor<Dual> gradient;
        gradient(0, 1) = 1;
        return gradient;
      }(),
      Dual{law.density, law.density}, Dual{packing});

  const double eta = law.viscosity_at(0.5, packing);
  const double expected = eta * 2.5 * 0.5 / (1 - 0.5 / packing);  // d eta/d ln(phi)
  EXPECT_NEAR(sigma(0, 1).value, eta, 10 * round_off * eta);
  EXPECT_NEAR(sigma(0, 1).slope, expected, 40 * round_off * expected);
}

/// Beyond phi_max nothing diverges and nothing is lost: the highest viscosity, up to the density that meets
/// it.
TEST(Suspension, CreepsWhereItIsJammed) {  // Eq. (R75)
  const double packing = 0.64;
  const double q = 2.5 * packing;
  const double met = packing * (1 - std::pow(1e4, -1 / q));
  EXPECT_LT(law.viscosity_at(met * (1 - 1e-9), packing), 1e4);
  for (const double fraction : {met * (1 + 1e-9), packing, 0.7, 1.0}) {
    EXPECT_EQ(law.viscosity_at(fraction, packing), 1e4) << fraction;
  }
  EXPECT_TRUE(std::isnan(law.viscosity_at(0.5, std::nan(""))));
  EXPECT_TRUE(std::isnan(law.viscosity_at(std::nan(""), packing)));
}

/// Where it fails: near its packing the viscosity bounds an explicit step, and at the packing
/// jammed_viscosity does, rho dx^2/(2 eta): 10^4 times less than of the liquid. A lower one is the remedy,
/// for more creep.
TEST(Suspension, ExplicitStepsBlowUpAboveTheLimitOfTheJam) {  // Eqs. (R7), (R75)
  const double dx = 0.02;                                     // [m]
  Suspension jammed = law;
  jammed.solid_fraction = 0.65;  // an ordinary mix has room for 0.64
  const double limit = law.density * dx * dx / (2 * law.jammed_viscosity);
  const double tolerance = 1000 * round_off;  // ten operations in each of 100 steps

  EXPECT_NEAR(zigzag_after(jammed, 100, 0.99 * limit, dx), std::pow(0.98, 100), tolerance);
  EXPECT_NEAR(zigzag_after(jammed, 100, 1.01 * limit, dx), std::pow(1.02, 100),
              tolerance * std::pow(1.02, 100));

  Suspension milder = jammed;
  milder.jammed_viscosity = 1e3;
  EXPECT_LT(zigzag_after(milder, 100, 1.01 * limit, dx), 1);
}

}  // namespace
}  // namespace scree::rheology
