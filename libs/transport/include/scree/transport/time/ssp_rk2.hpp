#pragma once

#include <scree/transport/concepts.hpp>

#include <array>

namespace scree::transport {

/// Two stages, second order (Heun's method as a mean of Euler steps): the default.
/// @see Eq. (T7b), \cite shu1988
struct SspRk2 {
  static constexpr std::string_view name = "ssp_rk2";
  static constexpr std::string_view summary = "two stages, second order: the default";
  static constexpr std::array<double, 2> kept{0, 1.0 / 2};
};
static_assert(Integrator<SspRk2>);

}  // namespace scree::transport
