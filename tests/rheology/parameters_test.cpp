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

TEST(Validate, NamesTheParameterThatMustBeSmaller) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MuOfI law = typical<MuOfI>();
  law.mu_s = 0.38;

  law.mu_2 = 0.3;
  EXPECT_EQ(complaint(law), "mu_of_i: mu_2 = 0.3: must exceed mu_s = 0.38");
  law.mu_2 = 0.38;
  EXPECT_EQ(complaint(law), "mu_of_i: mu_2 = 0.38: must exceed mu_s = 0.38");
  law.mu_2 = nan;
  EXPECT_EQ(complaint(law), "mu_of_i: mu_2 = nan: must be finite and above 0");
  law.mu_2 = 0.64;
  law.I_0 = 0;
  EXPECT_EQ(complaint(law), "mu_of_i: I_0 = 0: must be finite and above 0");
}

TEST(Validate, NamesAnUpperBound) {
  RegularisedMuOfI law = typical<RegularisedMuOfI>();
  law.alpha = 2;

  EXPECT_EQ(complaint(law), "regularised_mu_of_i: alpha = 2: must be finite and above 0 and below 2");
}

/// Every relation of every law, broken by equality.
template <class Law>
void expect_relations_to_be_checked() {
  for (const auto& parameter : Law::parameters) {
    Law law = typical<Law>();
    law.*parameter.member = parameter.bound == Bound::positive ? 0 : -1;
    EXPECT_NE(complaint(law), "") << Law::name << ' ' << parameter.name;
    if (parameter.exceeds == nullptr || parameter.may_equal) continue;
    law = typical<Law>();
    law.*parameter.member = law.*parameter.exceeds;
    EXPECT_NE(complaint(law), "") << Law::name << ' ' << parameter.name;
  }
}

template <class... Laws>
void expect_relations_of_all(std::type_identity<std::variant<Laws...>> /*list*/) {
  (expect_relations_to_be_checked<Laws>(), ...);
}

TEST(Validate, ChecksEachParameterOfEachLaw) {
  expect_relations_of_all(std::type_identity<AnyLaw>{});
}

}  // namespace
}  // namespace scree::rheology
