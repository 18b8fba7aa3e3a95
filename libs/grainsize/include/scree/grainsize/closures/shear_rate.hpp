#pragma once

#include <scree/error.hpp>
#include <scree/grainsize/concepts.hpp>
#include <scree/parameter.hpp>

#include <cmath>

namespace scree::grainsize {

/// Kinetic pressure that follows the shear rate, p_k = rho |gdot|, so that B = -c grad |gdot|.
///
/// The paper's closure, read as an isotropic pressure. Coupled both ways to a viscosity that rises with the
/// mean size it is ill-posed, see well_posedness.hpp.
/// @see Eq. (G6), \cite marks2015
class ShearRate {
 public:
  static constexpr std::string_view name = "shear_rate";
  static constexpr std::string_view summary =
      "coarse grains move towards lower shear rate: B = -c grad(gdot)";
  static constexpr std::string_view unit = "m^2";
  static constexpr std::array<Parameter, 1> parameters{{{"c", unit, "strength of segregation"}}};

  /// @param c strength [m^2]; negative turns the direction round.  @throws InputError unless it is finite.
  explicit ShearRate(double c) : c_{c} { require(std::isfinite(c), "ShearRate: c must be finite"); }

  /// p_k/rho per unit of c: |gdot| [1/s].
  [[nodiscard]] double drive(double shear_rate, double /*mean_size*/) const noexcept { return shear_rate; }

  /// @returns the component of B along the normal [m/s]
  [[nodiscard]] double velocity(const FaceDrive& face) const noexcept {
    return -c_ * (face.right - face.left) / face.distance;
  }

 private:
  double c_;
};
static_assert(Closure<ShearRate>);

}  // namespace scree::grainsize
