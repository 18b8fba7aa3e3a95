#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/face.hpp>

#include <array>
#include <cstddef>

namespace scree::transport::detail {

/// How the sites of a lattice are numbered, first axis fastest, and which are neighbours.
template <int D>
struct Numbering {
  Indices<D> count;
  std::array<bool, D> is_periodic;

  [[nodiscard]] Index size(int axis) const noexcept { return count[static_cast<std::size_t>(axis)]; }

  /// Distance in the numbering between neighbours along `axis`.
  [[nodiscard]] Index stride(int axis) const noexcept {
    Index result = 1;
    for (int a = 0; a < axis; ++a) result *= size(a);
    return result;
  }

  /// Rows of sites in one layer across `axis`.
  [[nodiscard]] Index rows_per_layer(int axis) const noexcept { return stride(axis) / count[0]; }

  [[nodiscard]] Indices<D> site(Index index) const noexcept {
    Indices<D> result{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      result[axis] = index % count[axis];
      index /= count[axis];
    }
    return result;
  }

  /// The coordinate next to `coordinate`, one `step` of +1 or -1 along `axis`, round the end if need be.
  [[nodiscard]] Index beside(Index coordinate, int axis, Index step) const noexcept {
    const Index target = coordinate + step;
    if (target < 0) return size(axis) - 1;
    return target == size(axis) ? 0 : target;
  }

  /// The neighbour of `site`, which has `coordinate` along `axis`; no_site past an end.
  [[nodiscard]] Index neighbour(Index site, Index coordinate, int axis, Index step) const noexcept {
    const Index target = coordinate + step;
    if (target >= 0 && target < size(axis)) return site + step * stride(axis);
    if (!is_periodic[static_cast<std::size_t>(axis)]) return no_site;
    return site + (step - step * size(axis)) * stride(axis);
  }
};

}  // namespace scree::transport::detail
