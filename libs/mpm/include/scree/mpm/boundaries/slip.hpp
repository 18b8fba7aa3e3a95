#pragma once

#include <string_view>

namespace scree::mpm {

/// Smooth wall: no velocity through it, no friction along it.  @see Eq. (M16)
struct Slip {
  static constexpr std::string_view name = "slip";
  static constexpr std::string_view summary = "smooth wall: no velocity through it, none held along it";
  /// Whether the wall holds the velocity component `component`, its normal lying along `axis`.
  [[nodiscard]] static constexpr bool holds(int component, int axis) noexcept { return component == axis; }
};

}  // namespace scree::mpm
