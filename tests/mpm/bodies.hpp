#pragma once

#include "fluid.hpp"

#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

namespace scree::mpm {

/// A mesh of `num_cells` cells of `spacing` along each axis from the origin.
template <int D>
[[nodiscard]] CartesianGrid<D> cube(Index num_cells, double spacing, bool is_periodic) {
  Indices<D> count{};
  count.fill(num_cells);
  std::array<bool, static_cast<std::size_t>(D)> periodic{};
  periodic.fill(is_periodic);
  return {Vector<D>::Zero(), Vector<D>::Constant(spacing), count, periodic};
}

/// Points with unequal masses in places drawn from [margin, length - margin]^D, at rest.
template <int D, int V = D>
[[nodiscard]] Particles<D, V> scattered(const CartesianGrid<D>& grid, Index count, double margin) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> draw{0, 1};
  Particles<D, V> particles;
  particles.resize(count);
  for (Index p = 0; p < count; ++p) {
    for (int axis = 0; axis < D; ++axis) {
      particles.position.component(axis)[p] =
          grid.origin()[axis] + margin + draw(random) * (grid.length(axis) - 2 * margin);
    }
    particles.mass.component(0)[p] = 1 + draw(random);
    particles.density.component(0)[p] = 1000;
    particles.id.component(0)[p] = static_cast<double>(p);
  }
  return particles;
}

/// Fills a column with numbers drawn from [-1, 1], times `scale`.
inline void fill_at_random(Column& column, double scale) {
  std::mt19937 random{13};
  std::uniform_real_distribution<double> draw{-scale, scale};
  for (double& value : column.values()) value = draw(random);
}

/// Points of equal mass, `per_cell` along each axis of every cell.
template <int D, int V = D>
[[nodiscard]] Particles<D, V> filled(const CartesianGrid<D>& grid, Index per_cell, double density = 1000) {
  Indices<D> count{};
  count.fill(per_cell);
  Vector<D> high = grid.origin();
  for (int axis = 0; axis < D; ++axis) high[axis] += grid.length(axis);
  return seed_box<D, V>(grid, grid.origin(), high, count, density);
}

template <int D, int V>
[[nodiscard]] Stages<D, V> stages_of(Particles<D, V>& particles, const AnyShape& shape,
                                     const AnyTransfer& rule, const Fluid& law = dust) {
  Stages<D, V> stages;
  stages.stress = std::make_unique<StressUpdateBy<D, V, Fluid>>(law, particles);
  stages.transfer = make_transfer<D, V>(shape, rule);
  return stages;
}

/// sum m v_i, and sum m |v_i| as the scale of its rounding.
struct Momentum {
  double total = 0;  ///< [kg m/s]
  double size = 0;   ///< [kg m/s]
};

/// Summed in long double, so that the sum's own rounding is none of the scheme's.
template <int D, int V>
[[nodiscard]] Momentum momentum_of(const Particles<D, V>& particles, int component) {
  long double total = 0;
  long double size = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const auto momentum =
        static_cast<long double>(particles.mass.component(0)[p]) * particles.velocity.component(component)[p];
    total += momentum;
    size += std::abs(momentum);
  }
  return {static_cast<double>(total), static_cast<double>(size)};
}

/// Mean position and velocity of all points, by mass.
template <int D>
struct Mean {
  Vector<D> position = Vector<D>::Zero();
  Vector<D> velocity = Vector<D>::Zero();
};
template <int D>
[[nodiscard]] Mean<D> mean_of(const Particles<D>& particles) {
  Mean<D> mean;
  double mass = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double m = particles.mass.component(0)[p];
    mass += m;
    for (int axis = 0; axis < D; ++axis) {
      mean.position[axis] += m * particles.position.component(axis)[p];
      mean.velocity[axis] += m * particles.velocity.component(axis)[p];
    }
  }
  return {mean.position / mass, mean.velocity / mass};
}

/// Largest absolute value in a column.
[[nodiscard]] inline double largest(const Column& column) {
  double result = 0;
  for (const double value : column.values()) result = std::max(result, std::abs(value));
  return result;
}

/// Roundings on the way of one point through `num_steps` steps: to each node of its stencil (support^D) and
/// back, some dozen operations each.
[[nodiscard]] inline double rounding_of(int dimension, std::size_t support, int num_steps) {
  return 12 * 2 * std::pow(static_cast<double>(support), dimension) * num_steps * round_off;
}

}  // namespace scree::mpm
