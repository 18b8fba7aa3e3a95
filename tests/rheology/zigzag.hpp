#pragma once

#include "points.hpp"

namespace scree::rheology {

/// Growth of a zigzag (up in one cell, down in the next) over explicit steps of `dt` on a periodic row of
/// cells of width `dx`: its speed at the end over `speed`, that at the start [m/s]. `compression` [-] is how
/// much denser the material is than without pressure.
template <class Law>
[[nodiscard]] double zigzag_after(const Law& law, int num_steps, double dt, double dx, double speed = 1,
                                  double compression = 1) {
  std::vector<double> v{speed, -speed, speed, -speed, speed, -speed};
  const std::size_t n = v.size();
  std::vector<Point<Law>> faces(n, Point<Law>{law});  // above each cell
  for (int step = 0; step < num_steps; ++step) {
    for (std::size_t i = 0; i < n; ++i) {
      faces[i].step(simple_shear((v[(i + 1) % n] - v[i]) / dx), compression * law.density, dt);
    }
    for (std::size_t i = 0; i < n; ++i) {
      v[i] += dt / (law.density * dx) * (faces[i].stress(0, 1) - faces[(i + n - 1) % n].stress(0, 1));
    }
  }
  return std::abs(v.front()) / speed;
}

}  // namespace scree::rheology
