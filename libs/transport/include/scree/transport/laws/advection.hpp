#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <array>
#include <cmath>

namespace scree::transport {

/// Advection of one quantity by a constant velocity: f(u) = v u.  Eq. (T12)
template <int D>
struct Advection {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;

  Vector<D> velocity = Vector<D>::Ones();  ///< [m/s]

  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    return {dot(velocity, normal) * u[0]};
  }
  [[nodiscard]] double max_speed(const State& /*left*/, const State& /*right*/,
                                 const Vector<D>& normal) const noexcept {
    return std::abs(dot(velocity, normal));
  }
  [[nodiscard]] SpeedRange speed_range(const State& /*left*/, const State& /*right*/,
                                       const Vector<D>& normal) const noexcept {
    const double speed = dot(velocity, normal);
    return {speed, speed};
  }
};
static_assert(ConservationLaw<Advection<2>, 2>);

}  // namespace scree::transport
