#pragma once

#include "points.hpp"

namespace scree::rheology {

/// The shear rate [1/s] in (0, fastest) at which a law without memory bears a shear stress, by bisection down
/// to round-off; the stress grows with the rate.
template <class Law>
[[nodiscard]] double shear_rate_at(const Law& law, double shear_stress, double density, double fastest,
                                   double grain_size = 1e-3) {
  double slow = 0;
  double fast = fastest;
  for (double middle = fast / 2; slow < middle && middle < fast; middle = (slow + fast) / 2) {
    const bool is_too_fast = stress(law, simple_shear(middle), density, grain_size)(0, 1) > shear_stress;
    (is_too_fast ? fast : slow) = middle;
  }
  return fast;
}

}  // namespace scree::rheology
