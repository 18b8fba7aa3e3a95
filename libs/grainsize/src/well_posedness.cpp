#include <scree/grainsize/well_posedness.hpp>

#include <cmath>

namespace scree::grainsize {

namespace {
/// c gdot (s_a - s_h) mu' [Pa]: what drives the instability.
double feedback(const CoupledFlow& flow) noexcept {
  return flow.c * flow.shear_rate * (flow.arithmetic_mean - flow.harmonic_mean) * flow.viscosity_slope;
}
}  // namespace

double critical_remixing(const CoupledFlow& flow) noexcept {
  return feedback(flow) / flow.viscosity;
}

double growth_rate(const CoupledFlow& flow, double wave_number, double remixing) noexcept {
  const double k_squared = wave_number * wave_number;
  const double surplus = (feedback(flow) - remixing * flow.viscosity) * k_squared * k_squared;
  const double damping = (flow.viscosity + flow.density * remixing) * k_squared;
  const double discriminant = damping * damping + 4 * flow.density * surplus;
  if (discriminant < 0) return -damping / (2 * flow.density);  // a decaying oscillation
  return 2 * surplus / (damping + std::sqrt(discriminant));    // no cancellation for small surplus
}

double bidisperse_flux(double fraction_small, double size_ratio) noexcept {
  const double q = size_ratio - 1;
  return q * fraction_small * (1 - fraction_small) / (1 + q * fraction_small);
}

}  // namespace scree::grainsize
