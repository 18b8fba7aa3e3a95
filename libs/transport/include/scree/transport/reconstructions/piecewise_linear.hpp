#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/limiters/minmod.hpp>

#include <tuple>

namespace scree::transport {

/// Second order: a straight line in each cell, each component's slope limited by itself.
///
/// Sums of components are not kept (each has its own limiter factor): for coupled fractions use
/// PiecewiseLinearCommon.
/// @see Eq. (T5), \cite vanleer1979
template <Limiter L>
struct PiecewiseLinear {
  static constexpr std::string_view name = "piecewise_linear";
  static constexpr std::string_view summary =
      "second order: a line per cell, each component limited by itself";

  L limiter{};

  template <class State>
  [[nodiscard]] Edges<State> operator()(const State& below, const State& here,
                                        const State& above) const noexcept {
    Edges<State> edges;
    for_each_component<static_cast<int>(std::tuple_size_v<State>)>([&](std::size_t k) {
      const double slope = limiter(here[k] - below[k], above[k] - here[k]);
      edges.low[k] = here[k] - 0.5 * slope;
      edges.high[k] = here[k] + 0.5 * slope;
    });
    return edges;
  }

  /// 1/(1 + theta/2) with theta the limiter's sharpness: 0.66, 0.60, 0.50 for 1, 1.3, 2.  Eq. (T9)
  [[nodiscard]] double promised_cfl() const noexcept { return 1 / (1 + limiter.sharpness() / 2); }
};
template <Limiter L>
PiecewiseLinear(L) -> PiecewiseLinear<L>;

static_assert(Reconstruction<PiecewiseLinear<Minmod>, 1>);

}  // namespace scree::transport
