#include "extra_passes.hpp"
#include "instances.hpp"
#include "point_text.hpp"
#include "step_phases.hpp"

#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/step.hpp>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace scree::mpm {

namespace {

/// Readies all that depends on where the blocks are.
template <int D, int V>
void use_blocks(State<D, V>& state, const Stages<D, V>& stages) {
  state.block_results.resize(state.blocks.blocks.size());
  state.needs_sort = false;
  if (!stages.node_solve) {  // which may move any node
    std::vector<Indices<D>> corners;
    corners.reserve(state.blocks.blocks.size());
    for (const ParticleBlock<D>& block : state.blocks.blocks) {
      corners.push_back(block.first_cell);
      for (Index& node : corners.back()) node -= block_skin<D>;
    }
    state.nodes.use(corners, stages.transfer->tile_edge());
  }
  if (stages.node_means) detail::find_read(state, stages);
}

/// @throws InputError if a boundary reads what no stage brings.  Eq. (M170)
template <int D, int V>
void require_means(const Stages<D, V>& stages) {
  const Index num_means = stages.node_means ? stages.node_means->size() : 0;
  for (const auto& boundary : stages.boundaries) {
    require(boundary->num_means() <= num_means,
            "a boundary reads " + std::to_string(boundary->num_means()) +
                " means of what points carry, but the stages bring " + std::to_string(num_means) +
                " to the nodes: Stages::node_means must be those that gave it their places");
  }
}

}  // namespace

template <int D, int V>
void detail::sort(State<D, V>& state, const Stages<D, V>& stages, Threads threads) {
  const Stopwatch watch{state.seconds.sort};
  state.blocks = cell_sort(state.particles, state.nodes.grid(), stages.transfer->stencil_shift(), threads);
  use_blocks(state, stages);
}

namespace {

/// Deals with the points outside the mesh; those that are to stop the run are found by the sorting that
/// follows.
template <int D, int V>
void deal_with_leaving(State<D, V>& state, const Stages<D, V>& stages) {
  if (stages.leaving == Leaving::absorb) {
    state.absorbed += absorb_outside(state.particles, state.nodes.grid(), stages.balanced);
  } else if (stages.leaving == Leaving::reflect) {
    reflect_outside(state.particles, state.nodes.grid());
  }
}

/// The worst of all blocks; a maximum does not depend on the order.
template <int D, int V>
void reduce(State<D, V>& state) {
  state.rates = {};
  for (const BlockResult& result : state.block_results) {
    Rates& worst = state.rates;
    worst.wave_speed = std::max(worst.wave_speed, result.stiffness.wave_speed);
    worst.kinematic_viscosity = std::max(worst.kinematic_viscosity, result.stiffness.kinematic_viscosity);
    worst.relaxation_rate = std::max(worst.relaxation_rate, result.stiffness.relaxation_rate);
    worst.advection_rate = std::max(worst.advection_rate, result.motion.advection_rate);
    state.needs_sort = state.needs_sort || result.motion.needs_sort;
  }
}

constexpr std::string_view remedy = "; a shorter step, by smaller shares of its limits, may help";

/// Looks where a block reports one: points that are taken out, without mass, stay until the next sorting and
/// would else have all points looked at in every step.
/// @throws RunError naming a point that the step of dt has left without volume.  Eq. (M125)
template <int D, int V>
void require_volumes(const State<D, V>& state, double dt) {
  const Particles<D, V>& particles = state.particles;
  for (std::size_t b = 0; b < state.block_results.size(); ++b) {
    if (!state.block_results[b].motion.lacks_volume) continue;
    const ParticleBlock<D>& block = state.blocks.blocks[b];
    for (Index p = block.begin; p < block.end; ++p) {
      const double density = particles.density.component(0)[p];
      if (!(particles.mass.component(0)[p] > 0) || detail::has_volume(density)) continue;
      std::ostringstream message;
      message << point_text(particles, p) << " has no volume left after a step of " << dt
              << " s: its density is " << density << " kg/m^3" << remedy;
      throw RunError{message.str()};
    }
  }
}

/// @throws RunError naming the law and the point that it was furthest from solving.
template <int D, int V>
void require_solved(const State<D, V>& state, const Stages<D, V>& stages) {
  BlockStiffness worst;
  for (const BlockResult& result : state.block_results) {
    if (result.stiffness.unsolved > worst.unsolved) worst = result.stiffness;
  }
  if (!(worst.unsolved > 0)) return;
  std::ostringstream message;
  message << "the law '" << stages.stress->law() << "' was not solved at "
          << point_text(state.particles, worst.unsolved_point)
          << ": its equations are left with a relative error of " << worst.unsolved << remedy;
  throw RunError{message.str()};
}

}  // namespace

