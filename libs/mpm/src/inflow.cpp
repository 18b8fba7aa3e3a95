#include "instances.hpp"
#include "step_phases.hpp"

#include <scree/mpm/append.hpp>
#include <scree/mpm/inflow.hpp>
#include <scree/mpm/seed.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace scree::mpm {

namespace {

constexpr double slack = 1e-6;  // [-], of a spacing: places are sums of few roundings of the mesh's length

[[nodiscard]] bool is_whole(double number) {
  return std::abs(number - std::round(number)) <= slack;
}

template <int D, int V>
void check(const Stream<D, V>& stream, const CartesianGrid<D>& grid) {
  const int axis = axis_of(stream);
  require(!grid.is_periodic()[static_cast<std::size_t>(axis)],
          "Stream: the axis that it runs along must not be periodic");
  const double low = (stream.low[axis] - grid.origin()[axis]) / grid.spacing()[axis];
  const double high = (stream.high[axis] - grid.origin()[axis]) / grid.spacing()[axis];
  require(is_whole(low) && is_whole(high), "Stream: along the stream the box must begin and end on nodes");
  require(high - low >= 2 - slack, "Stream: along the stream the box must be at least two cells long");
  require(std::isfinite(stream.start) && stream.stop > stream.start, "Stream: it must begin before it ends");
}

/// Points of the box between two places along the stream.
template <int D, int V>
[[nodiscard]] Particles<D, V> seed_part(const Stream<D, V>& stream, const CartesianGrid<D>& grid, double low,
                                        double high) {
  check(stream, grid);
  const int axis = axis_of(stream);
  Vector<D> lowest = stream.low;
  Vector<D> highest = stream.high;
  lowest[axis] = low;
  highest[axis] = high;
  auto particles = seed_box<D, V>(grid, lowest, highest, stream.per_cell, stream.density);
  for (int i = 0; i < V; ++i) {
    double* const velocity = particles.velocity.component(i);
    std::fill_n(velocity, particles.size(), stream.velocity[static_cast<std::size_t>(i)]);
  }
  return particles;
}

/// Distance between layers [m].
template <int D, int V>
[[nodiscard]] double thickness_of(const Stream<D, V>& stream, const CartesianGrid<D>& grid) {
  const int axis = axis_of(stream);
  return grid.spacing()[axis] / static_cast<double>(stream.per_cell[static_cast<std::size_t>(axis)]);
}

template <int D, int V>
[[nodiscard]] bool runs_upward(const Stream<D, V>& stream) {
  return stream.velocity[static_cast<std::size_t>(axis_of(stream))] > 0;
}

/// Speed along its axis [m/s].
template <int D, int V>
[[nodiscard]] double speed_of(const Stream<D, V>& stream, int axis) {
  return std::abs(stream.velocity[static_cast<std::size_t>(axis)]);
}

/// Nodes of one axis, their places in Nodes, that a part of it reaches.
template <int D>
[[nodiscard]] std::vector<Index> places_between(const Nodes<D>& nodes, int axis, double low, double high) {
  const auto a = static_cast<std::size_t>(axis);
  std::vector<Index> places;
  for (Index node = nodes.first(a); node < nodes.first(a) + nodes.count(a); ++node) {
    const double x = static_cast<double>(node);
    const double period = nodes.grid().is_periodic()[a] ? static_cast<double>(nodes.count(a)) : 0;
    const bool is_reached = (low < x && x < high) || (low < x - period && x - period < high) ||
                            (low < x + period && x + period < high);
    if (is_reached) places.push_back(nodes.place(node, a));
  }
  return places;
}

template <int D, int V>
[[nodiscard]] std::vector<Index> held_nodes(const Stream<D, V>& stream, const CartesianGrid<D>& grid,
                                            double reach) {
  const Nodes<D> nodes{grid, {.num_velocities = 1, .has_increment = false}};
  const int along = axis_of(stream);
  std::vector<Index> held{0};
  for (int axis = 0; axis < D; ++axis) {
    double low = (stream.low[axis] - grid.origin()[axis]) / grid.spacing()[axis] - reach + slack;
    double high = (stream.high[axis] - grid.origin()[axis]) / grid.spacing()[axis] + reach - slack;
    if (axis == along && runs_upward(stream)) high += 2 * slack - reach;
    if (axis == along && !runs_upward(stream)) low += reach - 2 * slack;
    std::vector<Index> longer;
    for (const Index place : places_between(nodes, axis, low, high)) {
      for (const Index node : held) {
        longer.push_back(node + place * nodes.stride(static_cast<std::size_t>(axis)));
      }
    }
    held = std::move(longer);
  }
  return held;
}

template <int D>
class InflowHold final : public Boundary<D> {
 public:
  InflowHold(std::vector<Index> held, const std::array<double, 3>& velocity, double start, double stop)
      : held_{std::move(held)}, velocity_{velocity}, start_{start}, stop_{stop} {}

