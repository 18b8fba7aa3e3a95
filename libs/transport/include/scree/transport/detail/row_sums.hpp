#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/detail/tiles.hpp>

#include <algorithm>

namespace scree::transport::detail {

/// What the fluxes through both faces along one axis count for at a site.  Eqs. (T2), (T9)
struct AxisWeights {
  double width;   ///< 1/(extent of the control volume) [1/m]
  double larger;  ///< of the larger of both faces' speeds in the limit of dt [1/m]
  double both;    ///< of their sum, at a wall, where the whole of the site's value stands behind one face

  template <int D>
  AxisWeights(const Lattice<D>& lattice, const Indices<D>& site, int axis, double cfl) noexcept
      : width{1 / lattice.width(site, axis)}, larger{width}, both{0} {
    const auto a = static_cast<std::size_t>(axis);
    if (lattice.is_periodic[a] || (site[a] > 0 && site[a] < lattice.count[a] - 1)) return;
    larger = 0;
    both = cfl * width;
  }
};

/// The balance of a tile of sites while its axes are added up.
template <int N>
struct RowSums {
  using Row = std::array<double, Tile<N>::stride>;

  Tile<N> outflow;              ///< density x -du/dt
  alignas(64) Row limit;        ///< density x CFL number per second, in the end without the density [1/s]
  alignas(64) Row per_density;  ///< 1/density; 0 where empty

  void clear() noexcept {
    for (auto& component : outflow.values) component.fill(0);
    limit.fill(0);
  }

  /// Adds one axis for sites begin .. end - 1, from the fluxes through their low and high faces.
  [[gnu::noinline]] void add(const double* low, const double* high, const AxisWeights& weights, Index begin,
                             Index end) noexcept {
    using In = FluxTile<N>;
    for (int k = 0; k < N; ++k) {
      double* sum = outflow.row(k);
      const double* low_flux = low + k * In::stride;
      const double* high_flux = high + k * In::stride;
      for (Index i = begin; i < end; ++i) sum[i] += weights.width * (high_flux[i] - low_flux[i]);
    }
    const double* low_drain = low + In::drain * In::stride;
    const double* high_drain = high + In::drain * In::stride;
    const double* low_diffusion = low + In::diffusion * In::stride;
    const double* high_diffusion = high + In::diffusion * In::stride;
    for (Index i = begin; i < end; ++i) {
      limit[static_cast<std::size_t>(i)] += weights.larger * std::max(low_drain[i], high_drain[i]) +
                                            weights.both * (low_drain[i] + high_drain[i]) +
                                            weights.width * (low_diffusion[i] + high_diffusion[i]);
    }
  }

  /// Divides by the density: du/dt of `count` sites from `first` on, and their limit, which a du/dt that is
  /// not finite makes NaN.
  template <class Grid>
  [[gnu::noinline]] void finish(const Grid& grid, Index first, Index count, double* __restrict rate,
                                Index rate_stride) noexcept {
    for (Index i = 0; i < count; ++i) {
      const double density = grid.density(first + i);
      per_density[static_cast<std::size_t>(i)] = density > 0 ? 1 / density : 0.0;
    }
    for (int k = 0; k < N; ++k) {
      const double* sum = outflow.row(k);
      double* component = rate + k * rate_stride + first;
      for (Index i = 0; i < count; ++i) {
        const double value = -sum[i] * per_density[static_cast<std::size_t>(i)];
        component[i] = value;
        limit[static_cast<std::size_t>(i)] += 0 * value;
      }
    }
    for (Index i = 0; i < count; ++i) {
      limit[static_cast<std::size_t>(i)] *= per_density[static_cast<std::size_t>(i)];
    }
  }
};

}  // namespace scree::transport::detail
