#include <scree/error.hpp>
#include <scree/transport/detail/pieces.hpp>
#include <scree/transport/detail/staggered_checks.hpp>

#include <cmath>
#include <sstream>

namespace scree::transport::detail {

void require_staggered(Sites sites, double cfl, double largest) {
  require(sites == Sites::cells, "StaggeredSolver: the sites of the lattice are nodes: must be cells");
  if (0 < cfl && cfl <= largest) return;
  std::ostringstream text;
  text << "StaggeredSolver: the CFL number is " << cfl << ": must lie in (0, " << largest
       << "], where the scheme is stable";
  throw InputError{text.str()};
}

double proven_staggered_cfl(double sharpness, int dimension) noexcept {
  // D (theta/4 + 2 nu + (2 D - 1) theta nu^2) = 1
  const double rest = 1.0 / dimension - sharpness / 4;
  const double bend = (2 * dimension - 1) * sharpness;
  return rest > 0 ? rest / (1 + std::sqrt(1 + bend * rest)) : 0.0;
}

double largest_staggered_cfl(int dimension) noexcept {
  const double D = dimension;
  return std::sqrt(D - 2 + std::sqrt(2 * D * D - 2 * D + 4)) / (2 * D);
}

template <int D>
Lattice<D> corners_of(const Lattice<D>& cells) {
  Lattice<D> corners = cells;
  for (std::size_t axis = 0; axis < D; ++axis) corners.count[axis] += cells.is_periodic[axis] ? 0 : 1;
  corners.first = cells.first - cells.spacing / 2;
  corners.sites = Sites::nodes;
  return corners;
}

template Lattice<1> corners_of<1>(const Lattice<1>&);
template Lattice<2> corners_of<2>(const Lattice<2>&);
template Lattice<3> corners_of<3>(const Lattice<3>&);

}  // namespace scree::transport::detail
