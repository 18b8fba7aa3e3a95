#pragma once

#include <string_view>

namespace scree::mpm {

/// Rough wall: the material on it does not move.  @see Eq. (M15)
struct NoSlip {
  static constexpr std::string_view name = "no_slip";
  static constexpr std::string_view summary = "rough wall: no velocity on it";
  /// Whether the wall holds the velocity component `component`, its normal lying along `axis`.
  [[nodiscard]] static constexpr bool holds(int /*component*/, int /*axis*/) noexcept { return true; }
};

}  // namespace scree::mpm
