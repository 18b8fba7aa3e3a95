#pragma once

#include <scree/transport/concepts.hpp>

#include <array>
#include <cstddef>
#include <functional>

namespace scree::transport {

/// A boundary of the user's own: the state outside as a function of the one inside, of the place and of the
/// time; what the numerical flux makes of both comes in. An open end unless a function is given.
template <int D, int N>
struct UserGiven {
  static constexpr std::string_view name = "user_given";
  static constexpr std::string_view summary = "the state outside by a function of state, place and time";
  static constexpr bool is_closed = false;

  using State = std::array<double, static_cast<std::size_t>(N)>;

  /// Must not throw, and must not depend on the order of calls: threads call it side by side.
  std::function<State(const State& inside, const BoundaryFace<D>& face)> outside =
      [](const State& inside, const BoundaryFace<D>& /*face*/) { return inside; };

  template <class Flux, class Law>
  [[nodiscard]] FaceFlux<State> flux(const Flux& flux, const Law& law, const State& inside,
                                     const BoundaryFace<D>& face) const noexcept {
    return flux(law, inside, outside(inside, face), face.outward);
  }
};

}  // namespace scree::transport
