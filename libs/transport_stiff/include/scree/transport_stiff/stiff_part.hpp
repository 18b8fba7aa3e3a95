#pragma once

#include <scree/blocks.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace scree::transport {

/// Calls body(site, its coordinates) for all sites of a lattice, on threads.
template <int D, class Body>
void for_each_site(const Lattice<D>& lattice, Threads threads, Body&& body) {
  constexpr Index chunk = 1024;
  const Index num_sites = lattice.num_sites();
  for_each_block((num_sites + chunk - 1) / chunk, threads, [&](Index block) {
    const Index end = std::min(num_sites, (block + 1) * chunk);
    Indices<D> coordinates = lattice.site(block * chunk);
    for (Index site = block * chunk; site < end; ++site) {
      body(site, coordinates);
      for (std::size_t axis = 0; axis < D && ++coordinates[axis] == lattice.count[axis]; ++axis) {
        coordinates[axis] = 0;
      }
    }
  });
}

/// Calls body(neighbour, weight, face) for each open face of a filled site along `axis`: those at the ends of
/// the lattice and beside empty sites are closed. The low face comes first.
///
/// The weight is rho_f/(rho_i w h) [1/m^2], with w the extent of the control volume and h the distance
/// between both sites: what K(u_j) - K(u_i) counts for in du_i/dt.  Eqs. (T10), (T11)
template <LatticeGrid Grid, class Body>
void for_each_open_face(const Grid& grid, Index site, const Indices<Grid::dimension>& coordinates, int axis,
                        Body&& body) noexcept {
  const auto& lattice = grid.lattice();
  const auto a = static_cast<std::size_t>(axis);
  const double density = grid.density(site);
  const double per_distance = 1 / (density * lattice.width(coordinates, axis) * lattice.spacing[axis]);
  const Index stride = lattice.stride(axis);
  const auto visit = [&](bool is_low, Index steps) {
    const bool is_end = coordinates[a] == (is_low ? 0 : lattice.count[a] - 1);
    if (is_end && !lattice.is_periodic[a]) return;
    const Index neighbour = site + (is_end ? steps - steps * lattice.count[a] : steps) * stride;
    const double face_density = std::min(density, grid.density(neighbour));
    if (!(face_density > 0)) return;
    body(neighbour, face_density * per_distance,
         Face{is_low ? neighbour : site, is_low ? site : neighbour, axis, lattice.spacing[axis]});
  };
  visit(true, -1);
  visit(false, 1);
}

/// State `site` of num_sites x N values, component fastest.
template <std::size_t N>
[[nodiscard]] std::array<double, N> state_at(std::span<const double> u, Index site) noexcept {
  std::array<double, N> state;
  std::copy_n(u.data() + static_cast<std::size_t>(site) * N, N, state.begin());
  return state;
}

/// Writes what a law's diffusion and source add to du/dt at all sites; zero at empty ones.  Eq. (T55)
/// @param u, rate num_sites x num_components, component fastest
template <LatticeGrid Grid, class Law>
void stiff_rate(const Grid& grid, const Law& law, Threads threads, double time, std::span<const double> u,
                std::span<double> rate) {
  constexpr int D = Grid::dimension;
  constexpr auto N = static_cast<std::size_t>(PointLawOf<Law>::num_components);
  const Lattice<D>& lattice = grid.lattice();
  for_each_site(lattice, threads, [&](Index site, const Indices<D>& coordinates) {
    std::array<double, N> sum{};
    if (grid.density(site) > 0) {
      const auto here = state_at<N>(u, site);
      if constexpr (Diffusive<PointLawOf<Law>>) {
        for (int axis = 0; axis < D; ++axis) {
          for_each_open_face(grid, site, coordinates, axis,
                             [&](Index neighbour, double weight, const Face& face) {
                               const auto& point_law = law_at(law, face);
                               const auto inside = point_law.potential(here);
                               const auto outside = point_law.potential(state_at<N>(u, neighbour));
                               for (std::size_t k = 0; k < N; ++k)
                                 sum[k] += weight * (outside[k] - inside[k]);
                             });
        }
      }
      if constexpr (HasSource<Law, D>) {
        const auto source = law.source(here, lattice.position(coordinates), time);
        for (std::size_t k = 0; k < N; ++k) sum[k] += source[k];
      }
    }
    std::copy(sum.begin(), sum.end(), rate.begin() + static_cast<std::ptrdiff_t>(N) * site);
  });
}

}  // namespace scree::transport
