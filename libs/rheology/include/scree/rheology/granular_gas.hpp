#pragma once

#include <scree/rheology/elementary.hpp>
#include <scree/tensor.hpp>

#include <cmath>
#include <numbers>

namespace scree::rheology {

/// Solid fraction of hard spheres [-] beyond which their fluid is metastable, and crowds towards close
/// packing.
inline constexpr double freezing_fraction = 0.49;

namespace detail {
/// g_0 of Carnahan and Starling (1969).
template <class Real>
[[nodiscard]] constexpr Real carnahan_starling(const Real& phi) noexcept {
  const Real gap = 1.0 - phi;
  return 0.5 * (2.0 - phi) / (gap * gap * gap);
}
}  // namespace detail

/// How much likelier than in a dilute gas two spheres touch, g_0 [-]: unbounded at close packing.
/// Eq. (R101), from Torquato (1995), \cite torquato1995
/// @param phi solid fraction [-], below close_packing  @param close_packing phi_c [-], above 0.49
template <class Real>
[[nodiscard]] constexpr Real contact_value(const Real& phi, double close_packing) noexcept {
  constexpr double at_freezing = detail::carnahan_starling(freezing_fraction);
  const Real crowded = at_freezing * (close_packing - freezing_fraction) / (close_packing - phi);
  return select(phi < freezing_fraction, detail::carnahan_starling(phi), crowded);
}

/// Its derivative by the solid fraction [-].
template <class Real>
[[nodiscard]] constexpr Real contact_value_slope(const Real& phi, double close_packing) noexcept {
  const Real squared_gap = (1.0 - phi) * (1.0 - phi);
  const Real fluid = (5.0 - 2.0 * phi) / (2.0 * (squared_gap * squared_gap));
  return select(phi < freezing_fraction, fluid,
                Real(contact_value(phi, close_packing) / (close_packing - phi)));
}

/// What collisions make of a granular temperature T, as functions of the solid fraction.  Eqs. (R100), (R102)
/// to (R105)
template <class Real>
struct CollisionalFactors {
  Real pressure;            ///< p/(rho_s T) [-]
  Real viscosity;           ///< eta/(rho_s d sqrt(T)) [-]
  Real bulk_viscosity;      ///< eta_b/(rho_s d sqrt(T)) [-]
  Real dissipation;         ///< Gamma d/(rho_s T^(3/2)) [-]
  Real correlation_length;  ///< L/d [-], at least 1; divides the dissipation, and has been
};

/// @param phi solid fraction [-]  @param contact g_0 [-]  @param restitution e [-]
/// @param correlation c of Eq. (R105) [-]; 0: collisions are independent of each other
template <class Real>
[[nodiscard]] CollisionalFactors<Real> collisional_factors(const Real& phi, const Real& contact,
                                                           double restitution, double correlation) noexcept {
  const double e = restitution;
  const double root_pi = std::sqrt(std::numbers::pi);
  const Real G = phi * contact;
  const Real collisional = (1 + e) / 2 * phi * G;
  const Real streaming = (5.0 + 2 * (1 + e) * (3 * e - 1) * G) * (5.0 + 4 * (1 + e) * G) /
                         ((24 - 6 * (1 - e) * (1 - e) - 5 * (1 - e * e)) * contact);
  const Real viscosity = 8 / (5 * root_pi) * (collisional + std::numbers::pi / 32 * streaming);
  const Real independent = 12 / root_pi * (1 - e * e) * phi * G;
  const Real ratio = correlation * correlation / 4 * independent / viscosity;
  const Real correlated = elementary::pow(G * G * ratio * ratio * ratio, Real(1.0 / 9.0));
  const Real length = select(correlated < 1.0, Real(1.0), correlated);
  return {phi * (1.0 + 2 * (1 + e) * G), viscosity, 4 / (3 * root_pi) * (1 + e) * phi * G,
          independent / length, length};
}

/// Root of w at the end of a step of dw/dt = a + b w - c w^2, in closed form: exact for constant a, b and c,
/// and never negative.  Eq. (R107)
/// @param old w at its start, not negative  @param a, c not negative
template <class Real>
[[nodiscard]] Real riccati_step(const Real& old, const Real& a, const Real& b, const Real& c,
                                const Real& dt) noexcept {
  using std::sqrt;
  const Real size = select(b < 0.0, -b, b);
  const Real r = sqrt(b * b + 4.0 * a * c);
  const Real decay = -elementary::expm1(-r * dt);
  const Real tau = select(r == 0.0, 0.5 * dt, decay / (r * (2.0 - decay)));  // tanh(r dt/2)/r
  // 1 - |b| tau, which is not negative, as a sum of positive numbers
  const Real excess = select(r == 0.0, Real(0.0), 4.0 * a * c / (r + size));
  const Real rest = 2.0 * (1.0 - decay) / (2.0 - decay) + excess * tau;
  const Real more = 1.0 + size * tau;
  const Real numerator = old * select(b < 0.0, rest, more) + 2.0 * a * tau;
  return numerator / (select(b < 0.0, more, rest) + 2.0 * c * old * tau);
}

}  // namespace scree::rheology
