#include "derivative.hpp"
#include "points.hpp"

#include <scree/rheology/plane_functions.hpp>
#include <scree/rheology/tensor_functions.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::rheology {
namespace {

/// Eigen-systems: fifteen rotations of some eight roundings each, of components that are at most three times
/// the largest.
constexpr double by_axes_tolerance = 3 * 15 * 8 * round_off;
/// A logarithm near 1, relative to its norm: a longest way of some twenty roundings (of a cofactor three, a
/// determinant three, a quotient two, two products of tensors six, the series six) of at most twice the
/// result.
constexpr double logarithm_tolerance = 2 * 20 * round_off;
/// An exponential, relative to its largest eigenvalue: a factor of the series, four roundings, its sum and,
/// once it is squared, a product of tensors, three each. Each squaring doubles it, up to twice |a| over the
/// reach.
constexpr double exponential_tolerance = 10 * round_off;
constexpr double exponential_reach = 0.3;  // of |a|

[[nodiscard]] double norm(const Tensor<double>& a) {
  return std::sqrt(contract(a, a));
}

/// A tensor of three dimensions.
struct Full {
  static constexpr double logarithm_reach = 0.25;  ///< of |b - 1|, where it is a series

  template <class Real>
  [[nodiscard]] static Symmetric<Real> of(const Tensor<Real>& a) {
    return symmetric(a);
  }
};

/// One of a plane, with its component along z.
struct Plane {
  static constexpr double logarithm_reach = 0.2;