  void fold(Nodes<D>& /*nodes*/, const double* /*gravity*/, double /*dt*/) const noexcept override {}
  void hold(Nodes<D>& nodes, double /*dt*/) const noexcept override { set_velocity(nodes); }
  /// Images too: what walls beside the stream made of them does not hold here.
  void reflect(Nodes<D>& nodes) const noexcept override { set_velocity(nodes); }
  void advance(double dt) noexcept override { time_ += dt; }

 private:
  /// A node that is held does not change: a point keeps its velocity under increments too.
  void set_velocity(Nodes<D>& nodes) const noexcept {
    if (!(start_ <= time_ && time_ < stop_)) return;
    const NodeRecord layout = nodes.record();
    for (const Index n : held_) {
      double* const node = nodes[n];
      if (!(node[NodeRecord::mass] > 0)) continue;
      for (int i = 0; i < layout.num_velocities; ++i) {
        node[NodeRecord::momentum + i] = velocity_[static_cast<std::size_t>(i)];
        if (layout.has_increment) node[layout.increment() + i] = 0;
      }
    }
  }

  std::vector<Index> held_;
  std::array<double, 3> velocity_;  // [m/s]
  double start_;                    // [s]
  double stop_;                     // [s]
  double time_ = 0;                 // [s]
};

}  // namespace

template <int D, int V>
int axis_of(const Stream<D, V>& stream) {
  int axis = -1;
  int count = 0;
  for (int i = 0; i < V; ++i) {
    const double v = stream.velocity[static_cast<std::size_t>(i)];
    require(std::isfinite(v), "Stream: the velocity must be finite");
    if (i >= D || v == 0) continue;
    axis = i;
    ++count;
  }
  require(count == 1, "Stream: the velocity must lie along one axis of the mesh");
  return axis;
}

template <int D, int V>
Particles<D, V> fill_box(const Stream<D, V>& stream, const CartesianGrid<D>& grid) {
  const int axis = axis_of(stream);
  return seed_part(stream, grid, stream.low[axis], stream.high[axis]);
}

template <int D, int V>
Particles<D, V> first_layer(const Stream<D, V>& stream, const CartesianGrid<D>& grid) {
  const int axis = axis_of(stream);
  require(stream.per_cell[static_cast<std::size_t>(axis)] >= 1,
          "Stream: each cell must get at least one point along each axis");
  const double thickness = thickness_of(stream, grid);
  return runs_upward(stream) ? seed_part(stream, grid, stream.low[axis], stream.low[axis] + thickness)
                             : seed_part(stream, grid, stream.high[axis] - thickness, stream.high[axis]);
}

template <int D, int V>
Inflow<D, V>::Inflow(const Stream<D, V>& stream, const CartesianGrid<D>& grid, Particles<D, V> layer)
    : stream_{stream},
      axis_{axis_of(stream)},
      thickness_{thickness_of(stream, grid)},
      upstream_{runs_upward(stream) ? stream.low[axis_] : stream.high[axis_]},
      layer_{std::move(layer)} {
  check(stream, grid);
  require(layer_.size() > 0, "Inflow: a layer must have points");
}

