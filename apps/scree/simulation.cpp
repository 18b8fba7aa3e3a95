#include "scree/simulation.hpp"

#include "scree/axes.hpp"
#include "scree/dimensions.hpp"
#include "scree/filling.hpp"
#include "scree/ground.hpp"
#include "scree/leaving_text.hpp"
#include "scree/node_viscosity.hpp"
#include "scree/overlaps.hpp"
#include "scree/streams.hpp"
#include "scree/walls.hpp"

#include <scree/io/bounds.hpp>
#include <scree/mpm/append.hpp>
#include <scree/mpm/axisymmetric.hpp>
#include <scree/mpm/geostatic.hpp>
#include <scree/mpm/seed_region.hpp>
#include <scree/mpm/terrain/above_bed.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

namespace scree::app {

namespace {

template <int D>
[[nodiscard]] CartesianGrid<D> make_grid(const Scene& scene) {
  const MeshScene& mesh = scene.mesh;
  const double edge =
      mesh.size[static_cast<std::size_t>(normal_component(D))] / static_cast<double>(mesh.cells);
  Vector<D> spacing;
  Indices<D> cells{};
  std::array<bool, D> is_periodic{};
  for (std::size_t d = 0; d < D; ++d) {
    cells[d] = std::lround(mesh.size[d] / edge);
    spacing[static_cast<int>(d)] = mesh.size[d] / static_cast<double>(cells[d]);
    is_periodic[d] = scene.axes[d].is_periodic;
  }
  return {Vector<D>::Zero(), spacing, cells, is_periodic};
}

/// Gravity by velocity component [m/s^2]: down the slope along the flow, into the base along its normal.
template <int V>
[[nodiscard]] std::array<double, V> gravity_of(const GravityScene& gravity, int dimensions) {
  const double slope = gravity.slope_degrees * std::numbers::pi / 180;
  std::array<double, V> result{};
  result[static_cast<std::size_t>(normal_component(dimensions))] = -gravity.magnitude * std::cos(slope);
  const int along = flow_component(dimensions, V);
  if (along >= 0) result[static_cast<std::size_t>(along)] = gravity.magnitude * std::sin(slope);
  return result;
}

/// The ground of a scene; none if it has none.
template <int D>
[[nodiscard]] mpm::AnySurface<D> ground_of(const Scene& scene) {
  if constexpr (D > 1) {
    if (scene.terrain) return surface_of<D>(*scene.terrain, scene.mesh);
  }
  return {};
}

/// What holds material: ground and bodies first, so that the walls of the mesh have the last word but for the
/// boxes that streams enter by.
/// @param reach of the shape function [spacings]
template <int D, int V>
[[nodiscard]] std::vector<std::unique_ptr<mpm::Boundary<D>>> make_boundaries(const Scene& scene,
                                                                             const CartesianGrid<D>& grid,
                                                                             const mpm::AnySurface<D>& ground,
                                                                             double reach) {
  std::vector<std::unique_ptr<mpm::Boundary<D>>> boundaries;
  if constexpr (D > 1) {
    if (ground) boundaries.push_back(make_terrain<D>(*scene.terrain, ground, grid));
    require_apart(scene, grid, ground);
    for (const BodyScene& body : scene.bodies) boundaries.push_back(make_body<D>(body));
  }
  for (int axis = 0; axis < D; ++axis) {
    const AxisScene& ends = scene.axes[static_cast<std::size_t>(axis)];
    if (ends.is_periodic) continue;
    boundaries.push_back(make_boundary<D>(ends.low, axis, mpm::Side::low));
    boundaries.push_back(make_boundary<D>(ends.high, axis, mpm::Side::high));
  }
  for (const InflowScene& inflow : scene.inflows) {
    boundaries.push_back(mpm::make_inflow_hold(stream_of<D, V>(scene, inflow), grid, reach));
  }
  std::erase(boundaries, nullptr);
  return boundaries;
}

/// @throws InputError if a body begins inside the material.
template <int D, int V>
void require_clear_of_bodies(const Scene& scene, const mpm::Particles<D, V>& particles) {
  if constexpr (D > 1) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      try {
        mpm::require_above(particles, surface_of<D>(scene.bodies[i]));
      } catch (const InputError& error) {
        throw InputError{"[[bodies]] " + std::to_string(i + 1) + ": as " + error.what()};
      }
    }
  }
}

