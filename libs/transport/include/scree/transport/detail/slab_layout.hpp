#pragma once

#include <scree/transport/detail/axis_geometry.hpp>
#include <scree/transport/detail/numbering.hpp>
#include <scree/transport/detail/row_kernels.hpp>
#include <scree/transport/detail/tiles.hpp>
#include <scree/transport/face.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scree::transport::detail {

/// A row of sites: its number, first site, and that site's coordinates.
template <int D>
struct RowPlace {
  Index row;
  Index start;
  Indices<D> site;

  [[nodiscard]] Index along(int axis) const noexcept { return site[static_cast<std::size_t>(axis)]; }
};

/// Where the sites of some layers of a lattice are: their rows, the tiles of these, their neighbours and
/// what they measure.
template <class Grid>
class SlabLayout {
 public:
  static constexpr int D = Grid::dimension;
  using Place = RowPlace<D>;
  using Geometry = AxisGeometry<Grid::has_equal_spacing>;

  /// Layers first_layer .. end_layer - 1 along the last axis (which 1D has not: one row).
  SlabLayout(const Grid& grid, Index first_layer, Index end_layer, double cfl)
      : numbering_{grid.count(), grid.is_periodic()}, first_layer_{first_layer}, end_layer_{end_layer} {
    for (int axis = 0; axis < D; ++axis) geometry_.emplace_back(grid, axis, cfl);
  }

  [[nodiscard]] Index first_row() const noexcept { return first_layer_ * rows_per_layer(); }
  [[nodiscard]] Index end_row() const noexcept { return end_layer_ * rows_per_layer(); }
  [[nodiscard]] Place place_of(Index row) const noexcept {
    const Index start = row * numbering_.count[0];
    return {row, start, numbering_.site(start)};
  }
  /// The last coordinate along a row.
  [[nodiscard]] Index last() const noexcept { return numbering_.count[0] - 1; }

  [[nodiscard]] Index num_tiles() const noexcept {
    return (numbering_.count[0] + tile_width - 1) / tile_width;
  }
  [[nodiscard]] Index count_of(Index tile) const noexcept {
    return std::min(tile_width, numbering_.count[0] - tile * tile_width);
  }
  /// Coordinates of a tile's first site.
  [[nodiscard]] static Indices<D> site_of(const Place& place, Index tile) noexcept {
    Indices<D> site = place.site;
    site[0] = tile * tile_width;
    return site;
  }

  /// Lines of tiles along an axis across the rows: those that one layer across it starts.
  [[nodiscard]] Index num_lines(int axis) const noexcept {
    return numbering_.rows_per_layer(axis) * num_tiles();
  }
  /// The number of the line that a tile of a row lies on; those of axis 1 come first, one row of them, then
  /// those of axis 2, one row for each coordinate along axis 1.
  [[nodiscard]] std::size_t line(const Place& place, int axis, Index tile) const noexcept {
    const Index row = axis == 1 ? 0 : 1 + place.along(1);
    return static_cast<std::size_t>(row * num_tiles() + tile);
  }
  [[nodiscard]] bool starts_line(const Place& place, int axis) const noexcept {
    return place.along(axis) == 0 || (axis == D - 1 && place.along(axis) == first_layer_);
  }

  [[nodiscard]] bool is_periodic(int axis) const noexcept {
    return numbering_.is_periodic[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] const Geometry& geometry(int axis) const noexcept {
    return geometry_[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] const Numbering<D>& numbering() const noexcept { return numbering_; }

  /// Sites of a row that all have one `coordinate` along another axis.
  [[nodiscard]] auto stencil_across(Index here, Index coordinate, int axis, Index count) const noexcept {
    const Index below = numbering_.neighbour(here, coordinate, axis, -1);
    const Index above = numbering_.neighbour(here, coordinate, axis, 1);
    StencilRow row{below, here, above, count, geometry(axis).ratios_across(coordinate)};
    if (below == no_site || above == no_site) row.below = row.above = here;
    return row;
  }

  /// Cuts sites begin .. end - 1 of a row into those with neighbours beside them and the row's end sites.
  template <class Part>
  void for_each_part(Index begin, Index end, Part&& part) const noexcept {
    part(begin, std::min<Index>(end, 1));
    part(std::max<Index>(begin, 1), std::min(end, last()));
    part(std::max<Index>({begin, last(), 1}), end);
  }

 private:
  [[nodiscard]] Index rows_per_layer() const noexcept {
    return D == 1 ? 1 : numbering_.rows_per_layer(D - 1);
  }

  Numbering<D> numbering_;
  std::vector<Geometry> geometry_;
  Index first_layer_;
  Index end_layer_;
};

}  // namespace scree::transport::detail
