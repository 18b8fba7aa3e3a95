#pragma once

#include <scree/constitutive_law.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::mpm {

/// A solid that keeps its form: the stress turns with the material and grows with its rate of deformation.
struct Rubber {
  static constexpr std::string_view name = "rubber";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {
    Real xx, yy, zz, yz, xz, xy;  ///< of the stress [Pa]
  };
  static constexpr std::array<StateColumn, 6> states{
      {{"sxx", "Pa"}, {"syy", "Pa"}, {"szz", "Pa"}, {"syz", "Pa"}, {"sxz", "Pa"}, {"sxy", "Pa"}}};

  double bulk_modulus;   ///< K [Pa]
  double shear_modulus;  ///< G [Pa]
  double density;        ///< [kg/m^3]

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& /*input*/, const State<Real>& old,
                                                   Real dt) const noexcept {
    const Tensor<Real>& gradient = deformation.velocity_gradient;
    const Tensor<Real> rate = symmetric_part(gradient);
    Tensor<Real> stress{{old.xx, old.xy, old.xz, old.xy, old.yy, old.yz, old.xz, old.yz, old.zz}};
    const Tensor<Real> before = stress;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t k = 0; k < 3; ++k) {
          stress(i, j) = stress(i, j) + dt * ((gradient(i, k) - rate(i, k)) * before(k, j) -
                                              before(i, k) * (gradient(k, j) - rate(k, j)));
        }
      }
    }
    stress += dt * isotropic(bulk_modulus * trace(rate)) + 2 * dt * shear_modulus * deviator(rate);
    return {stress, {stress(0, 0), stress(1, 1), stress(2, 2), stress(1, 2), stress(0, 2), stress(0, 1)}};
  }
  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>& /*deformation*/,
                                            const Input<double>& /*input*/,
                                            const State<double>& /*state*/) const noexcept {
    return {std::sqrt((bulk_modulus + 4 * shear_modulus / 3) / density), 0};
  }
};
static_assert(ConstitutiveLaw<Rubber>);

}  // namespace scree::mpm
