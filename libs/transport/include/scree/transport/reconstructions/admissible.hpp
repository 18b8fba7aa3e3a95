#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/reconstructions/any_reconstruction.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace scree::transport {

/// Whether the mean of both faces is the cell's value; so it is, unless a reconstruction says otherwise.
template <class R>
constexpr bool keeps_mean = true;
template <class R>
requires requires {
  { R::keeps_mean } -> std::convertible_to<bool>;
}
constexpr bool keeps_mean<R> = R::keeps_mean;

/// Another reconstruction with its deviations from the cell's value scaled down, all by one factor, where a
/// state at a face cannot be: halved up to twice, then dropped.
///
/// An admissible cell then stays so under the promised CFL number, for laws whose admissible states are
/// convex and kept by a first-order step (Euler, ShallowWater). Nothing else changes: only values at faces
/// are scaled, so the scheme is as conservative as before, and keeps its order where nothing needs scaling.
/// A cell that is not admissible itself is left flat, and its NaN is found.
/// @see Eqs. (T23), (T24), \cite perthame1996
template <class R, HasAdmissibleStates Law>
struct Admissible {
  static_assert(!is_chosen_at_run_time<R>, "put AnyReconstruction round several Admissible, not inside one");
  static constexpr std::string_view name = "admissible";
  static constexpr std::string_view summary = "another reconstruction, scaled down to states that can be";
  static constexpr bool keeps_mean = transport::keeps_mean<R>;

  R reconstruction{};
  Law law{};  ///< whose states

  using State = typename Law::State;

  [[nodiscard]] Edges<State> operator()(const State& below, const State& here,
                                        const State& above) const noexcept {
    const Edges<State> edges = reconstruction(below, here, above);
    const bool is_fine = holds(here, edges);
    const Edges<State> halves = scaled(here, edges, 0.5);
    const Edges<State> quarters = scaled(here, edges, 0.25);
    const double part = holds(here, halves) ? 0.5 : holds(here, quarters) ? 0.25 : 0.0;
    const Edges<State> remedy = scaled(here, edges, part);
    Edges<State> result;
    for_each_component<Law::num_components>([&](std::size_t k) {
      result.low[k] = is_fine ? edges.low[k] : remedy.low[k];
      result.high[k] = is_fine ? edges.high[k] : remedy.high[k];
    });
    return result;
  }

  /// The same round another reconstruction, such as one for unequal cells.
  template <class Other>
  [[nodiscard]] Admissible<Other, Law> around(const Other& other) const noexcept {
    return {other, law};
  }

  /// Half the part of the cell that stands behind its faces: 1/2 where the mean is kept, else 2/5.  Eq. (T24)
  [[nodiscard]] double promised_cfl() const noexcept {
    return std::min(keeps_mean ? 0.5 : part_in_edges / 2, reconstruction.promised_cfl());
  }

 private:
  // [-] Of a cell's value that is thought of as the mean of its faces; the rest is a state of its own, which
  // must be admissible too. Near 1 this scales strong waves down, near 0 it shortens the step.
  static constexpr double part_in_edges = 0.8;

  [[nodiscard]] static Edges<State> scaled(const State& here, const Edges<State>& edges,
                                           double part) noexcept {
    Edges<State> result;
    for_each_component<Law::num_components>([&](std::size_t k) {
      result.low[k] = here[k] + part * (edges.low[k] - here[k]);
      result.high[k] = here[k] + part * (edges.high[k] - here[k]);
    });
    return result;
  }

  [[nodiscard]] bool holds(const State& here, const Edges<State>& edges) const noexcept {
    const bool holds_low = law.is_admissible(edges.low);
    const bool holds_high = law.is_admissible(edges.high);
    bool result = holds_low & holds_high;
    if constexpr (!keeps_mean) {
      constexpr double weight = part_in_edges / (1 - part_in_edges);
      State rest;
      for_each_component<Law::num_components>([&](std::size_t k) {
        rest[k] = here[k] + weight * (here[k] - 0.5 * (edges.low[k] + edges.high[k]));
      });
      result = result & law.is_admissible(rest);
    }
    return result;
  }
};
template <class R, class Law>
Admissible(R, Law) -> Admissible<R, Law>;

}  // namespace scree::transport