/// Points in the box of a stream, clear of ground and bodies.
template <int D, int V>
[[nodiscard]] mpm::Particles<D, V> box_of_stream(const Scene& scene, std::size_t number,
                                                 const CartesianGrid<D>& grid,
                                                 const mpm::AnySurface<D>& ground) {
  auto points = mpm::fill_box(stream_of<D, V>(scene, scene.inflows[number]), grid);
  try {
    if (ground) mpm::require_above(points, ground);
    require_clear_of_bodies(scene, points);
  } catch (const InputError& error) {
    throw InputError{"[[inflow]] " + std::to_string(number + 1) + ": " + error.what()};
  }
  if (scene.grains) Mixture{scene}.add_to(points, scene.inflows[number].fractions);
  return points;
}

/// The material, and streams that enter from the start.
template <int D, int V>
[[nodiscard]] mpm::Particles<D, V> make_particles(const Scene& scene, const Filling<D>& filling,
                                                  const CartesianGrid<D>& grid,
                                                  const mpm::AnySurface<D>& ground) {
  mpm::Particles<D, V> particles;
  if (!scene.material.is_absent) particles = filling.template points<V>();
  require_clear_of_bodies(scene, particles);
  require_clear_of_streams(scene, particles);
  if (scene.grains) Mixture{scene}.add_to(particles);
  for (std::size_t i = 0; i < scene.inflows.size(); ++i) {
    const auto box = box_of_stream<D, V>(scene, i, grid, ground);
    if (begins_full(scene.inflows[i])) mpm::append(particles, box);
  }
  if (!scene.inflows.empty()) {
    double number = 0;
    for (double& id : particles.id.values()) id = number++;
  }
  return particles;
}

template <int D, int V>
[[nodiscard]] mpm::Stages<D, V> make_stages(const Scene& scene, const CartesianGrid<D>& grid,
                                            mpm::Particles<D, V>& particles) {
  mpm::Stages<D, V> stages;
  if constexpr (D == 2 && V == 2) {  // first: the law reads what this adds
    if (scene.mesh.is_axisymmetric) stages.point_term = mpm::make_axisymmetric(particles, grid, scene.shape);
  }
  stages.stress = std::visit(
      [&](const auto& law) -> std::unique_ptr<mpm::StressUpdate<D, V>> {
        return std::make_unique<mpm::StressUpdateBy<D, V, std::decay_t<decltype(law)>>>(law, particles);
      },
      scene.law);
  for (const InitialScene& initial : scene.initial) {
    const std::size_t column = particles.find_column(initial.column, "the scene");
    std::ranges::fill(particles.column(column).values(), initial.value);
  }
  stages.transfer = mpm::make_transfer<D, V>(scene.shape, scene.transfer);
  stages.order = scene.order;
  stages.averaging = scene.averaging;
  if (scene.xpic_order > 0) stages.xpic = mpm::make_xpic<D, V>(scene.shape, scene.xpic_order);
  stages.leaving = scene.leaving;
  stages.balanced = particles.column_named(fraction_column);
  stages.gravity = gravity_of<V>(scene.gravity, D);
  return stages;
}

/// Whether a point has a density at which it bears this pressure.
template <int D, int V>
[[nodiscard]] bool can_bear(const mpm::Particles<D, V>& particles, const mpm::StressUpdate<D, V>& stress,
                            double pressure) {
  constexpr double nothing = 1e-6;  // [-], of the law's own density: material so thin is none
  try {
    return stress.density_at(particles, 0, pressure) > nothing * particles.density.component(0)[0];
  } catch (const RunError&) {
    return false;
  }
}

/// Puts points at rest under their own weight. Where nothing presses they keep their law's density.
/// @throws InputError if the law does not bear the pressure on the surface.
template <int D, int V>
void settle(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages,
            mpm::Particles<D, V>& particles) {
  const int normal = normal_component(D);
  const double gravity = -stages.gravity[static_cast<std::size_t>(normal)];
  const double pressure = scene.material.surface_pressure;
  if (gravity == 0 && pressure == 0) return;
  require(can_bear(particles, *stages.stress, pressure),
          "[material] surface_pressure = " + io::to_text(pressure) + ": the law '" +
              std::string{stages.stress->law()} +
              "' has no density at which it bears this pressure [Pa], as the top of the material does at the "
              "start; give another");
  const std::function<double(const Vector<D>&)> top = [&](const Vector<D>& x) {
    return surface_above(scene, filling, x);
  };
  mpm::set_geostatic(particles, *stages.stress, normal, top, gravity, pressure);
}

/// Points, at rest under their own weight, and the parts of the step that reads their columns.
template <int D, int V>
[[nodiscard]] mpm::State<D, V> make_state(const Scene& scene, mpm::Stages<D, V>& stages, std::string& note,
                                          Threads threads) {
  const CartesianGrid<D> grid = make_grid<D>(scene);
  const mpm::AnySurface<D> ground = ground_of<D>(scene);
  const Filling<D> filling{scene, grid, ground};
  auto particles = make_particles<D, V>(scene, filling, grid, ground);
  stages = make_stages(scene, grid, particles);
  stages.boundaries = make_boundaries<D, V>(scene, grid, ground, 1 + stages.transfer->stencil_shift());
  settle(scene, filling, stages, particles);
  note = choose_viscosity(scene, grid, particles, stages, threads);
  return mpm::start(std::move(particles), grid, stages, threads);
}

