#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport::detail {

/// A row of sites with neighbours at equal distances, as reconstructions expect them.
struct EqualCells {
  template <class R, class State>
  [[nodiscard]] Edges<State> edges(const R& reconstruction, const State& below, const State& here,
                                   const State& above, Index /*entry*/) const noexcept {
    return reconstruction(below, here, above);
  }
  [[nodiscard]] friend EqualCells operator+(EqualCells row, Index /*begin*/) noexcept { return row; }
};

/// A row of sites whose neighbours are at other distances than their own extent.
template <class Ratio>
struct UnequalCells {
  Ratio below;  ///< extent over distance
  Ratio above;
};

}  // namespace scree::transport::detail
