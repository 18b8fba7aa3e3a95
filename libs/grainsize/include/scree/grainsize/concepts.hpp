#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

namespace scree::grainsize {

/// What a closure sees of a face between two control volumes. Left and right follow the face's normal.
struct FaceDrive {
  double left;      ///< drive of the volume the normal leaves [unit of the closure's drive]
  double right;     ///< drive of the volume it enters
  double distance;  ///< between their centres [m], positive
  double gravity;   ///< component of the unit vector of gravity along the normal [-]
};

/// A segregation closure: the driver B of Eq. (G3), in two steps.
///
/// `drive(shear_rate, mean_size)` is evaluated on the material points, from |gdot| [1/s] and the arithmetic
/// mean size s_a [m], and averaged to control volumes by mass. `velocity(face)` is the component of B along
/// the normal of a face between two volumes [m/s]; where it is positive, grains coarser than the harmonic
/// mean move along the normal and finer ones against it. `unit` is that of the closure's constant c.
template <class C>
concept Closure = std::is_trivially_copyable_v<C> &&
    requires(const C closure, double x, const FaceDrive& face) {
  { C::name } -> std::convertible_to<std::string_view>;
  { C::summary } -> std::convertible_to<std::string_view>;
  { C::unit } -> std::convertible_to<std::string_view>;
  { closure.drive(x, x) }
  noexcept->std::same_as<double>;
  { closure.velocity(face) }
  noexcept->std::same_as<double>;
};

}  // namespace scree::grainsize
