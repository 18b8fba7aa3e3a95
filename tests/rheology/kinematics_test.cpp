#include "points.hpp"

#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/plane_symmetric.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

TEST(MidpointIncrement, IsTheMidpointRule) {  // Eq. (R18)
  for (const auto& gradient : velocity_gradients()) {
    const auto a = 0.1 * gradient;
    const auto left = product(isotropic(1.0) - 0.5 * a, midpoint_increment(a));

    EXPECT_LE(largest(left - (isotropic(1.0) + 0.5 * a)), 30 * round_off);  // some thirty operations
  }
}

TEST(MidpointIncrement, IsARotationOfASpin) {  // Eq. (R18)
  for (const auto& gradient : velocity_gradients()) {
    const auto rotation = midpoint_increment(skew_part(gradient));

    EXPECT_LE(largest(product(transposed(rotation), rotation) - isotropic(1.0)), 60 * round_off);
  }
}

TEST(Turned, IsTheRotationOfTheMidpointIncrement) {  // Eq. (R18): the closed form of a spin
  const auto stresses = velocity_gradients();
  for (std::size_t n = 0; n < stresses.size(); ++n) {
    const auto& gradient = stresses[(n + 1) % stresses.size()];
    const auto a = symmetric_part(stresses[n]);
    const auto expected = carried_by(midpoint_increment(0.5 * skew_part(gradient)), a);

    const auto actual = turned(symmetric(a), gradient, 0.5).tensor();

    EXPECT_LE(largest(actual - expected), 60 * round_off * 3);  // some sixty operations on sums of three
  }
}

TEST(Carried, IsTheSameInThePlaneForm) {  // Eq. (R18), with a stretch along z
  const auto tensors = velocity_gradients();
  for (std::size_t n = 0; n < tensors.size(); ++n) {
    auto gradient = tensors[n];
    gradient(0, 2) = gradient(1, 2) = gradient(2, 0) = gradient(2, 1) = 0;
    const auto a = symmetric_part(tensors[(n + 1) % tensors.size()]);
    const PlaneSymmetric<double> plane{a(0, 0), a(1, 1), a(2, 2), a(0, 1)};

    const auto expected = carried(symmetric(plane.tensor()), gradient, 0.1).tensor();
    const auto actual = carried(plane, gradient, 0.1).tensor();

    EXPECT_LE(largest(actual - expected), 60 * round_off * 3);  // as above
  }
}

TEST(DeviatoricRate, IsTheDeviatorOfTheSymmetricPart) {
  for (const auto& gradient : velocity_gradients()) {
    const auto expected = deviator(symmetric_part(gradient));
    const auto actual = deviatoric_rate(gradient);

    EXPECT_LE(largest(actual.tensor() - expected), 8 * round_off);
    EXPECT_NEAR(squared_norm(actual), contract(expected, expected), 9 * 8 * round_off);
  }
}

}  // namespace
}  // namespace scree::rheology
