#pragma once

#include <scree/rheology/parameters.hpp>
#include <scree/tensor.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace scree::rheology {

/// Grains that flow because their neighbours do: the granular fluidity g = gdot/mu [1/s], with mu = tau/p,
/// spreads over a cooperativity length of some grain sizes. Its local law is mu(I) = mu_s + b I, linear.
///
/// These are the coefficients at one point; `FluidityGrid` solves the equation.
/// @see Eqs. (R173)-(R177), from Kamrin & Koval (2012), \cite kamrin2012 , and Henann & Kamrin (2014),
/// \cite henann2014
struct NonlocalFluidity {
  static constexpr std::string_view name = "nonlocal_fluidity";
  static constexpr std::string_view summary = "fluidity that spreads over some grain sizes";

  double mu_s;           ///< friction of slow flow [-]
  double slope;          ///< b = dmu/dI [-]
  double amplitude;      ///< A, of the cooperativity length [-]
  double grain_density;  ///< rho_s, of the solid [kg/m^3]
  double response_time;  ///< t_0, of the fluidity [s]

  static constexpr std::array<LawParameter<NonlocalFluidity>, 5> parameters{{
      {"mu_s", "-", "friction of slow flow", &NonlocalFluidity::mu_s, Bound::positive, 0.3819},
      {"slope", "-", "of friction over the inertial number", &NonlocalFluidity::slope, Bound::positive,
       0.9377},
      {"amplitude", "-", "of the cooperativity length", &NonlocalFluidity::amplitude, Bound::positive, 0.48},
      {"grain_density", "kg/m^3", "density of the solid", &NonlocalFluidity::grain_density, Bound::positive,
       2450},
      {"response_time", "s", "of the fluidity", &NonlocalFluidity::response_time, Bound::positive, 1e-4},
  }};

  /// Fluidity that mu(I) alone gives [1/s]; none up to mu_s.  Eq. (R174)
  /// @param friction mu = tau/p [-]  @param pressure p [Pa], positive  @param grain_size s_a [m]
  template <class Real>
  [[nodiscard]] Real local_fluidity(const Real& friction, const Real& pressure,
                                    const Real& grain_size) const noexcept {
    const Real excess = friction - mu_s;
    return select(excess <= 0.0, Real(0.0), excess / saturation(friction, pressure, grain_size));
  }

  /// xi, over which fluidity spreads [m]; infinite at mu_s.  Eq. (R175)
  template <class Real>
  [[nodiscard]] Real cooperativity_length(const Real& friction, const Real& grain_size) const noexcept {
    using std::sqrt;
    const Real distance = friction - mu_s;
    return amplitude * grain_size / sqrt(select(distance < 0.0, Real(-distance), distance));
  }

  /// b mu s_a sqrt(rho_s/p) [s]: what the square of the fluidity is met by.  Eq. (R177)
  template <class Real>
  [[nodiscard]] Real saturation(const Real& friction, const Real& pressure,
                                const Real& grain_size) const noexcept {
    using std::sqrt;
    return slope * friction * grain_size * sqrt(grain_density / pressure);
  }

  /// Thickness below which a layer on a rough bed (no fluidity) under a free surface stops although its
  /// friction is above mu_s: (pi/2) xi [m].  Eq. (R181)
  [[nodiscard]] double stopping_thickness(double friction, double grain_size) const noexcept {
    return std::numbers::pi / 2 * cooperativity_length(friction, grain_size);
  }
};

}  // namespace scree::rheology
