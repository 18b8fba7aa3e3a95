#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Dense granular flow that dilates: friction mu(I), and a packing that loosens with I. Sheared grains press
/// as hard as the volume that they are kept in demands; grains at rest are an elastic packing as loose as
/// they were left.
///
/// Its memory is the volume that the packing would have without pressure. It follows phi(I) over a strain,
/// solved for at the end of the step.
/// @see Eqs. (R11) to (R14) and (R77) to (R80), from Pouliquen et al. (2006), \cite pouliquen2006, and Pailha
/// & Pouliquen (2009), \cite pailha2009
struct MuPhiOfI {
  static constexpr std::string_view name = "mu_phi_of_i";
  static constexpr std::string_view summary = "granular flow that dilates: friction and packing by I";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool disconnects = false;    // sheared grains press at any density

  template <class Real>
  struct Input {
    Real grain_size;  ///< arithmetic mean s_a [m]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  struct State {
    Real unloaded_volume;  ///< v, of the packing without pressure, over that at rest [-]
  };
  static constexpr std::array<StateColumn, 1> states{{{"unloaded_volume", "-", 1, Interval{}}}};

  double mu_s;               ///< friction of slow flow [-]
  double mu_2;               ///< friction of fast flow [-]
  double I_0;                ///< inertial number half way between them [-]
  double dilation;           ///< a, growth of the volume with I [-]
  double relaxation_strain;  ///< gamma_r, shear over which the volume follows [-]
  double grain_density;      ///< rho_s, of the solid [kg/m^3]
  double shear_rate_floor;   ///< [1/s], keeps the viscosity finite at rest; error bound in Eq. (R14)
  double bulk_modulus;       ///< K, of a packing [Pa]
  double density;            ///< rho_0 of the bulk after slow flow, without pressure [kg/m^3]

  using Self = MuPhiOfI;
  static constexpr std::array<LawParameter<MuPhiOfI>, 9> parameters{{
      {"mu_s", "-", "friction of slow flow", &Self::mu_s, Bound::positive, 0.382},
      {.name = "mu_2",
       .unit = "-",
       .meaning = "friction of fast flow",
       .member = &Self::mu_2,
       .bound = Bound::positive,
       .typical = 0.644,
       .exceeds = &Self::mu_s},
      {"I_0", "-", "inertial number half way between them", &Self::I_0, Bound::positive, 0.279},
      {"dilation", "-", "growth of the volume with the inertial number", &Self::dilation, Bound::positive,
       0.33},
      {"relaxation_strain", "-", "shear over which the volume follows", &Self::relaxation_strain,
       Bound::positive, 0.2},
      {"grain_density", "kg/m^3", "density of the solid", &Self::grain_density, Bound::positive, 2500},
      {"shear_rate_floor", "1/s", "rate below which it creeps", &Self::shear_rate_floor, Bound::positive,
       1e-3},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Self::bulk_modulus, Bound::positive, 1e6},
      {"density", "kg/m^3", "density after slow flow, without pressure", &Self::density, Bound::positive,
       1500},
  }};

  /// Friction at yield [-].  Eq. (R164)
  [[nodiscard]] constexpr double yield_friction() const noexcept { return mu_s; }

  /// Cauchy stress [Pa] and unloaded volume at the end of the step.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& old,
                                                   Real dt) const noexcept {
    using std::sqrt;
    const Tensor<Real>& gradient = deformation.velocity_gradient;
    const Real volume = density / deformation.density;  // over that at rest
    const Real strain = shear_rate(gradient) * dt * (1 / relaxation_strain);
    const Real softness = sqrt(grain_density / bulk_modulus);
    const Real inertia = shear_rate(gradient) * input.grain_size * softness;  // I sqrt(p/K)
    const Real linear = (1.0 + strain) * volume - old.unloaded_volume - strain;
    const Root<Real> x =
        positive_root(Real((1.0 + strain) * volume), linear, Real(strain * dilation * inertia));
    const Real p = bulk_modulus * x.value * x.value;
    const Real gdot = floored_shear_rate(gradient, shear_rate_floor);
    const Real grain_rate = gdot * input.grain_size * sqrt(grain_density);
    const Real eta = mu_of_i_strength(mu_s, mu_2, I_0, grain_rate, Real(sqrt(bulk_modulus) * x.value)) / gdot;
    const Real kept = old.unloaded_volume;  // by grains apart that nothing stirs
    return {newtonian_stress(gradient, eta, p),
            {select(x.value == 0.0, kept, Real(volume * (1.0 + x.value * x.value)))},
            x.unsolved};
  }

  /// Wave speed of the packing [m/s], Eq. (R2), and viscosity at this rate and at the pressure of the state
  /// [Pa s].
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& input,
                                          const State<Real>& state) const noexcept {
    using std::sqrt;
    const Real unloaded = deformation.density * state.unloaded_volume;
    const Real p = contact_pressure(pressure(unloaded, density, bulk_modulus));
    const Real gdot = floored_shear_rate(deformation.velocity_gradient, shear_rate_floor);
    const Real grain_rate = gdot * input.grain_size * sqrt(grain_density);
    return {wave_speed(Real(density), Real(bulk_modulus * state.unloaded_volume)),
            mu_of_i_strength(mu_s, mu_2, I_0, grain_rate, Real(sqrt(p))) / gdot};
  }

 private:
  template <class Real>
  struct Root {
    Real value;
    Real unsolved;
  };

  /// The root x >= 0 of cubic x^3 + linear x = constant, where cubic > 0 and constant >= 0.  Eq. (R79)
  ///
  /// Left of the root nothing is lost: the function is convex there, and Newton's steps come down to the root
  /// from an upper bound that is at most twice as large. Seven steps reach round-off.
  template <class Real>
  [[nodiscard]] static Root<Real> positive_root(const Real& cubic, const Real& linear,
                                                const Real& constant) noexcept {
    using std::sqrt;
    constexpr int num_steps = 7;
    constexpr double tolerance = 1e-12;  // [-], of the terms
    const Real alone = elementary::pow(constant / cubic, Real(1.0 / 3.0));
    const Real ratio = constant / linear;
    const Real loose = select(ratio < alone, ratio, alone);
    const Real rest = select(linear < 0.0, Real(-linear), Real(0.0));
    Real x = select(linear <= 0.0, Real(sqrt(rest / cubic) + alone), loose);
    for (int i = 0; i < num_steps; ++i) {
      const Real slope = 3.0 * cubic * x * x + linear;
      x = select(slope <= 0.0, x, Real((2.0 * cubic * x * x * x + constant) / slope));
    }
    const Real left = x * (cubic * x * x + linear) - constant;
    const Real terms = x * (cubic * x * x + select(linear < 0.0, Real(-linear), linear)) + constant;
    const Real size = select(left < 0.0, Real(-left), left);
    return {x, select(size <= tolerance * terms, Real(0.0), Real(size / terms))};
  }
};
static_assert(DescribedLaw<MuPhiOfI> && HasYieldFriction<MuPhiOfI>);

}  // namespace scree::rheology
