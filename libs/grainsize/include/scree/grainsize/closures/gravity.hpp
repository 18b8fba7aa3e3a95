#pragma once

#include <scree/error.hpp>
#include <scree/grainsize/concepts.hpp>
#include <scree/parameter.hpp>

#include <cmath>

namespace scree::grainsize {

/// Kinetic sieving: coarse grains rise against gravity in proportion to the shear rate, B = -c |gdot| g/|g|.
/// @see Eq. (G8), \cite gray2005, \cite marks2012
class Gravity {
 public:
  static constexpr std::string_view name = "gravity";
  static constexpr std::string_view summary =
      "coarse grains rise where the material shears: B = -c gdot g/|g|";
  static constexpr std::string_view unit = "m";
  static constexpr std::array<Parameter, 1> parameters{{{"c", unit, "rise per unit of shear"}}};

  /// @param c rise per unit of shear [m]; negative lets the coarse sink.  @throws InputError unless finite.
  explicit Gravity(double c) : c_{c} { require(std::isfinite(c), "Gravity: c must be finite"); }

  /// |gdot| [1/s].
  [[nodiscard]] double drive(double shear_rate, double /*mean_size*/) const noexcept { return shear_rate; }

  /// @returns the component of B along the normal [m/s], from the mean shear rate of the two volumes
  [[nodiscard]] double velocity(const FaceDrive& face) const noexcept {
    return -c_ * face.gravity * (face.left + face.right) / 2;
  }

 private:
  double c_;
};
static_assert(Closure<Gravity>);

}  // namespace scree::grainsize
