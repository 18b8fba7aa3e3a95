#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/steepest_slopes.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree::transport {

/// Buckley-Leverett's fractional flow with gravity: along axis d it is
/// f_d(u) = F(u) (1 - C_d (1 - u)^2), F = u^2/(u^2 + M (1 - u)^2), 0 <= u <= 1.
///
/// Neither convex nor monotone: the fluids may flow against each other. Without gravity it is
/// BuckleyLeverett, which is faster.
/// @see Eq. (T19), \cite kurganov2000
template <int D>
class BuckleyLeverettGravity {
 public:
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;

  /// @param gravity C along each axis: weight of the difference in density against the viscous forces [-].
  /// @param viscosity_ratio M, of the wetting fluid over the other [-], positive.
  /// @throws InputError if one is not finite, or M not positive.
  explicit BuckleyLeverettGravity(const Vector<D>& gravity = Vector<D>::Constant(5),
                                  double viscosity_ratio = 1)
      : gravity_{gravity}, M_{viscosity_ratio} {
    require(viscosity_ratio > 0 && std::isfinite(viscosity_ratio),
            "BuckleyLeverettGravity: the viscosity ratio must be positive and finite");
    require(gravity.allFinite(), "BuckleyLeverettGravity: gravity must be finite");
    for (int axis = 0; axis < D; ++axis) {
      steepest_[static_cast<std::size_t>(axis)] =
          detail::steepest_slopes_of_fractional_flow(gravity[axis], viscosity_ratio);
    }
  }

  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    const double wet = u[0] * u[0];
    const double dry = (1 - u[0]) * (1 - u[0]);
    const double along = sum(normal) - dry * dot(gravity_, normal);
    return {along * (wet / (wet + M_ * dry))};
  }

  /// The larger end of speed_range().
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& normal) const noexcept {
    const SpeedRange range = speed_range(left, right, normal);
    return larger(-range.lowest, range.highest);
  }

  /// The slopes of f_d over the whole interval, from those at its ends and wherever f_d'' = 0 between: exact
  /// along an axis, a bound along other normals.
  [[nodiscard]] SpeedRange speed_range(const State& left, const State& right,
                                       const Vector<D>& normal) const noexcept {
    SpeedRange range{0, 0};
    for_each_component<D>([&](std::size_t axis) {
      const double part = normal[static_cast<int>(axis)];
      const SpeedRange along = slopes(left[0], right[0], axis);
      range.lowest += part > 0 ? part * along.lowest : part * along.highest;
      range.highest += part > 0 ? part * along.highest : part * along.lowest;
    });
    return range;
  }

 private:
  /// Smallest and largest f_d' between two states.
  [[nodiscard]] SpeedRange slopes(double left, double right, std::size_t axis) const noexcept {
    const double low = std::min(left, right);
    const double high = std::max(left, right);
    const double slope_left = slope(left, axis);
    SpeedRange range{slope_left, slope_left};
    const auto include = [&](double value) {
      range.lowest = -larger(-range.lowest, -value);
      range.highest = larger(range.highest, value);
    };
    include(slope(right, axis));
    for_each_component<detail::SteepestSlopes::max_count>([&](std::size_t i) {
      const bool is_between = (low < steepest_[axis].at[i]) & (steepest_[axis].at[i] < high);
      include(is_between ? steepest_[axis].slope[i] : slope_left);
    });
    return range;
  }

  [[nodiscard]] double slope(double u, std::size_t axis) const noexcept {
    const double C = gravity_[static_cast<int>(axis)];
    const double dry = (1 - u) * (1 - u);
    const double total = u * u + M_ * dry;
    const double fraction = u * u / total;
    const double fraction_slope = 2 * M_ * u * (1 - u) / (total * total);
    return fraction_slope * (1 - C * dry) + 2 * C * fraction * (1 - u);
  }

  Vector<D> gravity_;
  double M_;
  std::array<detail::SteepestSlopes, static_cast<std::size_t>(D)> steepest_;
};
static_assert(ConservationLaw<BuckleyLeverettGravity<1>, 1> && HasSpeedRange<BuckleyLeverettGravity<2>, 2>);

}  // namespace scree::transport
