#include "instances.hpp"

#include <scree/error.hpp>
#include <scree/mpm/cell_means.hpp>
#include <scree/mpm/point_transfer.hpp>

#include <algorithm>
#include <cmath>

namespace scree::mpm {

namespace {

/// Number of the cell that holds a point; the last one of an axis holds its end too.
template <int D, int V>
[[nodiscard]] Index cell_of(const Particles<D, V>& particles, Index p,
                            const CartesianGrid<D>& grid) noexcept {
  Index cell = 0;
  for (int axis = D; axis-- > 0;) {
    const Index count = grid.num_cells()[static_cast<std::size_t>(axis)];
    const double x = particles.position.component(axis)[p];
    auto place =
        static_cast<Index>(std::floor(coordinate(x, grid.origin()[axis], 1 / grid.spacing()[axis], 0.0)));
    if (place < 0 || place >= count) {
      const bool is_periodic = grid.is_periodic()[static_cast<std::size_t>(axis)];
      place = is_periodic ? (place % count + count) % count : std::clamp(place, Index{0}, count - 1);
    }
    cell = cell * count + place;
  }
  return cell;
}

template <int D, int V>
[[nodiscard]] double trace_of(const Column& tensor, Index p) noexcept {
  double trace = 0;
  for (int j = 0; j < D; ++j) trace += tensor.component(j + V * j)[p];
  return trace;
}

}  // namespace

template <int D>
template <int V>
void CellMeans<D>::average_trace(const Particles<D, V>& particles, Column& tensor,
                                 const ParticleBlocks<D>& blocks, const CartesianGrid<D>& grid,
                                 Threads threads) {
  SCREE_ASSERT(static_cast<Index>(cells_.size()) == grid.cells().num_sites());
  const auto for_each_point = [&](auto&& body) {  // blocks of one colour share no cell, as they share no node
    blocks.for_each_coloured(threads, [&](Index b) {
      const ParticleBlock<D>& block = blocks.blocks[static_cast<std::size_t>(b)];
      for (Index p = block.begin; p < block.end; ++p) {
        body(p, cells_[static_cast<std::size_t>(cell_of_[static_cast<std::size_t>(p)])]);
      }
    });
  };
  blocks.for_each(threads, [&](Index b) {
    const ParticleBlock<D>& block = blocks.blocks[static_cast<std::size_t>(b)];
    for (Index p = block.begin; p < block.end; ++p) {
      cell_of_[static_cast<std::size_t>(p)] = cell_of<D, V>(particles, p, grid);
    }
  });
  for_each_point([](Index, Sum& cell) { cell = {}; });
  for_each_point([&](Index p, Sum& cell) {
    const double volume = particles.mass.component(0)[p] / particles.density.component(0)[p];
    cell.volume += volume;
    cell.trace += volume * trace_of<D, V>(tensor, p);
  });
  for_each_point([&](Index p, const Sum& cell) {
    if (!(cell.volume > 0)) return;  // points of mass zero only
    const double change = (cell.trace / cell.volume - trace_of<D, V>(tensor, p)) / D;
    for (int j = 0; j < D; ++j) tensor.component(j + V * j)[p] += change;
  });
}

// NOLINTBEGIN(bugprone-macro-parentheses): D and V are template arguments
#define SCREE_INSTANCE(D, V)                                                                              \
  template void CellMeans<D>::average_trace<V>(const Particles<D, V>&, Column&, const ParticleBlocks<D>&, \
                                               const CartesianGrid<D>&, Threads);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace scree::mpm
