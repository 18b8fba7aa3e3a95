#include "instances.hpp"
#include "places.hpp"

#include <scree/rheology_stiff/viscous_operator.hpp>

#include <algorithm>

namespace scree::rheology {

using detail::at;

template <int D, int V>
ViscousOperator<D, V>::ViscousOperator(const CartesianGrid<D>& grid, Quadrature quadrature, Threads threads)
    : grid_{grid}, cell_{make_cell_stiffness<D, V>(grid.spacing(), quadrature)}, threads_{threads} {
  for (int corner = 0; corner < num_corners; ++corner) {
    columns_[at(corner)] = cell_.matrix.template middleCols<V>(corner * V);
  }
  const Lattice<D> nodes = grid.nodes();
  const Lattice<D> cells = grid.cells();
  for (int axis = 0; axis < D; ++axis) {
    const Index num_nodes_along = nodes.count[at(axis)];
    const Index num_cells_along = cells.count[at(axis)];
    const auto place = [&](Index i, Index count, Index stride) {
      if (grid.is_periodic()[at(axis)]) return (i + count) % count * stride;
      return 0 <= i && i < count ? i * stride : -1;
    };
    for (Index i = 0; i < num_nodes_along; ++i) {
      const auto node = [&](Index n) { return place(n, num_nodes_along, nodes.stride(axis)); };
      const auto cell = [&](Index c) { return place(c, num_cells_along, cells.stride(axis)); };
      places_[at(axis)].push_back({{node(i - 1), node(i), node(i + 1)}, {cell(i - 1), cell(i)}});
    }
  }
}

/// Calls begin(node), then body(node, cell, corner, corners of that cell) for each cell round it, then
/// end(node).
template <int D, int V>
template <class Begin, class Body, class End>
void ViscousOperator<D, V>::for_each_neighbour(Begin&& begin, Body&& body, End&& end) const noexcept {
  const Index length = static_cast<Index>(places_[0].size());
  for_each_block(num_nodes() / length, threads_, [&](Index line) {
    std::array<const Place*, D> place{};
    Index rest = line;
    Index first_node = 0;
    for (std::size_t axis = 1; axis < D; ++axis) {
      const auto count = static_cast<Index>(places_[axis].size());
      place[axis] = &places_[axis][at(rest % count)];
      first_node += place[axis]->node[1];
      rest /= count;
    }
    for (Index i = 0; i < length; ++i) {
      place[0] = &places_[0][at(i)];
      const Index node = first_node + i;
      auto sum = begin(node);
      for (int corner = 0; corner < num_corners; ++corner) {
        Index cell = 0;
        bool exists = true;
        for (std::size_t axis = 0; axis < D; ++axis) {
          const Index along = place[axis]->cell[1 - ((at(corner) >> axis) & 1)];
          exists = exists && along >= 0;
          cell += along;
        }
        if (!exists) continue;
        std::array<Index, at(num_corners)> nodes;
        for (std::size_t other = 0; other < at(num_corners); ++other) {
          nodes[other] = 0;
          for (std::size_t axis = 0; axis < D; ++axis) {
            const std::size_t step = 1 + ((other >> axis) & 1) - ((at(corner) >> axis) & 1);
            nodes[other] += place[axis]->node[step];
          }
        }
        body(sum, cell, corner, nodes);
      }
      end(node, sum);
    }
  });
}

template <int D, int V>
template <class Load>
void ViscousOperator<D, V>::gather(std::span<const double> mass, std::span<const double> v,
                                   std::span<double> out, Load&& load) const noexcept {
  using Values = Vector<V>;
  for_each_neighbour(
      [&](Index node) -> Values {
        if (mass.empty()) return Values::Zero();
        return mass[at(node)] * Eigen::Map<const Values>(v.data() + node * V);
      },
      [&](Values& sum, Index cell, int corner, const auto& nodes) {
        Element element;
        if (!load(cell, nodes, element)) return;
        sum.noalias() += columns_[at(corner)].transpose() * element;
      },
      [&](Index node, const Values& sum) { Eigen::Map<Values>(out.data() + node * V) = sum; });
}

template <int D, int V>
void ViscousOperator<D, V>::apply(std::span<const double> mass, std::span<const double> weights,
                                  std::span<const double> v, std::span<double> out) const noexcept {
  gather(mass, v, out, [&](Index cell, const auto& nodes, Element& element) {
    const double weight = weights[at(cell)];
    if (weight == 0) return false;
    for (int corner = 0; corner < num_corners; ++corner) {
      element.template segment<V>(corner * V) =
          weight * Eigen::Map<const Vector<V>>(v.data() + nodes[at(corner)] * V);
    }
    return true;
  });
}

template <int D, int V>
void ViscousOperator<D, V>::apply_tangent(std::span<const double> mass, std::span<const double> weights,
                                          std::span<const double> couplings, std::span<const double> u,
                                          std::span<const double> v, std::span<double> out) const noexcept {
  gather(mass, v, out, [&](Index cell, const auto& nodes, Element& element) {
    const double weight = weights[at(cell)];
    const double coupling = couplings[at(cell)];
    if (weight == 0 && coupling == 0) return false;
    for (int corner = 0; corner < num_corners; ++corner) {
      const Index first = nodes[at(corner)] * V;
      element.template segment<V>(corner * V) = weight * Eigen::Map<const Vector<V>>(v.data() + first) +
                                                coupling * Eigen::Map<const Vector<V>>(u.data() + first);
    }
    return true;
  });
}

template <int D, int V>
std::array<Index, static_cast<std::size_t>(1) << D> ViscousOperator<D, V>::corners(
    Index cell) const noexcept {
  std::array<Index, static_cast<std::size_t>(1) << D> nodes{};
  const Indices<D> low = grid_.cells().site(cell);
  for (std::size_t corner = 0; corner < nodes.size(); ++corner) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      nodes[corner] += places_[axis][at(low[axis])].node[1 + ((corner >> axis) & 1)];
    }
  }
  return nodes;
}

