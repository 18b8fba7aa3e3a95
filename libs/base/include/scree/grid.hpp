#pragma once

#include <scree/error.hpp>
#include <scree/lattice.hpp>

namespace scree {

/// A box of equal cells, aligned with the axes: cells, nodes and their arithmetic.
template <int D>
class CartesianGrid {
 public:
  /// @param origin lowest corner [m]
  /// @param spacing edges of a cell [m], positive
  /// @param num_cells cells along each axis, at least 1
  /// @param is_periodic axes whose two ends are one
  /// @throws InputError if an edge is not positive and finite, the origin not finite, or an axis has no cell.
  CartesianGrid(const Vector<D>& origin, const Vector<D>& spacing, const Indices<D>& num_cells,
                const std::array<bool, D>& is_periodic)
      : origin_{origin}, spacing_{spacing}, num_cells_{num_cells}, is_periodic_{is_periodic} {
    for (int axis = 0; axis < D; ++axis) {
      require(spacing[axis] > 0 && std::isfinite(spacing[axis]),
              "CartesianGrid: a cell's edges must be positive and finite");
      require(std::isfinite(origin[axis]), "CartesianGrid: the origin must be finite");
      require(num_cells[static_cast<std::size_t>(axis)] >= 1,
              "CartesianGrid: each axis must have at least one cell");
    }
  }

  [[nodiscard]] const Vector<D>& origin() const noexcept { return origin_; }
  [[nodiscard]] const Vector<D>& spacing() const noexcept { return spacing_; }
  [[nodiscard]] const Indices<D>& num_cells() const noexcept { return num_cells_; }
  [[nodiscard]] const std::array<bool, D>& is_periodic() const noexcept { return is_periodic_; }

  /// Length of the box along `axis` [m].
  [[nodiscard]] double length(int axis) const noexcept {
    return spacing_[axis] * static_cast<double>(num_cells_[static_cast<std::size_t>(axis)]);
  }

  /// The cells as control volumes.
  [[nodiscard]] Lattice<D> cells() const noexcept {
    return {num_cells_, spacing_, origin_ + spacing_ / 2, is_periodic_, Sites::cells};
  }

  /// The nodes with their control volumes: one more than cells along an axis that is not periodic.
  [[nodiscard]] Lattice<D> nodes() const noexcept {
    Indices<D> count = num_cells_;
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (!is_periodic_[axis]) ++count[axis];
    }
    return {count, spacing_, origin_, is_periodic_, Sites::nodes};
  }

 private:
  Vector<D> origin_;
  Vector<D> spacing_;
  Indices<D> num_cells_;
  std::array<bool, D> is_periodic_;
};

}  // namespace scree
