#pragma once

#include <scree/rheology/concepts.hpp>

#include <array>
#include <string_view>

namespace scree::rheology {

/// A wall as rough as the material itself: it bears the share of the material's own friction that it is
/// given, so that a wall of share 1 never slides before the material beside it yields.
/// @see Eq. (R164)
struct MaterialFriction {
  static constexpr std::string_view name = "material_friction";
  static constexpr std::string_view summary = "a share of the friction of the material on the wall";

  template <class Real>
  struct Input {
    Real friction;  ///< of the material at the wall: mu(I), or its shear stress at yield over p [-]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"friction", "-", 0.4}}};

  double share;  ///< of the material's friction [-]

  static constexpr std::array<LawParameter<MaterialFriction>, 1> parameters{{
      {"share", "-", "of the material's own friction", &MaterialFriction::share, Bound::positive, 1},
  }};

  /// Largest shear traction [Pa].  @param pressure p [Pa]
  template <class Real>
  [[nodiscard]] constexpr Real traction(const Real& pressure, const Real& /*speed*/,
                                        const Input<Real>& input) const noexcept {
    return share * input.friction * pressure;
  }

  /// Speed at the end of a step [m/s].  Eq. (R163)  @param speed without friction [m/s]
  template <class Real>
  [[nodiscard]] constexpr Real slowed(const Real& speed, const WallContact<Real>& contact,
                                      const Input<Real>& input) const noexcept {
    const Real loss = contact.mobility * traction(contact.pressure, speed, input);
    return select(speed <= loss, Real(0.0), speed - loss);
  }
};
static_assert(DescribedWall<MaterialFriction>);

}  // namespace scree::rheology
