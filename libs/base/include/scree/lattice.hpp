#pragma once

#include <scree/tensor.hpp>

#include <array>
#include <cstddef>

namespace scree {

/// D integers: a cell, a node, an extent.
template <int D>
using Indices = std::array<Index, static_cast<std::size_t>(D)>;

/// Where the sites of a lattice sit, and so how large the control volume of the outermost ones is.
enum class Sites {
  cells,  ///< at the centres of a grid's cells: all volumes are whole
  nodes   ///< at the nodes: the volumes of those on a wall are cut in half by it
};

/// A regular lattice of control volumes in D dimensions: the cells of a grid, or the boxes round its nodes.
/// Sites are numbered with the first axis fastest. A periodic axis has no end.
template <int D>
struct Lattice {
  Indices<D> count{};  ///< sites along each axis
  Vector<D> spacing;   ///< between sites [m]
  Vector<D> first;     ///< position of site (0, .., 0) [m]
  std::array<bool, D> is_periodic{};
  Sites sites = Sites::cells;

  [[nodiscard]] Index num_sites() const noexcept {
    Index product = 1;
    for (const Index n : count) product *= n;
    return product;
  }

  [[nodiscard]] Index index(const Indices<D>& site) const noexcept {
    Index result = 0;
    for (int axis = D - 1; axis >= 0; --axis) {
      result = result * count[static_cast<std::size_t>(axis)] + site[static_cast<std::size_t>(axis)];
    }
    return result;
  }

  [[nodiscard]] Indices<D> site(Index index) const noexcept {
    Indices<D> result{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      result[axis] = index % count[axis];
      index /= count[axis];
    }
    return result;
  }

  /// Distance in the numbering between neighbours along `axis`.
  [[nodiscard]] Index stride(int axis) const noexcept {
    Index result = 1;
    for (int a = 0; a < axis; ++a) result *= count[static_cast<std::size_t>(a)];
    return result;
  }

  [[nodiscard]] Vector<D> position(const Indices<D>& site) const noexcept {
    Vector<D> x = first;
    for (int axis = 0; axis < D; ++axis) {
      x[axis] += static_cast<double>(site[static_cast<std::size_t>(axis)]) * spacing[axis];
    }
    return x;
  }

  /// Extent of a site's control volume along `axis` [m].
  [[nodiscard]] double width(const Indices<D>& site, int axis) const noexcept {
    const auto a = static_cast<std::size_t>(axis);
    const bool is_cut = sites == Sites::nodes && !is_periodic[a] && (site[a] == 0 || site[a] == count[a] - 1);
    return is_cut ? spacing[axis] / 2 : spacing[axis];
  }

  /// Control volume of a site [m^D].
  [[nodiscard]] double volume(const Indices<D>& site) const noexcept {
    double product = 1;
    for (int axis = 0; axis < D; ++axis) product *= width(site, axis);
    return product;
  }

  /// Area of the faces of a site normal to `axis` [m^(D-1)].
  [[nodiscard]] double face_area(const Indices<D>& site, int axis) const noexcept {
    double product = 1;
    for (int other = 0; other < D; ++other) {
      if (other != axis) product *= width(site, other);
    }
    return product;
  }
};

}  // namespace scree
