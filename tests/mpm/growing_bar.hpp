#pragma once

#include "periodic_bar.hpp"
#include "schemes.hpp"

#include <utility>
#include <vector>

namespace scree::mpm {

/// How a disturbance of everything, small and at random, grows: growth_of().
template <int D>
[[nodiscard]] double growth(Particles<D> particles, const CartesianGrid<D>& grid, const Stages<D, D>& stages,
                            double dt, int num_steps) {
  disturb(particles, dt);
  return growth_of(std::move(particles), grid, stages, dt, num_steps);
}

/// Of a bar.
[[nodiscard]] inline double growth(Particles<1, 1> particles, const Stages<1, 1>& stages, double dt,
                                   int num_steps) {
  return growth(std::move(particles), cube<1>(Bar::num_cells, Bar::spacing, true), stages, dt, num_steps);
}

[[nodiscard]] inline double growth(const Bar& bar, double sum, int num_steps) {
  constexpr double dt = 0.01;
  auto particles = points_of(bar);
  auto stages = stages_of<1, 1>(particles, bar.shape, bar.transfer, fluid_of(sum, bar.viscous, dt));
  stages.order = bar.order;
  return growth(std::move(particles), stages, dt, num_steps);
}

[[nodiscard]] inline std::vector<Bar> every_bar() {
  std::vector<Bar> bars;
  std::vector<AnyTransfer> transfers = every<AnyTransfer>();
  transfers.emplace_back(PicFlip{0.5});
  for (const Index per_cell : {1, 2}) {
    for (const AnyShape& shape : every_shape_for(static_cast<double>(per_cell))) {
      for (const AnyTransfer& transfer : transfers) {
        for (const Order order : {Order::usl, Order::musl, Order::usf}) {
          for (const double viscous : {0.0, 0.5, 1.0}) {
            bars.push_back({shape, transfer, order, per_cell, per_cell == 1 ? 0 : 0.1, viscous});
          }
        }
      }
    }
  }
  return bars;
}

}  // namespace scree::mpm
