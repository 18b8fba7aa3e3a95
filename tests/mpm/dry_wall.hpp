#pragma once

#include <scree/wall_law.hpp>

#include <array>
#include <string_view>

namespace scree::mpm {

/// Dry friction, mu p.
struct Dry {
  static constexpr std::string_view name = "dry";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  double friction = 0.5;  ///< mu [-]

  template <class Real>
  [[nodiscard]] Real traction(const Real& pressure, const Real& /*speed*/,
                              const Input<Real>& /*input*/) const noexcept {
    return friction * pressure;
  }
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>& /*input*/) const noexcept {
    const Real loss = contact.mobility * friction * contact.pressure;
    return select(speed <= loss, Real(0), speed - loss);
  }
};
static_assert(WallLaw<Dry>);

/// Dry friction, mu p, with the mu that it reads.
struct Rubs {
  static constexpr std::string_view name = "rubs";
  template <class Real>
  struct Input {
    Real friction;
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"friction", "-", 0.4}}};

  template <class Real>
  [[nodiscard]] Real traction(const Real& pressure, const Real& /*speed*/,
                              const Input<Real>& input) const noexcept {
    return input.friction * pressure;
  }
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>& input) const noexcept {
    const Real loss = contact.mobility * input.friction * contact.pressure;
    return select(speed <= loss, Real(0), speed - loss);
  }
};
static_assert(WallLaw<Rubs>);

}  // namespace scree::mpm
