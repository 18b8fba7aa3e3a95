#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// An open end: the state outside is the one inside, so waves leave and none enters.
struct Outflow {
  static constexpr std::string_view name = "outflow";
  static constexpr std::string_view summary = "an open end: the state outside is the one inside";
  static constexpr bool is_closed = false;

  template <class Flux, class Law, int D>
  [[nodiscard]] FaceFlux<typename Law::State> flux(const Flux& flux, const Law& law,
                                                   const typename Law::State& inside,
                                                   const BoundaryFace<D>& face) const noexcept {
    return flux(law, inside, inside, face.outward);
  }
};

}  // namespace scree::transport
