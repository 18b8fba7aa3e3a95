#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree::transport {

/// Buckley-Leverett's fractional flow of two fluids in a porous rock, f(u) = u^2/(u^2 + M (1 - u)^2) along
/// every axis, 0 <= u <= 1. Not convex: the largest speed may lie between two states. With gravity:
/// BuckleyLeverettGravity.
/// @see Eq. (T14), \cite buckley1942
class BuckleyLeverett {
 public:
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;

  /// @param viscosity_ratio M, of the wetting fluid over the other [-], positive.  @throws InputError
  explicit BuckleyLeverett(double viscosity_ratio = 1) : M_{viscosity_ratio} {
    require(viscosity_ratio > 0 && std::isfinite(viscosity_ratio),
            "BuckleyLeverett: the viscosity ratio must be positive and finite");
    const double share = M_ / (1 + M_);
    inflexion_ = 0.5 - std::sin(std::asin(1 - 2 * share) / 3);
  }

  template <int D>
  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    const double wet = u[0] * u[0];
    return {sum(normal) * (wet / (wet + M_ * (1 - u[0]) * (1 - u[0])))};
  }

  /// f' rises up to the inflexion and falls after it, so its maximum over an interval is at the point of the
  /// interval that is nearest to the inflexion.
  template <int D>
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& normal) const noexcept {
    const double low = std::min(left[0], right[0]);
    const double high = std::max(left[0], right[0]);
    const double fastest = std::min(std::max(inflexion_, low), high);
    return std::abs(sum(normal)) * larger(std::abs(slope(fastest)), 0 * (left[0] + right[0]));
  }

  /// The smallest f' of an interval is at one of its ends.
  template <int D>
  [[nodiscard]] SpeedRange speed_range(const State& left, const State& right,
                                       const Vector<D>& normal) const noexcept {
    const double direction = sum(normal);
    const double slowest = -larger(-slope(left[0]), -slope(right[0]));
    const double fastest =
        slope(std::min(std::max(inflexion_, std::min(left[0], right[0])), std::max(left[0], right[0])));
    const double one = direction * slowest;
    const double other = direction * fastest;
    return {-larger(-one, -other), larger(one, other)};
  }

 private:
  [[nodiscard]] double slope(double u) const noexcept {
    const double total = u * u + M_ * (1 - u) * (1 - u);
    return 2 * M_ * u * (1 - u) / (total * total);
  }

  double M_;
  double inflexion_;  // 2 u^3 - 3 u^2 + M/(1 + M) = 0
};
static_assert(ConservationLaw<BuckleyLeverett, 1> && HasSpeedRange<BuckleyLeverett, 2>);

}  // namespace scree::transport
