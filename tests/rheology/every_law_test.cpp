#include "derivative.hpp"
#include "points.hpp"
#include "typed_lists.hpp"

#include <scree/rheology/dissipation.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/laws.hpp>

#include <bit>
#include <limits>
#include <set>
#include <tuple>
#include <type_traits>

namespace scree::rheology {
namespace {

using testing::Dual;

template <class Law>
class EveryLaw : public ::testing::Test {
 protected:
  static constexpr Law law = typical<Law>();
};
TYPED_TEST_SUITE(EveryLaw, testing::Each<AnyLaw>, testing::EntryName);

/// The laws of a list that have a property.
template <template <class> class Property, class List>
struct Chosen;
template <template <class> class Property, template <class...> class List, class... Laws>
struct Chosen<Property, List<Laws...>> {
  using type = decltype(std::tuple_cat(
      std::conditional_t<Property<Laws>::value, std::tuple<Laws>, std::tuple<>>{}...));
};
/// A memory of six numbers or more holds a tensor, which turns with the material; fewer are scalars.
template <class Law>
struct HasTensorMemory : std::bool_constant<(Law::states.size() >= 6)> {};
template <class Law>
struct HasNoTensorMemory : std::bool_constant<(Law::states.size() < 6)> {};
template <class Law>
struct Disconnects : std::bool_constant<disconnects<Law>> {};

template <class Law>
class EveryLawThatDisconnects : public EveryLaw<Law> {};
using Disconnecting = Chosen<Disconnects, AnyLaw>::type;
TYPED_TEST_SUITE(EveryLawThatDisconnects, testing::Each<Disconnecting>, testing::EntryName);

template <class Law>
class EveryLawWithTensorMemory : public EveryLaw<Law> {};
using WithTensorMemory = Chosen<HasTensorMemory, AnyLaw>::type;
TYPED_TEST_SUITE(EveryLawWithTensorMemory, testing::Each<WithTensorMemory>, testing::EntryName);

template <class Law>
class EveryLawWithoutTensorMemory : public EveryLaw<Law> {};
using WithoutTensorMemory = Chosen<HasNoTensorMemory, AnyLaw>::type;
TYPED_TEST_SUITE(EveryLawWithoutTensorMemory, testing::Each<WithoutTensorMemory>, testing::EntryName);

TYPED_TEST(EveryLaw, DescribesEachNumberItReadsAndKeeps) {
  using Input = typename TypeParam::template Input<double>;
  using State = typename TypeParam::template State<double>;

  EXPECT_EQ(TypeParam::inputs.size() * sizeof(double), std::is_empty_v<Input> ? 0 : sizeof(Input));
  EXPECT_EQ(TypeParam::states.size() * sizeof(double), std::is_empty_v<State> ? 0 : sizeof(State));
  EXPECT_EQ(TypeParam::parameters.size() * sizeof(double), sizeof(TypeParam));
  std::set<std::string_view> names;
  for (const InputColumn& input : TypeParam::inputs) {
    EXPECT_TRUE(names.insert(input.name).second && !input.unit.empty()) << input.name;
    EXPECT_TRUE(input.range.contains(input.typical)) << input.name;
  }
  for (const StateColumn& state : TypeParam::states) {
    EXPECT_TRUE(names.insert(state.name).second && !state.unit.empty()) << state.name;
    EXPECT_TRUE(std::isfinite(state.initial)) << state.name;
  }
}

TYPED_TEST(EveryLaw, AcceptsItsTypicalParameters) {
  EXPECT_NO_THROW(validate(this->law));
}

/// Space turned once and for all, with everything in it: each step's answer is turned alike.
TYPED_TEST(EveryLaw, IsObjective) {
  for (const double density : densities(this->law)) {
    Point<TypeParam> here{this->law};
    Point<TypeParam> turned{this->law};
    int num_steps = 0;
    for (const auto& gradient : velocity_gradients()) {
      here.step(gradient, density, 1e-3);
      turned.step(rotated(gradient), density, 1e-3);

      // Two rotations of 2 x 9 products and sums and some 20 operations between them, on components that
      // are at most 4 times larger than those of D' and the stress.
      const auto expected = rotated(here.stress);
      const double tolerance = 4 * 60 * round_off * largest(expected) + 4 * rounding_of_strain(this->law);
      EXPECT_LE(largest(turned.stress - expected), ++num_steps * tolerance);
    }
  }
}

/// What a law leaves in its memory is what `validate_columns` would let in again: up to a millionth.
TYPED_TEST(EveryLawWithTensorMemory, SaysWhetherItIsOfTraceZero) {
  Point<TypeParam> point{this->law};
  for (const auto& gradient : velocity_gradients()) {
    point.step(gradient, 1.001 * this->law.density, 1e-3);
    const auto memory = std::bit_cast<std::array<double, TypeParam::states.size()>>(point.state);
    const double trace = std::abs(memory[0] + memory[1] + memory[2]);
    double largest = 0;
    for (std::size_t i = 0; i < 6; ++i) largest = std::max(largest, std::abs(memory[i]));

    EXPECT_GT(largest, 0);
    EXPECT_EQ(remembers_deviator<TypeParam>, trace <= 1e-6 * largest);
  }
}

TYPED_TEST(EveryLawWithoutTensorMemory, DoesNotFeelASpin) {
  for (const auto& gradient : velocity_gradients()) {
    auto spinning = gradient;
    spinning(0, 1) += 0.5;
    spinning(1, 0) -= 0.5;
    for (const double density : densities(this->law)) {
      const auto expected = stress(this->law, gradient, density);

      const auto actual = stress(this->law, spinning, density);

      EXPECT_LE(largest(actual - expected), 4 * 20 * round_off * largest(expected));  // as in IsObjective
    }
  }
}

/// A rigid rotation by one radian in 100 steps turns the stress of a strained point, and does nothing else.
TYPED_TEST(EveryLawWithTensorMemory, TurnsWithTheMaterial) {  // Eq. (R18)
  constexpr int num_steps = 100;
  const double density = 1.5 * this->law.density;
  Point<TypeParam> point{this->law};
  point.step(velocity_gradients().front(), density, 1e-5);  // too little for any law to yield
  point.step({}, density, 0);                               // what is viscous is gone
  Tensor<double> spin;  // about (1, 2, 2)/3, whose rotation by the midpoint rule is 2 atan(w dt/2) a step
  const double dt = 2 * std::tan(0.5 / num_steps);
  const std::array axis{1.0 / 3, 2.0 / 3, 2.0 / 3};
  for (std::size_t i = 0; i < 3; ++i) {
    spin(i, (i + 1) % 3) = -axis[(i + 2) % 3];
    spin((i + 1) % 3, i) = axis[(i + 2) % 3];
  }
  const auto expected = rotated(point.stress);

  for (int n = 0; n < num_steps; ++n) point.step(spin, density, dt);

  const double tolerance = 60 * round_off * largest(expected) + rounding_of_strain(this->law);
  EXPECT_LE(largest(point.stress - expected), num_steps * tolerance);
}

TYPED_TEST(EveryLaw, DissipatesInShear) {  // Eq. (R6)
  for (const auto& gradient : velocity_gradients()) {
    for (const double density : densities(this->law)) {
      const auto sigma = stress(this->law, gradient, density);

      // The pressure cancels in the deviator up to 4 roundings of it, on each of three components.
      const double tolerance =
          (12 * round_off * largest(sigma) + rounding_of_strain(this->law)) * largest(gradient);
      EXPECT_GE(dissipation(sigma, gradient), -tolerance);
    }
  }
}

TYPED_TEST(EveryLaw, AnswersAlikeInEachPlaneOfPlaneStrain) {
  for (const auto& plane : velocity_gradients()) {
    for (const double density : densities(this->law)) {
      Tensor<double> xy;
      Tensor<double> yz;
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) xy(i, j) = yz(i + 1, j + 1) = plane(i, j);
      }

      const auto in_xy = stress(this->law, xy, density);
      const auto in_yz = stress(this->law, yz, density);

      // Some 20 operations, in another order.
      const double tolerance = 20 * round_off * largest(in_xy) + rounding_of_strain(this->law);
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
  for (const double density : densities(this->law)) {
    const auto exact = stress<TypeParam, Dual>(this->law, dual, density);

    const auto ahead = stress(this->law, at + step * along, density);
    const auto behind = stress(this->law, at - step * along, density);

    // Truncation step^2 of a change of order one, rounding of some 20 operations on either side over 2 step.
    const double tolerance =
        (step * step + 20 * round_off / step) * largest(ahead) + rounding_of_strain(this->law) / step;
    for (std::size_t i = 0; i < 9; ++i) {
      const double difference = (ahead.components[i] - behind.components[i]) / (2 * step);
      EXPECT_NEAR(exact.components[i].slope, difference, tolerance);
    }
  }
}

TYPED_TEST(EveryLaw, DoesNotHideANan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double dt = 1;  // long enough for any law to flow, whatever its strength
  const auto gradient = velocity_gradients().front();
  auto broken = gradient;
  broken(0, 1) = nan;

  EXPECT_TRUE(std::isnan(stress(this->law, gradient, nan)(0, 0)));
  for (const double density : densities(this->law)) {
    EXPECT_TRUE(std::isnan(stress(this->law, broken, density)(0, 1)));
    if (!TypeParam::inputs.empty()) {
      EXPECT_TRUE(std::isnan(stress(this->law, gradient, density, nan, dt)(0, 1)));
    }
  }
}

TYPED_TEST(EveryLaw, SolvesItsEquations) {
  for (const auto& gradient : velocity_gradients()) {
    for (const double density : densities(this->law)) {
      const auto response =
          this->law.update({gradient, density}, typical_input<TypeParam>(), initial_state<TypeParam>(), 1e-3);

      EXPECT_EQ(response.unsolved, 0) << density;
    }
  }
}

TYPED_TEST(EveryLaw, IsAFunctionOfItsArgumentsAlone) {
  for (const auto& gradient : velocity_gradients()) {
    const auto first = stress(this->law, gradient, 1.001 * this->law.density);
    const auto second = stress(this->law, gradient, 1.001 * this->law.density);

    EXPECT_EQ(first.components, second.components);
  }
}

/// What is stored between two steps is all that the next one needs.
TYPED_TEST(EveryLaw, GoesOnFromItsStoredState) {
  using State = typename TypeParam::template State<double>;
  const double density = 1.01 * this->law.density;
  Point<TypeParam> straight{this->law};
  for (const auto& gradient : velocity_gradients()) straight.step(gradient, density, 1e-3);

  Point<TypeParam> stopped{this->law};
  std::size_t num_steps = 0;
  for (const auto& gradient : velocity_gradients()) {
    if (++num_steps == 4) {
      Point<TypeParam> reloaded{this->law};
      if constexpr (!TypeParam::states.empty()) {
        const auto stored = std::bit_cast<std::array<double, TypeParam::states.size()>>(stopped.state);
        reloaded.state = std::bit_cast<State>(stored);
      }
      stopped = reloaded;
    }
    stopped.step(gradient, density, 1e-3);
  }

  EXPECT_EQ(stopped.stress.components, straight.stress.components);
}

/// A step of no length asks for the stress of the present state: output and initial states rely on it.
TYPED_TEST(EveryLaw, KeepsItsStressOverNoTime) {
  const double density = 1.01 * this->law.density;
  for (const auto& gradient : velocity_gradients()) {
    Point<TypeParam> point{this->law};
    for (int n = 0; n < 3; ++n) point.step(gradient, density, 1e-2);
    const auto expected = point.stress;

    point.step(gradient, density, 0);

    const double tolerance = 60 * round_off * largest(expected) + rounding_of_strain(this->law);
    EXPECT_LE(largest(point.stress - expected), tolerance);
  }
}

/// p < 0: no stress, no NaN, and full strength as soon as the material is dense again.
TYPED_TEST(EveryLawThatDisconnects, LosesNothingToATimeWithoutContact) {  // Eq. (R5)
  for (const auto& gradient : velocity_gradients()) {
    Point<TypeParam> point{this->law};
    point.step(gradient, 1.01 * this->law.density, 1e-3);

    point.step(gradient, 0.9 * this->law.density, 1e-3);
    EXPECT_EQ(largest(point.stress), 0);
    point.step(gradient, 1.01 * this->law.density, 1e-3);

    const auto fresh =
        stress(this->law, gradient, 1.01 * this->law.density, typical_input<TypeParam>(), 1e-3);
    const double tolerance = 60 * round_off * largest(fresh) + rounding_of_strain(this->law);
    EXPECT_LE(largest(point.stress - fresh), tolerance);
  }
}

TYPED_TEST(EveryLaw, HasFiniteStiffness) {
  for (const double density : densities(this->law)) {
    for (const auto& gradient : {velocity_gradients().front(), Tensor<double>{}}) {
      const auto stiffness =
          this->law.stiffness({gradient, density}, typical_input<TypeParam>(), initial_state<TypeParam>());

      EXPECT_TRUE(stiffness.wave_speed > 0 && std::isfinite(stiffness.wave_speed));
      EXPECT_TRUE(stiffness.viscosity >= 0 && std::isfinite(stiffness.viscosity));
      EXPECT_TRUE(stiffness.relaxation_rate >= 0 && std::isfinite(stiffness.relaxation_rate));
    }
  }
}

}  // namespace
}  // namespace scree::rheology
