#pragma once

#include <scree/constitutive_law.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace scree {

/// How hard material presses on a wall over one step, and how easily it is slowed there.
template <class Real>
struct WallContact {
  Real pressure;  ///< p, normal to the wall [Pa], not negative
  /// What one pascal of shear traction takes from the speed of sliding over the step [m/s/Pa]: dt A/m, with
  /// the area A and the mass m of the material on it.
  Real mobility;
};

/// The contract of those who move material along walls (mpm) and rheology (which supplies the laws): a value
/// type of parameters with two pure functions of one point. `Input` is an aggregate of Real, empty if there
/// is nothing to read, and `inputs` describes its members.
/// - traction(p, v, input): the largest shear traction at the sliding speed v >= 0 [Pa], not negative; it
/// acts
///   against the sliding, and holds what does not slide up to its value at v = 0.
/// - slowed(v, contact, input): the speed that is left of v at the end of the step, by backward Euler,
///   v' + mobility traction(p, v') = v; 0 where v <= mobility traction(p, 0), so that friction stops the
///   sliding and never reverses it.
template <class Law>
concept WallLaw = std::is_trivially_copyable_v<Law> &&
    requires(const Law law, const typename Law::template Input<double>& input,
             const WallContact<double>& contact, double x) {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::inputs.size() } -> std::convertible_to<std::size_t>;
  { law.traction(x, x, input) }
  noexcept->std::same_as<double>;
  { law.slowed(x, contact, input) }
  noexcept->std::same_as<double>;
};

/// The velocity that a wall leaves to material of `velocity`, which has been moved over a step as if there
/// were no wall: nothing into the wall, and along it what friction leaves. Material that moves away is left
/// alone.
/// @param velocity relative to the wall [m/s]  @param normal of unit length, into the material
/// @param mobility dt A/m, of `WallContact` [m/s/Pa], positive; the pressure is what stops the approach,
///   approach/mobility.
/// @see Eqs. (R160)-(R162)
template <int D, WallLaw Law>
[[nodiscard]] Vector<D> slide(const Law& law, const Vector<D>& velocity, const Vector<D>& normal,
                              double mobility, const typename Law::template Input<double>& input) noexcept {
  const double approach = -velocity.dot(normal);
  if (approach <= 0) return velocity;
  const Vector<D> tangential = velocity + approach * normal;
  const double speed = tangential.norm();
  if (speed == 0) return Vector<D>::Zero();
  return law.slowed(speed, WallContact<double>{approach / mobility, mobility}, input) / speed * tangential;
}

}  // namespace scree
