#pragma once

#include "stencil.hpp"
#include "step_phases.hpp"

#include <scree/mpm/point_transfer.hpp>

#include <algorithm>
#include <limits>

/// What a step does beside its own passes when it is told to: stress in another order, means over cells, a
/// filter of velocities.
namespace scree::mpm::detail {

inline void copy(std::span<const double> from, std::span<double> to) {
  std::copy(from.begin(), from.end(), to.begin());
}

/// The memory that the passes need: more is taken only when there are more points.
template <int D, int V>
void prepare(State<D, V>& state, const Stages<D, V>& stages) {
  const Particles<D, V>& particles = state.particles;
  Spare& spare = state.spare;
  const bool has_filter = stages.xpic.order > 0;
  const auto make = [](std::vector<double>& values, const Column& column) {
    values.resize(column.values().size());
  };
  if (has_stress_pass(stages) || mends_gradients(stages)) make(spare.position, particles.position);
  if (!has_stress_pass(stages) && !has_filter) return;
  make(spare.velocity, particles.velocity);
  make(spare.velocity_gradient, particles.velocity_gradient);
  if (has_filter) {
    make(spare.smooth, particles.velocity);
    make(spare.filtered, particles.velocity);
  }
  if (!has_stress_pass(stages)) return;
  make(spare.density, particles.density);
  if (stages.averaging.is_on()) state.means.prepare(state.nodes.grid(), particles.size());
}

/// Whether a density is that of a volume: positive and finite. No number passes too: it shows in the place of
/// its point.
[[nodiscard]] inline bool has_volume(double density) noexcept {
  return !(density <= 0 || density > std::numeric_limits<double>::max());
}

/// Density by what a step makes of a point's volume.  Eqs. (M13), (M125)
/// @returns whether a point is left without volume.
template <int D, int V>
[[nodiscard]] bool strain_density(Particles<D, V>& particles, const ParticleBlock<D>& block,
                                  double dt) noexcept {
  bool lacks_volume = false;
  for (Index p = block.begin; p < block.end; ++p) {
    double& density = particles.density.component(0)[p];
    density /= volume_ratio<double, D, V>(gradient_of(particles, p), dt);
    lacks_volume = lacks_volume || !has_volume(density);
  }
  return lacks_volume;
}

/// Stress and density by the motion of dt: by the velocity gradient that points have, or under musl and usf
/// by that of the momentum they have. Their velocity, and its gradient, stay.  Eqs. (M126)-(M128), (M131),
/// (M132)
template <int D, int V>
void update_stress(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  const Stopwatch watch{state.seconds.scatter};
  Particles<D, V>& particles = state.particles;
  copy(particles.velocity_gradient.values(), state.spare.velocity_gradient);
  if (stages.order != Order::usl && dt > 0) {
    copy(particles.velocity.values(), state.spare.velocity);
    map_to_nodes_and_back(state, stages, *stages.transfer, dt, threads);
    copy(state.spare.velocity, particles.velocity.values());
  }
  const CartesianGrid<D>& grid = state.nodes.grid();
  if (stages.averaging.volume_change) {
    state.means.average_trace(particles, particles.velocity_gradient, state.blocks, grid, threads);
  }
  state.blocks.for_each(threads, [&](Index b) {
    const ParticleBlock<D>& block = state.blocks.blocks[static_cast<std::size_t>(b)];
    BlockResult& result = state.block_results[static_cast<std::size_t>(b)];
    result.motion.lacks_volume = strain_density(particles, block, dt);
    result.stiffness = stages.stress->apply(particles, block, dt);
  });
  if (stages.averaging.pressure) {
    state.means.average_trace(particles, particles.stress, state.blocks, grid, threads);
  }
  copy(state.spare.velocity_gradient, particles.velocity_gradient.values());
}

/// `gather`, then stress where it comes last; density is left to the pass that brings stress up to date.
template <int D, int V>
void gather_beside_stress(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  Particles<D, V>& particles = state.particles;
  copy(particles.position.values(), state.spare.position);
  copy(particles.density.values(), state.spare.density);
  gather(state, stages, dt, threads);
  copy(state.spare.density, particles.density.values());
}

/// Stress at the end of a step, where points were when their nodes moved.
template <int D, int V>
void update_stress_last(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  const std::span<double> position = state.particles.position.values();
  std::swap_ranges(position.begin(), position.end(), state.spare.position.begin());
  update_stress(state, stages, dt, threads);
  copy(state.spare.position, position);
}

/// How the filter will change the points' velocities as they are.  Eq. (M130)
template <int D, int V>
void find_filtered(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  const Stopwatch watch{state.seconds.scatter};
  Particles<D, V>& particles = state.particles;
  Spare& spare = state.spare;
  const std::span<double> velocity = particles.velocity.values();
  copy(particles.velocity_gradient.values(), spare.velocity_gradient);
  copy(velocity, spare.velocity);
  map_to_nodes_and_back(state, stages, *stages.xpic.smoother, dt, threads);
  copy(velocity, spare.smooth);
  copy(velocity, spare.filtered);
  for (int k = 1; k < stages.xpic.order; ++k) {
    map_to_nodes_and_back(state, stages, *stages.xpic.smoother, dt, threads);
    for (std::size_t i = 0; i < velocity.size(); ++i) {
      spare.filtered[i] += spare.smooth[i] - velocity[i];
      velocity[i] = spare.filtered[i];
    }
  }
  for (std::size_t i = 0; i < velocity.size(); ++i) spare.filtered[i] -= spare.velocity[i];
  copy(spare.velocity, velocity);
  copy(spare.velocity_gradient, particles.velocity_gradient.values());
}

/// Changes velocities as `find_filtered` has found.
template <int D, int V>
void filter(State<D, V>& state) {
  const std::span<double> velocity = state.particles.velocity.values();
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += state.spare.filtered[i];
}

}  // namespace scree::mpm::detail
