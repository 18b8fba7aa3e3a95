#include "polygon_checks.hpp"

#include <scree/transport/grids/polygonal_mesh.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace scree::transport {
namespace {

constexpr int hilbert_levels = 16;  // 65536 places along each axis

/// The place of a point along a Hilbert curve that fills the unit square, x and y in [0, 2^levels).
[[nodiscard]] std::uint64_t hilbert_place(std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  for (std::uint32_t s = 1U << (hilbert_levels - 1); s > 0; s /= 2) {
    const bool right = (x & s) != 0;
    const bool top = (y & s) != 0;
    const std::uint64_t quadrant = right ? (top ? 2 : 3) : (top ? 1 : 0);
    place += quadrant * s * s;
    if (!top) {  // the lower quadrants are mirrored
      if (right) {
        x = ~x & (s - 1);
        y = ~y & (s - 1);
      }
      std::swap(x, y);
    }
  }
  return place;
}

}  // namespace

std::vector<Index> hilbert_order(const PolygonalMesh& mesh) {
  std::vector<Vector<2>> middles;
  Vector<2> low = Vector<2>::Constant(std::numeric_limits<double>::infinity());
  Vector<2> high = -low;
  for (Index cell = 0; cell < mesh.num_cells(); ++cell) {
    middles.push_back(detail::middle_of(mesh, cell));
    low = low.cwiseMin(middles.back());
    high = high.cwiseMax(middles.back());
  }
  const double scale = ((1U << hilbert_levels) - 1) / std::max((high - low).maxCoeff(), 1e-300);
  std::vector<std::uint64_t> places;
  for (const Vector<2>& middle : middles) {
    const Vector<2> scaled = scale * (middle - low);
    places.push_back(
        hilbert_place(static_cast<std::uint32_t>(scaled[0]), static_cast<std::uint32_t>(scaled[1])));
  }
  std::vector<Index> order(middles.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return places[static_cast<std::size_t>(a)] < places[static_cast<std::size_t>(b)];
  });
  return order;
}

PolygonalMesh reordered(const PolygonalMesh& mesh, std::span<const Index> order) {
  PolygonalMesh result;
  result.boundary_names = mesh.boundary_names;
  result.periodic_pairs = mesh.periodic_pairs;
  std::vector<Index> new_number(mesh.vertices.size(), -1);
  const auto renumber = [&](Index vertex) {
    Index& number = new_number[static_cast<std::size_t>(vertex)];
    if (number < 0) {
      number = static_cast<Index>(result.vertices.size());
      result.vertices.push_back(mesh.vertices[static_cast<std::size_t>(vertex)]);
    }
    return number;
  };
  std::vector<Index> polygon;
  for (const Index cell : order) {
    polygon.clear();
    for (const Index corner : mesh.cell(cell)) polygon.push_back(renumber(corner));
    result.add_cell(polygon);
  }
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    result.boundary_edges.push_back({renumber(edge.from), renumber(edge.to), edge.boundary});
  }
  return result;
}

}  // namespace scree::transport
