#pragma once

#include <scree/mpm/concepts.hpp>

namespace scree::mpm {

/// Cubic B-splines over four nodes: their second derivative is continuous too, so points cross cells more
/// quietly still, at a third more cost per axis.
/// @see Eq. (M110), Steffen, Kirby & Berzins (2008), \cite steffen2008
struct Cubic {
  static constexpr std::string_view name = "cubic";
  static constexpr std::string_view summary = "cubic B-splines, 4 nodes per axis; smoothest, and dearest";
  static constexpr std::size_t support = 4;
  static constexpr double inverse_moment = 3;
  static constexpr double shift = 1;

  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 4> weights(Real xi) noexcept {
    constexpr double sixth = 1.0 / 6;
    constexpr double peak = 2.0 / 3;
    const Real t = xi - 1;  // from the second node
    const Real s = 2 - xi;  // to the third
    return {sixth * s * s * s, peak - 0.5 * t * t * (1 + s), peak - 0.5 * s * s * (1 + t), sixth * t * t * t};
  }
  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 4> gradients(Real xi) noexcept {
    const Real t = xi - 1;
    const Real s = 2 - xi;
    return {-0.5 * s * s, t * (1.5 * t - 2), s * (2 - 1.5 * s), 0.5 * t * t};
  }
  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 4> affine(Real xi) noexcept {
    const auto w = weights(xi);
    return {-inverse_moment * w[0] * xi, inverse_moment * w[1] * (1 - xi), inverse_moment * w[2] * (2 - xi),
            inverse_moment * w[3] * (3 - xi)};
  }
  template <class Real>
  [[nodiscard]] static constexpr Real second_moment(Real /*xi*/) noexcept {
    return Real(1 / inverse_moment);
  }
};
static_assert(Shape<Cubic>);

}  // namespace scree::mpm
