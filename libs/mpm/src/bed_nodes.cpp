#include <scree/mpm/terrain/bed_nodes.hpp>

#include <algorithm>
#include <cmath>

namespace scree::mpm {

namespace {

/// Samples of the surface along each edge of a cell.
template <int D>
inline constexpr Index samples_per_edge = D == 3   ? 4
                                          : D == 2 ? 8
                                                   : 16;

/// How far from the surface, along its normal, a box of these edges reaches that is centred on it [m].
template <int D>
[[nodiscard]] double reach(const Vector<D>& normal, const Vector<D>& edges) {
  return normal.cwiseAbs().dot(edges);
}

/// Adds what the nodes of a cell stand for: the sum over samples of hat functions times a delta function of
/// the distance, as wide as makes its sum exact for planes, \cite engquist2005.
/// @param depth_at_place of the flow, at a place of the bed [m]
template <int D, class DepthAtPlace>
void add_areas(const AnySurface<D>& surface, const DepthAtPlace& depth_at_place, const Vector<D>& low,
               const Vector<D>& spacing, const std::array<Index, std::size_t{1} << D>& corners,
               std::vector<double>& areas) {
  constexpr Index m = samples_per_edge<D>;
  Lattice<D> samples;
  samples.count.fill(m);
  samples.spacing = spacing / static_cast<double>(m);
  samples.first = low + samples.spacing / 2;
  for (Index s = 0; s < samples.num_sites(); ++s) {
    const Vector<D> x = samples.position(samples.site(s));
    const FromSurface<D> seen = surface(x);
    const double width = reach<D>(seen.normal, samples.spacing);
    const double closeness = 1 - std::abs(seen.distance) / width;
    if (!(closeness > 0)) continue;
    const Vector<D> on_bed = x - seen.distance * seen.normal;
    const Vector<D> xi =
        (on_bed - low).cwiseQuotient(spacing).cwiseMax(Vector<D>::Zero()).cwiseMin(Vector<D>::Ones());
    const double area = depth_at_place(on_bed) * closeness / width * samples.spacing.prod();
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      double weight = 1;
      for (int axis = 0; axis < D; ++axis) weight *= (corner >> axis) & 1 ? xi[axis] : 1 - xi[axis];
      areas[static_cast<std::size_t>(corners[corner])] += weight * area;
    }
  }
}

template <int D>
[[nodiscard]] std::vector<double> areas_of(const CartesianGrid<D>& grid, const Nodes<D>& nodes,
                                           const AnySurface<D>& surface, Symmetry symmetry) {
  const auto depth_at_place = [&](const Vector<D>& x) { return depth_at(symmetry, grid, x); };
  std::vector<double> areas(static_cast<std::size_t>(nodes.num_nodes()), 0.0);
  const Lattice<D> cells = grid.cells();
  for (Index c = 0; c < cells.num_sites(); ++c) {
    const Indices<D> cell = cells.site(c);
    const Vector<D> centre = cells.position(cell);
    const FromSurface<D> seen = surface(centre);
    if (!(std::abs(seen.distance) <= grid.spacing().norm())) continue;
    std::array<Index, std::size_t{1} << D> corners{};
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        const Index node = cell[axis] + static_cast<Index>((corner >> axis) & 1);
        corners[corner] += nodes.place(node, axis) * nodes.stride(axis);
      }
    }
    add_areas<D>(surface, depth_at_place, centre - grid.spacing() / 2, grid.spacing(), corners, areas);
  }
  return areas;
}

}  // namespace

template <int D>
Vector<D> node_position(const Nodes<D>& nodes, Index node) {
  Vector<D> x = nodes.grid().origin();
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Index place = node / nodes.stride(axis) % nodes.count(axis) + nodes.first(axis);
    x[static_cast<int>(axis)] += static_cast<double>(place) * nodes.grid().spacing()[static_cast<int>(axis)];
  }
  return x;
}

template <int D>
std::vector<BedNode> bed_nodes(const CartesianGrid<D>& grid, const AnySurface<D>& surface,
                               Symmetry symmetry) {
  const Nodes<D> nodes{grid, {.num_velocities = 1, .has_increment = false}};
  const std::vector<double> areas = areas_of(grid, nodes, surface, symmetry);
  const double least = least_area_share * grid.spacing().prod() / grid.spacing().maxCoeff();
  const double rounding = 1e-9;  // [-], of the reach: a bed through nodes does not reach the next ones
  std::vector<BedNode> result;
  for (Index n = 0; n < nodes.num_nodes(); ++n) {
    const FromSurface<D> seen = surface(node_position(nodes, n));
    if (!(seen.distance < (1 - rounding) * reach<D>(seen.normal, grid.spacing()))) continue;
    Vector<3> normal = Vector<3>::Zero();
    normal.template head<D>() = seen.normal;
    result.push_back({n, normal, std::max(areas[static_cast<std::size_t>(n)], least)});
  }
  require(!result.empty(), "bed_nodes: the bed reaches no node of the mesh");
  return result;
}

template Vector<1> node_position(const Nodes<1>&, Index);
template std::vector<BedNode> bed_nodes(const CartesianGrid<1>&, const AnySurface<1>&, Symmetry);
template Vector<2> node_position(const Nodes<2>&, Index);
template std::vector<BedNode> bed_nodes(const CartesianGrid<2>&, const AnySurface<2>&, Symmetry);
template Vector<3> node_position(const Nodes<3>&, Index);
template std::vector<BedNode> bed_nodes(const CartesianGrid<3>&, const AnySurface<3>&, Symmetry);

}  // namespace scree::mpm
