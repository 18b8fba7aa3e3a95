#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// Central flux of Kurganov & Tadmor: the mean of both sides' fluxes, less half the largest wave speed
/// times the jump. One speed for all components, so that sums which the law keeps stay kept.
///
/// Needs no Riemann solver: any flux function will do. With piecewise constant states it is the local
/// Lax-Friedrichs (Rusanov) flux.
/// @see Eq. (T3), \cite kurganov2000
struct KurganovTadmor {
  static constexpr std::string_view name = "kurganov_tadmor";
  static constexpr std::string_view summary =
      "central, one local speed for all components: any law, no Riemann solver";

  /// @param normal unit, from `left` to `right`.
  template <class Law, int D>
  [[nodiscard]] FaceFlux<typename Law::State> operator()(const Law& law, const typename Law::State& left,
                                                         const typename Law::State& right,
                                                         const Vector<D>& normal) const noexcept {
    const auto flux_left = law.flux(left, normal);
    const auto flux_right = law.flux(right, normal);
    const double speed = law.max_speed(left, right, normal);
    FaceFlux<typename Law::State> face;
    face.speed = speed;
    for_each_component<Law::num_components>([&](std::size_t k) {
      face.value[k] = 0.5 * ((flux_left[k] + flux_right[k]) - speed * (right[k] - left[k]));
    });
    return face;
  }
};

}  // namespace scree::transport
