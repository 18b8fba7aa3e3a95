#pragma once

namespace scree::mpm {

/// What a block tells after its points have moved.
struct BlockMotion {
  double advection_rate = 0;  ///< largest sum over axes of |v_d| / spacing_d [1/s]
  bool needs_sort = false;    ///< a point has left the reach of its block, or its position is not finite
  bool lacks_volume = false;  ///< the density of a point is not positive, or infinite
};

}  // namespace scree::mpm
