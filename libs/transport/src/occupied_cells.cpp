#include <scree/error.hpp>
#include <scree/transport/detail/numbering.hpp>
#include <scree/transport/grids/occupied_cells.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace scree::transport {
namespace {

template <int D>
Index num_sites(const Indices<D>& count) {
  Index product = 1;
  for (const Index n : count) product *= n;
  return product;
}

void require_one_per_site(std::size_t num_values, std::size_t num_sites, const char* what) {
  if (num_values == num_sites) return;
  std::ostringstream text;
  text << "OccupiedCells: " << num_values << ' ' << what << " for " << num_sites << " sites";
  throw InputError{text.str()};
}

}  // namespace

template <int D, class Grid>
OccupiedCells<D, Grid>::OccupiedCells(const Grid& grid)
    : Grid{grid}, densities_(static_cast<std::size_t>(num_sites<D>(grid.count()))) {}

template <int D, class Grid>
void OccupiedCells<D, Grid>::set_masses(std::span<const double> masses) {
  require_one_per_site(masses.size(), densities_.size(), "masses");
  for (std::size_t site = 0; site < masses.size(); ++site) {
    if (!(masses[site] >= 0 && std::isfinite(masses[site]))) {
      std::ostringstream text;
      text << "OccupiedCells: the mass of site " << site << " is " << masses[site]
           << " kg: must be zero or positive, and finite";
      throw InputError{text.str()};
    }
  }
  const detail::Numbering<D> numbering{this->count(), this->is_periodic()};
  for (std::size_t site = 0; site < masses.size(); ++site) {
    densities_[site] = masses[site] / this->volume(numbering.site(static_cast<Index>(site)));
  }
}

template <int D, class Grid>
void OccupiedCells<D, Grid>::set_fill(std::span<const double> shares) {
  require_one_per_site(shares.size(), densities_.size(), "shares");
  for (std::size_t site = 0; site < shares.size(); ++site) {
    if (!(0 <= shares[site] && shares[site] <= 1)) {
      std::ostringstream text;
      text << "OccupiedCells: the share of site " << site << " is " << shares[site] << ": must lie in [0, 1]";
      throw InputError{text.str()};
    }
  }
  std::ranges::copy(shares, densities_.begin());
}

template class OccupiedCells<1>;
template class OccupiedCells<2>;
template class OccupiedCells<3>;
template class OccupiedCells<1, Rectilinear<1>>;
template class OccupiedCells<2, Rectilinear<2>>;
template class OccupiedCells<3, Rectilinear<3>>;

}  // namespace scree::transport
