#include <scree/error.hpp>
#include <scree/transport/detail/not_finite.hpp>
#include <scree/transport/detail/place.hpp>

namespace scree::transport::detail {

template <int D>
void throw_not_finite(const Indices<D>& site, const Vector<D>& position) {
  throw RunError{"transport: the rate of change is not finite at " + place_text<D>(site, position)};
}

template void throw_not_finite<1>(const Indices<1>&, const Vector<1>&);
template void throw_not_finite<2>(const Indices<2>&, const Vector<2>&);
template void throw_not_finite<3>(const Indices<3>&, const Vector<3>&);

}  // namespace scree::transport::detail
