#pragma once

#include <scree/rheology/concepts.hpp>
#include <scree/rheology/granular_gas.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace scree::rheology {

/// A gas of grains: pressure and viscosity by collisions, whose vigour, the granular temperature T, is kept
/// on each point: shear and compression heat it, inelastic collisions cool it. Up to close packing, with the
/// correlated collisions of dense shear.
///
/// The temperature is solved for in closed form: Haff's cooling, steady shear and the way there are exact
/// whatever the step. It does not flow from point to point: conduction needs a mesh. Nothing is left of the
/// stress at T = 0, and material begins at T = 1e-4 m^2/s^2, fluctuations of 1 cm/s.
/// @see Eqs. (R100) to (R108), from Garzo & Dufty (1999), \cite garzo1999, Lun et al. (1984), \cite lun1984,
/// Torquato (1995), \cite torquato1995, and Jenkins & Berzi (2010), \cite jenkins2010
struct KineticTheory {
  static constexpr std::string_view name = "kinetic_theory";
  static constexpr std::string_view summary =
      "a gas of grains with a temperature of its own, up to dense flow";
  static constexpr std::size_t most_lanes = 8;  // measured
  static constexpr bool disconnects = false;

  template <class Real>
  struct Input {
    Real grain_size;  ///< arithmetic mean, d [m]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  struct State {
    Real temperature;  ///< T, a third of the mean square of velocity fluctuations [m^2/s^2]
  };
  static constexpr std::array<StateColumn, 1> states{{{"granular_temperature", "m^2/s^2", 1e-4, Interval{}}}};

  double restitution;    ///< e, normal speed after a collision over that before [-]
  double correlation;    ///< c of Eq. (R105) [-]; 0: collisions are independent
  double close_packing;  ///< phi_c [-]
  double density;        ///< of the bulk as it is placed [kg/m^3]
  double grain_density;  ///< rho_s, of the solid [kg/m^3]

  using Self = KineticTheory;
  static constexpr std::array<LawParameter<KineticTheory>, 5> parameters{{
      {"restitution", "-", "normal speed after a collision over that before", &Self::restitution,
       Bound::non_negative, 0.9, 1},
      {"correlation", "-", "of collisions in dense shear, 0 for none", &Self::correlation,
       Bound::non_negative, 0.5},
      {.name = "close_packing",
       .unit = "-",
       .meaning = "solid fraction at which nothing moves",
       .member = &Self::close_packing,
       .bound = Bound::positive,
       .typical = 0.64,
       .upper = 0.7405,  // of spheres in a lattice, pi/sqrt(18)
       .lower = freezing_fraction},
      {"density", "kg/m^3", "density of the bulk as it is placed", &Self::density, Bound::positive, 1000},
      {.name = "grain_density",
       .unit = "kg/m^3",
       .meaning = "density of the solid",
       .member = &Self::grain_density,
       .bound = Bound::positive,
       .typical = 2500,
       .exceeds = &Self::density},
  }};

  /// Pressure, viscosities and dissipation at a density, over their powers of T.
  /// @param bulk_density rho [kg/m^3]
  template <class Real>
  [[nodiscard]] CollisionalFactors<Real> factors(const Real& bulk_density) const noexcept {
    const Real phi = bulk_density * (1 / grain_density);
    return collisional_factors(phi, contact_value(phi, close_packing), restitution, correlation);
  }

  /// Cauchy stress [Pa] and temperature at the end of the step. Without a solution at and beyond close
  /// packing: `unsolved` is phi/phi_c there.
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& old,
                                                   Real dt) const noexcept {
    using std::sqrt;
    const Real phi = deformation.density * (1 / grain_density);
    const Real& d = input.grain_size;
    const CollisionalFactors<Real> f = factors(deformation.density);
    const Tensor<Real> rate = symmetric_part(deformation.velocity_gradient);
    const Tensor<Real> shear = deviator(rate);
    const Real expansion = trace(rate);
    const Real third = 1.0 / (3.0 * phi);  // of 3 rho dw/dt, w = sqrt(T)
    const Real heating =
        f.viscosity * (2.0 * contract(shear, shear)) + f.bulk_viscosity * (expansion * expansion);
    const Real w = riccati_step<Real>(sqrt(old.temperature), third * d * heating,
                                      -third * f.pressure * expansion, third * f.dissipation / d, dt);
    const Real isotropic_part = grain_density * w * (d * f.bulk_viscosity * expansion - f.pressure * w);
    const Real eta = grain_density * d * f.viscosity * w;
    const Real unsolved = select(phi < close_packing, Real(0.0), phi * (1 / close_packing));
    return {Real(2.0) * eta * shear + isotropic<Real>(isotropic_part), {w * w}, unsolved};
  }

  /// Speed of sound without loss of energy [m/s], Eq. (R108), and viscosity of a plane wave of pressure
  /// [Pa s], which is larger than that of shear.
  template <class Real>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& deformation, const Input<Real>& input,
                                          const State<Real>& state) const noexcept {
    using std::sqrt;
    const Real phi = deformation.density * (1 / grain_density);
    const CollisionalFactors<Real> f = factors(deformation.density);
    const Real g = contact_value(phi, close_packing);
    const Real slope =
        1.0 + 2 * (1 + restitution) * phi * (2.0 * g + phi * contact_value_slope(phi, close_packing));
    const Real squared = state.temperature * (slope + 2.0 / 3 * f.pressure * f.pressure / (phi * phi));
    const Real viscosity = grain_density * input.grain_size * sqrt(state.temperature) *
                           (f.bulk_viscosity + 4.0 / 3 * f.viscosity);
    return {sqrt(squared), viscosity};
  }
};
static_assert(DescribedLaw<KineticTheory>);

}  // namespace scree::rheology
