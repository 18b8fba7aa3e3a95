#pragma once

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

/// Cohesionless sand at large strain: elastic in the logarithmic (Hencky) strain, shear stress up to friction
/// times pressure, plastic flow at constant volume, stress-free where it has been pulled apart.
///
/// The volume of the elastic strain is that of the material itself, which is what the volume correction of
/// Tampubolon et al. amounts to: sand that was pulled apart bears load again at the density where it let go,
/// not before. So the memory is the elastic strain at constant volume.
/// @see Eqs. (R2), (R5), (R22) to (R25) and (R183), from Klar et al. (2016), \cite klar2016, and Tampubolon
/// et al. (2017), \cite tampubolon2017
struct DruckerPrager {
  static constexpr std::string_view name = "drucker_prager";
  static constexpr std::string_view summary = "cohesionless sand at large strain, without rate";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool remembers_deviator = true;

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  using State = Symmetric<Real>;  ///< elastic logarithmic strain, of trace 0 [-]
  template <class Real>
  using PlaneState = PlaneSymmetric<Real>;
  static constexpr std::array<StateColumn, 6> states = elastic_strain_columns;
  static constexpr std::array<std::size_t, 4> plane_states{0, 1, 2, 3};

  double friction;       ///< shear stress per pressure at yield [-], Eq. (R25)
  double shear_modulus;  ///< G [Pa]
  double bulk_modulus;   ///< K [Pa]
  double density;        ///< rho_0, below which grains do not touch [kg/m^3]

  static constexpr std::array<LawParameter<DruckerPrager>, 4> parameters{{
      {"friction", "-", "shear stress per pressure at yield", &DruckerPrager::friction, Bound::non_negative,
       0.69},
      {"shear_modulus", "Pa", "elastic shear modulus", &DruckerPrager::shear_modulus, Bound::positive, 5e5},
      {"bulk_modulus", "Pa", "pressure per logarithmic compression", &DruckerPrager::bulk_modulus,
       Bound::positive, 1e6},
      {"density", "kg/m^3", "density below which grains do not touch", &DruckerPrager::density,
       Bound::positive, 1500},
  }};

  /// Friction at yield [-].  Eq. (R164)
  [[nodiscard]] constexpr double yield_friction() const noexcept { return friction; }

  /// Cauchy stress [Pa] and elastic strain at the end of the step.
  template <class Real, template <class> class Form>
  [[nodiscard]] Response<Real, Form<Real>> update(const Deformation<Real>& deformation,
                                                  const Input<Real>& input, const Form<Real>& old,
                                                  Real dt) const noexcept {
    return correct(deformation, input, predict(deformation, old, dt), dt);
  }

  /// The elastic strain if all of the step is elastic.
  template <class Real, template <class> class Form>
  [[nodiscard]] Form<Real> predict(const Deformation<Real>& deformation, const Form<Real>& old,
                                   Real dt) const noexcept {
    return trial_strain(old, deformation.velocity_gradient, dt);
  }

  /// What yield leaves of it.
  template <class Real, template <class> class Form>
  [[nodiscard]] Response<Real, Form<Real>> correct(const Deformation<Real>& deformation,
                                                   const Input<Real>& /*input*/, const Form<Real>& trial,
                                                   Real /*dt*/) const noexcept {
    using std::sqrt;
    const Real compression = deformation.density * (1 / density);  // 1/J
    // J times that of Cauchy; 0 where grains do not touch, and so is the strain that yields there.
    const Real p = contact_pressure(Real(bulk_modulus * elementary::log_near_one(compression)));
    const Real yield_strain = friction / (std::numbers::sqrt2 * shear_modulus) * p;  // its norm
    const Real squared = squared_norm(trial);
    const auto is_elastic = squared <= yield_strain * yield_strain;
    // The quotient and the root do not wait for each other.
    const Real share = yield_strain / squared * sqrt(squared);
    const Form<Real> strain = select(is_elastic, Real(1.0), share) * trial;
    const Form<Real> shear = (2.0 * shear_modulus * compression) * strain;
    return {shear.tensor() - isotropic<Real>(compression * p), strain};
  }

  /// Speed of pressure waves [m/s] of the unloaded material, and no viscosity.  Eq. (R21)
  template <class Real, template <class> class Form>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/,
                                          const Input<Real>& /*input*/,
                                          const Form<Real>& /*state*/) const noexcept {
    return {wave_speed(density, bulk_modulus + 4 * shear_modulus / 3), 0};
  }
};
static_assert(DescribedLaw<DruckerPrager> && HasPlaneForm<DruckerPrager> && HasYieldFriction<DruckerPrager>);

}  // namespace scree::rheology
