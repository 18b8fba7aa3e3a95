#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <algorithm>

namespace scree::transport {

/// Central-upwind flux of Kurganov, Noelle & Petrova: the fan of waves has an end on either side, so that
/// where all waves go one way the flux is the upwind one. One pair of speeds for all components.
///
/// Sharper than KurganovTadmor for laws that tell their speeds apart (HasSpeedRange), the same for others.
/// @see Eq. (T16), \cite kurganov2001
struct KurganovNoellePetrova {
  static constexpr std::string_view name = "kurganov_noelle_petrova";
  static constexpr std::string_view summary =
      "central-upwind, speeds to both sides: sharper where waves go one way";

  /// @param normal unit, from `left` to `right`.
  template <class Law, int D>
  [[nodiscard]] FaceFlux<typename Law::State> operator()(const Law& law, const typename Law::State& left,
                                                         const typename Law::State& right,
                                                         const Vector<D>& normal) const noexcept {
    const auto flux_left = law.flux(left, normal);
    const auto flux_right = law.flux(right, normal);
    const auto [to_left, to_right] = fan(law, left, right, normal);
    const double width = to_right + to_left;
    const double per_width = width > 0 ? 1 / width : 0.0;  // at rest the central flux is left
    const double lean = (to_right - to_left) * per_width;  // 1: all from the left, -1: all from the right
    const double spread = to_right * to_left * per_width;
    FaceFlux<typename Law::State> face;
    face.speed = larger(to_left, to_right);
    for_each_component<Law::num_components>([&](std::size_t k) {
      const double mean = 0.5 * (flux_left[k] + flux_right[k]);
      face.value[k] = mean + (0.5 * lean * (flux_left[k] - flux_right[k]) - spread * (right[k] - left[k]));
    });
    return face;
  }

 private:
  /// How fast the fan grows to either side [m/s], both >= 0; NaN passes through.
  struct Fan {
    double to_left;
    double to_right;
  };

  template <class Law, int D>
  [[nodiscard]] static Fan fan(const Law& law, const typename Law::State& left,
                               const typename Law::State& right, const Vector<D>& normal) noexcept {
    if constexpr (HasSpeedRange<Law, D>) {
      const SpeedRange range = law.speed_range(left, right, normal);
      return {larger(-range.lowest, 0), larger(range.highest, 0)};
    } else {
      const double speed = law.max_speed(left, right, normal);
      return {speed, speed};
    }
  }
};

}  // namespace scree::transport
