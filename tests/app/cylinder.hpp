#pragma once

#include "collapse.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scree::app::testing {

/// A cylinder of the scene `granular_cylinder_collapse` at rest after its collapse.
class Heap {
 public:
  static constexpr double radius = 0.1;  // [m], of the cylinder

  /// @param aspect ratio of the cylinder  @param cells along its radius
  Heap(double aspect, int cells)
      : points_{collapsed({.name = "granular_cylinder_collapse",
                           .width = radius,
                           .aspect = aspect,
                           .cells = cells,
                           .num_columns = std::lround((2 + 3 * std::min(aspect, 2.0)) * cells)})} {}

  /// How far it has run out, over the radius of the cylinder, where it is one grain of 3 mm thick: material
  /// is gathered into rings a sixteenth of the radius wide, on any mesh.
  [[nodiscard]] double runout() const {
    constexpr double grain = 3e-3;           // [m]
    constexpr double width = radius / 16;    // [m]
    constexpr std::size_t num_rings = 1000;  // to 6 m
    std::vector<double> thickness(num_rings, 0.0);
    for (const FallenPoint& point : points_) {
      const auto ring = static_cast<std::size_t>(point.place / width);
      thickness.at(ring) += point.mass / (1500 * (static_cast<double>(ring) + 0.5) * width * width);
    }
    std::size_t last = num_rings - 1;
    while (last > 0 && thickness[last] < grain) --last;
    const double share = (thickness[last] - grain) / (thickness[last] - thickness[last + 1]);
    return (static_cast<double>(last) + 0.5 + share) * width / radius - 1;
  }

  /// The same, where 99.5 % of the mass lie behind.
  [[nodiscard]] double runout_of_mass() const { return front_of_mass(points_) / radius - 1; }

 private:
  std::vector<FallenPoint> points_;
};

/// Experiments on a rough floor, \cite lube2004; of no more than two digits.  Eq. (M179)
[[nodiscard]] inline double of_cylinders(double aspect) {
  return aspect < 1.7 ? 1.24 * aspect : 1.6 * std::sqrt(aspect);
}

/// How far a run may be off: the rim is met to a cell, half the step takes 6 % off the run-out of aspect
/// ratio 2 on 16 cells (2.20 for 2.32), and the law's last digit is worth 3 %.
[[nodiscard]] inline double tolerance_of(double aspect, int cells) {
  return 1.0 / cells + 0.09 * of_cylinders(aspect);
}

}  // namespace scree::app::testing
