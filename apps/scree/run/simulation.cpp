#include "scree/run/simulation.hpp"

#include "scree/assemble/filling.hpp"
#include "scree/assemble/make_points.hpp"
#include "scree/assemble/make_stages.hpp"
#include "scree/assemble/node_viscosity.hpp"
#include "scree/assemble/stored_points.hpp"
#include "scree/run/leaving_text.hpp"
#include "scree/run/stability.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/law_columns.hpp"

#include <scree/io/bounds.hpp>
#include <scree/mpm/append.hpp>
#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/limiting_point.hpp>
#include <scree/mpm/seed_region.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace scree::app {

namespace {

/// Points, at rest under their own weight, and the parts of the step that reads their columns.
template <int D, int V>
[[nodiscard]] mpm::State<D, V> make_state(const Scene& scene, mpm::Stages<D, V>& stages, std::string& note,
                                          Threads threads) {
  const CartesianGrid<D> grid = make_grid<D>(scene);
  const mpm::AnySurface<D> ground = ground_of<D>(scene);
  const Filling<D> filling{scene, grid, ground};
  auto particles = make_points<D, V>(scene, filling, grid, ground);
  stages = make_stages(scene, grid, particles);
  const PlaceOfMean place_of = [&](std::string_view column, const InputColumn& input, std::string_view law) {
    if (!stages.node_means) stages.node_means = std::make_unique<mpm::NodeMeans<D, V>>(scene.shape);
    return stages.node_means->add(particles, column, input, law);
  };
  stages.boundaries =
      make_boundaries<D, V>(scene, grid, ground, 1 + stages.transfer->stencil_shift(), place_of);
  if (scene.material.stored) {
    take_stored(scene, particles);
    stages.stress->require_inputs(particles);
    stages.stress->require_memory(particles);
    if (stages.node_means) stages.node_means->require_inputs(particles);
  } else {
    require_stiff(scene, filling, stages, particles);
    settle(scene, filling, stages, particles, threads);
  }
  note = choose_viscosity(scene, grid, particles, stages, threads);
  auto state = mpm::start(std::move(particles), grid, stages, threads);
  require_stable_step(scene, state);
  return state;
}

/// More threads than this many points can feed only wait for each other.
[[nodiscard]] Threads useful(Threads threads, Index num_points) {
  constexpr Index points_per_thread = 4000;
  return {static_cast<int>(std::min<Index>(threads.count, 1 + num_points / points_per_thread))};
}

/// Checks before the run what take_in() does when a layer is due.
template <int D, int V>
void require_layers(const std::vector<mpm::Inflow<D, V>>& inflows, const mpm::Particles<D, V>& particles,
                    const mpm::Stages<D, V>& stages) {
  for (std::size_t i = 0; i < inflows.size(); ++i) {
    const mpm::Particles<D, V>& layer = inflows[i].layer();
    try {
      mpm::require_columns(particles, layer);
      stages.stress->require_inputs(layer);
      stages.stress->require_memory(layer);
      if (stages.node_means) stages.node_means->require_inputs(layer);
    } catch (const InputError& error) {
      throw InputError{"[[inflow]] " + std::to_string(i + 1) + ": " + error.what()};
    }
  }
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
  is_blocked_.resize(streams.inflows.size());
  streams.outflows = outflows_of<D>(scene_, grid());
  streams.taken.resize(streams.outflows.size());
  if (scene_.grains) mixture_.emplace(scene_);
  if (scene_.grains && scene_.segregation) {
    Vector<D> direction = Eigen::Map<const Vector<D>>{stages_.gravity.data()};
    if (direction.norm() > 0) direction.normalize();
    coupling_.emplace(*scene_.segregation, scene_.grains->classes, grid(), scene_.shape, direction,
                      symmetry_of(scene_), threads_);
  }
  if (scene_.grains && crushes(scene_.law)) {
    crushing_.emplace(state.particles, *scene_.grains, scene_.mixture.ultimate_fractal_dimension);
    if (crushing_->advance(state.particles)) follow_grains();
  }
  if (scene_.grains) {
    observe_fractions(state.particles, tally.fractions);
    tally.first_class_masses = class_masses(state.particles);
  }
  require_layers(streams.inflows, state.particles, stages_);
}

/// Its layer goes through all that gives points of the run their columns.
template <int D, int V>
mpm::Inflow<D, V> Simulation<D, V>::make_inflow(const InflowScene& inflow) const {
  const mpm::Stream<D, V> stream = stream_of<D, V>(scene_, inflow);
  auto layer = mpm::first_layer(stream, grid());
  if (scene_.grains) Mixture{scene_}.add_to(layer, inflow.fractions);
  const mpm::Stages<D, V> stages = make_stages(scene_, grid(), layer);
  settle(scene_, Filling<D>{scene_, grid(), ground_of<D>(scene_)}, stages, layer, threads_);
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
std::optional<SegregationLimit<D>> Simulation<D, V>::segregation_limit() {
  return coupling_ ? coupling_->last_limit() : std::nullopt;
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
  if (clock.first_dt == 0) clock.first_dt = next.dt;
  if (next.dt >= smallest_share * clock.first_dt) return;
  const auto point = mpm::limiting_point(state.particles, *stages_.stress, grid(), next.limit);
  throw RunError{"the stable step has fallen from " + io::to_text(clock.first_dt) + " to " +
                 io::to_text(next.dt) + " s, bound by the " +
                 std::string{mpm::limit_names[static_cast<std::size_t>(next.limit)]} + " limit" +
                 (point ? " of " + mpm::point_name(state.particles, *point) : "") +
                 ": the run has become unstable; use a smaller share of the limits ([numerics])"};
}

/// Rates that are no numbers say nothing of it: with them the next step fails.
template <int D, int V>
std::string Simulation<D, V>::instability_now() const {
  const mpm::Rates& rates = state.rates;
  if (num_points() == 0 ||
      !std::isfinite(rates.wave_speed + rates.kinematic_viscosity + rates.advection_rate))
    return {};
  return instability(scene_, state, *stages_.stress);
}

template <int D, int V>
void Simulation<D, V>::require_stable() const {
  const std::string unstable = instability_now();
  if (unstable.empty()) return;
  const auto point = mpm::limiting_point(state.particles, *stages_.stress, grid(), next_step().limit);
  throw RunError{
      "the run has become unstable: " + unstable +
      (point ? "; it is " + mpm::point_name(state.particles, *point) + " that bounds the step" : "")};
}

/// Those of a checkpoint are by the constants that its law had.
template <int D, int V>
void Simulation<D, V>::renew_rates() {
  const mpm::BlockStiffness now = stages_.stress->stiffness(state.particles, 0, state.particles.size());
  state.rates = {now.wave_speed, now.kinematic_viscosity, state.rates.advection_rate, now.relaxation_rate};
}

/// @param limit what bounds steps, this one too unless a frame cuts it short
template <int D, int V>
void Simulation<D, V>::advance(double dt, mpm::Limit limit) {
  try {
    mpm::step(state, stages_, dt, threads_);
  } catch (const mpm::OutsideMesh& error) {
    const bool is_to_stop = stages_.leaving == mpm::Leaving::stop;
    throw RunError{error.what() + (is_to_stop ? leaving_text(state.particles, grid(), clock.time + dt)
                                              : step_remedy(scene_, limit))};
  } catch (const RunError& error) {
    throw RunError{error.what() + step_remedy(scene_, limit)};
  }
}

template <int D, int V>
void Simulation<D, V>::pass_material() {
  for (std::size_t i = 0; i < streams.inflows.size(); ++i) {
    if (mpm::take_in(state, stages_, streams.inflows[i], clock.moved, threads_)) look_for_blocked(i);
  }
  for (std::size_t i = 0; i < streams.outflows.size(); ++i) {
    streams.taken[i] += mpm::take_out(state, streams.outflows[i], stages_.balanced);
  }
}

/// Where a layer has entered, so that it costs little beside the sorting of all points.
template <int D, int V>
void Simulation<D, V>::look_for_blocked(std::size_t number) {
  if (is_blocked_[number]) return;
  const std::string text =
      blocked_warning(scene_, number, streams.inflows[number].layer(), state, stages_, clock.moved);
  if (text.empty()) return;
  is_blocked_[number] = true;
  warning_ += (warning_.empty() ? "" : "; ") + text;
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
  if (mixture_) mixture_->update(state.particles);  // by the constants of this scene
  const double every = scene_.output.every;         // of this scene, too
  while (clock.frame > 1 && static_cast<double>(clock.frame - 1) * every > clock.time) --clock.frame;
  while (static_cast<double>(clock.frame) * every <= clock.time) ++clock.frame;
  if (num_points() == 0) state.needs_sort = true;  // as count_updates() left it
  if (instability_now().empty()) return;
  renew_rates();
  const std::string unstable = instability_now();
  require(unstable.empty(), unstable);
}

template <int D, int V>
bool Simulation<D, V>::step() {
  if (is_finished()) {
    throw InputError{"the run has reached its end, [time] end = " + io::to_text(scene_.end) +
                     ": no step is left"};
  }
  mpm::TimeStep next = next_step();
  require_progress(next);
  const mpm::Limit limit = next.limit;
  const double left = next_frame_time() - clock.time;
  const bool reaches_frame = left <= next.dt;
  if (reaches_frame) next = {left, mpm::Limit::output};
  advance(next.dt, limit);
  clock.moved += next.dt;
  pass_material();
  count_updates();
  if (crushing_ && crushing_->advance(state.particles)) follow_grains();
  clock.time = reaches_frame ? next_frame_time() : clock.time + next.dt;
  ++clock.step;
  if (reaches_frame) ++clock.frame;
  if (coupling_) {
    clock.unsegregated_time += next.dt;
    ++clock.unsegregated_steps;
  }
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
    if (stages_.node_means) stages_.node_means->require_inputs(state.particles);
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
