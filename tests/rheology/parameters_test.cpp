#include <scree/rheology/laws.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace scree::rheology {
namespace {

/// What validate() says, empty if it accepts.
template <class Law>
std::string complaint(const Law& law) {
  try {
    validate(law);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Validate, AcceptsAFluidWithoutViscosity) {
  EXPECT_EQ(complaint(Newtonian{.viscosity = 0, .bulk_modulus = 1e7, .density = 1000}), "");
}

TEST(Validate, NamesLawParameterValueAndBound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();

  EXPECT_EQ(complaint(Newtonian{.viscosity = -1, .bulk_modulus = 1e7, .density = 1000}),
            "newtonian: viscosity = -1 Pa s: must be finite and at least 0");
  EXPECT_EQ(complaint(Newtonian{.viscosity = 750, .bulk_modulus = 0, .density = 1000}),
            "newtonian: bulk_modulus = 0 Pa: must be finite and above 0");
  EXPECT_EQ(complaint(Newtonian{.viscosity = 750, .bulk_modulus = 1e7, .density = nan}),
            "newtonian: density = nan kg/m^3: must be finite and above 0");
  EXPECT_EQ(
      complaint(SizeDependentNewtonian{.viscosity_per_size = infinity, .bulk_modulus = 1e7, .density = 1000}),
      "size_dependent_newtonian: viscosity_per_size = inf Pa s/m: must be finite and at least 0");
}

}  // namespace
}  // namespace scree::rheology
