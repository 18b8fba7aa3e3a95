#pragma once

#include <scree/error.hpp>
#include <scree/mpm/concepts.hpp>
#include <scree/parameter.hpp>

#include <algorithm>

namespace scree::mpm {

/// Uniform generalised interpolation: the hat functions of Linear averaged over the box that a point fills at
/// first, so that their gradient does not jump. One point per axis makes them those of Quadratic, many those
/// of Linear. Boxes keep their size as material stretches.
/// @see Eq. (M111), Bardenhagen & Kober (2004), \cite bardenhagen2004
class Gimp {
 public:
  static constexpr std::string_view name = "gimp";
  static constexpr std::string_view summary =
      "hat functions averaged over the points' boxes (uniform GIMP), 3 nodes per axis";
  static constexpr std::array<Parameter, 1> parameters{
      {{"points_per_axis", "-", "points along each axis of a cell at the start, whose boxes fill it"}}};
  static constexpr std::size_t support = 3;
  static constexpr double shift = 0.5;

  /// @param points_per_axis of a cell, whose boxes fill it [-].  @throws InputError below 1.
  explicit constexpr Gimp(double points_per_axis = 2) : half_width_{0.5 / points_per_axis} {
    require(1 <= points_per_axis && 0 < half_width_, "Gimp: points_per_axis must be at least 1 and finite");
  }
  /// Half the edge of a point's box, l [spacings].
  [[nodiscard]] constexpr double half_width() const noexcept { return half_width_; }

  template <class Real>
  [[nodiscard]] constexpr std::array<Real, 3> weights(Real xi) const noexcept {
    const Beyond<Real> right = beyond(xi - 1);
    const Beyond<Real> left = beyond(1 - xi);
    const double scale = 0.25 / half_width_;
    const Real w_0 = scale * (left.far * left.far - left.near * left.near);
    const Real w_2 = scale * (right.far * right.far - right.near * right.near);
    return {w_0, 1 - w_0 - w_2, w_2};
  }
  template <class Real>
  [[nodiscard]] constexpr std::array<Real, 3> gradients(Real xi) const noexcept {
    const Beyond<Real> right = beyond(xi - 1);
    const Beyond<Real> left = beyond(1 - xi);
    const double scale = 0.5 / half_width_;
    const Real g_0 = scale * (left.near - left.far);
    const Real g_2 = scale * (right.far - right.near);
    return {g_0, -g_0 - g_2, g_2};
  }
  template <class Real>
  [[nodiscard]] constexpr std::array<Real, 3> affine(Real xi) const noexcept {
    const auto w = weights(xi);
    const Real inverse = 1 / second_moment(xi);
    return {-w[0] * xi * inverse, w[1] * (1 - xi) * inverse, w[2] * (2 - xi) * inverse};
  }
  /// At least l/2, with a point on a node.
  template <class Real>
  [[nodiscard]] constexpr Real second_moment(Real xi) const noexcept {
    const auto w = weights(xi);
    return w[0] * xi * xi + w[1] * (1 - xi) * (1 - xi) + w[2] * (2 - xi) * (2 - xi);
  }

 private:
  /// How far the ends of a point's box lie past the middle node, to one side; zero if they do not.
  template <class Real>
  struct Beyond {
    Real near;
    Real far;
  };
  template <class Real>
  [[nodiscard]] constexpr Beyond<Real> beyond(Real middle) const noexcept {
    using std::max;
    return {max(middle - half_width_, Real(0)), max(middle + half_width_, Real(0))};
  }

  double half_width_;
};
static_assert(Shape<Gimp>);

}  // namespace scree::mpm
