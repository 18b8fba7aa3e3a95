#pragma once

#include <scree/rheology/concepts.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace scree::rheology {

/// Snow and debris avalanches: dry friction and a drag that grows with the square of the speed,
/// mu p + rho g v^2/xi.
/// @see Eqs. (R165) and (R166), from Voellmy (1955), \cite voellmy1955
struct Voellmy {
  static constexpr std::string_view name = "voellmy";
  static constexpr std::string_view summary = "dry friction and a drag with the square of the speed";

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  double friction;    ///< mu [-]
  double turbulence;  ///< xi [m/s^2]
  double density;     ///< rho, of the flow [kg/m^3]
  double gravity;     ///< g [m/s^2]

  static constexpr std::array<LawParameter<Voellmy>, 4> parameters{{
      {"friction", "-", "shear traction over normal pressure, of slow flow", &Voellmy::friction,
       Bound::non_negative, 0.16},
      {"turbulence", "m/s^2", "xi; the drag is rho g v^2 over it", &Voellmy::turbulence, Bound::positive,
       2000},
      {"density", "kg/m^3", "of the flow", &Voellmy::density, Bound::positive, 300},
      {"gravity", "m/s^2", "by which xi is measured", &Voellmy::gravity, Bound::positive, 9.81},
  }};

  /// Drag over the square of the speed, rho g/xi [Pa s^2/m^2].
  [[nodiscard]] constexpr double drag() const noexcept { return density * gravity / turbulence; }

  /// Largest shear traction [Pa].  Eq. (R165)  @param pressure p [Pa]  @param speed v [m/s]
  template <class Real>
  [[nodiscard]] constexpr Real traction(const Real& pressure, const Real& speed,
                                        const Input<Real>& /*input*/) const noexcept {
    return friction * pressure + drag() * speed * speed;
  }

  /// Speed at the end of a step [m/s], the positive root of a quadratic equation.  Eq. (R166)
  /// @param speed without friction [m/s]
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>& /*input*/) const noexcept {
    using std::sqrt;
    const Real rest = speed - contact.mobility * (friction * contact.pressure);
    const Real moving = select(rest <= 0.0, Real(0.0), rest);
    return 2.0 * moving / (1.0 + sqrt(1.0 + 4.0 * drag() * contact.mobility * moving));
  }
};
static_assert(DescribedWall<Voellmy>);

}  // namespace scree::rheology
