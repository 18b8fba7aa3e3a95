#pragma once

#include <scree/transport/concepts.hpp>

#include <array>
#include <cstddef>

namespace scree::transport {

/// A given state outside, such as an inflow: what it sends in by the numerical flux comes in.
template <int N>
struct Prescribed {
  static constexpr std::string_view name = "prescribed";
  static constexpr std::string_view summary = "a given state outside, such as an inflow";
  static constexpr bool is_closed = false;

  std::array<double, static_cast<std::size_t>(N)> outside{};  ///< in the units of the state

  template <class Flux, class Law, int D>
  [[nodiscard]] FaceFlux<typename Law::State> flux(const Flux& flux, const Law& law,
                                                   const typename Law::State& inside,
                                                   const BoundaryFace<D>& face) const noexcept {
    return flux(law, inside, outside, face.outward);
  }
};

}  // namespace scree::transport