  template <class Real>
  [[nodiscard]] static PlaneSymmetric<Real> of(const Tensor<Real>& a) {
    return {a(0, 0), a(1, 1), a(2, 2), a(0, 1)};
  }
};

/// Of norm 1: of any direction, with eigenvalues that coincide, of trace 0, of a plane.
template <class Form>
[[nodiscard]] std::vector<Tensor<double>> directions() {
  std::vector<Tensor<double>> result;
  for (const auto& gradient : velocity_gradients()) result.push_back(symmetric_part(gradient));
  result.push_back(isotropic(-1.0));
  result.push_back(symmetric_part(rotated({{1, 0, 0, 0, 1, 0, 0, 0, -2}})));
  result.push_back({{0, 1, 0, 1, 0, 0, 0, 0, 0}});
  result.push_back({{1, 0, 0, 0, 1, 0, 0, 0, 0}});
  result.push_back({{0, 0, 0, 0, 0, 0, 0, 0, -1}});
  for (auto& a : result) {
    a = Form::of(a).tensor();
    a *= 1 / norm(a);
  }
  return result;
}

/// Sums c[k] a^k, k from 1, term by term in numbers of more digits.
template <class Coefficient>
[[nodiscard]] Tensor<double> summed(const Tensor<double>& a, int num_terms, const Coefficient& c) {
  Tensor<long double> factor;
  for (std::size_t i = 0; i < 9; ++i) factor.components[i] = a.components[i];
  Tensor<long double> power = isotropic(1.0L);
  Tensor<long double> sum;
  for (int k = 1; k <= num_terms; ++k) {
    power = product(power, factor);
    sum += c(k) * power;
  }
  Tensor<double> result;
  for (std::size_t i = 0; i < 9; ++i) result.components[i] = static_cast<double>(sum.components[i]);
  return result;
}

[[nodiscard]] Tensor<double> half_logarithm_by_axes(const Tensor<double>& b) {
  const auto half_log = [](double value) { return std::log(value) / 2; };
  return detail::by_axes(symmetric(b), half_log).tensor();
}

template <class Form>
[[nodiscard]] Tensor<double> half_logarithm_of(const Tensor<double>& b) {
  return half_logarithm(Form::of(b)).tensor();
}

template <class Form>
[[nodiscard]] Tensor<double> exponential_of(const Tensor<double>& a) {
  return exponential(Form::of(a)).tensor();
}

using Forms = ::testing::Types<Full, Plane>;
template <class Form>
class HalfLogarithm : public ::testing::Test {};
TYPED_TEST_SUITE(HalfLogarithm, Forms);
template <class Form>
class Exponential : public ::testing::Test {};
TYPED_TEST_SUITE(Exponential, Forms);

/// The smallest strain keeps its digits too, which its logarithm along axes loses.
TYPED_TEST(HalfLogarithm, IsItsPowerSeriesToRoundOffOfTheStrain) {  // Eqs. (R183), (R185)
  for (const auto& direction : directions<TypeParam>()) {
    for (const double size : {1e-12, 1e-6, 1e-3, 0.05, 0.999 * TypeParam::logarithm_reach}) {
      const auto b = isotropic(1.0) + size * direction;

      const auto strain = half_logarithm_of<TypeParam>(b);

      const auto expected = summed(b - isotropic(1.0), 60, [](int k) {  // left: 1/4^61
        return (k % 2 == 1 ? 0.5L : -0.5L) / k;
      });
      EXPECT_LE(norm(strain - expected), logarithm_tolerance * norm(expected)) << "size " << size;
    }
  }
}

TYPED_TEST(HalfLogarithm, AgreesWithThatAlongAxesWhereTheSeriesEnds) {
  constexpr double reach = TypeParam::logarithm_reach;
  for (const auto& direction : directions<TypeParam>()) {
    for (const double size : {reach * (1 - 1e-15), reach * (1 + 1e-15)}) {
      const auto b = isotropic(1.0) + size * direction;

      const auto strain = half_logarithm_of<TypeParam>(b);

      // Of eigenvalues, then their logarithms, half as much over 0.75; composed again.
      const double tolerance = by_axes_tolerance * (0.5 * 1.25 / 0.75 + 0.15) + logarithm_tolerance;
      EXPECT_LE(largest(strain - half_logarithm_by_axes(b)), tolerance) << "size " << size;
    }
  }
}

TEST(HalfLogarithmOfThreeDimensions, IsThatAlongAxesBeyondTheSeries) {
  for (const auto& direction : directions<Full>()) {
    const auto b = isotropic(1.0) + (Full::logarithm_reach * (1 + 1e-15)) * direction;

    EXPECT_EQ(half_logarithm_of<Full>(b).components, half_logarithm_by_axes(b).components);
  }
}

TYPED_TEST(Exponential, IsItsPowerSeriesToRoundOff) {  // Eqs. (R183), (R186)
  for (const auto& direction : directions<TypeParam>()) {
    for (const double size : {0.0, 1e-12, 1e-3, 0.1, 0.999 * exponential_reach, 1.0, 5.0}) {
      const auto a = size * direction;

      const auto stretch = exponential_of<TypeParam>(a);

      long double factorial = 1;
      const auto expected = isotropic(1.0) + summed(a, 60, [&](int k) { return 1 / (factorial *= k); });
      const double tolerance =
          exponential_tolerance * std::max(1.0, 2 * size / exponential_reach) * std::exp(size);
      EXPECT_LE(largest(stretch - expected), tolerance) << "size " << size;
    }
  }
}

TYPED_TEST(Exponential, IsTheInverseOfTheLogarithm) {
  for (const auto& direction : directions<TypeParam>()) {
    for (const double size : {1e-9, 1e-3, 0.2, 0.4, 0.9}) {
      const auto b = isotropic(1.0) + size * direction;

      const auto again = exponential_of<TypeParam>(2.0 * half_logarithm_of<TypeParam>(b));

      // Along axes: of eigenvalues, in the logarithm over the smallest, and of that composed again.
      const double of_logarithm =
          size < TypeParam::logarithm_reach
              ? logarithm_tolerance * size
              : by_axes_tolerance * ((1 + size) / (1 - size) - std::log(1 - size)) / 2;
      const double of_exponential =
          exponential_tolerance * std::max(1.0, -2 * std::log(1 - size) / exponential_reach);
      EXPECT_LE(largest(again - b), (2 * of_logarithm + of_exponential) * (1 + size)) << "size " << size;
    }
  }
}

TYPED_TEST(Exponential, EndsWhereThereIsNoNumber) {
  for (const double size : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    EXPECT_FALSE(std::isfinite(exponential_of<TypeParam>(isotropic(size))(0, 0))) << size;
  }
}

/// Neither a negative eigenvalue, nor what is no number or out of range, is near 1.
TYPED_TEST(HalfLogarithm, IsNoNumberWhereThereIsNone) {
  for (const double spoilt : {-0.5, std::nan(""), -1e200}) {
    Tensor<double> b = isotropic(1.0);
    b(1, 1) = spoilt;
    EXPECT_TRUE(std::isnan(half_logarithm_of<TypeParam>(b)(1, 1))) << spoilt;
  }
  EXPECT_TRUE(std::isnan(half_logarithm_of<TypeParam>(isotropic(-1.0))(1, 1)));
}

/// Of one size, of two in the plane, and of one size there: products of them are numbers of any size.
TYPED_TEST(HalfLogarithm, IsPreciseForEigenvaluesOfAnySize) {
  for (const double size : {1e-12, 1e-3, 0.0123, 1e3, 1e150}) {
    const double expected = std::log(size) / 2;
    const double tolerance = 8 * round_off * std::abs(expected);  // of a product or two in a logarithm
    const auto of_one = half_logarithm_of<TypeParam>(isotropic(size));
    const auto of_two = half_logarithm_of<TypeParam>({{size, 0, 0, 0, 1 / size, 0, 0, 0, 1}});
    const auto in_plane = half_logarithm_of<TypeParam>({{size, 0, 0, 0, size, 0, 0, 0, 1 / size}});
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_NEAR(of_one(i, i), expected, tolerance) << size;
      EXPECT_NEAR(of_two(i, i), i == 0 ? expected : -expected, tolerance) << size;
      EXPECT_NEAR(in_plane(i, i), expected, tolerance) << size;
    }
    EXPECT_NEAR(of_one(2, 2), expected, tolerance) << size;
    EXPECT_NEAR(of_two(2, 2), 0, tolerance) << size;
    EXPECT_NEAR(in_plane(2, 2), -expected, tolerance) << size;
  }
}

