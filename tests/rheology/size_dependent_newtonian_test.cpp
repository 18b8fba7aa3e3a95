#include "points.hpp"

#include <scree/rheology/laws/newtonian.hpp>
#include <scree/rheology/laws/size_dependent_newtonian.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

// One million Pa s per metre: the "10^3 s" of Marks & Einav with the size s in millimetres.
constexpr SizeDependentNewtonian law{.viscosity_per_size = 1e6, .bulk_modulus = 1e7, .density = 1000};

TEST(SizeDependentNewtonian, IsNewtonianAtOneSize) {  // Eq. (R4)
  const double size = 0.00075;                        // [m]
  const Newtonian same{.viscosity = law.viscosity_per_size * size, .bulk_modulus = 1e7, .density = 1000};
  for (const auto& gradient : velocity_gradients()) {
    for (const double density : densities(law)) {
      EXPECT_EQ(stress(law, gradient, density, size).components, stress(same, gradient, density).components);
    }
  }
}

TEST(SizeDependentNewtonian, CoarseGrainsTwiceAsLargeShearHalfAsFast) {  // Eq. (R4)
  Tensor<double> shear;
  shear(0, 1) = 4;
  Tensor<double> half_as_fast;
  half_as_fast(0, 1) = 2;

  EXPECT_EQ(stress(law, shear, 1000.0, 0.0005)(0, 1), stress(law, half_as_fast, 1000.0, 0.001)(0, 1));
}

TEST(SizeDependentNewtonian, HasTheViscosityOfThePapersFlow) {  // 750 Pa s at 0.5 and 1 mm, half and half
  EXPECT_NEAR(law.stiffness(Deformation<double>{}, {0.00075}, {}).viscosity, 750,
              2 * round_off * 750);  // the size, the product
  EXPECT_EQ(law.stiffness(Deformation<double>{}, {0.00075}, {}).wave_speed, 100);
}

}  // namespace
}  // namespace scree::rheology
