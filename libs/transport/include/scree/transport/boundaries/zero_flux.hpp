#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// A wall: nothing passes.
struct ZeroFlux {
  static constexpr std::string_view name = "zero_flux";
  static constexpr std::string_view summary = "a wall: nothing passes";
  static constexpr bool is_closed = true;

  template <class Flux, class Law, int D>
  [[nodiscard]] FaceFlux<typename Law::State> flux(const Flux& /*flux*/, const Law& /*law*/,
                                                   const typename Law::State& /*inside*/,
                                                   const BoundaryFace<D>& /*face*/) const noexcept {
    return {};
  }
};

}  // namespace scree::transport
