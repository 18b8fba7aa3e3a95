#pragma once

#include "collapse.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace scree::app::testing {

/// What grains bring to I: their diameter and a density.
struct ColumnGrains {
  double diameter;  // [m]
  double density;   // [kg/m^3]
};

/// A column of the scene `granular_column_collapse` at rest after its collapse.
class Column {
 public:
  static constexpr double half_width = 0.1;  // [m]

  /// Chosen: as many as the columns of \cite lagree2014 have, of half widths of 0.298, 0.228 and 0.108 m at
  /// aspect ratios 0.5, 1.42 and 6.26, of grains of 5 mm. The larger two are of as many; below, a power joins
  /// the numbers. Their I has the density of the medium, as that of \cite popinet2011 has.
  [[nodiscard]] static ColumnGrains chosen_grains(double aspect) {
    const double number = aspect > 1.42 ? 2940 : 1780 * std::pow(aspect / 0.5, 0.48);
    return {half_width / std::sqrt(number / aspect), 1500};
  }

  /// @param aspect ratio of the column  @param cells along its half width
  Column(double aspect, int cells) : Column(aspect, cells, chosen_grains(aspect)) {}
  /// @param acoustic share of the acoustic limit that a step takes
  Column(double aspect, int cells, const ColumnGrains& grains, double acoustic = 0.5)
      : points_{
            collapsed({.name = "granular_column_collapse",
                       .width = half_width,
                       .aspect = aspect,
                       .cells = cells,
                       .num_columns = std::lround((2 + 6 * aspect) * cells)},
                      {"material.points_per_cell=2", fmt::format("grains.diameters=[{}]", grains.diameter),
                       fmt::format("rheology.grain_density={}", grains.density),
                       fmt::format("numerics.acoustic={}", acoustic)})} {}

  /// How far it has run out, over its half width: the foremost place behind which, over an eighth of that
  /// width, material is as deep as half a cell of \cite popinet2011, so that single points that skid ahead
  /// do not count.
  [[nodiscard]] double runout() const {
    constexpr double width = half_width / 8;   // [m]
    constexpr double depth = half_width / 64;  // [m]
    double front = 0;
    double within = 0;
    auto last = points_.begin();
    for (const FallenPoint& point : points_) {
      within += point.mass;
      for (; last->place <= point.place - width; ++last) within -= last->mass;
      if (within >= 1500 * depth * width) front = point.place;
    }
    return front / half_width - 1;
  }

  /// The same, where 99.5 % of the mass lie behind.
  [[nodiscard]] double runout_of_mass() const { return front_of_mass(points_) / half_width - 1; }

 private:
  std::vector<FallenPoint> points_;
};

/// Of mu(I) in two dimensions with the parameters of the scene, \cite lagree2011.  Eq. (M198)
[[nodiscard]] inline double of_the_continuum(double aspect) {
  return aspect < 7 ? 2.2 * aspect : 3.9 * std::pow(aspect, 0.7);
}

/// How far the front moves if a depth, over the half width of the column, goes from its toe: over the mean
/// slope of a heap of the column's area in a triangle as long as the law says, 2 a/(1 + runout)^2.
[[nodiscard]] inline double along_the_toe(double depth, double aspect) {
  return depth * std::pow(1 + of_the_continuum(aspect), 2) / (2 * aspect);
}

/// How far a run may be off, the sum of what each part may do. A toe is known to a cell on a mesh, and steps
/// may do as much; a front in the law's own mesh is known to half a cell; the last digit of the law's factor
/// is worth 2.3 %; and grains 13 % larger or smaller, as far as they are known between its columns, 3.2 %:
/// run-outs go as d^-0.25 at the most. At aspect ratio 8 what is foremost are fragments: six runs on 16 and
/// 32 cells scatter by 1, one standard deviation.
[[nodiscard]] inline double tolerance_of_columns(double aspect, int cells) {
  const double fragments = aspect < 8 ? 0 : 1;
  return along_the_toe(2.0 / cells + 1.0 / 64, aspect) + 0.055 * of_the_continuum(aspect) + fragments;
}

}  // namespace scree::app::testing
