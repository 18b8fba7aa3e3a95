#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// Van Albada's limiter: a rational mean that leans to the smaller difference. Smooth and gentle.
/// @see Eq. (T5d), \cite vanalbada1982
struct VanAlbada {
  static constexpr std::string_view name = "van_albada";
  static constexpr std::string_view summary =
      "rational mean leaning to the smaller difference: smooth, gentle";

  [[nodiscard]] double operator()(double backward, double forward) const noexcept {
    const double product = backward * forward;
    const double squares = backward * backward + forward * forward;
    return product > 0 ? product * (backward + forward) / squares : 0.0;
  }

  /// (1 + sqrt 2)/2, reached where one difference is 1 + sqrt 2 times the other.
  [[nodiscard]] double sharpness() const noexcept { return 1.2071067811865475; }
};
static_assert(Limiter<VanAlbada>);

}  // namespace scree::transport
