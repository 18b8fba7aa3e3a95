#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/detail/row.hpp>
#include <scree/transport/detail/tiles.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

// The third loop: what goes in and out through all faces of the sites of a tile, in one pass.

namespace scree::transport::detail {

/// Fluxes through the low and high faces of a row of sites along one axis, and what they count for.
template <class Weight>
struct AxisFluxes {
  const double* low;
  const double* high;
  Weight per_width;  ///< Eq. (T2)
  Weight of_larger;  ///< Eq. (T9)
  Weight of_both;
  const double* walls =
      nullptr;  ///< what the closed parts of both faces add, a WallTile; for laws that reflect

  [[nodiscard]] AxisFluxes part(Index begin) const noexcept {
    return {low + begin, high + begin, per_width + begin, of_larger + begin, of_both + begin, walls + begin};
  }

  template <bool HasWalls>
  [[nodiscard]] double outflow(std::size_t k, Index i) const noexcept {
    const Index entry = static_cast<Index>(k) * Tile<1>::stride + i;
    double passed = high[entry] - low[entry];
    if constexpr (HasWalls) passed += walls[entry];
    return per_width[i] * passed;
  }

  /// Density x CFL number per second.  Eq. (T9)
  template <class Fluxes, bool HasWalls>
  [[nodiscard]] double limit(Index i) const noexcept {
    double drain_low = low[Fluxes::drain * Fluxes::stride + i];
    double drain_high = high[Fluxes::drain * Fluxes::stride + i];
    if constexpr (HasWalls) {
      using Walls = WallTile<Fluxes::drain>;
      drain_low += walls[Walls::drain_low * Walls::stride + i];
      drain_high += walls[Walls::drain_high * Walls::stride + i];
    }
    double result = of_larger[i] * std::max(drain_low, drain_high) + of_both[i] * (drain_low + drain_high);
    if constexpr (Fluxes::has_diffusion) {
      const Index diffusion = Fluxes::diffusion * Fluxes::stride + i;
      result += per_width[i] * (low[diffusion] + high[diffusion]);
    }
    return result;
  }
};

/// The fluxes of a tile of sites along all axes; `sources` enter as well, density x a rate per component.
template <int D>
struct TileFluxes {
  AxisFluxes<const double*> along;
  std::array<AxisFluxes<Same>, static_cast<std::size_t>(D - 1)> across;
  const double* sources;

  [[nodiscard]] TileFluxes part(Index begin) const noexcept {
    TileFluxes result{along.part(begin), across, sources + begin};
    for (auto& axis : result.across) axis = axis.part(begin);
    return result;
  }
};

/// What a balance has, known when compiled.
template <class FluxTile, bool HasSources, bool HasWalls>
struct BalanceParts {
  using Fluxes = FluxTile;
  static constexpr int num_components = FluxTile::drain;
  static constexpr bool has_sources = HasSources;
  static constexpr bool has_walls = HasWalls;
};

/// Writes du/dt of `count` sites from `first` on, and their limits of dt, which a du/dt that is not finite
/// makes NaN.  Eqs. (T2), (T9), (T10)
///
/// @param write called as write(component, site, rate)
/// @param worst largest limit met in each lane so far
template <class Parts, class Grid, int D, class Write>
[[gnu::noinline, gnu::flatten]] void balance(const Grid& grid, Index first, Index count,
                                             const TileFluxes<D>& tile_fluxes, const Write& writer,
                                             double* __restrict limits, double* __restrict worst) noexcept {
  using Fluxes = typename Parts::Fluxes;
  constexpr bool has_walls = Parts::has_walls;
  const TileFluxes<D> fluxes = tile_fluxes;  // copies, which no store through a pointer can change
  const Write write = writer;
#pragma GCC ivdep
  for (Index i = 0; i < count; ++i) {
    const double density = grid.density(first + i);
    const double per_density = density > 0 ? 1 / density : 0.0;
    double limit = fluxes.along.template limit<Fluxes, has_walls>(i);
    for_each_component<D - 1>(
        [&](std::size_t axis) { limit += fluxes.across[axis].template limit<Fluxes, has_walls>(i); });
    double sum = 0;
    for_each_component<Parts::num_components>([&](std::size_t k) {
      double outflow = fluxes.along.template outflow<has_walls>(k, i);
      for_each_component<D - 1>(
          [&](std::size_t axis) { outflow += fluxes.across[axis].template outflow<has_walls>(k, i); });
      if constexpr (Parts::has_sources) {
        outflow -= fluxes.sources[static_cast<Index>(k) * Tile<1>::stride + i];
      }
      const double rate = -outflow * per_density;
      write(static_cast<Index>(k), first + i, rate);
      sum += rate;
    });
    limit = limit * per_density + 0 * sum;
    limits[i] = limit;
    worst[i] = larger(worst[i], limit);
  }
}

/// Writes du/dt itself.
struct WriteRate {
  double* rates;
  Index stride;

  void operator()(Index component, Index site, double rate) const noexcept {
    rates[component * stride + site] = rate;
  }
};

/// Writes the next stage of a Runge-Kutta step instead: kept u^n + (1 - kept)(u + dt rate).  Eq. (T7)
struct WriteStage {
  const double* start;
  const double* here;
  double* next;  // neither of the others: neighbours still want `here`, and a step may be taken again
  Index stride;
  double kept;
  double dt;

  void operator()(Index component, Index site, double rate) const noexcept {
    const Index entry = component * stride + site;
    next[entry] = kept * start[entry] + (1 - kept) * (here[entry] + dt * rate);
  }
};

}  // namespace scree::transport::detail
