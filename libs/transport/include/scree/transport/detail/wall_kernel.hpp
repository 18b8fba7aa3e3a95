#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/tiles.hpp>
#include <scree/transport/fields.hpp>

#include <algorithm>
#include <cstddef>

// The walls between the cells of a grid that is filled in part, for laws whose waves they throw back.

namespace scree::transport::detail {

/// Sites of a row and their neighbours along an axis; no_site where there is a boundary, which is no wall of
/// the cell's own.
struct WallRow {
  Index below;
  Index here;
  Index above;
  Index count;
  int axis;
  double distance;  ///< as boundaries have it [m]
};

/// The part of a site's density that a face to a neighbour does not let through: rho_i - rho_f.  Eq. (T65)
template <class Grid>
[[nodiscard]] double closed_density(const Grid& grid, Index site, Index neighbour) noexcept {
  if (neighbour == no_site) return 0;
  return std::max(grid.density(site) - grid.density(neighbour), 0.0);
}

/// Writes what the walls at both faces of each site do to it: the flux between its state and the mirror
/// image, times the closed density.
template <class Problem, int N>
void reflect_at_walls(const Problem& problem, const Fields<N>& fields, const WallRow& row,
                      double* __restrict walls) noexcept {
  using Out = WallTile<N>;
  using Normal = Vector<Problem::dimension>;
  const Normal upward = Normal::Unit(row.axis);
  for (int k = 0; k < N + 2; ++k) std::fill_n(walls + k * Out::stride, row.count, 0.0);
  for (Index i = 0; i < row.count; ++i) {
    const Index site = row.here + i;
    const Index neighbours[] = {row.below == no_site ? no_site : row.below + i,
                                row.above == no_site ? no_site : row.above + i};
    for (const End end : {End::low, End::high}) {
      const auto side = static_cast<std::size_t>(end);
      const double closed = closed_density(problem.grid, site, neighbours[side]);
      if (!(closed > 0)) continue;
      const Normal outward = end == End::low ? Normal{-upward} : upward;
      const auto law = law_at(problem.law, Face{site, no_site, row.axis, row.distance});
      const auto inside = fields[site];
      const auto face = problem.flux(law, inside, law.mirror(inside, outward), outward);
      for (int k = 0; k < N; ++k)
        walls[k * Out::stride + i] += closed * face.value[static_cast<std::size_t>(k)];
      walls[(end == End::low ? Out::drain_low : Out::drain_high) * Out::stride + i] = closed * face.speed;
    }
  }
}

}  // namespace scree::transport::detail
