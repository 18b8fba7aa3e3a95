#pragma once

#include <scree/rheology/concepts.hpp>

#include <array>
#include <string_view>

namespace scree::rheology {

/// Dry friction: a shear traction of at most mu p, whatever the speed.
/// @see Eq. (R163), from Coulomb (1776)
struct Coulomb {
  static constexpr std::string_view name = "coulomb";
  static constexpr std::string_view summary = "dry friction, mu p";

  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  double friction;  ///< mu [-]

  static constexpr std::array<LawParameter<Coulomb>, 1> parameters{{
      {"friction", "-", "shear traction over normal pressure", &Coulomb::friction, Bound::non_negative, 0.4},
  }};

  /// Largest shear traction [Pa].  @param pressure p [Pa]
  template <class Real>
  [[nodiscard]] constexpr Real traction(const Real& pressure, const Real& /*speed*/,
                                        const Input<Real>& /*input*/) const noexcept {
    return friction * pressure;
  }

  /// Speed at the end of a step [m/s].  Eq. (R163)  @param speed without friction [m/s]
  template <class Real>
  [[nodiscard]] constexpr Real slowed(const Real& speed, const WallContact<Real>& contact,
                                      const Input<Real>& /*input*/) const noexcept {
    const Real loss = contact.mobility * (friction * contact.pressure);
    return select(speed <= loss, Real(0.0), speed - loss);
  }
};
static_assert(DescribedWall<Coulomb>);

}  // namespace scree::rheology
