#pragma once

#include <scree/mpm/concepts.hpp>

namespace scree::mpm {

/// Quadratic B-splines over three nodes: their gradient is continuous, so points cross cells quietly.
/// @see Eq. (M5), Steffen, Kirby & Berzins (2008), \cite steffen2008
struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static constexpr std::string_view summary =
      "quadratic B-splines, 3 nodes per axis; for points that cross cells";
  static constexpr std::size_t support = 3;
  static constexpr double inverse_moment = 4;
  static constexpr double shift = 0.5;

  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 3> weights(Real xi) noexcept {
    return {0.5 * (1.5 - xi) * (1.5 - xi), 0.75 - (xi - 1) * (xi - 1), 0.5 * (xi - 0.5) * (xi - 0.5)};
  }
  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 3> gradients(Real xi) noexcept {
    return {xi - 1.5, -2 * (xi - 1), xi - 0.5};
  }
  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 3> affine(Real xi) noexcept {
    const auto w = weights(xi);
    return {-inverse_moment * w[0] * xi, inverse_moment * w[1] * (1 - xi), inverse_moment * w[2] * (2 - xi)};
  }
  template <class Real>
  [[nodiscard]] static constexpr Real second_moment(Real /*xi*/) noexcept {
    return Real(1 / inverse_moment);
  }
};
static_assert(Shape<Quadratic>);

}  // namespace scree::mpm