/// The slope of ln(b)/2 as b changes by a tensor that commutes with b is half of that times the inverse of b;
/// as b turns by a spin W, by W b - b W, the logarithm turns alike.
class SlopeOfTheHalfLogarithm : public ::testing::TestWithParam<double> {
 protected:
  const Tensor<double> b = symmetric_part(rotated({{1 - GetParam(), 0, 0, 0, 1, 0, 0, 0, 1 + GetParam()}}));
  /// A product of dual numbers is three for one, and an axis turns by what is next to it over the gap.
  const double tolerance = GetParam() < Full::logarithm_reach / 2
                               ? 3 * logarithm_tolerance
                               : 3 * by_axes_tolerance * (1 + GetParam()) / (GetParam() * GetParam());

  [[nodiscard]] Tensor<double> slope(const Tensor<double>& change) const {
    using testing::Dual;
    Tensor<Dual> changing;
    for (std::size_t i = 0; i < 9; ++i) changing.components[i] = Dual{b.components[i], change.components[i]};
    const Tensor<Dual> strain = half_logarithm(symmetric(changing)).tensor();
    Tensor<double> result;
    for (std::size_t i = 0; i < 9; ++i) result.components[i] = strain.components[i].slope;
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(BothWays, SlopeOfTheHalfLogarithm, ::testing::Values(0.1, 0.5));

TEST_P(SlopeOfTheHalfLogarithm, IsThatOfANumberWhereAxesStay) {
  for (const auto& change : {isotropic(1.0), b, product(b, b)}) {
    EXPECT_LE(largest(product(2.0 * slope(change), b) - change), tolerance * norm(b) * norm(change));
  }
}

TEST_P(SlopeOfTheHalfLogarithm, TurnsWithTheAxes) {
  const auto strain = half_logarithm_of<Full>(b);
  for (const auto& gradient : velocity_gradients()) {
    const auto spin = skew_part(gradient);
    const auto turned = [&](const Tensor<double>& a) { return product(spin, a) - product(a, spin); };

    EXPECT_LE(largest(slope(turned(b)) - turned(strain)), tolerance * norm(turned(b)));
  }
}

}  // namespace
}  // namespace scree::rheology
