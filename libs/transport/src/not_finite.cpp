#include <scree/error.hpp>
#include <scree/transport/detail/not_finite.hpp>

#include <sstream>

namespace scree::transport::detail {

template <int D>
void throw_not_finite(const Lattice<D>& lattice, Index site) {
  const Indices<D> indices = lattice.site(site);
  const Vector<D> position = lattice.position(indices);
  std::ostringstream text;
  text << "transport: the rate of change is not finite at site (";
  for (std::size_t axis = 0; axis < D; ++axis) text << (axis == 0 ? "" : ", ") << indices[axis];
  text << "), position (";
  for (int axis = 0; axis < D; ++axis) text << (axis == 0 ? "" : ", ") << position[axis];
  text << ") m";
  throw RunError{text.str()};
}

template void throw_not_finite<1>(const Lattice<1>&, Index);
template void throw_not_finite<2>(const Lattice<2>&, Index);
template void throw_not_finite<3>(const Lattice<3>&, Index);

}  // namespace scree::transport::detail