template <int D, int V>
void ViscousOperator<D, V>::products(std::span<const double> u, std::span<const double> v,
                                     std::span<double> out) const noexcept {
  const Index length = grid_.num_cells()[0];
  for_each_block(num_cells() / length, threads_, [&](Index line) {
    for (Index cell = line * length; cell < (line + 1) * length; ++cell) {
      const auto nodes = corners(cell);
      Element left;
      Element right;
      for (int corner = 0; corner < num_corners; ++corner) {
        const Index first = nodes[at(corner)] * V;
        left.template segment<V>(corner * V) = Eigen::Map<const Vector<V>>(u.data() + first);
        right.template segment<V>(corner * V) = Eigen::Map<const Vector<V>>(v.data() + first);
      }
      out[at(cell)] = left.dot(cell_.matrix * right);
    }
  });
}

template <int D, int V>
void ViscousOperator<D, V>::diagonal(std::span<const double> weights, std::span<double> out) const noexcept {
  using Values = Vector<V>;
  const Element diagonal = cell_.matrix.diagonal();
  for_each_neighbour([](Index /*node*/) -> Values { return Values::Zero(); },
                     [&](Values& sum, Index cell, int corner, const auto& /*nodes*/) {
                       sum += weights[at(cell)] * diagonal.template segment<V>(corner * V);
                     },
                     [&](Index node, const Values& sum) { Eigen::Map<Values>(out.data() + node * V) = sum; });
}

template <int D, int V>
double ViscousOperator<D, V>::largest_rate(std::span<const double> mass,
                                           std::span<const double> weights) const noexcept {
  double largest = 0;
  for (Index node = 0; node < num_nodes(); ++node) {
    if (!(mass[at(node)] > 0)) continue;
    const Indices<D> site = grid_.nodes().site(node);
    double sum = 0;
    for (std::size_t corner = 0; corner < at(num_corners); ++corner) {
      Index cell = 0;
      bool exists = true;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const Index along = places_[axis][at(site[axis])].cell[(corner >> axis) & 1];
        exists = exists && along >= 0;
        cell += along;
      }
      if (exists) sum += weights[at(cell)];
    }
    largest = std::max(largest, sum / mass[at(node)]);
  }
  return cell_.largest_eigenvalue * largest;
}

#define SCREE_INSTANCE(D, V) template class ViscousOperator<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::rheology
