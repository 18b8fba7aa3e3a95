#include <scree/error.hpp>
#include <scree/transport/detail/not_finite.hpp>

#include <sstream>

namespace scree::transport::detail {

template <int D>
void throw_not_finite(const Indices<D>& site, const Vector<D>& position) {
  std::ostringstream text;
  text << "transport: the rate of change is not finite at site (";
  for (std::size_t axis = 0; axis < D; ++axis) text << (axis == 0 ? "" : ", ") << site[axis];
  text << "), position (";
  for (int axis = 0; axis < D; ++axis) text << (axis == 0 ? "" : ", ") << position[axis];
  text << ") m";
  throw RunError{text.str()};
}

template void throw_not_finite<1>(const Indices<1>&, const Vector<1>&);
template void throw_not_finite<2>(const Indices<2>&, const Vector<2>&);
template void throw_not_finite<3>(const Indices<3>&, const Vector<3>&);

}  // namespace scree::transport::detail