template <int D, int V>
State<D, V> start(Particles<D, V> particles, const CartesianGrid<D>& grid, const Stages<D, V>& stages,
                  Threads threads) {
  require(particles.size() > 0, "a run needs at least one material point");
  require(stages.xpic.order == 0 || stages.transfer->record().has_increment,
          "xpic filters the velocities of points that take increments: its transfer must be pic_flip");
  require(
      stages.point_term == nullptr || !detail::has_stress_pass(stages),
      "terms of points, as of flow round an axis, take their stress as they go to the nodes: the order must "
      "be usl, without means over cells");
  for (const auto& boundary : stages.boundaries) {
    const std::optional<MeshEnd> end = boundary->cuts_shapes();
    require(!end || !grid.is_periodic()[static_cast<std::size_t>(end->axis)],
            "a wall with friction stands on an axis that is periodic");
  }
  require_means(stages);
  State<D, V> state{std::move(particles), Nodes<D>{grid, stages.transfer->record()}};
  if (stages.node_means) state.nodes.carry(stages.node_means->size());
  const auto masses = state.particles.mass.values();
  state.mass_floor = stages.mass_floor * *std::max_element(masses.begin(), masses.end());
  const auto ids = state.particles.id.values();
  state.next_id = *std::max_element(ids.begin(), ids.end()) + 1;
  detail::sort(state, stages, threads);
  if (detail::has_stress_pass(stages) && stages.order != Order::usf) {
    detail::prepare(state, stages);
    detail::update_stress(state, stages, 0, threads);  // what the first forces are
  }
  detail::widen_rates(state.rates, state.particles, stages, grid);
  return state;
}

template <int D, int V>
void resume(State<D, V>& state, const Stages<D, V>& stages) {
  require_means(stages);
  colour_blocks(state.blocks, state.nodes.grid());
  if (stages.node_means) state.nodes.carry(stages.node_means->size());
  use_blocks(state, stages);
}

template <int D, int V>
void step(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads) {
  const bool has_stress_pass = detail::has_stress_pass(stages);
  detail::prepare(state, stages);
  detail::bring_means(state, stages, threads);
  if (stages.xpic.order > 0) detail::find_filtered(state, stages, dt, threads);
  if (stages.order == Order::usf) {
    detail::update_stress(state, stages, dt, threads);
    require_volumes(state, dt);
  }
  detail::scatter(state, stages, dt, threads);
  require_solved(state, stages);
  detail::move_nodes(state, stages, dt, threads);
  if (has_stress_pass) {
    detail::gather_beside_stress(state, stages, dt, threads);
  } else {
    detail::gather(state, stages, dt, threads);
  }
  if (stages.xpic.order > 0) detail::filter(state);
  const bool is_stress_last = has_stress_pass && stages.order != Order::usf;
  if (is_stress_last) detail::update_stress_last(state, stages, dt, threads);
  require_volumes(state, dt);
  if (is_stress_last) require_solved(state, stages);
  for (const auto& boundary : stages.boundaries) boundary->advance(dt);
  reduce(state);
  if (!state.needs_sort) return;
  deal_with_leaving(state, stages);
  detail::sort(state, stages, threads);
}

namespace {

/// What all nodes share in a step.
struct Advance {
  std::array<double, 3> fall{};  ///< dt g, zero where there is no such velocity [m/s]
  double dt;                     ///< [s]
  double mass_floor;             ///< [kg]
};

/// Three velocities whatever their number: the places of others are zero and stay so.
template <bool has_increment>
void advance_node(double* node, const Advance& by) noexcept {
  const bool moves = node[NodeRecord::mass] > by.mass_floor;
  const double inverse_mass = moves ? 1 / node[NodeRecord::mass] : 0;
  const double falls = moves ? 1 : 0;
  for (int i = 0; i < 3; ++i) {
    double increment = falls * by.fall[static_cast<std::size_t>(i)];
    if constexpr (has_increment) {
      double& force = node[NodeRecord::increment() + i];
      increment += by.dt * inverse_mass * force;
      force = increment;
    }
    double& velocity = node[NodeRecord::momentum + i];
    velocity = inverse_mass * velocity + increment;
  }
}

}  // namespace

template <int D>
void advance_momentum(Nodes<D>& nodes, const double* gravity, double dt, double mass_floor, Threads threads) {
  const NodeRecord layout = nodes.record();
  Advance by{.dt = dt, .mass_floor = mass_floor};
  for (int i = 0; i < layout.num_velocities; ++i) {
    by.fall[static_cast<std::size_t>(i)] = dt * gravity[i];
  }
  for_each_block(nodes.num_batches(), threads, [&](Index batch) {
    for (const NodeRun& run : nodes.batch(batch)) {
      double* const end = nodes[run.end];
      if (layout.has_increment) {
        for (double* node = nodes[run.begin]; node != end; node += 8) advance_node<true>(node, by);
      } else {
        for (double* node = nodes[run.begin]; node != end; node += 4) advance_node<false>(node, by);
      }
    }
  });
}

#define SCREE_INSTANCE(D, V)                                                                          \
  template void detail::sort(State<D, V>&, const Stages<D, V>&, Threads);                             \
  template State<D, V> start(Particles<D, V>, const CartesianGrid<D>&, const Stages<D, V>&, Threads); \
  template void resume(State<D, V>&, const Stages<D, V>&);                                            \
  template void step(State<D, V>&, const Stages<D, V>&, double, Threads);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
template void advance_momentum(Nodes<1>&, const double*, double, double, Threads);
template void advance_momentum(Nodes<2>&, const double*, double, double, Threads);
template void advance_momentum(Nodes<3>&, const double*, double, double, Threads);

}  // namespace scree::mpm
