#pragma once

#include "bodies.hpp"

#include <scree/mpm/critical_step.hpp>

namespace scree::mpm {

/// A periodic bar and how it is advanced.
struct Bar {
  static constexpr Index num_cells = 32;  ///< every other wave of those that critical_sums() looks at
  static constexpr double spacing = 0.125;

  AnyShape shape;
  AnyTransfer transfer;
  Order order = Order::usl;
  Index per_cell = 1;
  double offset = 0;   ///< of all points from the middle of their parts of a cell [spacings]
  double viscous = 0;  ///< share of the sum (M173) that viscosity has [-]
};

[[nodiscard]] inline Particles<1, 1> points_of(const Bar& bar) {
  auto particles = filled<1>(cube<1>(Bar::num_cells, Bar::spacing, true), bar.per_cell);
  for (double& x : particles.position.values()) x += bar.offset * Bar::spacing;
  return particles;
}

[[nodiscard]] inline double critical_sum_of(const Bar& bar) {
  return critical_sums(points_of(bar), cube<1>(Bar::num_cells, Bar::spacing, true), bar.shape, bar.transfer,
                       bar.order)[0];
}

}  // namespace scree::mpm
