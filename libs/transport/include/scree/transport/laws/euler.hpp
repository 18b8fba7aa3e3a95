#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace scree::transport {

/// Euler's equations of an ideal gas: density [kg/m^3], momentum [kg/(m^2 s)] and total energy [J/m^3], in
/// this order. The primitive variables are density, velocity [m/s] and pressure [Pa].
///
/// Near vacuum second-order slopes of the conserved variables give states with negative pressure; slopes of
/// the primitive ones do not (InPrimitives). The speed of sound of a state that cannot be is NaN, which the
/// solver reports.
/// @see Eqs. (T15), (T17)
// Written with 1/u[0], which compilers then find only once: divisions bound the speed of the flux.
template <int D>
class Euler {
 public:
  static constexpr int num_components = D + 2;
  using State = std::array<double, static_cast<std::size_t>(D + 2)>;

  /// @param gamma ratio of specific heats [-], above 1.  @throws InputError
  explicit Euler(double gamma = 1.4) : gamma_{gamma} {
    require(gamma > 1 && std::isfinite(gamma), "Euler: the ratio of specific heats must exceed 1");
  }

  /// The conserved state of a gas of density [kg/m^3], velocity [m/s] and pressure [Pa].
  [[nodiscard]] State state(double density, const Vector<D>& velocity, double pressure) const noexcept {
    State w;
    w[0] = density;
    for_each_component<D>([&](std::size_t axis) { w[1 + axis] = velocity[static_cast<int>(axis)]; });
    w[D + 1] = pressure;
    return conserved(w);
  }

  [[nodiscard]] double pressure(const State& u) const noexcept {
    return (gamma_ - 1) * (u[D + 1] - 0.5 * squared_momentum(u) * (1 / u[0]));
  }

  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    const double p = pressure(u);
    const double speed = normal_momentum(u, normal) * (1 / u[0]);
    State f;
    f[0] = u[0] * speed;
    for_each_component<D>(
        [&](std::size_t axis) { f[1 + axis] = u[1 + axis] * speed + p * normal[static_cast<int>(axis)]; });
    f[D + 1] = (u[D + 1] + p) * speed;
    return f;
  }

  /// |v.n| + c of the faster side: enough for positive density and pressure, though a strong shock between
  /// both states can be faster.
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& normal) const noexcept {
    return larger(fastest(left, normal), fastest(right, normal));
  }

  /// From the smaller v.n - c to the larger v.n + c of both sides.
  [[nodiscard]] SpeedRange speed_range(const State& left, const State& right,
                                       const Vector<D>& normal) const noexcept {
    const double v_left = normal_momentum(left, normal) * (1 / left[0]);
    const double v_right = normal_momentum(right, normal) * (1 / right[0]);
    const double c_left = sound_speed(left);
    const double c_right = sound_speed(right);
    return {-larger(c_left - v_left, c_right - v_right), larger(v_left + c_left, v_right + c_right)};
  }

  /// The same gas, its velocity along the normal turned round.
  [[nodiscard]] State mirror(const State& u, const Vector<D>& normal) const noexcept {
    const double momentum = normal_momentum(u, normal);
    State mirrored = u;
    for_each_component<D>(
        [&](std::size_t axis) { mirrored[1 + axis] -= 2 * momentum * normal[static_cast<int>(axis)]; });
    return mirrored;
  }

  /// Whether density and pressure are positive, and density x energy no less than 1e-308 in SI units.
  [[nodiscard]] bool is_admissible(const State& u) const noexcept {
    const bool has_mass = u[0] > 0;
    const bool has_heat = u[0] * u[D + 1] > 0.5 * squared_momentum(u);
    return has_mass & has_heat;  // both, without a branch
  }

  /// Density, velocity and pressure of a conserved state.
  [[nodiscard]] State primitive(const State& u) const noexcept {
    const double per_density = 1 / u[0];
    State w;
    w[0] = u[0];
    for_each_component<D>([&](std::size_t axis) { w[1 + axis] = u[1 + axis] * per_density; });
    w[D + 1] = (gamma_ - 1) * (u[D + 1] - 0.5 * squared_momentum(u) * per_density);
    return w;
  }

  /// The inverse of primitive().
  [[nodiscard]] State conserved(const State& w) const noexcept {
    State u;
    u[0] = w[0];
    for_each_component<D>([&](std::size_t axis) { u[1 + axis] = w[0] * w[1 + axis]; });
    u[D + 1] = w[D + 1] / (gamma_ - 1) + 0.5 * w[0] * squared_momentum(w);  // here: squared velocity
    return u;
  }

 private:
  [[nodiscard]] static double squared_momentum(const State& u) noexcept {
    double squares = 0;
    for_each_component<D>([&](std::size_t axis) { squares += u[1 + axis] * u[1 + axis]; });
    return squares;
  }

  [[nodiscard]] static double normal_momentum(const State& u, const Vector<D>& normal) noexcept {
    double momentum = 0;
    for_each_component<D>(
        [&](std::size_t axis) { momentum += u[1 + axis] * normal[static_cast<int>(axis)]; });
    return momentum;
  }

  /// [m/s]; NaN for a state that cannot be, one with negative density and pressure included.
  [[nodiscard]] double sound_speed(const State& u) const noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return std::sqrt(gamma_ * pressure(u) * (u[0] > 0 ? 1 / u[0] : nan));
  }

  [[nodiscard]] double fastest(const State& u, const Vector<D>& normal) const noexcept {
    return std::abs(normal_momentum(u, normal) * (1 / u[0])) + sound_speed(u);
  }

  double gamma_;
};
static_assert(ConservationLaw<Euler<1>, 1> && ConservationLaw<Euler<2>, 2> && ConservationLaw<Euler<3>, 3>);
static_assert(HasSpeedRange<Euler<2>, 2> && HasMirror<Euler<2>, 2>);
static_assert(HasAdmissibleStates<Euler<2>> && HasPrimitives<Euler<2>>);

}  // namespace scree::transport
