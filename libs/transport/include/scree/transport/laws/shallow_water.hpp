#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace scree::transport {

/// Shallow water over a flat bed: depth [m] and momentum, depth x velocity [m^2/s], in this order. The
/// primitive variables are depth and velocity.
///
/// A dry state has depth zero; its velocity counts as zero. Depths stay positive under the promised CFL
/// number, and velocities at a wetting front stay bounded, so that no depth need be called "almost dry".
/// A bed that is not flat is a source, -g h grad b: water at rest over it moves by the error of the scheme.
/// @see Eq. (T18), \cite stoker1957
template <int D>
class ShallowWater {
 public:
  static_assert(D == 1 || D == 2);
  static constexpr int num_components = D + 1;
  using State = std::array<double, static_cast<std::size_t>(D + 1)>;

  /// @param gravity across the bed [m/s^2], positive.  @throws InputError
  explicit ShallowWater(double gravity = 9.81) : gravity_{gravity} {
    require(gravity > 0 && std::isfinite(gravity), "ShallowWater: gravity must be positive and finite");
  }

  /// The conserved state of water of some depth [m] and velocity [m/s].
  [[nodiscard]] State state(double depth, const Vector<D>& velocity) const noexcept {
    State w;
    w[0] = depth;
    for_each_component<D>([&](std::size_t axis) { w[1 + axis] = velocity[static_cast<int>(axis)]; });
    return conserved(w);
  }

  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    const State w = primitive(u);
    const double speed = along(w, normal);
    const double pressure = 0.5 * gravity_ * u[0] * u[0];
    State f;
    f[0] = u[0] * speed;
    for_each_component<D>([&](std::size_t axis) {
      f[1 + axis] = u[0] * w[1 + axis] * speed + pressure * normal[static_cast<int>(axis)];
    });
    return f;
  }

  /// |v.n| + sqrt(g h) of the faster side: enough for positive depths, though a front over a dry bed, at
  /// |v.n| + 2 sqrt(g h), is faster.
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& normal) const noexcept {
    return larger(std::abs(along(primitive(left), normal)) + wave_speed(left),
                  std::abs(along(primitive(right), normal)) + wave_speed(right));
  }

  /// From the smaller v.n - sqrt(g h) to the larger v.n + sqrt(g h) of both sides.
  [[nodiscard]] SpeedRange speed_range(const State& left, const State& right,
                                       const Vector<D>& normal) const noexcept {
    const double v_left = along(primitive(left), normal);
    const double v_right = along(primitive(right), normal);
    const double c_left = wave_speed(left);
    const double c_right = wave_speed(right);
    return {-larger(c_left - v_left, c_right - v_right), larger(v_left + c_left, v_right + c_right)};
  }

  /// The same water, its velocity along the normal turned round.
  [[nodiscard]] State mirror(const State& u, const Vector<D>& normal) const noexcept {
    const double momentum = along(u, normal);
    State mirrored = u;
    for_each_component<D>(
        [&](std::size_t axis) { mirrored[1 + axis] -= 2 * momentum * normal[static_cast<int>(axis)]; });
    return mirrored;
  }

  /// Whether the depth is zero or positive, and the momentum a number.
  [[nodiscard]] bool is_admissible(const State& u) const noexcept {
    double momentum = 0;
    for_each_component<D>([&](std::size_t axis) { momentum += std::abs(u[1 + axis]); });
    const bool has_depth = u[0] >= 0;
    const bool has_momentum = momentum < std::numeric_limits<double>::infinity();
    return has_depth & has_momentum;  // both, without a branch
  }

  /// Depth and velocity of a conserved state; the velocity of a dry one is zero.
  [[nodiscard]] State primitive(const State& u) const noexcept {
    const bool is_dry = u[0] == 0;
    State w;
    w[0] = u[0];
    for_each_component<D>([&](std::size_t axis) { w[1 + axis] = is_dry ? 0.0 : u[1 + axis] / u[0]; });
    return w;
  }

  /// The inverse of primitive().
  [[nodiscard]] State conserved(const State& w) const noexcept {
    State u;
    u[0] = w[0];
    for_each_component<D>([&](std::size_t axis) { u[1 + axis] = w[0] * w[1 + axis]; });
    return u;
  }

 private:
  /// The part along the normal of the vector that follows the depth.
  [[nodiscard]] static double along(const State& w, const Vector<D>& normal) noexcept {
    double part = 0;
    for_each_component<D>([&](std::size_t axis) { part += w[1 + axis] * normal[static_cast<int>(axis)]; });
    return part;
  }

  /// Of waves on the water, against it [m/s]; NaN for a negative depth.
  [[nodiscard]] double wave_speed(const State& u) const noexcept { return std::sqrt(gravity_ * u[0]); }

  double gravity_;
};
static_assert(ConservationLaw<ShallowWater<1>, 1> && ConservationLaw<ShallowWater<2>, 2>);
static_assert(HasSpeedRange<ShallowWater<2>, 2> && HasMirror<ShallowWater<2>, 2>);
static_assert(HasAdmissibleStates<ShallowWater<2>> && HasPrimitives<ShallowWater<2>>);

}  // namespace scree::transport
