#include "scree/assemble/streams.hpp"

#include "scree/scene/axes.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/law_columns.hpp"
#include "scree/scene/vector_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace scree::app {

namespace {

template <int D>
[[nodiscard]] bool is_in_box(const InflowScene& inflow, const Vector<D>& x) {
  return (vector_of<D>(inflow.low).array() <= x.array()).all() &&
         (x.array() <= vector_of<D>(inflow.high).array()).all();
}

/// Mean density by volume of the points that weigh something, in a box or, without one, all [kg/m^3]; 0 of
/// none.
template <int D, int V>
[[nodiscard]] double mean_density(const mpm::Particles<D, V>& particles,
                                  const std::optional<mpm::Outflow<D>>& box) {
  double mass = 0;
  double volume = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double m = particles.mass.component(0)[p];
    bool counts = m > 0;
    for (int d = 0; d < D && box && counts; ++d) {
      const double x = particles.position.component(d)[p];
      counts = box->low[d] <= x && x <= box->high[d];
    }
    if (!counts) continue;
    mass += m;
    volume += m / particles.density.component(0)[p];
  }
  return volume > 0 ? mass / volume : 0;
}

/// The cells against the face that a stream leaves its box by.
template <int D, int V>
[[nodiscard]] mpm::Outflow<D> cells_before(const mpm::Stream<D, V>& stream, const CartesianGrid<D>& grid) {
  const int axis = mpm::axis_of(stream);
  mpm::Outflow<D> cells{stream.low, stream.high};
  if (stream.velocity[static_cast<std::size_t>(axis)] > 0) {
    cells.low[axis] = stream.high[axis];
    cells.high[axis] = stream.high[axis] + grid.spacing()[axis];
  } else {
    cells.high[axis] = stream.low[axis];
    cells.low[axis] = stream.low[axis] - grid.spacing()[axis];
  }
  return cells;
}

/// By how much waves and weight alone make a stream denser: what it runs into may stop it, and material may
/// heap up before it to the top of the mesh [-].
template <int D, int V>
[[nodiscard]] double harmless_compression(const Scene& scene, const mpm::Stream<D, V>& stream,
                                          const CartesianGrid<D>& grid, const mpm::Particles<D, V>& layer,
                                          const mpm::Stages<D, V>& stages) {
  const double sound = stages.stress->stiffness(layer, 0, layer.size()).wave_speed;
  const double speed = std::abs(stream.velocity[static_cast<std::size_t>(mpm::axis_of(stream))]);
  const int normal = normal_component(D);
  const double height = grid.origin()[normal] + grid.length(normal) - stream.low[normal];
  const double gravity = std::abs(stages.gravity[static_cast<std::size_t>(normal)]);
  const double modulus = std::min(bulk_modulus_of(scene.law), stream.density * sound * sound);
  return speed / sound + stream.density * gravity * height / modulus;
}

}  // namespace

template <int D, int V>
Index Streams<D, V>::num_passed() const {
  Index sum = 0;
  for (const auto& inflow : inflows) sum += inflow.num_layers() * inflow.layer().size();
  for (const auto& one : taken) sum += one.count;
  return sum;
}

template <int D, int V>
mpm::Stream<D, V> stream_of(const Scene& scene, const InflowScene& inflow) {
  mpm::Stream<D, V> stream;
  stream.low = vector_of<D>(inflow.low);
  stream.high = vector_of<D>(inflow.high);
  std::copy_n(inflow.velocity.begin(), V, stream.velocity.begin());
  stream.density = std::visit([](const auto& law) { return law.density; }, scene.law);
  stream.per_cell.fill(inflow.points_per_cell);
  stream.start = inflow.start;
  stream.stop = inflow.stop;
  return stream;
}

template <int D>
std::vector<mpm::Outflow<D>> outflows_of(const Scene& scene, const CartesianGrid<D>& grid) {
  std::vector<mpm::Outflow<D>> outflows;
  for (const OutflowScene& one : scene.outflows) {
    outflows.push_back({vector_of<D>(one.low), vector_of<D>(one.high)});
    mpm::check(outflows.back(), grid);
  }
  return outflows;
}