/// More threads than this many points can feed only wait for each other.
[[nodiscard]] Threads useful(Threads threads, Index num_points) {
  constexpr Index points_per_thread = 4000;
  return {static_cast<int>(std::min<Index>(threads.count, 1 + num_points / points_per_thread))};
}

}  // namespace

template <int D, int V>
Simulation<D, V>::Simulation(const Scene& scene, Threads threads)
    : scene_{scene},
      threads_{threads},
      most_threads_{threads},
      state{make_state<D, V>(scene_, stages_, viscosity_note_, threads)} {
  threads_ = useful(threads, state.particles.size());
  const auto masses = state.particles.mass.values();
  tally.first_mass = std::accumulate(masses.begin(), masses.end(), 0.0);
  for (const InflowScene& inflow : scene_.inflows) streams.inflows.push_back(make_inflow(inflow));
  streams.outflows = outflows_of<D>(scene_, grid());
  streams.taken.resize(streams.outflows.size());
  if (!scene_.grains) return;
  mixture_.emplace(scene_);
  if (scene_.segregation) {
    Vector<D> direction = Eigen::Map<const Vector<D>>{stages_.gravity.data()};
    if (direction.norm() > 0) direction.normalize();
    coupling_.emplace(*scene_.segregation, scene_.grains->classes, grid(), scene_.shape, direction, threads_);
  }
  if (crushes(scene_.law)) {
    crushing_.emplace(state.particles, *scene_.grains, scene_.mixture.ultimate_fractal_dimension);
    if (crushing_->advance(state.particles)) follow_grains();
  }
  observe_fractions(state.particles, tally.fractions);
  tally.first_class_masses = class_masses(state.particles);
}

/// Its layer goes through all that gives points of the run their columns.
template <int D, int V>
mpm::Inflow<D, V> Simulation<D, V>::make_inflow(const InflowScene& inflow) const {
  const mpm::Stream<D, V> stream = stream_of<D, V>(scene_, inflow);
  auto layer = mpm::first_layer(stream, grid());
  if (scene_.grains) Mixture{scene_}.add_to(layer, inflow.fractions);
  const mpm::Stages<D, V> stages = make_stages(scene_, grid(), layer);
  settle(scene_, Filling<D>{scene_, grid(), ground_of<D>(scene_)}, stages, layer);
  if (scene_.grains && crushes(scene_.law)) {
    const Crushing<D, V> crushing{layer, *scene_.grains, scene_.mixture.ultimate_fractal_dimension};
    if (crushing.advance(layer)) Mixture{scene_}.update(layer);
  }
  return {stream, grid(), std::move(layer)};
}

template <int D, int V>
std::vector<double> Simulation<D, V>::stability_numbers() const {
  std::vector<double> numbers(static_cast<std::size_t>(state.particles.size()));
  stages_.stress->stability_number(state.particles, numbers);
  return numbers;
}

template <int D, int V>
std::optional<double> Simulation<D, V>::ill_posed_share() const {
  if (!stages_.stress->tells_stability() || num_points() == 0) return std::nullopt;
  const std::vector<double> numbers = stability_numbers();
  Index ill_posed = 0;
  for (Index p = 0; p < state.particles.size(); ++p) {
    if (state.particles.mass.component(0)[p] > 0 && numbers[static_cast<std::size_t>(p)] > 0) ++ill_posed;
  }
  return static_cast<double>(ill_posed) / static_cast<double>(num_points());
}

template <int D, int V>
std::string Simulation<D, V>::too_few_points() const {
  constexpr Index wanted = Index{1} << D;  // two along each axis
  const mpm::CellFilling filling = mpm::cell_filling(state.particles, grid(), wanted);
  std::string thin_streams = too_thin_streams(scene_);
  if (scene_.material.is_absent || 2 * filling.num_too_few <= filling.num_filled) return thin_streams;
  return thin_streams + (thin_streams.empty() ? "" : "; ") + std::to_string(filling.num_too_few) + " of " +
         std::to_string(filling.num_filled) + " cells with material hold fewer than " +
         std::to_string(wanted) +
         " points, which carry stress badly: give more [material] points_per_cell, or material more cells";
}

template <int D, int V>
Index Simulation<D, V>::num_points() const noexcept {
  const auto masses = state.particles.mass.values();
  return static_cast<Index>(std::count_if(masses.begin(), masses.end(), [](double m) { return m > 0; }));
}

