#include "scree/streams.hpp"

#include "scree/axes.hpp"
#include "scree/dimensions.hpp"
#include "scree/vector_of.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace scree::app {

namespace {

template <int D>
[[nodiscard]] bool is_in_box(const InflowScene& inflow, const Vector<D>& x) {
  return (vector_of<D>(inflow.low).array() <= x.array()).all() &&
         (x.array() <= vector_of<D>(inflow.high).array()).all();
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

#define SCREE_INSTANCE(D, V)                                              \
  template struct Streams<D, V>;                                          \
  template mpm::Stream<D, V> stream_of(const Scene&, const InflowScene&); \
  template void require_clear_of_streams(const Scene&, const mpm::Particles<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
template std::vector<mpm::Outflow<1>> outflows_of(const Scene&, const CartesianGrid<1>&);
template std::vector<mpm::Outflow<2>> outflows_of(const Scene&, const CartesianGrid<2>&);
template std::vector<mpm::Outflow<3>> outflows_of(const Scene&, const CartesianGrid<3>&);
template double surface_above(const Scene&, const Filling<1>&, const Vector<1>&);
template double surface_above(const Scene&, const Filling<2>&, const Vector<2>&);
template double surface_above(const Scene&, const Filling<3>&, const Vector<3>&);

}  // namespace scree::app
