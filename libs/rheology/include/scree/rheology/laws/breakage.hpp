#pragma once

#include <scree/rheology/breakage_return.hpp>
#include <scree/rheology/columns.hpp>
#include <scree/rheology/concepts.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/logarithmic_strain.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

namespace scree::rheology {

/// Brittle grains under high pressure: elastic in logarithmic strain, softer as they break, crushed where
/// their elastic energy suffices and sheared by friction. The breakage B, from 0 (as found) to 1 (as fine as
/// they get), says how far the size distribution has moved to its ultimate one.
///
/// A step is solved backward in time, so that B neither falls nor exceeds 1 in a step of any length. The
/// volume of the elastic strain is that of the density less what was compacted for good; pulled apart, grains
/// bear nothing until they are as dense again as where they let go.
/// @see Eqs. (R21), (R110) to (R119) and (R183), from Einav (2007), \cite einav2007, \cite einav2007b
struct Breakage {
  static constexpr std::string_view name = "breakage";
  static constexpr std::string_view summary = "grains that are crushed, and become finer";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool remembers_deviator = true;
  static constexpr bool disconnects = false;  // the density at which they let go grows as they are compacted

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real, template <class> class Form>
  struct Memory {
    Form<Real> strain;  ///< elastic logarithmic strain, of trace 0 [-]
    Real compaction;    ///< ln(density/rho_0) at which the pressure vanishes [-]
    Real breakage;      ///< B [-]
  };
  template <class Real>
  using State = Memory<Real, Symmetric>;
  template <class Real>
  using PlaneState = Memory<Real, PlaneSymmetric>;
  static constexpr std::array<StateColumn, 8> states = followed_by(
      elastic_strain_columns, StateColumn{"compaction", "-", 0, Interval{.upper = 1, .is_open = false}},
      StateColumn{"breakage", "-", 0, Interval{.upper = 1}});
  static constexpr std::array<std::size_t, 6> plane_states{0, 1, 2, 3, 6, 7};

  double bulk_modulus;           ///< K of unbroken grains [Pa]
  double shear_modulus;          ///< G of unbroken grains [Pa]
  double grading;                ///< theta, share of the elastic energy that breaking all would release [-]
  double critical_energy;        ///< E_c [Pa]
  double critical_stress_ratio;  ///< M, q/p of grains that no longer break [-]
  double coupling_angle;         ///< omega [degrees]: 0 breaks without compacting, 90 would only compact
  double density;                ///< rho_0, of the bulk without pressure [kg/m^3]

  using Self = Breakage;
  static constexpr std::array<LawParameter<Breakage>, 7> parameters{{
      {"bulk_modulus", "Pa", "pressure per logarithmic compression", &Self::bulk_modulus, Bound::positive,
       2e8},
      {"shear_modulus", "Pa", "elastic shear modulus", &Self::shear_modulus, Bound::positive, 8e7},
      {"grading", "-", "distance of the ultimate sizes from those at first", &Self::grading, Bound::positive,
       0.85, 1},
      {"critical_energy", "Pa", "energy at which grains break", &Self::critical_energy, Bound::positive, 5e4},
      {"critical_stress_ratio", "-", "q/p of grains that no longer break", &Self::critical_stress_ratio,
       Bound::positive, 1.2},
      {"coupling_angle", "degrees", "how much breaking compacts", &Self::coupling_angle, Bound::positive, 70,
       90},
      {"density", "kg/m^3", "density without pressure", &Self::density, Bound::positive, 1600},
  }};

  /// Pressure at which unbroken grains break if compressed alike from all sides, p_cr [Pa].  Eq. (R112)
  [[nodiscard]] double crushing_pressure() const noexcept {
    return std::sqrt(2 * bulk_modulus * critical_energy / grading);
  }

  /// Cauchy stress [Pa], elastic strain, compaction and breakage at the end of the step.
  template <class Real, template <class> class Form>
  [[nodiscard]] Response<Real, Memory<Real, Form>> update(const Deformation<Real>& deformation,
                                                          const Input<Real>& /*input*/,
                                                          const Memory<Real, Form>& old,
                                                          Real dt) const noexcept {
    using std::sqrt;
    const double strain_unit = crushing_pressure() / bulk_modulus;
    const double shape_unit = strain_unit * std::sqrt(bulk_modulus / (3 * shear_modulus));
    const Real compression = deformation.density * (1 / density);  // 1/J
    const Real total = elementary::log_near_one(compression);
    const Form<Real> strain = trial_strain(old.strain, deformation.velocity_gradient, dt);
    const Real size = sqrt((2.0 / 3) * squared_norm(strain));
    const BreakageState<Real> trial{(total - old.compaction) * (1 / strain_unit), size * (1 / shape_unit),
                                    old.breakage};
    const BreakageState<Real> end = returned(trial);
    const Real is_connected = select(trial.volume <= 0.0, Real(0.0), Real(1.0));
    const Real kept = is_connected * select(trial.shape == 0.0, Real(1.0), end.shape / trial.shape);
    const Real softened = is_connected * compression * (1.0 - grading * end.breakage);
    const Form<Real> elastic = kept * strain;
    const Form<Real> shear = (softened * (2 * shear_modulus)) * elastic;
    const Real p = softened * (bulk_modulus * strain_unit) * end.volume;
    const Real compaction = old.compaction + (trial.volume - end.volume) * strain_unit;
    return {shear.tensor() - isotropic(p), {elastic, compaction, end.breakage}, end.unsolved};
  }

  /// Speed of pressure waves [m/s] of the elastic material, as broken as it is, and no viscosity.  Eq. (R21)
  template <class Real, template <class> class Form>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/,
                                          const Input<Real>& /*input*/,
                                          const Memory<Real, Form>& state) const noexcept {
    const Real softened = 1.0 - grading * state.breakage;
    return {wave_speed(Real(density), Real(softened * (bulk_modulus + 4 * shear_modulus / 3))), Real(0.0)};
  }

 private:
  /// The trial itself where it is elastic or pulled apart, else its return to the yield surface.
  template <class Real>
  [[nodiscard]] BreakageState<Real> returned(const BreakageState<Real>& trial) const noexcept {
    const double cosine = std::cos(coupling_angle * std::numbers::pi / 180);
    const BreakageReturn flow{grading, cosine * cosine,
                              std::sqrt(3 * shear_modulus / bulk_modulus) / critical_stress_ratio};
    const BreakageState<Real> plastic = flow(trial);
    const auto flows = Real(0.0) < flow.yield(trial) && Real(0.0) < trial.volume;
    return {select(flows, plastic.volume, trial.volume), select(flows, plastic.shape, trial.shape),
            select(flows, plastic.breakage, trial.breakage), select(flows, plastic.unsolved, Real(0.0))};
  }
};
static_assert(DescribedLaw<Breakage> && HasPlaneForm<Breakage>);

}  // namespace scree::rheology
