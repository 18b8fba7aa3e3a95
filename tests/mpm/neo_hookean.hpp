#pragma once

#include <scree/constitutive_law.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::mpm {

/// Compressible neo-Hookean solid in plane strain, as a user would write it: its memory is the deformation
/// gradient F, and sigma = (lambda ln J 1 + mu (F F^T - 1))/J with J = det F.  @see Eq. (M80)
struct NeoHookean {
  static constexpr std::string_view name = "neo_hookean";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {
    Real xx;
    Real xy;
    Real yx;
    Real yy;
  };
  static constexpr std::array<StateColumn, 4> states{{{"deformation_gradient_xx", "-", 1},
                                                      {"deformation_gradient_xy", "-", 0},
                                                      {"deformation_gradient_yx", "-", 0},
                                                      {"deformation_gradient_yy", "-", 1}}};

  double lambda;   ///< [Pa]
  double mu;       ///< [Pa]
  double density;  ///< of the undeformed solid [kg/m^3]

  /// Speed of compression waves in the undeformed solid [m/s].
  [[nodiscard]] double wave_speed() const { return std::sqrt((lambda + 2 * mu) / density); }

  template <class Real>
  [[nodiscard]] Tensor<Real> stress(const State<Real>& F) const noexcept {
    using std::log;
    const Real J = F.xx * F.yy - F.xy * F.yx;
    const Real volumetric = lambda * log(J);
    Tensor<Real> sigma;
    sigma(0, 0) = (volumetric + mu * (F.xx * F.xx + F.xy * F.xy - 1)) / J;
    sigma(1, 1) = (volumetric + mu * (F.yx * F.yx + F.yy * F.yy - 1)) / J;
    sigma(2, 2) = volumetric / J;
    sigma(0, 1) = sigma(1, 0) = mu * (F.xx * F.yx + F.xy * F.yy) / J;
    return sigma;
  }

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& /*input*/, const State<Real>& F,
                                                   Real dt) const noexcept {
    const Tensor<Real>& L = deformation.velocity_gradient;
    const State<Real> next{
        F.xx + dt * (L(0, 0) * F.xx + L(0, 1) * F.yx), F.xy + dt * (L(0, 0) * F.xy + L(0, 1) * F.yy),
        F.yx + dt * (L(1, 0) * F.xx + L(1, 1) * F.yx), F.yy + dt * (L(1, 0) * F.xy + L(1, 1) * F.yy)};
    return {stress(next), next};
  }
  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>& /*deformation*/,
                                            const Input<double>& /*input*/,
                                            const State<double>& /*state*/) const noexcept {
    return {wave_speed(), 0};
  }
};
static_assert(ConstitutiveLaw<NeoHookean>);

}  // namespace scree::mpm
