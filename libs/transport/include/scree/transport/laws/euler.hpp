#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <array>
#include <cmath>

namespace scree::transport {

/// Euler's equations of an ideal gas: density [kg/m^3], momentum [kg/(m^2 s)] and total energy [J/m^3], in
/// this order.
///
/// Near vacuum second-order slopes of these variables give states with negative pressure; their speed of
/// sound is NaN, which the solver reports.  Eq. (T15)
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
    State u;
    u[0] = density;
    for_each_component<D>(
        [&](std::size_t axis) { u[1 + axis] = density * velocity[static_cast<int>(axis)]; });
    u[D + 1] = pressure / (gamma_ - 1) + 0.5 * density * velocity.squaredNorm();
    return u;
  }

  [[nodiscard]] double pressure(const State& u) const noexcept {
    double squares = 0;
    for_each_component<D>([&](std::size_t axis) { squares += u[1 + axis] * u[1 + axis]; });
    return (gamma_ - 1) * (u[D + 1] - 0.5 * squares / u[0]);
  }

  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    const double p = pressure(u);
    const double speed = normal_momentum(u, normal) / u[0];
    State f;
    f[0] = u[0] * speed;
    for_each_component<D>(
        [&](std::size_t axis) { f[1 + axis] = u[1 + axis] * speed + p * normal[static_cast<int>(axis)]; });
    f[D + 1] = (u[D + 1] + p) * speed;
    return f;
  }

  /// |v.n| + c of the faster side.
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& normal) const noexcept {
    return larger(fastest(left, normal), fastest(right, normal));
  }

 private:
  [[nodiscard]] static double normal_momentum(const State& u, const Vector<D>& normal) noexcept {
    double momentum = 0;
    for_each_component<D>(
        [&](std::size_t axis) { momentum += u[1 + axis] * normal[static_cast<int>(axis)]; });
    return momentum;
  }

  [[nodiscard]] double fastest(const State& u, const Vector<D>& normal) const noexcept {
    return std::abs(normal_momentum(u, normal) / u[0]) + std::sqrt(gamma_ * pressure(u) / u[0]);
  }

  double gamma_;
};
static_assert(ConservationLaw<Euler<1>, 1> && ConservationLaw<Euler<2>, 2> && ConservationLaw<Euler<3>, 3>);

}  // namespace scree::transport
