#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// A wall that throws waves back: the state outside is the mirror image of the one inside, so that no mass
/// passes but a pressure acts. For a law without a mirror image nothing passes at all.
struct Reflecting {
  static constexpr std::string_view name = "reflecting";
  static constexpr std::string_view summary = "a wall that reflects: the mirror image of the state outside";
  static constexpr bool is_closed = false;

  template <class Flux, class Law, int D>
  [[nodiscard]] FaceFlux<typename Law::State> flux(const Flux& flux, const Law& law,
                                                   const typename Law::State& inside,
                                                   const BoundaryFace<D>& face) const noexcept {
    if constexpr (HasMirror<Law, D>) {
      return flux(law, inside, law.mirror(inside, face.outward), face.outward);
    } else {
      return {};
    }
  }
};

}  // namespace scree::transport
