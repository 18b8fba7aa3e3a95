#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <array>
#include <cmath>

namespace scree::transport {

/// Burgers' equation, f(u) = u^2/2 along every axis. Convex: the ends bound the speeds between.  Eq. (T13)
struct Burgers {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;

  template <int D>
  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    return {sum(normal) * (0.5 * u[0] * u[0])};
  }
  template <int D>
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& normal) const noexcept {
    return std::abs(sum(normal)) * larger(std::abs(left[0]), std::abs(right[0]));
  }
  template <int D>
  [[nodiscard]] SpeedRange speed_range(const State& left, const State& right,
                                       const Vector<D>& normal) const noexcept {
    const double speed_left = sum(normal) * left[0];
    const double speed_right = sum(normal) * right[0];
    return {-larger(-speed_left, -speed_right), larger(speed_left, speed_right)};
  }
};
static_assert(ConservationLaw<Burgers, 1> && ConservationLaw<Burgers, 3>);

}  // namespace scree::transport
