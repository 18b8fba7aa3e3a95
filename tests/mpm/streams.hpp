#pragma once

#include "bodies.hpp"

#include <scree/mpm/inflow.hpp>
#include <scree/mpm/outflow.hpp>

#include <limits>
#include <memory>

namespace scree::mpm {

/// A run of nothing but a stream that passes through a mesh, from its box to where it is taken out.
template <int D, int V = D>
struct Passage {
  Passage(const Stream<D, V>& stream, const CartesianGrid<D>& grid, const Outflow<D>& end,
          const AnyShape& shape, const AnyTransfer& rule, const Fluid& law = dust, Threads num_threads = {1})
      : outflow{end}, threads{num_threads} {
    check(outflow, grid);
    auto particles = fill_box(stream, grid);
    first_mass = sum_of(particles.mass);
    stages = stages_of<D, V>(particles, shape, rule, law);
    stages.boundaries.push_back(make_inflow_hold(stream, grid, 1 + stages.transfer->stencil_shift()));
    inflow = std::make_unique<Inflow<D, V>>(stream, grid, first_layer(stream, grid));
    state = std::make_unique<State<D, V>>(start(std::move(particles), grid, stages, threads));
  }
  void advance(int num_steps, double dt) {
    for (int n = 0; n < num_steps; ++n) {
      step(*state, stages, dt, threads);
      time += dt;
      take_in(*state, stages, *inflow, time, threads);
      taken += take_out(*state, outflow);
    }
  }
  [[nodiscard]] static double sum_of(const Column& column) {
    double sum = 0;
    for (const double value : column.values()) sum += value;
    return sum;
  }
  [[nodiscard]] double mass() const { return sum_of(state->particles.mass); }

  Outflow<D> outflow;
  Threads threads;
  Stages<D, V> stages;
  std::unique_ptr<Inflow<D, V>> inflow;
  std::unique_ptr<State<D, V>> state;
  Passed<V> taken;
  double first_mass = 0;  // [kg]
  double time = 0;        // [s]
};

/// A jet in the middle of a mesh of 16 x 16 cells of 1/16 m: 1/4 m wide, from its box at the left to the last
/// quarter at the right, at 1 m/s.
inline constexpr double jet_cell = 0.0625;  // [m]

[[nodiscard]] inline CartesianGrid<2> jet_grid() {
  return cube<2>(16, jet_cell, false);
}

[[nodiscard]] inline Stream<2> jet_stream() {
  return {
      .low = {0.125, 0.375}, .high = {0.25, 0.625}, .velocity = {1, 0}, .density = 1000, .per_cell = {2, 2}};
}

[[nodiscard]] inline Outflow<2> jet_end() {
  const double infinity = std::numeric_limits<double>::infinity();
  return {.low = {0.75, -infinity}, .high = {infinity, infinity}};
}

}  // namespace scree::mpm
