#pragma once

#include <scree/transport/concepts.hpp>
#include <scree/transport/grids/cartesian.hpp>
#include <scree/transport/grids/rectilinear.hpp>

#include <span>
#include <vector>

namespace scree::transport {

/// A grid seen through its filled sites: each has a mass, and what is transported is per unit of mass.
///
/// m_i du_i/dt = -sum_f rho_f A_f F_f with rho_f = min(m_i/V_i, m_j/V_j): what leaves one site enters the
/// other, faces to empty sites are closed, and a sliver of mass does not shorten the time step. Where a law
/// has a mirror image the closed part of each face is a wall that reflects.
/// @see Eqs. (T10), (T65), (M1)
template <int D, class Grid = Cartesian<D>>
class OccupiedCells : public Grid {
 public:
  static constexpr bool is_full = false;

  /// All sites empty.
  explicit OccupiedCells(const Grid& grid);

  /// @param masses one per site [kg]; 0 means empty.
  /// @throws InputError if their number is not that of the sites, or one is negative or not finite.
  void set_masses(std::span<const double> masses);

  /// @param shares one per site: the part of it that is filled, by a material of density 1 [-]; 0 is a mask.
  /// @throws InputError if their number is not that of the sites, or one does not lie in [0, 1].
  void set_fill(std::span<const double> shares);

  /// Mass over control volume [kg/m^D]; 0 where empty.
  [[nodiscard]] double density(Index site) const noexcept { return densities_.data()[site]; }

 private:
  std::vector<double> densities_;
};

extern template class OccupiedCells<1>;
extern template class OccupiedCells<2>;
extern template class OccupiedCells<3>;
extern template class OccupiedCells<1, Rectilinear<1>>;
extern template class OccupiedCells<2, Rectilinear<2>>;
extern template class OccupiedCells<3, Rectilinear<3>>;
static_assert(LatticeGrid<OccupiedCells<2>>);

}  // namespace scree::transport
