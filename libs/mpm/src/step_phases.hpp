#pragma once

#include <scree/mpm/limiting_point.hpp>
#include <scree/mpm/step.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

/// The phases that steps of every order are made of.
namespace scree::mpm::detail {

/// Adds the time between its birth and its end to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_{sum} {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& sum_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Sorts all points anew, and readies what depends on where their blocks are; in step.cpp.
/// @throws RunError naming a point outside the mesh.
template <int D, int V>
void sort(State<D, V>& state, const Stages<D, V>& stages, Threads threads);

/// Makes rates no smaller than those of these points.
template <int D, int V>
void widen_rates(Rates& rates, const Particles<D, V>& particles, const Stages<D, V>& stages,
                 const CartesianGrid<D>& grid) {
  const BlockStiffness stiffness = stages.stress->stiffness(particles, 0, particles.size());
  rates.wave_speed = std::max(rates.wave_speed, stiffness.wave_speed);
  rates.kinematic_viscosity = std::max(rates.kinematic_viscosity, stiffness.kinematic_viscosity);
  rates.relaxation_rate = std::max(rates.relaxation_rate, stiffness.relaxation_rate);
  for (Index p = 0; p < particles.size(); ++p) {
    rates.advection_rate = std::max(rates.advection_rate, advection_rate(particles, grid, p));
  }
}

/// Whether stress has a pass of its own: else it is brought up to date while its block goes to the nodes.
template <int D, int V>
[[nodiscard]] bool has_stress_pass(const Stages<D, V>& stages) noexcept {
  return stages.order != Order::usl || stages.averaging.is_on();
}

/// What a block's points give to the nodes, for walls to fold.
template <int D, int V>
void scatter_block(State<D, V>& state, const Stages<D, V>& stages, const Transfer<D, V>& transfer,
                   const ParticleBlock<D>& block, double dt) noexcept {
  transfer.scatter(state.particles, block, state.nodes, dt);
  for (const auto& boundary : stages.boundaries) {
    const std::optional<MeshEnd> end = boundary->cuts_shapes();
    if (end) transfer.scatter_cut(state.particles, block, state.nodes, *end, dt);
  }
}

/// Points to nodes; the law on the way, unless it has had its pass.
template <int D, int V>
void scatter(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  const Stopwatch watch{state.seconds.scatter};
  const bool by_the_way = !has_stress_pass(stages);
  state.nodes.clear();
  state.blocks.for_each_coloured(threads, [&](Index b) {
    const ParticleBlock<D>& block = state.blocks.blocks[static_cast<std::size_t>(b)];
    if (by_the_way) {
      state.block_results[static_cast<std::size_t>(b)].stiffness =
          stages.stress->apply(state.particles, block, dt);
    }
    scatter_block(state, stages, *stages.transfer, block, dt);
    if (stages.point_term) stages.point_term->scatter(state.particles, block, state.nodes, dt);
  });
}

/// Where boundaries read of points, as they stand.
template <int D, int V>
void find_read(State<D, V>& state, const Stages<D, V>& stages) {
  state.read.find(stages.boundaries, state.nodes, state.blocks, stages.transfer->tile_edge());
}

/// What boundaries read of points, for all of the step: as the points begin it.  Eq. (M170)
template <int D, int V>
void bring_means(State<D, V>& state, const Stages<D, V>& stages, Threads threads) {
  if (!stages.node_means) return;
  const Stopwatch watch{state.seconds.nodes};
  const auto moves = [](const auto& boundary) {
    return boundary->num_means() > 0 && boundary->reads_elsewhere();
  };
  if (std::ranges::any_of(stages.boundaries, moves)) find_read(state, stages);
  stages.node_means->bring(state.particles, state.blocks, state.read, state.nodes, state.spare.extremes,
                           threads);
}

template <int D, int V>
void move_nodes(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  const Stopwatch watch{state.seconds.nodes};
  for (const auto& boundary : stages.boundaries) boundary->fold(state.nodes, stages.gravity.data(), dt);
  advance_momentum(state.nodes, stages.gravity.data(), dt, state.mass_floor, threads);
  for (const auto& boundary : stages.boundaries) boundary->hold(state.nodes, dt);
  if (stages.node_solve) stages.node_solve->solve(state.particles, state.nodes, dt, state.mass_floor);
  for (const auto& boundary : stages.boundaries) boundary->reflect(state.nodes);
}

/// Whether gradients beside walls are mended after `Transfer::gather`.
template <int D, int V>
[[nodiscard]] bool mends_gradients(const Stages<D, V>& stages) noexcept {
  const auto cuts = [](const auto& boundary) { return boundary->cuts_shapes().has_value(); };
  return stages.transfer->gathers_cut() && std::ranges::any_of(stages.boundaries, cuts);
}

/// Whether a wall cuts shape functions of a block's points off: nodes past it are among those of the block.
template <int D, int V>
[[nodiscard]] bool is_cut(const ParticleBlock<D>& block, const CartesianGrid<D>& grid,
                          const Stages<D, V>& stages) noexcept {
  return std::ranges::any_of(stages.boundaries, [&](const auto& boundary) {
    const std::optional<MeshEnd> end = boundary->cuts_shapes();
    if (!end) return false;
    const auto axis = static_cast<std::size_t>(end->axis);
    const Index first = block.first_cell[axis] - block_skin<D>;
    return end->side == Side::low ? first < 0
                                  : first + stages.transfer->tile_edge() - 1 > grid.num_cells()[axis];
  });
}

/// Copies where the points of a block are.
template <int D, int V>
void keep_positions(State<D, V>& state, const ParticleBlock<D>& block) noexcept {
  const Index stride = state.particles.size();
  for (int axis = 0; axis < D; ++axis) {
    const double* const x = state.particles.position.component(axis);
    std::copy(x + block.begin, x + block.end, state.spare.position.data() + axis * stride + block.begin);
  }
}

/// What nodes give to a block's points, beside walls that cut shapes off too.
/// @param transfer that takes it  @param position of all points before, or of those whose gradients it mends
template <int D, int V>
BlockMotion gather_block(State<D, V>& state, const Stages<D, V>& stages, const Transfer<D, V>& transfer,
                         const ParticleBlock<D>& block, const double* position, double dt) noexcept {
  const BlockMotion motion = transfer.gather(state.particles, block, state.nodes, dt);
  for (const auto& boundary : stages.boundaries) {
    const std::optional<MeshEnd> end = boundary->cuts_shapes();
    if (end) transfer.gather_cut(state.particles, block, state.nodes, *end, position, dt);
  }
  return motion;
}

template <int D, int V>
void gather(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  const Stopwatch watch{state.seconds.gather};
  const bool mends = mends_gradients(stages);
  state.blocks.for_each(threads, [&](Index b) {
    const ParticleBlock<D>& block = state.blocks.blocks[static_cast<std::size_t>(b)];
    if (mends && is_cut(block, state.nodes.grid(), stages)) keep_positions(state, block);
    state.block_results[static_cast<std::size_t>(b)].motion =
        gather_block(state, stages, *stages.transfer, block, state.spare.position.data(), dt);
    if (stages.point_term) stages.point_term->gather(state.particles, block, dt);
  });
}

/// Gives points the velocity and its gradient that the nodes have by the points' momentum as it is: no force
/// acts and nothing moves, but walls hold.  @param dt of the step, for what walls hold by it [s]
template <int D, int V>
void map_to_nodes_and_back(State<D, V>& state, const Stages<D, V>& stages, const Transfer<D, V>& transfer,
                           double dt, Threads threads) {
  constexpr std::array<double, V> no_gravity{};
  state.nodes.clear();
  state.blocks.for_each_coloured(threads, [&](Index b) {
    scatter_block(state, stages, transfer, state.blocks.blocks[static_cast<std::size_t>(b)], 0);
  });
  for (const auto& boundary : stages.boundaries) boundary->fold(state.nodes, no_gravity.data(), 0);
  advance_momentum(state.nodes, no_gravity.data(), 0, state.mass_floor, threads);
  for (const auto& boundary : stages.boundaries) boundary->hold_mapped(state.nodes, dt);
  for (const auto& boundary : stages.boundaries) boundary->reflect(state.nodes);
  const double* const position = state.particles.position.component(0);  // nothing moves
  state.blocks.for_each(threads, [&](Index b) {
    gather_block(state, stages, transfer, state.blocks.blocks[static_cast<std::size_t>(b)], position, 0);
  });
}

}  // namespace scree::mpm::detail
