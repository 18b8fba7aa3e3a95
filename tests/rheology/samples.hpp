#pragma once

#include "points.hpp"

#include <array>
#include <cmath>

namespace scree::rheology {

[[nodiscard]] inline Tensor<double> diagonal(double xx, double yy, double zz) {
  return {{xx, 0, 0, 0, yy, 0, 0, 0, zz}};
}

/// A point strained along fixed axes, as in a laboratory's cell, with the density that belongs to it.
template <class Law>
struct Sample {
  Point<Law> point;
  std::array<double, 3> strain{};  ///< total, logarithmic [-]

  [[nodiscard]] double volume() const { return strain[0] + strain[1] + strain[2]; }  // logarithmic
  [[nodiscard]] double density() const { return point.law.density * std::exp(-volume()); }
  [[nodiscard]] double stress(std::size_t axis) const { return point.stress(axis, axis); }
  [[nodiscard]] double pressure() const { return -trace(point.stress) / 3; }

  /// Adds logarithmic strains in one step.
  void step(double xx, double yy, double zz) {
    strain = {strain[0] + xx, strain[1] + yy, strain[2] + zz};
    point.step(diagonal(xx, yy, zz), density(), 1);
  }
};

}  // namespace scree::rheology
