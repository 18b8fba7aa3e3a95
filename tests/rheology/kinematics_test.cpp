#include "points.hpp"

#include <scree/rheology/kinematics.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace scree::rheology {
namespace {

/// (1 - A/2)^-1 (1 + A/2): what the midpoint rule makes of dF/dt = W F over a step with A = W dt.
[[nodiscard]] Tensor<double> midpoint_rotation(const Tensor<double>& spin) {
  Eigen::Matrix3d a;
  for (int i = 0; i < 9; ++i) a(i / 3, i % 3) = spin.components[static_cast<std::size_t>(i)];
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d r = (one - 0.5 * a).inverse() * (one + 0.5 * a);
  Tensor<double> result;
  for (int i = 0; i < 9; ++i) result.components[static_cast<std::size_t>(i)] = r(i / 3, i % 3);
  return result;
}

TEST(Turned, IsTheRotationOfTheMidpointRule) {  // Eq. (R18)
  const auto stresses = velocity_gradients();
  for (std::size_t n = 0; n < stresses.size(); ++n) {
    const auto& gradient = stresses[(n + 1) % stresses.size()];
    const auto a = symmetric_part(stresses[n]);
    const auto expected = carried_by(midpoint_rotation(0.5 * skew_part(gradient)), a);

    const auto actual = turned(symmetric(a), gradient, 0.5).tensor();

    EXPECT_LE(largest(actual - expected),
              60 * round_off * 3);  // some sixty operations on sums of three, an inverse among them
    EXPECT_NEAR(contract(actual, actual), contract(a, a), 60 * round_off * 3 * contract(a, a));
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
