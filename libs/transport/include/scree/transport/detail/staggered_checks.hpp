#pragma once

#include <scree/lattice.hpp>

namespace scree::transport::detail {

/// @throws InputError unless the lattice is one of cells and the CFL number lies in (0, largest].
void require_staggered(Sites sites, double cfl, double largest);

/// The largest CFL number at which a limiter of this sharpness provably keeps bounds in `dimension`
/// dimensions; 0 if none is known.  Eq. (T45)
[[nodiscard]] double proven_staggered_cfl(double sharpness, int dimension) noexcept;

/// The largest CFL number at which the scheme without a limiter is linearly stable.  Eq. (T46)
[[nodiscard]] double largest_staggered_cfl(int dimension) noexcept;

}  // namespace scree::transport::detail
