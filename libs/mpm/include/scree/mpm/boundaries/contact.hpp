#pragma once

#include <scree/mpm/boundaries/hold.hpp>
#include <scree/mpm/nodes.hpp>
#include <scree/wall_law.hpp>

#include <array>
#include <limits>
#include <string_view>

namespace scree::mpm {

/// Material that touches the wall does not slide, however weakly it is pressed: a rough bed, on which
/// material has its own friction.
struct Sticks {
  static constexpr std::string_view name = "sticks";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  template <class Real>
  [[nodiscard]] constexpr Real traction(const Real& /*pressure*/, const Real& /*speed*/,
                                        const Input<Real>& /*input*/) const noexcept {
    return Real(std::numeric_limits<double>::infinity());
  }
  template <class Real>
  [[nodiscard]] constexpr Real slowed(const Real& /*speed*/, const WallContact<Real>& /*contact*/,
                                      const Input<Real>& /*input*/) const noexcept {
    return Real(0);
  }
};
static_assert(WallLaw<Sticks>);

/// A wall without friction.
struct Slides {
  static constexpr std::string_view name = "slides";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  template <class Real>
  [[nodiscard]] constexpr Real traction(const Real& /*pressure*/, const Real& /*speed*/,
                                        const Input<Real>& /*input*/) const noexcept {
    return Real(0);
  }
  template <class Real>
  [[nodiscard]] constexpr Real slowed(const Real& speed, const WallContact<Real>& /*contact*/,
                                      const Input<Real>& /*input*/) const noexcept {
    return speed;
  }
};
static_assert(WallLaw<Slides>);

/// How a wall holds what touches it.
template <WallLaw Law_>
struct Contact {
  using Law = Law_;
  using Input = typename Law::template Input<double>;

  Law law;
  Hold hold = Hold::pushes;

  /// The velocity that is left to material, both relative to the wall [m/s]: what `slide` leaves; if the wall
  /// pulls too, none away from it, the sliding then slowed as under no pressure.
  /// @param mobility dt A/m, positive [m/s/Pa]  @see Eq. (M63)
  [[nodiscard]] Vector<3> left(const Vector<3>& velocity, const Vector<3>& normal, double mobility,
                               const Input& input) const noexcept {
    const double away = velocity.dot(normal);
    if (away < 0 || hold == Hold::pushes) return slide<3>(law, velocity, normal, mobility, input);
    const Vector<3> tangential = velocity - away * normal;
    const double speed = tangential.norm();
    if (speed == 0) return Vector<3>::Zero();
    return law.slowed(speed, WallContact<double>{0, mobility}, input) / speed * tangential;
  }
};

/// Gives a node the velocity new_velocity(its own) [m/s], and its increment alike; components without an axis
/// come after those that have one. A node without mass stays as it is.
template <class NewVelocity>
void change_velocity(NodeRecord layout, double* node, NewVelocity&& new_velocity) noexcept {
  if (!(node[NodeRecord::mass] > 0)) return;
  Vector<3> velocity = Vector<3>::Zero();
  for (int i = 0; i < layout.num_velocities; ++i) velocity[i] = node[NodeRecord::momentum + i];
  const Vector<3> left = new_velocity(velocity);
  for (int i = 0; i < layout.num_velocities; ++i) {
    if (layout.has_increment) node[layout.increment() + i] += left[i] - velocity[i];
    node[NodeRecord::momentum + i] = left[i];
  }
}

}  // namespace scree::mpm
