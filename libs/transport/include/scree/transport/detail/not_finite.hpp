#pragma once

#include <scree/lattice.hpp>

namespace scree::transport::detail {

/// @throws RunError that names a site where the rate of change is not finite, and its position.
template <int D>
[[noreturn]] void throw_not_finite(const Lattice<D>& lattice, Index site);

extern template void throw_not_finite<1>(const Lattice<1>&, Index);
extern template void throw_not_finite<2>(const Lattice<2>&, Index);
extern template void throw_not_finite<3>(const Lattice<3>&, Index);

}  // namespace scree::transport::detail
