#pragma once

#include <scree/constitutive_law.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::mpm {

/// A weakly compressible viscous material that bears tension too: sigma = -K (rho/rho_0 - 1) 1 + 2 mu D'.
/// Linear for small disturbances, so that waves and diffusion in it have closed forms.
struct Fluid {
  static constexpr std::string_view name = "fluid";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double bulk_modulus;       ///< K [Pa]
  double reference_density;  ///< rho_0 [kg/m^3]
  double viscosity;          ///< mu [Pa s]

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& /*input*/, const State<Real>& /*old*/,
                                                   Real /*dt*/) const noexcept {
    const Real pressure = bulk_modulus * (deformation.density / reference_density - 1);
    const Tensor<Real> viscous = 2 * viscosity * deviator(symmetric_part(deformation.velocity_gradient));
    return {viscous - isotropic(pressure), {}};
  }
  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>& /*deformation*/,
                                            const Input<double>& /*input*/,
                                            const State<double>& /*state*/) const noexcept {
    return {std::sqrt(bulk_modulus / reference_density), viscosity};
  }
};
static_assert(ConstitutiveLaw<Fluid>);

/// Material that resists nothing.
inline constexpr Fluid dust{.bulk_modulus = 0, .reference_density = 1000, .viscosity = 0};

}  // namespace scree::mpm
