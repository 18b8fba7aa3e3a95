#pragma once

#include <scree/transport/boundaries/outflow.hpp>
#include <scree/transport/boundaries/prescribed.hpp>
#include <scree/transport/boundaries/reflecting.hpp>
#include <scree/transport/boundaries/user_given.hpp>
#include <scree/transport/boundaries/zero_flux.hpp>
#include <scree/transport/type_list.hpp>

#include <array>
#include <cstddef>

namespace scree::transport {

/// Every boundary there is, in D dimensions and for N components. A new one is its header and one entry
/// here. (Periodicity is no boundary but a property of the grid: a periodic axis has no end.)
template <int D, int N>
using BoundaryList = TypeList<  //
    ZeroFlux,                   //
    Outflow,                    //
    Reflecting,                 //
    Prescribed<N>,              //
    UserGiven<D, N>>;

/// A boundary chosen at run time; a wall unless another is given.
template <int D, int N>
using AnyBoundary = AnyOf<BoundaryList<D, N>>;

/// The boundaries of a box: [axis][0] at its low end, [axis][1] at its high end. Those of a periodic axis
/// are not used.
template <int D, int N>
using BoxBoundaries = std::array<std::array<AnyBoundary<D, N>, 2>, static_cast<std::size_t>(D)>;

/// One boundary for all sides of a box, what everywhere() returns: turns into the BoxBoundaries that are
/// asked for.
template <class B>
struct Everywhere {
  B boundary;

  // Not explicit: it may stand where the boundaries of a box are asked for.
  template <class Any, std::size_t D>
  operator std::array<std::array<Any, 2>, D>() const {
    std::array<std::array<Any, 2>, D> sides;
    for (auto& axis : sides) axis.fill(boundary);
    return sides;
  }
};

/// The same boundary at all sides of a box: `{.boundaries = everywhere(Outflow{})}`.
template <class B>
[[nodiscard]] Everywhere<B> everywhere(const B& boundary) {
  return {boundary};
}

}  // namespace scree::transport
