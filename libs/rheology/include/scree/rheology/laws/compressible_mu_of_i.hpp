#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/newtonian_stress.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::rheology {

/// Granular flow that dilates, well posed: in steady flow friction mu(I) and packing phi(I), and else a
/// resistance to changes of volume that makes the stress the gradient of a convex potential of the rate of
/// deformation. A compressible I-dependent rheology (CIDR).
/// @see Eqs. (R2), (R11), (R12), (R77) and (R81) to (R86); the class of laws is that of Barker et al. (2017),
/// \cite barker2017cidr, and Schaeffer et al. (2019), \cite schaeffer2019
struct CompressibleMuOfI {
  static constexpr std::string_view name = "compressible_mu_of_i";
  static constexpr std::string_view summary =
      "granular flow that dilates, friction and packing by I, well posed";
  static constexpr bool disconnects = false;  // sheared grains press at any density

  template <class Real>
  struct Input {
    Real grain_size;  ///< arithmetic mean s_a [m]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double mu_s;              ///< friction of slow flow [-]
  double mu_2;              ///< friction of fast flow [-]
  double I_0;               ///< inertial number half way between them [-]
  double dilation;          ///< a, growth of the volume with I [-]
  double bulk_friction;     ///< b, resistance to changes of volume [-], Eq. (R81)
  double I_min;             ///< inertial number below which packing no longer follows it [-], Eq. (R83)
  double grain_density;     ///< rho_s, of the solid [kg/m^3]
  double shear_rate_floor;  ///< [1/s], keeps the viscosity finite at rest; error bound in Eq. (R14)
  double bulk_modulus;      ///< K, of grains in contact [Pa]
  double density;           ///< rho_0 of the bulk, from which on grains are in contact [kg/m^3]

  using Self = CompressibleMuOfI;
  static constexpr std::array<LawParameter<CompressibleMuOfI>, 10> parameters{{
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
      {"bulk_friction", "-", "resistance to changes of volume", &Self::bulk_friction, Bound::positive, 1},
      {"I_min", "-", "inertial number below which packing no longer follows it", &Self::I_min,
       Bound::positive, 0.01},
      {"grain_density", "kg/m^3", "density of the solid", &Self::grain_density, Bound::positive, 2500},
      {"shear_rate_floor", "1/s", "rate below which it creeps", &Self::shear_rate_floor, Bound::positive,
       1e-3},
      {"bulk_modulus", "Pa", "pressure per relative compression", &Self::bulk_modulus, Bound::positive, 1e6},
      {"density", "kg/m^3", "density from which on grains are in contact", &Self::density, Bound::positive,
       1500},
  }};

  /// Friction at yield [-].  Eq. (R164)
  [[nodiscard]] constexpr double yield_friction() const noexcept { return mu_s; }

  /// Cauchy stress at the end of the step [Pa]; depends on neither a state nor the step.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& /*old*/,
                                                   Real /*dt*/) const noexcept {
    using std::sqrt;
    const Tensor<Real>& gradient = deformation.velocity_gradient;
    const Flow<Real> flow = flow_of(deformation, input);
    const Real y = dilating(Real(trace(gradient) / (flow.friction * flow.shear_rate)));
    const Real size = sqrt(1.0 + y * (chi() * y - 2.0));
    const Real p = flow.contact + flow.steady * size * (1.0 - chi() * y);
    const Real tau = mu_s * flow.contact + flow.friction * flow.steady * size * (1.0 - y);
    const Real eta = tau / flow.shear_rate;
    return {Real(2.0) * eta * deviator(symmetric_part(gradient)) - isotropic<Real>(p), {}};
  }

  /// Speed of waves of the packing [m/s], and no less than the highest viscosity that a disturbance meets in
  /// any direction [Pa s], from the second derivatives of the potential.  Eqs. (R85), (R86)
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& input,
                                          const State<Real>& /*state*/) const noexcept {
    using std::sqrt;
    const Flow<Real> flow = flow_of(deformation, input);
    const Real y = dilating(Real(trace(deformation.velocity_gradient) / (flow.friction * flow.shear_rate)));
    const Real size = sqrt(1.0 + y * (chi() * y - 2.0));
    const Real less = 1.0 - chi() * y;
    const Real scale = flow.steady / flow.shear_rate;  // [Pa s]
    const Real eta = flow.friction * scale * size * (1.0 - y) + mu_s * flow.contact / flow.shear_rate;
    const Real by_volume = scale / flow.friction * (less * less / size + chi() * size);
    const Real mixed = scale * (less * (1.0 - y) / size + size);
    const Real by_shear = flow.friction * (2.0 * scale * size * (1.0 - y) + y * mixed);
    const Real stiffening = (2 * density / dilation) * flow.steady * size * less /
                            (flow.inertial_number * deformation.density * deformation.density);
    return {sqrt(bulk_modulus / density + stiffening),
            by_volume + 4 / std::sqrt(3.0) * mixed + 4.0 / 3.0 * select(by_shear < eta, eta, by_shear)};
  }

 private:
  /// What the potential is made from at one point.
  template <class Real>
  struct Flow {
    Real contact;          // p_e, pressure of grains in contact [Pa]
    Real inertial_number;  // at which steady flow has this packing [-]
    Real friction;         // mu of that flow [-]
    Real shear_rate;       // floored [1/s]
    Real steady;           // p_0, pressure of that flow [Pa]
  };

  [[nodiscard]] double chi() const noexcept { return 1 + bulk_friction; }

  /// Grains that fly apart do not pull: from y = 1/chi on the pressure of shear is zero.
  template <class Real>
  [[nodiscard]] Real dilating(const Real& y) const noexcept {
    return select(Real(1 / chi()) < y, Real(1 / chi()), y);
  }

  template <class Real>
  [[nodiscard]] Flow<Real> flow_of(const Deformation<Real>& deformation,
                                   const Input<Real>& input) const noexcept {
    using std::sqrt;
    Flow<Real> flow;
    flow.contact = contact_pressure(pressure(deformation.density, density, bulk_modulus));
    const Real loose = contact_pressure(Real(density / deformation.density - 1.0));
    flow.inertial_number = sqrt(loose * loose * (1 / (dilation * dilation)) + I_min * I_min);
    flow.friction = mu_s + (mu_2 - mu_s) * flow.inertial_number / (I_0 + flow.inertial_number);
    flow.shear_rate = floored_shear_rate(deformation.velocity_gradient, shear_rate_floor);
    const Real root_p = flow.shear_rate * input.grain_size * sqrt(grain_density) / flow.inertial_number;
    flow.steady = root_p * root_p;
    return flow;
  }
};
static_assert(DescribedLaw<CompressibleMuOfI> && HasYieldFriction<CompressibleMuOfI>);

}  // namespace scree::rheology