template <int D, int V>
Passed<V> Inflow<D, V>::entered() const {
  Passed<V> all;
  const auto num_layers = static_cast<double>(num_layers_);
  for (Index p = 0; p < layer_.size(); ++p) count_point(layer_, p, std::nullopt, all);
  all.count *= num_layers_;
  all.mass *= num_layers;
  for (double& momentum : all.momentum) momentum *= num_layers;
  return all;
}

template <int D, int V>
Index Inflow<D, V>::num_due(double time) const noexcept {
  const double way = speed_of(stream_, axis_) * (std::min(time, stream_.stop) - stream_.start);
  if (!(way > 0)) return 0;
  return std::max<Index>(static_cast<Index>(std::floor(way / thickness_)) - num_layers_, 0);
}

template <int D, int V>
Particles<D, V> Inflow<D, V>::next(double time) {
  Particles<D, V> points = layer_;
  ++num_layers_;
  const double way = speed_of(stream_, axis_) * (time - stream_.start);
  const double inward = way - (static_cast<double>(num_layers_) - 0.5) * thickness_;
  const double place = runs_upward(stream_) ? upstream_ + inward : upstream_ - inward;
  std::fill_n(points.position.component(axis_), points.size(), place);
  return points;
}

template <int D, int V>
double Inflow<D, V>::longest_step(double time) const noexcept {
  if (!(time < stream_.stop)) return std::numeric_limits<double>::infinity();
  return std::max(stream_.start - time, 0.0) + thickness_ / speed_of(stream_, axis_);
}

template <int D, int V>
bool take_in(State<D, V>& state, const Stages<D, V>& stages, Inflow<D, V>& inflow, double time,
             Threads threads) {
  const Index num_due = inflow.num_due(time);
  if (num_due == 0) return false;
  require_columns(state.particles, inflow.layer());
  stages.stress->require_inputs(inflow.layer());
  if (stages.node_means) stages.node_means->require_inputs(inflow.layer());
  for (Index layer = 0; layer < num_due; ++layer) {
    Particles<D, V> points = inflow.next(time);
    for (double& id : points.id.values()) id = state.next_id++;
    append(state.particles, points);
  }
  const Particles<D, V>& layer = inflow.layer();
  const auto masses = layer.mass.values();
  state.mass_floor =
      std::max(state.mass_floor, stages.mass_floor * *std::max_element(masses.begin(), masses.end()));
  detail::widen_rates(state.rates, layer, stages, state.nodes.grid());
  detail::sort(state, stages, threads);
  return true;
}

template <int D, int V>
std::unique_ptr<Boundary<D>> make_inflow_hold(const Stream<D, V>& stream, const CartesianGrid<D>& grid,
                                              double reach) {
  check(stream, grid);
  std::array<double, 3> velocity{};
  std::copy(stream.velocity.begin(), stream.velocity.end(), velocity.begin());
  return std::make_unique<InflowHold<D>>(held_nodes(stream, grid, reach), velocity, stream.start,
                                         stream.stop);
}

template <int D>
using OwnedBoundary = std::unique_ptr<Boundary<D>>;

#define SCREE_INSTANCE(D, V)                                                                \
  template int axis_of(const Stream<D, V>&);                                                \
  template Particles<D, V> fill_box(const Stream<D, V>&, const CartesianGrid<D>&);          \
  template Particles<D, V> first_layer(const Stream<D, V>&, const CartesianGrid<D>&);       \
  template class Inflow<D, V>;                                                              \
  template bool take_in(State<D, V>&, const Stages<D, V>&, Inflow<D, V>&, double, Threads); \
  template OwnedBoundary<D> make_inflow_hold(const Stream<D, V>&, const CartesianGrid<D>&, double);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
