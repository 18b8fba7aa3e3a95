#include "coarsening.hpp"

#include "places.hpp"

#include <algorithm>
#include <limits>

namespace scree::rheology::detail {

template <int D>
std::optional<CartesianGrid<D>> Coarsening<D>::coarser(const CartesianGrid<D>& fine) {
  const auto can_coarsen = [&](int axis) {
    const Index n = fine.num_cells()[at(axis)];
    return fine.is_periodic()[at(axis)] ? n % 2 == 0 && n > 2 : n > 2;
  };
  double smallest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < D; ++axis) {
    if (can_coarsen(axis)) smallest = std::min(smallest, fine.spacing()[axis]);
  }
  Vector<D> spacing = fine.spacing();
  Indices<D> num_cells = fine.num_cells();
  constexpr double alike = 1.5;  // [-] nearer to 1 than to 2, on a scale of ratios
  for (int axis = 0; axis < D; ++axis) {
    if (!can_coarsen(axis) || spacing[axis] > alike * smallest) continue;
    spacing[axis] *= 2;
    num_cells[at(axis)] = (num_cells[at(axis)] + 1) / 2;
  }
  if (num_cells == fine.num_cells()) return std::nullopt;
  return CartesianGrid<D>{fine.origin(), spacing, num_cells, fine.is_periodic()};
}

template <int D>
Coarsening<D>::Coarsening(const CartesianGrid<D>& fine, const CartesianGrid<D>& coarse)
    : coarse_nodes_{coarse.nodes()} {
  const Lattice<D> fine_nodes = fine.nodes();
  const Lattice<D> fine_cells = fine.cells();
  for (int axis = 0; axis < D; ++axis) {
    const Index count = fine_nodes.count[at(axis)];
    const Index num_cells = fine_cells.count[at(axis)];
    const Index coarse_count = coarse_nodes_.count[at(axis)];
    const bool is_same = num_cells == coarse.num_cells()[at(axis)];
    const auto fine_place = [&](Index i) { return (i + count) % count * fine_nodes.stride(axis); };
    const auto coarse_place = [&](Index i) { return i % coarse_count * coarse_nodes_.stride(axis); };
    const auto exists = [&](Index i) { return fine.is_periodic()[at(axis)] || (0 <= i && i < count); };
    for (Index i = 0; i < count; ++i) {
      if (is_same) {
        parents_[at(axis)].push_back({{coarse_place(i), 0, 0}, {1, 0, 0}});
      } else if (i % 2 == 0) {
        parents_[at(axis)].push_back({{coarse_place(i / 2), 0, 0}, {1, 0, 0}});
      } else {
        parents_[at(axis)].push_back({{coarse_place(i / 2), coarse_place(i / 2 + 1), 0}, {0.5, 0.5, 0}});
      }
    }
    for (Index i = 0; i < coarse_count; ++i) {
      Kin kin;
      if (is_same) {
        kin = {{fine_place(i), 0, 0}, {1, 0, 0}};
      } else {
        const std::array<Index, 3> own{2 * i, 2 * i - 1, 2 * i + 1};
        for (std::size_t n = 0; n < 3; ++n) {
          if (!exists(own[n])) continue;
          kin.place[n] = fine_place(own[n]);
          kin.weight[n] = n == 0 ? 1 : 0.5;
        }
        if (kin.weight[0] == 0) kin.place[0] = fine_place(count - 1);
      }
      children_[at(axis)].push_back(kin);
    }
    for (Index i = 0; i < coarse.num_cells()[at(axis)]; ++i) {
      const Index first = is_same ? i : 2 * i;
      const bool has_second = !is_same && first + 1 < num_cells;
      const Index stride = fine_cells.stride(axis);
      cells_[at(axis)].push_back(
          {{first * stride, has_second ? (first + 1) * stride : 0, 0}, {1, has_second ? 1.0 : 0.0, 0}});
    }
  }
}

/// Calls body(number, number of its kin, weight) for each of its kin.
template <int D>
template <class Body>
void Coarsening<D>::for_each_kin(const Table& table, Body&& body) noexcept {
  constexpr std::size_t num_kin = D == 1 ? 3 : D == 2 ? 9 : 27;
  Index num_sites = 1;
  for (const auto& places : table) num_sites *= static_cast<Index>(places.size());
  for (Index site = 0; site < num_sites; ++site) {
    std::array<const Kin*, D> kin{};
    Index rest = site;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto count = static_cast<Index>(table[axis].size());
      kin[axis] = &table[axis][at(rest % count)];
      rest /= count;
    }
    for (std::size_t n = 0; n < num_kin; ++n) {
      double weight = 1;
      Index other = 0;
      std::size_t which = n;
      for (std::size_t axis = 0; axis < D; ++axis) {
        weight *= kin[axis]->weight[which % 3];
        other += kin[axis]->place[which % 3];
        which /= 3;
      }
      if (weight != 0) body(site, other, weight);
    }
  }
}

template <int D>
template <int V>
void Coarsening<D>::restrict_to(std::span<double> coarse, std::span<const double> fine) const noexcept {
  for_each_kin(children_, [&](Index node, Index child, double weight) {
    for (Index i = 0; i < V; ++i) coarse[at(node * V + i)] += weight * fine[at(child * V + i)];
  });
}

template <int D>
template <int V>
void Coarsening<D>::interpolate(std::span<double> fine, std::span<const double> mask,
                                std::span<const double> coarse) const noexcept {
  for_each_kin(parents_, [&](Index node, Index parent, double weight) {
    for (Index i = 0; i < V; ++i) {
      if (mask[at(node * V + i)] != 0) fine[at(node * V + i)] += weight * coarse[at(parent * V + i)];
    }
  });
}

template <int D>
void Coarsening<D>::sum_cells(std::span<double> coarse, std::span<const double> fine) const noexcept {
  std::ranges::fill(coarse, 0.0);
  for_each_kin(cells_,
               [&](Index cell, Index child, double weight) { coarse[at(cell)] += weight * fine[at(child)]; });
}

template <int D>
Index Coarsening<D>::heir(Index coarse_node) const noexcept {
  const Indices<D> site = coarse_nodes_.site(coarse_node);
  Index result = 0;
  for (std::size_t axis = 0; axis < D; ++axis) result += children_[axis][at(site[axis])].place[0];
  return result;
}

#define SCREE_INSTANCE(D, V)                                                                              \
  template void Coarsening<D>::restrict_to<V>(std::span<double>, std::span<const double>) const noexcept; \
  template void Coarsening<D>::interpolate<V>(std::span<double>, std::span<const double>,                 \
                                              std::span<const double>) const noexcept;
template class Coarsening<1>;
template class Coarsening<2>;
template class Coarsening<3>;
SCREE_INSTANCE(1, 1)
SCREE_INSTANCE(1, 2)
SCREE_INSTANCE(1, 3)
SCREE_INSTANCE(2, 1)
SCREE_INSTANCE(2, 2)
SCREE_INSTANCE(2, 3)
SCREE_INSTANCE(3, 1)
SCREE_INSTANCE(3, 3)
#undef SCREE_INSTANCE

}  // namespace scree::rheology::detail
