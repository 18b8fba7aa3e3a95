#pragma once

#include <scree/constitutive_law.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace demo {

/// An elastic solid in the plane for small turns: the rate of stress is K tr(D) 1 + 2 G dev(D). How such a
/// law is written is the idea of `own_law`.
struct Elastic {
  static constexpr std::string_view name = "elastic";
  template <class Real>
  struct Input {};
  static constexpr std::array<scree::InputColumn, 0> inputs{};
  template <class Real>
  struct State {
    Real xx, yy, zz, xy;  ///< of the stress [Pa]
  };
  static constexpr std::array<scree::StateColumn, 4> states{
      {{"stress_xx", "Pa"}, {"stress_yy", "Pa"}, {"stress_zz", "Pa"}, {"stress_xy", "Pa"}}};

  double bulk_modulus;   ///< K [Pa]
  double shear_modulus;  ///< G [Pa]
  double density;        ///< [kg/m^3]

  [[nodiscard]] double wave_speed() const noexcept {
    return std::sqrt((bulk_modulus + 4 * shear_modulus / 3) / density);
  }

  template <class Real>
  [[nodiscard]] scree::Response<Real, State<Real>> update(const scree::Deformation<Real>& deformation,
                                                          const Input<Real>& /*input*/,
                                                          const State<Real>& old, Real dt) const noexcept {
    const scree::Tensor<Real> D = symmetric_part(deformation.velocity_gradient);
    scree::Tensor<Real> stress{{old.xx, old.xy, 0, old.xy, old.yy, 0, 0, 0, old.zz}};
    stress += dt * scree::isotropic(bulk_modulus * trace(D)) + 2 * dt * shear_modulus * deviator(D);
    return {stress, {stress(0, 0), stress(1, 1), stress(2, 2), stress(0, 1)}};
  }
  [[nodiscard]] scree::Stiffness<double> stiffness(const scree::Deformation<double>& /*deformation*/,
                                                   const Input<double>& /*input*/,
                                                   const State<double>& /*state*/) const noexcept {
    return {wave_speed(), 0};
  }
};
static_assert(scree::ConstitutiveLaw<Elastic>);

}  // namespace demo
