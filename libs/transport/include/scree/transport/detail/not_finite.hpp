#pragma once

#include <scree/lattice.hpp>

namespace scree::transport::detail {

/// @throws RunError that names a site where the rate of change is not finite, and its position.
template <int D>
[[noreturn]] void throw_not_finite(const Indices<D>& site, const Vector<D>& position);

extern template void throw_not_finite<1>(const Indices<1>&, const Vector<1>&);
extern template void throw_not_finite<2>(const Indices<2>&, const Vector<2>&);
extern template void throw_not_finite<3>(const Indices<3>&, const Vector<3>&);

}  // namespace scree::transport::detail
