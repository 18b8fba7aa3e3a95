#include "instances.hpp"
#include "into_period.hpp"
#include "point_text.hpp"

#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/point_transfer.hpp>
#include <scree/pack_size.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scree::mpm {

namespace {

/// Blocks along each axis, and a numbering of (block, cell in block). A stencil may begin one cell before
/// the mesh: block 0 starts there.
template <int D>
struct Numbering {
  static constexpr Index edge = block_edge<D>;
  Indices<D> num_blocks{};
  Index cells_per_block = 1;

  explicit Numbering(const CartesianGrid<D>& grid) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      num_blocks[axis] = (grid.num_cells()[axis] + 1 + edge - 1) / edge;
      cells_per_block *= edge;
    }
  }
  [[nodiscard]] Index num_keys() const {
    Index product = cells_per_block;
    for (const Index n : num_blocks) product *= n;
    return product;
  }
  /// What a stencil's place along each axis adds to the number of its cell, from base -1 on: their sum is the
  /// number.
  [[nodiscard]] std::array<std::vector<Index>, D> parts(const CartesianGrid<D>& grid) const {
    std::array<std::vector<Index>, D> parts;
    Index block_step = cells_per_block;
    Index cell_step = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      for (Index shifted = 0; shifted <= grid.num_cells()[axis]; ++shifted) {
        parts[axis].push_back(shifted / edge * block_step + shifted % edge * cell_step);
      }
      block_step *= num_blocks[axis];
      cell_step *= edge;
    }
    return parts;
  }
  [[nodiscard]] Indices<D> first_cell(Index block) const {
    Indices<D> cell{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      cell[axis] = (block % num_blocks[axis]) * edge - 1;
      block /= num_blocks[axis];
    }
    return cell;
  }
};

template <int D, int V>
[[noreturn]] void throw_outside(const Particles<D, V>& particles, const CartesianGrid<D>& grid, Index p) {
  std::string box;
  bool is_finite = true;
  for (int axis = 0; axis < D; ++axis) {
    char text[96];
    std::snprintf(text, sizeof text, "%s[%.6g, %.6g]", axis ? " x " : "", grid.origin()[axis],
                  grid.origin()[axis] + grid.length(axis));
    box += text;
    is_finite = is_finite && std::isfinite(particles.position.component(axis)[p]);
  }
  if (!is_finite) throw RunError{point_text(particles, p) + " has no finite position"};
  throw OutsideMesh{point_text(particles, p) + " is outside the mesh " + box + " m"};
}

/// As std::floor, of numbers that an Index can hold.
[[nodiscard]] Index floor_of(double x) noexcept {
  const auto whole = static_cast<Index>(x);
  return x < static_cast<double>(whole) ? whole - 1 : whole;
}

constexpr Index no_mass = -1;  ///< instead of a number
constexpr Index outside = -2;

/// The number of each point's cell.
template <int D, int V>
[[nodiscard]] std::vector<Index> keys_of(Particles<D, V>& particles, const CartesianGrid<D>& grid,
                                         double stencil_shift, const Numbering<D>& numbering,
                                         Threads threads) {
  const auto parts = numbering.parts(grid);
  std::vector<Index> keys(static_cast<std::size_t>(particles.size()), 0);
  constexpr Index batch = 4096;
  for_each_block((particles.size() + batch - 1) / batch, threads, [&](Index b) {
    const Index begin = b * batch;
    const Index end = std::min(begin + batch, particles.size());
    for (int axis = 0; axis < D; ++axis) {
      const std::vector<Index>& part = parts[static_cast<std::size_t>(axis)];
      const double low = grid.origin()[axis];
      const double high = low + grid.length(axis);
      const double inverse_spacing = 1 / grid.spacing()[axis];
      const Index last = std::ssize(part) - 1;
      double* const position = particles.position.component(axis);
      if (grid.is_periodic()[static_cast<std::size_t>(axis)]) {
        for (Index p = begin; p < end; ++p) position[p] = detail::into_period(position[p], grid, axis);
      }
      for (Index p = begin; p < end; ++p) {
        Index& key = keys[static_cast<std::size_t>(p)];
        if (!(low <= position[p] && position[p] <= high)) {
          key = outside;
        } else if (key != outside) {
          const Index base = floor_of(coordinate(position[p], low, inverse_spacing, stencil_shift));
          key += part[static_cast<std::size_t>(std::min(base + 1, last))];
        }
      }
    }
    const double* const mass = particles.mass.component(0);
    for (Index p = begin; p < end; ++p) {
      if (!(mass[p] > 0)) keys[static_cast<std::size_t>(p)] = no_mass;
    }
  });
  const auto first_outside = std::ranges::find(keys, outside);
  if (first_outside != keys.end()) throw_outside(particles, grid, first_outside - keys.begin());
  return keys;
}

