#pragma once

namespace scree::grainsize {

/// A uniform patch of a flow in which `ShearRate` drives segregation and the viscosity depends on the mean
/// size: the state about which the two-way coupling is linearised.
struct CoupledFlow {
  double c;                ///< strength of the closure [m^2]
  double shear_rate;       ///< gdot [1/s]
  double density;          ///< rho [kg/m^3]
  double viscosity;        ///< mu [Pa s], positive
  double viscosity_slope;  ///< d mu/d s_a [Pa s/m]
  double arithmetic_mean;  ///< s_a [m]
  double harmonic_mean;    ///< s_h [m]
};

/// Remixing at and above which the coupled flow is well posed [m^2/s]: D_crit = c gdot (s_a - s_h) mu'/mu.
/// Zero or less means that it is so without remixing.  Eq. (G12)
[[nodiscard]] double critical_remixing(const CoupledFlow& flow) noexcept;

/// Growth rate of a disturbance across the flow [1/s], the larger root of
/// (omega + D k^2)(rho omega + mu k^2) = c gdot (s_a - s_h) mu' k^4. Negative: it decays. Without remixing
/// it grows as k^2 without bound where D_crit > 0.  Eq. (G11)
/// @param wave_number k = 2 pi/wavelength [1/m], positive
/// @param remixing D [m^2/s]
[[nodiscard]] double growth_rate(const CoupledFlow& flow, double wave_number, double remixing = 0) noexcept;

/// Segregation flux of two sizes over the driver, q phi (1 - phi)/(1 + q phi), q = size_ratio - 1 [-]. It is
/// the factor A of the bidisperse growth rate: (s_a - s_h) mu' = A d mu/d(coarse fraction).  Eq. (G9)
/// @param fraction_small phi in [0, 1]  @param size_ratio coarse over fine, at least 1
[[nodiscard]] double bidisperse_flux(double fraction_small, double size_ratio) noexcept;

}  // namespace scree::grainsize