template <int D>
double surface_above(const Scene& scene, const Filling<D>& filling, const Vector<D>& x) {
  const auto normal = static_cast<std::size_t>(normal_component(D));
  for (const InflowScene& inflow : scene.inflows) {
    if (!is_in_box<D>(inflow, x)) continue;
    return inflow.velocity[normal] == 0 ? inflow.high[normal] : x[static_cast<int>(normal)];
  }
  return filling.top_above(x);
}

template <int D, int V>
void require_clear_of_streams(const Scene& scene, const mpm::Particles<D, V>& material) {
  for (std::size_t i = 0; i < scene.inflows.size(); ++i) {
    for (Index p = 0; p < material.size(); ++p) {
      Vector<D> x;
      for (int d = 0; d < D; ++d) x[d] = material.position.component(d)[p];
      if (!is_in_box<D>(scene.inflows[i], x)) continue;
      throw InputError{fmt::format(
          "[[inflow]] {}: [material] begins in its box, at ({:.6g}) m: leave the box to the stream", i + 1,
          fmt::join(x.begin(), x.end(), ", "))};
    }
  }
}

std::string too_thin_streams(const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.inflows.size(); ++i) {
    if (scene.inflows[i].points_per_cell >= 2) continue;
    text += fmt::format(
        "{}[[inflow]] {} has a single point along each axis of a cell, and comes apart as soon as it speeds "
        "up: give it more points_per_cell",
        text.empty() ? "" : "; ", i + 1);
  }
  return text;
}

template <int D, int V>
std::string blocked_warning(const Scene& scene, std::size_t number, const mpm::Particles<D, V>& layer,
                            const mpm::State<D, V>& state, const mpm::Stages<D, V>& stages, double time) {
  constexpr double pushed = 0.1;  // [-], by which what has no room is to be squeezed
  const CartesianGrid<D>& grid = state.nodes.grid();
  const mpm::Stream<D, V> stream = stream_of<D, V>(scene, scene.inflows[number]);
  const mpm::Outflow<D> cells = cells_before(stream, grid);
  const double compression = mean_density<D, V>(state.particles, cells) / mean_density<D, V>(layer, {}) - 1;
  if (!(compression >= pushed + harmless_compression(scene, stream, grid, layer, stages))) return {};
  const Vector<D> middle = (cells.low + cells.high) / 2;
  return fmt::format(
      "[[inflow]] {}: at t = {:.4g} s the material before its box, at ({:.4g}) m, is {:.0f} % denser than "
      "the stream: it is blocked, and all that enters is squeezed into the room that there is: let it out, "
      "by an [[outflow]] or an end that is open, or stop the stream before",
      number + 1, time, fmt::join(middle.begin(), middle.end(), ", "), 100 * compression);
}

#define SCREE_INSTANCE(D, V)                                                                   \
  template struct Streams<D, V>;                                                               \
  template mpm::Stream<D, V> stream_of(const Scene&, const InflowScene&);                      \
  template void require_clear_of_streams(const Scene&, const mpm::Particles<D, V>&);           \
  template std::string blocked_warning(const Scene&, std::size_t, const mpm::Particles<D, V>&, \
                                       const mpm::State<D, V>&, const mpm::Stages<D, V>&, double);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
template std::vector<mpm::Outflow<1>> outflows_of(const Scene&, const CartesianGrid<1>&);
template std::vector<mpm::Outflow<2>> outflows_of(const Scene&, const CartesianGrid<2>&);
template std::vector<mpm::Outflow<3>> outflows_of(const Scene&, const CartesianGrid<3>&);
template double surface_above(const Scene&, const Filling<1>&, const Vector<1>&);
template double surface_above(const Scene&, const Filling<2>&, const Vector<2>&);
template double surface_above(const Scene&, const Filling<3>&, const Vector<3>&);

}  // namespace scree::app
