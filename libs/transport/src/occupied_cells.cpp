#include <scree/error.hpp>
#include <scree/transport/grids/occupied_cells.hpp>

#include <cmath>
#include <sstream>

namespace scree::transport {

template <int D>
OccupiedCells<D>::OccupiedCells(const Lattice<D>& lattice)
    : Cartesian<D>{lattice}, densities_(static_cast<std::size_t>(lattice.num_sites())) {}

template <int D>
void OccupiedCells<D>::set_masses(std::span<const double> masses) {
  if (masses.size() != densities_.size()) {
    std::ostringstream text;
    text << "OccupiedCells: " << masses.size() << " masses for " << densities_.size() << " sites";
    throw InputError{text.str()};
  }
  for (std::size_t site = 0; site < masses.size(); ++site) {
    if (!(masses[site] >= 0 && std::isfinite(masses[site]))) {
      std::ostringstream text;
      text << "OccupiedCells: the mass of site " << site << " is " << masses[site]
           << " kg: must be zero or positive, and finite";
      throw InputError{text.str()};
    }
  }
  for (std::size_t site = 0; site < masses.size(); ++site) {
    densities_[site] = masses[site] / this->lattice().volume(this->lattice().site(static_cast<Index>(site)));
  }
}

template class OccupiedCells<1>;
template class OccupiedCells<2>;
template class OccupiedCells<3>;

}  // namespace scree::transport
