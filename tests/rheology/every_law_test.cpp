#include "derivative.hpp"
#include "points.hpp"
#include "typed_lists.hpp"

#include <scree/rheology/laws.hpp>

#include <limits>

namespace scree::rheology {
namespace {

using testing::Dual;

template <class Law>
class EveryLaw : public ::testing::Test {
 protected:
  static constexpr Law law = typical<Law>();
};
TYPED_TEST_SUITE(EveryLaw, testing::Each<AnyLaw>, testing::EntryName);

TYPED_TEST(EveryLaw, NamesEachNumberItReadsAndKeeps) {
  using Input = typename TypeParam::template Input<double>;
  using State = typename TypeParam::template State<double>;

  EXPECT_EQ(TypeParam::input_names.size() * sizeof(double), std::is_empty_v<Input> ? 0 : sizeof(Input));
  EXPECT_EQ(TypeParam::state_names.size() * sizeof(double), std::is_empty_v<State> ? 0 : sizeof(State));
  EXPECT_EQ(TypeParam::parameters.size() * sizeof(double), sizeof(TypeParam));
}

TYPED_TEST(EveryLaw, AcceptsItsTypicalParameters) {
  EXPECT_NO_THROW(validate(this->law));
}

TYPED_TEST(EveryLaw, IsObjective) {
  for (const auto& gradient : velocity_gradients()) {
    for (const double density : densities) {
      const auto expected = rotated(stress(this->law, gradient, density));

      const auto actual = stress(this->law, rotated(gradient), density);

      // Two rotations of 2 x 9 products and sums and some 20 operations between them, on components that
      // are at most 4 times larger than those of D' and the stress.
      EXPECT_LE(largest(actual - expected), 4 * 60 * round_off * largest(expected));
    }
  }
}

TYPED_TEST(EveryLaw, DoesNotFeelASpin) {
  for (const auto& gradient : velocity_gradients()) {
    auto spinning = gradient;
    spinning(0, 1) += 0.5;
    spinning(1, 0) -= 0.5;
    for (const double density : densities) {
      const auto expected = stress(this->law, gradient, density);

      const auto actual = stress(this->law, spinning, density);

      EXPECT_LE(largest(actual - expected), 4 * 20 * round_off * largest(expected));  // as in IsObjective
    }
  }
}

TYPED_TEST(EveryLaw, DissipatesInShear) {  // Eq. (R6)
  for (const auto& gradient : velocity_gradients()) {
    for (const double density : densities) {
      const auto sigma = stress(this->law, gradient, density);

      const double power = contract(deviator(sigma), symmetric_part(gradient));

      // The pressure cancels in the deviator up to 4 roundings of it, on each of three components.
      EXPECT_GE(power, -12 * round_off * largest(sigma) * largest(gradient));
    }
  }
}

TYPED_TEST(EveryLaw, AnswersAlikeInEachPlaneOfPlaneStrain) {
  for (const auto& plane : velocity_gradients()) {
    for (const double density : densities) {
      Tensor<double> xy;
      Tensor<double> yz;
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) xy(i, j) = yz(i + 1, j + 1) = plane(i, j);
      }

      const auto in_xy = stress(this->law, xy, density);
      const auto in_yz = stress(this->law, yz, density);

      const double tolerance = 20 * round_off * largest(in_xy);  // some 20 operations, in another order
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          EXPECT_NEAR(in_xy(i, j), in_yz((i + 1) % 3, (j + 1) % 3), tolerance);
        }
      }
      EXPECT_EQ(in_xy(0, 2), 0);
      EXPECT_EQ(in_xy(1, 2), 0);
    }
  }
}

TYPED_TEST(EveryLaw, HasTheDerivativeThatItsDualNumbersCarry) {
  const auto gradients = velocity_gradients();
  const auto& at = gradients.front();
  const auto& along = gradients.back();
  Tensor<Dual> dual;
  for (std::size_t i = 0; i < 9; ++i) dual.components[i] = {at.components[i], along.components[i]};
  const double step = std::cbrt(round_off);  // balances truncation and rounding of a central difference
  for (const double density : densities) {
    const auto exact = stress<TypeParam, Dual>(this->law, dual, density);

    const auto ahead = stress(this->law, at + step * along, density);
    const auto behind = stress(this->law, at - step * along, density);

    // Truncation step^2 of a change of order one, rounding of some 20 operations on either side over 2 step.
    const double tolerance = (step * step + 20 * round_off / step) * largest(ahead);
    for (std::size_t i = 0; i < 9; ++i) {
      const double difference = (ahead.components[i] - behind.components[i]) / (2 * step);
      EXPECT_NEAR(exact.components[i].slope, difference, tolerance);
    }
  }
}

TYPED_TEST(EveryLaw, DoesNotHideANan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto gradient = velocity_gradients().front();
  auto broken = gradient;
  broken(0, 1) = nan;

  EXPECT_TRUE(std::isnan(stress(this->law, gradient, nan)(0, 0)));
  for (const double density : densities) {
    EXPECT_TRUE(std::isnan(stress(this->law, broken, density)(0, 1)));
    if (!TypeParam::input_names.empty()) {
      EXPECT_TRUE(std::isnan(stress(this->law, gradient, density, nan)(0, 1)));
    }
  }
}

TYPED_TEST(EveryLaw, IsAFunctionOfItsArgumentsAlone) {
  for (const auto& gradient : velocity_gradients()) {
    const auto first = stress(this->law, gradient, 1001.0);
    const auto second = stress(this->law, gradient, 1001.0);

    EXPECT_EQ(first.components, second.components);
  }
}

TYPED_TEST(EveryLaw, HasFiniteStiffness) {
  using Input = typename TypeParam::template Input<double>;
  for (const double density : densities) {
    const auto stiffness =
        this->law.stiffness({velocity_gradients().front(), density}, filled_with<Input>(1e-3));

    EXPECT_TRUE(stiffness.wave_speed > 0 && std::isfinite(stiffness.wave_speed));
    EXPECT_TRUE(stiffness.viscosity >= 0 && std::isfinite(stiffness.viscosity));
  }
}

}  // namespace
}  // namespace scree::rheology
