#pragma once

#include <scree/transport/concepts.hpp>
#include <scree/transport/grids/cartesian.hpp>

#include <span>
#include <vector>

namespace scree::transport {

/// A lattice seen through its filled sites: each has a mass, and what is transported is per unit of mass.
///
/// m_i du_i/dt = -sum_f rho_f A_f F_f with rho_f = min(m_i/V_i, m_j/V_j): what leaves one site enters the
/// other, faces to empty sites are closed, and a sliver of mass does not shorten the time step.
/// @see Eqs. (T10), (M1)
template <int D>
class OccupiedCells : public Cartesian<D> {
 public:
  /// All sites empty.
  explicit OccupiedCells(const Lattice<D>& lattice);

  /// @param masses one per site [kg]; 0 means empty.
  /// @throws InputError if their number is not that of the sites, or one is negative or not finite.
  void set_masses(std::span<const double> masses);

  /// Mass over control volume [kg/m^D]; 0 where empty.
  [[nodiscard]] double density(Index site) const noexcept { return densities_.data()[site]; }

 private:
  std::vector<double> densities_;
};

extern template class OccupiedCells<1>;
extern template class OccupiedCells<2>;
extern template class OccupiedCells<3>;
static_assert(LatticeGrid<OccupiedCells<2>>);

}  // namespace scree::transport
