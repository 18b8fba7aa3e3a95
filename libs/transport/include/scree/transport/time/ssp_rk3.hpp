#pragma once

#include <scree/transport/concepts.hpp>

#include <array>

namespace scree::transport {

/// Three stages, third order.
/// @see Eq. (T7c), \cite shu1988
struct SspRk3 {
  static constexpr std::string_view name = "ssp_rk3";
  static constexpr std::string_view summary = "three stages, third order";
  static constexpr std::array<double, 3> kept{0, 3.0 / 4, 1.0 / 3};
};
static_assert(Integrator<SspRk3>);

}  // namespace scree::transport
