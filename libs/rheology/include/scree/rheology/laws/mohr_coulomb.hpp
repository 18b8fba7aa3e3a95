#pragma once

#include <scree/rheology/columns.hpp>
#include <scree/rheology/concepts.hpp>
#include <scree/rheology/eigen_symmetric.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/logarithmic_strain.hpp>
#include <scree/rheology/mohr_coulomb_return.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// Soil at large strain by the strength of Mohr and Coulomb: elastic in the logarithmic (Hencky) strain,
/// shear stress on any plane up to cohesion plus friction times pressure, no principal stress above a
/// tension, flow that dilates by an angle of its own.
///
/// Its memory is the elastic strain at constant volume and the volume that shear has added. What it is pulled
/// apart by beyond that is not remembered: it bears load again at the density where it let go, not before.
/// @see Eqs. (R21), (R50) to (R61) and (R183), after Clausen et al. (2007), \cite clausen2007
struct MohrCoulomb {
  static constexpr std::string_view name = "mohr_coulomb";
  static constexpr std::string_view summary =
      "soil with friction, cohesion, dilatancy and a limit of tension";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool remembers_deviator = true;

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {
    Real xx, yy, zz, xy, xz, yz;  ///< elastic logarithmic strain, of trace 0 [-]
    Real dilation;                ///< logarithmic volume that flow has added [-]
  };
  static constexpr std::array<StateColumn, 7> states =
      followed_by(elastic_strain_columns, StateColumn{"dilation", "-", 0, Interval{-1, 1}});

  double friction;          ///< tangent of the friction angle phi [-]
  double cohesion;          ///< c, shear stress at yield without pressure [Pa]
  double dilatancy;         ///< tangent of the dilatancy angle psi [-]
  double tension_strength;  ///< largest principal stress [Pa]; c/tan(phi) where that is less
  double shear_modulus;     ///< G [Pa]
  double bulk_modulus;      ///< K [Pa]
  double density;           ///< rho_0, of the unloaded material [kg/m^3]

  static constexpr std::array<LawParameter<MohrCoulomb>, 7> parameters{{
      {.name = "friction",
       .unit = "-",
       .meaning = "tangent of the friction angle",
       .member = &MohrCoulomb::friction,
       .bound = Bound::non_negative,
       .typical = 0.577,
       .exceeds = &MohrCoulomb::dilatancy,
       .may_equal = true},
      {"cohesion", "Pa", "shear stress at yield without pressure", &MohrCoulomb::cohesion,
       Bound::non_negative, 1e3},
      {"dilatancy", "-", "tangent of the dilatancy angle", &MohrCoulomb::dilatancy, Bound::non_negative,
       0.176},
      {"tension_strength", "Pa", "largest principal stress, up to the apex", &MohrCoulomb::tension_strength,
       Bound::non_negative, 0},
      {"shear_modulus", "Pa", "elastic shear modulus", &MohrCoulomb::shear_modulus, Bound::positive, 5e5},
      {"bulk_modulus", "Pa", "pressure per logarithmic compression", &MohrCoulomb::bulk_modulus,
       Bound::positive, 1e6},
      {"density", "kg/m^3", "density of the unloaded material", &MohrCoulomb::density, Bound::positive, 1500},
  }};

  /// Friction at yield [-].  Eq. (R164)
  [[nodiscard]] constexpr double yield_friction() const noexcept { return friction; }

  /// Cauchy stress [Pa], elastic strain and dilation at the end of the step.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& /*input*/, const State<Real>& old,
                                                   Real dt) const noexcept {
    const Real compression = deformation.density * (1 / density);  // 1/J
    const Symmetric<Real> e{old.xx, old.yy, old.zz, old.xy, old.xz, old.yz};
    const Symmetric<Real> elastic = trial_strain(e, deformation.velocity_gradient, dt);
    auto [strain, axes] = descending(eigen_symmetric(elastic.tensor()));
    const Real mean_trial = bulk_modulus * (-elementary::log_near_one(compression) - old.dilation);
    Principal<Real> trial{};  // J times that of Cauchy
    for (std::size_t i = 0; i < 3; ++i) trial[i] = 2.0 * shear_modulus * strain[i] + mean_trial;
    const Strength strength = strength_at_rest();
    const Real tension = strength.tension / compression;
    const Principal<Real> tau =
        mohr_coulomb_return(trial, flow(), Real(strength.limit / compression), tension, stress_rounding());

    const Real is_closed = select(tension - stress_rounding() < tau[2], Real(0.0), Real(1.0));
    const auto is_elastic = tau[0] == trial[0] && tau[1] == trial[1] && tau[2] == trial[2];
    const Real lost = trial[0] - tau[0] + (trial[1] - tau[1]) + (trial[2] - tau[2]);  // 0 if elastic
    const Real dilation = old.dilation + is_closed * lost * (1 / (3 * bulk_modulus));
    Principal<Real> stress{};
    for (std::size_t i = 0; i < 3; ++i) {
      stress[i] = compression * tau[i];
      const Real over_others = (tau[i] - tau[(i + 1) % 3]) + (tau[i] - tau[(i + 2) % 3]);  // 0 at the apex
      strain[i] = select(is_elastic, strain[i], over_others * (1 / (6 * shear_modulus)));
    }
    const Symmetric<Real> s = symmetric(composed(strain, axes));
    return {composed(stress, axes), {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz, dilation}};
  }

  /// Speed of pressure waves [m/s] of the unloaded material, and no viscosity.  Eq. (R21)
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/,
                                          const Input<Real>& /*input*/,
                                          const State<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus + 4 * shear_modulus / 3), 0};
  }

 private:
  struct Strength {
    double limit;    ///< 2 c cos(phi) [Pa]
    double tension;  ///< largest principal stress [Pa]
  };

  /// Of the Cauchy stress. The apex is at c/tan(phi), which no frictionless material has.  Eqs. (R51), (R55)
  [[nodiscard]] Strength strength_at_rest() const noexcept {
    const bool is_cut = tension_strength * friction <= cohesion;
    return {2 * cohesion / std::sqrt(1 + friction * friction),
            is_cut ? tension_strength : cohesion / friction};
  }

  [[nodiscard]] MohrCoulombFlow flow() const noexcept {
    return {friction / std::sqrt(1 + friction * friction), dilatancy / std::sqrt(1 + dilatancy * dilatancy),
            shear_modulus, bulk_modulus - 2 * shear_modulus / 3};
  }

  /// Of trial stresses [Pa], whose strains are differences of numbers of order one.
  [[nodiscard]] double stress_rounding() const noexcept {
    constexpr double num_operations = 60;
    return num_operations * round_off * (2 * shear_modulus + bulk_modulus);
  }
};
static_assert(DescribedLaw<MohrCoulomb> && HasYieldFriction<MohrCoulomb>);

}  // namespace scree::rheology
