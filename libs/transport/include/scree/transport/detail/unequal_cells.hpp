#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/reconstructions/any_reconstruction.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace scree::transport::detail {

/// A reconstruction made for equal cells, on a cell of extent w whose neighbours are at other distances d.
///
/// It is shown neighbours that differ from the cell by (w/d) times what they do, so that a linear profile
/// stays linear; what it makes of them is scaled back where a face would pass its neighbour's value: by one
/// factor for both faces, which keeps the mean, and for all components where their sum is to be kept.
/// @see Eqs. (T60), (T61)
template <class R>
struct OnUnequalCells {
  static_assert(!is_chosen_at_run_time<R>, "AnyReconstruction has to be the outermost");
  static_assert(
      !requires { requires R::needs_equal_cells; },
      "this reconstruction is right on equal cells only: it cannot stand on a Rectilinear grid");

  const R& reconstruction;
  double ratio_below;  ///< w/d [-], below 2
  double ratio_above;

  template <class State>
  [[nodiscard]] Edges<State> operator()(const State& below, const State& here,
                                        const State& above) const noexcept {
    constexpr int num_components = static_cast<int>(std::tuple_size_v<State>);
    State seen_below;
    State seen_above;
    for_each_component<num_components>([&](std::size_t k) {
      seen_below[k] = here[k] - ratio_below * (here[k] - below[k]);
      seen_above[k] = here[k] + ratio_above * (above[k] - here[k]);
    });
    const Edges<State> edges = reconstruction(seen_below, here, seen_above);
    State part;
    for_each_component<num_components>([&](std::size_t k) {
      part[k] = std::min(allowed(edges.low[k] - here[k], below[k] - here[k]),
                         allowed(edges.high[k] - here[k], above[k] - here[k]));
    });
    if constexpr (requires { reconstruction.noise_of(0.0); }) {
      double least = 1;
      for_each_component<num_components>([&](std::size_t k) {
        const double variation = std::max(std::abs(here[k] - below[k]), std::abs(above[k] - here[k]));
        const bool is_taken = (variation > reconstruction.noise_of(here[k])) & (part[k] < least);
        least = is_taken ? part[k] : least;
      });
      part.fill(least);
    }
    Edges<State> result;
    for_each_component<num_components>([&](std::size_t k) {
      result.low[k] = here[k] + part[k] * (edges.low[k] - here[k]);
      result.high[k] = here[k] + part[k] * (edges.high[k] - here[k]);
    });
    return result;
  }

 private:
  /// The part of a deviation at a face that does not pass the neighbour's.
  [[nodiscard]] static double allowed(double deviation, double neighbour) noexcept {
    const double most = std::abs(neighbour);
    const double asked = std::abs(deviation);
    return asked > most ? most / asked : 1.0;
  }
};

/// A reconstruction as unequal cells need it. One that wraps another, such as in other variables, is put
/// round what the inner one becomes.
template <class R>
[[nodiscard]] auto on_unequal_cells(const R& reconstruction, double ratio_below,
                                    double ratio_above) noexcept {
  if constexpr (requires { reconstruction.around(reconstruction.reconstruction); }) {
    return reconstruction.around(on_unequal_cells(reconstruction.reconstruction, ratio_below, ratio_above));
  } else {
    return OnUnequalCells<R>{reconstruction, ratio_below, ratio_above};
  }
}

/// A row of sites with neighbours at equal distances, as reconstructions expect them.
struct EqualCells {
  template <class R, class State>
  [[nodiscard]] Edges<State> edges(const R& reconstruction, const State& below, const State& here,
                                   const State& above, Index /*entry*/) const noexcept {
    return reconstruction(below, here, above);
  }
  [[nodiscard]] friend EqualCells operator+(EqualCells row, Index /*begin*/) noexcept { return row; }
};

/// A row of sites whose neighbours are at other distances.
template <class Ratio>
struct UnequalCells {
  Ratio below;  ///< the site's extent over the distance to its neighbour [-]
  Ratio above;

  template <class R, class State>
  [[nodiscard]] Edges<State> edges(const R& reconstruction, const State& below_here, const State& here,
                                   const State& above_here, Index i) const noexcept {
    return on_unequal_cells(reconstruction, below[i], above[i])(below_here, here, above_here);
  }
  [[nodiscard]] friend UnequalCells operator+(UnequalCells row, Index begin) noexcept {
    return {row.below + begin, row.above + begin};
  }
};

}  // namespace scree::transport::detail
