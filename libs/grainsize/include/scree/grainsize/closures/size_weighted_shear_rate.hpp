#pragma once

#include <scree/error.hpp>
#include <scree/grainsize/concepts.hpp>
#include <scree/parameter.hpp>

#include <cmath>

namespace scree::grainsize {

/// Kinetic pressure that follows shear rate and grain size, p_k = rho (s_a/s_ref) |gdot|.
///
/// Where the viscosity is proportional to s_a, p_k is proportional to the shear stress and the two-way
/// coupled flow is well posed, see well_posedness.hpp.
/// @see Eq. (G7)
class SizeWeightedShearRate {
 public:
  static constexpr std::string_view name = "size_weighted_shear_rate";
  static constexpr std::string_view summary =
      "coarse grains move towards lower s_a gdot: B = -c grad(gdot s_a/s_ref)";
  static constexpr std::string_view unit = "m^2";
  static constexpr std::array<Parameter, 2> parameters{
      {{"c", unit, "strength of segregation"}, {"reference_size", "m", "size at which c is the strength"}}};

  /// @param c strength at the reference size [m^2]; negative turns the direction round
  /// @param reference_size s_ref [m]
  /// @throws InputError unless c is finite and s_ref positive and finite.
  SizeWeightedShearRate(double c, double reference_size) : c_{c}, reference_size_{reference_size} {
    require(std::isfinite(c), "SizeWeightedShearRate: c must be finite");
    require(reference_size > 0 && std::isfinite(reference_size),
            "SizeWeightedShearRate: the reference size must be positive and finite");
  }

  /// p_k/rho per unit of c: |gdot| s_a/s_ref [1/s]. The product is formed on the point, where shear rate and
  /// size belong together.
  [[nodiscard]] double drive(double shear_rate, double mean_size) const noexcept {
    return shear_rate * mean_size / reference_size_;
  }

  /// @returns the component of B along the normal [m/s]
  [[nodiscard]] double velocity(const FaceDrive& face) const noexcept {
    return -c_ * (face.right - face.left) / face.distance;
  }

 private:
  double c_;
  double reference_size_;
};
static_assert(Closure<SizeWeightedShearRate>);

}  // namespace scree::grainsize
