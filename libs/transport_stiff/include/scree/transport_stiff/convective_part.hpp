#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// A law without its diffusion and its source: what is left for explicit steps. All else is the law's own.
template <class Law>
struct ConvectivePart : Law {
  // These hide the law's.
  void potential() const = delete;
  void max_diffusivity() const = delete;
  void source() const = delete;
};

template <FaceDependent Law>
struct ConvectivePart<Law> : Law {
  void source() const = delete;
  [[nodiscard]] auto at(const Face& face) const noexcept {
    return ConvectivePart<PointLawOf<Law>>{Law::at(face)};
  }
};

}  // namespace scree::transport