/// Blocks with their padded ranges, and for each new place the point that goes there.
template <int D>
struct Sorting {
  ParticleBlocks<D> blocks;
  std::vector<Index> source;
  std::vector<Index> padding;  ///< places that hold points of mass zero
};

template <int D>
[[nodiscard]] Sorting<D> order_by(const std::vector<Index>& keys, const Numbering<D>& numbering) {
  std::vector<Index> next(static_cast<std::size_t>(numbering.num_keys()) + 1, 0);
  for (const Index key : keys) {
    if (key >= 0) ++next[static_cast<std::size_t>(key)];
  }
  Sorting<D> order;
  Index place = 0;
  for (Index first = 0; first < numbering.num_keys(); first += numbering.cells_per_block) {
    const Index begin = place;
    for (Index key = first; key < first + numbering.cells_per_block; ++key) {
      const Index count = next[static_cast<std::size_t>(key)];
      next[static_cast<std::size_t>(key)] = place;
      place += count;
    }
    if (place == begin) continue;
    const Index end = begin + (place - begin + pack_size - 1) / pack_size * pack_size;
    order.blocks.blocks.push_back({numbering.first_cell(first / numbering.cells_per_block), begin, end});
    for (; place < end; ++place) order.padding.push_back(place);
  }
  order.source.assign(static_cast<std::size_t>(place), 0);
  for (std::size_t p = 0; p < keys.size(); ++p) {
    if (keys[p] < 0) continue;
    order.source[static_cast<std::size_t>(next[static_cast<std::size_t>(keys[p])]++)] = static_cast<Index>(p);
  }
  for (const Index pad : order.padding) {
    order.source[static_cast<std::size_t>(pad)] = order.source[static_cast<std::size_t>(pad) - 1];
  }
  return order;
}

}  // namespace

template <int D>
void colour_blocks(ParticleBlocks<D>& blocks, const CartesianGrid<D>& grid) {
  const Numbering<D> numbering{grid};
  Index num_colours = 1;
  for (int axis = 0; axis < D; ++axis) num_colours *= 4;
  blocks.colours.assign(static_cast<std::size_t>(num_colours), {});
  for (std::size_t b = 0; b < blocks.blocks.size(); ++b) {
    Index colour = 0;
    for (std::size_t axis = D; axis-- > 0;) {
      const Index place = (blocks.blocks[b].first_cell[axis] + 1) / block_edge<D>;
      const Index to_last = numbering.num_blocks[axis] - 1 - place;
      // Round a periodic axis the last two blocks also meet the first ones: they stand alone.
      const bool meets_first = grid.is_periodic()[axis] && place > 0 && to_last <= 1;
      colour = colour * 4 + (meets_first ? 3 - to_last : place % 2);
    }
    blocks.colours[static_cast<std::size_t>(colour)].push_back(static_cast<Index>(b));
  }
  std::erase_if(blocks.colours, [](const auto& colour) { return colour.empty(); });
}

template <int D, int V>
ParticleBlocks<D> cell_sort(Particles<D, V>& particles, const CartesianGrid<D>& grid, double stencil_shift,
                            Threads threads) {
  const Numbering<D> numbering{grid};
  Sorting<D> order = order_by(keys_of(particles, grid, stencil_shift, numbering, threads), numbering);
  std::vector<Column*> columns;
  particles.for_each_column([&](Column& column) { columns.push_back(&column); });
  for_each_block(static_cast<Index>(columns.size()), threads,
                 [&](Index c) { columns[static_cast<std::size_t>(c)]->reorder(order.source); });
  for (const Index pad : order.padding) particles.mass.component(0)[pad] = 0;
  colour_blocks(order.blocks, grid);
  return std::move(order.blocks);
}

#define SCREE_INSTANCE(D, V) \
  template ParticleBlocks<D> cell_sort(Particles<D, V>&, const CartesianGrid<D>&, double, Threads);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
template void colour_blocks(ParticleBlocks<1>&, const CartesianGrid<1>&);
template void colour_blocks(ParticleBlocks<2>&, const CartesianGrid<2>&);
template void colour_blocks(ParticleBlocks<3>&, const CartesianGrid<3>&);

}  // namespace scree::mpm
