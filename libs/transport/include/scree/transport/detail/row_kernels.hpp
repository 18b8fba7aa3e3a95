#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/row.hpp>
#include <scree/transport/detail/tiles.hpp>
#include <scree/transport/detail/unequal_cells.hpp>
#include <scree/transport/face.hpp>
#include <scree/transport/fields.hpp>

#include <algorithm>

// The two loops in which all the work is: reconstruction and flux, along rows of up to tile_width sites.
// Each is one function that is never inlined into a caller, so that a face which two threads compute has
// the same bits in both, and has everything inlined into it, so that it can be vectorised.

namespace scree::transport::detail {

/// Sites as they are stored.
template <class Grid, int N>
struct StoredSites {
  static constexpr int num_components = N;

  const Grid& grid;
  const Fields<N>& fields;

  [[nodiscard]] double density(Index site) const noexcept { return grid.density(site); }
  [[nodiscard]] double value(std::size_t k, Index site) const noexcept {
    return fields.data()[static_cast<Index>(k) * fields.stride() + site];
  }
};

/// A copy of up to tile_width sites of a row, numbered from 0, and of their neighbours in it at both ends, -1
/// and the number of sites: so that all of them have their neighbours beside them.
template <int N>
class RowCopy {
 public:
  static constexpr int num_components = N;

  [[nodiscard]] double density(Index i) const noexcept { return rows_.row(N)[i]; }
  [[nodiscard]] double value(std::size_t k, Index i) const noexcept {
    return rows_.row(static_cast<int>(k))[i];
  }

  /// Copies `count` sites from `first` on, and those below and above; one that is no_site is empty.
  template <class Grid>
  void copy(const StoredSites<Grid, N>& sites, Index below, Index first, Index above, Index count) noexcept {
    for (int k = 0; k < N; ++k) {
      const double* source = sites.fields.data() + k * sites.fields.stride();
      double* target = rows_.row(k);
      std::copy_n(source + first, count, target);
      target[-1] = below == no_site ? target[0] : source[below];
      target[count] = above == no_site ? target[0] : source[above];
    }
    double* densities = rows_.row(N);
    for (Index i = 0; i < count; ++i) densities[i] = sites.density(first + i);
    densities[-1] = below == no_site ? 0.0 : sites.density(below);
    densities[count] = above == no_site ? 0.0 : sites.density(above);
  }

 private:
  Tile<N + 1> rows_{};
};

/// First of `count` consecutive sites, and of their neighbours on both sides along an axis; all three the
/// same where a neighbour is missing.
template <class Ratios>
struct StencilRow {
  Index below;
  Index here;
  Index above;
  Index count;
  Ratios ratios;

  [[nodiscard]] StencilRow part(Index begin, Index size) const noexcept {
    return {below + begin, here + begin, above + begin, size, ratios + begin};
  }
};

template <class Ratios>
StencilRow(Index, Index, Index, Index, Ratios) -> StencilRow<Ratios>;

/// Values of the reconstruction at both faces of each site of a row.  Eqs. (T4) to (T6)
template <class Sites, class R, class Ratios>
[[gnu::noinline, gnu::flatten]] void reconstruct(const Sites& sites, const R& reconstruction,
                                                 const StencilRow<Ratios>& row, double* __restrict low,
                                                 double* __restrict high) noexcept {
  constexpr int N = Sites::num_components;
  using State = std::array<double, static_cast<std::size_t>(N)>;
#pragma GCC ivdep
  for (Index i = 0; i < row.count; ++i) {
    const bool is_inside = std::min(sites.density(row.below + i), sites.density(row.above + i)) > 0;
    State below;
    State here;
    State above;
    for_each_component<N>([&](std::size_t k) {
      here[k] = sites.value(k, row.here + i);
      below[k] = select(is_inside, sites.value(k, row.below + i), here[k]);
      above[k] = select(is_inside, sites.value(k, row.above + i), here[k]);
    });
    const Edges<State> edges = row.ratios.edges(reconstruction, below, here, above, i);
    for_each_component<N>([&](std::size_t k) {
      low[static_cast<Index>(k) * Tile<N>::stride + i] = edges.low[k];
      high[static_cast<Index>(k) * Tile<N>::stride + i] = edges.high[k];
    });
  }
}

/// First of `count` consecutive faces: the sites on both sides, and the distance between them [m].
template <class Distance>
struct FaceRow {
  Index owner;
  Index neighbour;
  Index count;
  int axis;
  Distance distance;

