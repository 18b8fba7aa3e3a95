#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// No limiter: the gradient as it is. Second order everywhere, extrema too, and 10 % and more beyond the
/// bounds beside a jump: for smooth solutions only.
struct Unlimited {
  static constexpr std::string_view name = "unlimited";
  static constexpr std::string_view summary = "the gradient as it is: for smooth solutions only";
  static constexpr bool keeps_bounds = false;

  [[nodiscard]] double operator()(double /*allowed*/, double /*wanted*/, double /*width*/) const noexcept {
    return 1;
  }
};
static_assert(CellLimiter<Unlimited>);

}  // namespace scree::transport