template <int D, int V>
bool Simulation<D, V>::is_finished() const noexcept {
  return clock.time >= scene_.end;
}

template <int D, int V>
double Simulation<D, V>::next_frame_time() const noexcept {
  return std::min(static_cast<double>(clock.frame) * scene_.output.every, scene_.end);
}

template <int D, int V>
mpm::TimeStep Simulation<D, V>::next_step() const {
  if (state.particles.size() == 0) {  // all have left
    double dt = next_frame_time() - clock.time;
    for (const auto& inflow : streams.inflows) dt = std::min(dt, inflow.longest_step(clock.moved));
    return {dt, mpm::Limit::output};
  }
  return mpm::stable_time_step(grid(), state.rates, scene_.time_step);
}

template <int D, int V>
void Simulation<D, V>::require_progress(const mpm::TimeStep& next) {
  constexpr double smallest_share = 1e-4;  // [-], of the first step: a flow that still obeys its limits has
                                           // not sped up by so much
  if (state.particles.size() == 0) return;
  if (first_dt_ == 0) first_dt_ = next.dt;
  if (next.dt >= smallest_share * first_dt_) return;
  throw RunError{"the stable step has fallen from " + io::to_text(first_dt_) + " to " + io::to_text(next.dt) +
                 " s, bound by the " + std::string{mpm::limit_names[static_cast<std::size_t>(next.limit)]} +
                 " limit: the run has become unstable; use a smaller share of the limits ([numerics])"};
}

template <int D, int V>
void Simulation<D, V>::advance(double dt) {
  try {
    mpm::step(state, stages_, dt, threads_);
  } catch (const RunError& error) {
    throw RunError{error.what() + leaving_text(state.particles, grid(), clock.time + dt)};
  }
}

template <int D, int V>
void Simulation<D, V>::pass_material() {
  for (auto& inflow : streams.inflows) mpm::take_in(state, stages_, inflow, clock.moved, threads_);
  for (std::size_t i = 0; i < streams.outflows.size(); ++i) {
    streams.taken[i] += mpm::take_out(state, streams.outflows[i], stages_.balanced);
  }
}

/// Points are counted anew only when their number may have changed.
template <int D, int V>
void Simulation<D, V>::count_updates() {
  const Index passed = state.absorbed.count + streams.num_passed();
  if (passed != num_passed_) {
    num_passed_ = passed;
    num_points_ = num_points();
    threads_ = useful(most_threads_, state.particles.size());
    if (num_points_ == 0) state.needs_sort = true;  // those that only fill blocks go
  }
  point_updates_ += static_cast<double>(num_points_);
}

template <int D, int V>
void Simulation<D, V>::resume() {
  for (const auto& boundary : stages_.boundaries) boundary->advance(clock.moved);
  mpm::resume(state, stages_);
  if (num_points() == 0) state.needs_sort = true;  // as count_updates() left it
}

template <int D, int V>
bool Simulation<D, V>::step() {
  mpm::TimeStep next = next_step();
  require_progress(next);
  const double left = next_frame_time() - clock.time;
  const bool reaches_frame = left <= next.dt;
  if (reaches_frame) next = {left, mpm::Limit::output};
  advance(next.dt);
  clock.moved += next.dt;
  pass_material();
  count_updates();
  if (crushing_ && crushing_->advance(state.particles)) follow_grains();
  clock.time = reaches_frame ? next_frame_time() : clock.time + next.dt;
  ++clock.step;
  if (reaches_frame) ++clock.frame;
  clock.unsegregated_time += next.dt;
  ++clock.unsegregated_steps;
  ++tally.steps_by_limit[static_cast<std::size_t>(next.limit)];
  if (coupling_ && (reaches_frame || clock.unsegregated_steps >= scene_.segregation->every)) segregate();
  if (crushing_ && reaches_frame) observe_fractions(state.particles, tally.fractions);
  return reaches_frame;
}

template <int D, int V>
void Simulation<D, V>::follow_grains() {
  mixture_->update(state.particles);
  try {
    stages_.stress->require_inputs(state.particles);
  } catch (const InputError& error) {
    throw RunError{std::string{error.what()} +
                   "; the grains of this point have become none that the law knows"};
  }
}

template <int D, int V>
void Simulation<D, V>::segregate() {
  const auto start = std::chrono::steady_clock::now();
  const auto report = coupling_->advance(state, clock.unsegregated_time);
  follow_grains();
  observe_fractions(state.particles, tally.fractions);
  clock.unsegregated_time = 0;
  clock.unsegregated_steps = 0;
  ++tally.segregation_steps;
  tally.segregation_substeps += report.substeps;
  tally.segregation_seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

#define SCREE_INSTANCE(D, V) template class Simulation<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