  [[nodiscard]] FaceRow part(Index begin, Index size) const noexcept {
    return {owner + begin, neighbour + begin, size, axis, distance + begin};
  }
};

template <class Distance>
FaceRow(Index, Index, Index, int, Distance) -> FaceRow<Distance>;

/// What a point law's diffusion sends through a face, from the values at the sites.  Eq. (T11)
/// @return its share of the limit of dt [m/s]
template <class Law, class State>
[[nodiscard]] double add_diffusion(const Law& law, const State& left, const State& right, double per_distance,
                                   State& flux) noexcept {
  const State potential_left = law.potential(left);
  const State potential_right = law.potential(right);
  for_each_component<Law::num_components>(
      [&](std::size_t k) { flux[k] -= (potential_right[k] - potential_left[k]) * per_distance; });
  return law.max_diffusivity(left, right) * per_distance;
}

/// Fluxes through a row of faces between sites, from the reconstructed states on both sides of each, times
/// the smaller of the two densities; zero where a side is empty.  Eqs. (T3), (T10), (T11)
/// @param fastest largest speed met in each lane so far
template <class Grid, class Law, class Flux, int N, class Distance>
[[gnu::noinline, gnu::flatten]] void flux_between(const Grid& grid, const Law& law,
                                                  const Flux& numerical_flux, const Fields<N>& fields,
                                                  const FaceRow<Distance>& row, const double* __restrict left,
                                                  const double* __restrict right, double* __restrict flux,
                                                  double* __restrict fastest) noexcept {
  using State = std::array<double, static_cast<std::size_t>(N)>;
  using Out = FluxTile<N, Diffusive<PointLawOf<Law>>>;
  const Vector<Grid::dimension> normal = Vector<Grid::dimension>::Unit(row.axis);
  const Index stride = fields.stride();
  const double* u = fields.data();
#pragma GCC ivdep
  for (Index i = 0; i < row.count; ++i) {
    const Index owner = row.owner + i;
    const Index neighbour = row.neighbour + i;
    State edge_left;
    State edge_right;
    for_each_component<N>([&](std::size_t k) {
      edge_left[k] = left[static_cast<Index>(k) * Tile<N>::stride + i];
      edge_right[k] = right[static_cast<Index>(k) * Tile<N>::stride + i];
    });
    const auto& point_law = law_at(law, Face{owner, neighbour, row.axis, row.distance[i]});
    FaceFlux<State> face = numerical_flux(point_law, edge_left, edge_right, normal);
    const double density = std::min(grid.density(owner), grid.density(neighbour));
    const bool is_open = density > 0;
    if constexpr (Diffusive<PointLawOf<Law>>) {
      State site_left;
      State site_right;
      for_each_component<N>([&](std::size_t k) {
        site_left[k] = u[static_cast<Index>(k) * stride + owner];
        site_right[k] = u[static_cast<Index>(k) * stride + neighbour];
      });
      const double diffusion =
          add_diffusion(point_law, site_left, site_right, 1 / row.distance[i], face.value);
      flux[Out::diffusion * Out::stride + i] = select(is_open, density * diffusion, 0);
    }
    for_each_component<N>([&](std::size_t k) {
      flux[static_cast<Index>(k) * Out::stride + i] = select(is_open, density * face.value[k], 0);
    });
    flux[Out::drain * Out::stride + i] = select(is_open, density * face.speed, 0);
    const bool is_fastest = is_open & (face.speed > fastest[i]);
    fastest[i] = select(is_fastest, face.speed, fastest[i]);
  }
}

}  // namespace scree::transport::detail
