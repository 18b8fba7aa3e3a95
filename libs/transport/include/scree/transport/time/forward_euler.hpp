#pragma once

#include <scree/transport/concepts.hpp>

#include <array>

namespace scree::transport {

/// One stage, first order. With second-order slopes it turns smooth waves into staircases that no bound
/// or total variation shows: for comparison, not for use.  Eq. (T7a)
struct ForwardEuler {
  static constexpr std::string_view name = "forward_euler";
  static constexpr std::string_view summary = "one stage, first order: turns smooth waves into staircases";
  static constexpr std::array<double, 1> kept{0};
};
static_assert(Integrator<ForwardEuler>);

}  // namespace scree::transport
