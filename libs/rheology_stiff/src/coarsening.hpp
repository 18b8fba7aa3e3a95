#pragma once

#include <scree/grid.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace scree::rheology::detail {

/// A grid and the one with cells twice as large along some axes, and how values of nodes go between them: by
/// linear interpolation, and by its transpose.  Eq. (R138)
template <int D>
class Coarsening {
 public:
  /// None if no axis can be coarsened. An odd number of cells is covered by one coarse cell that sticks out;
  /// a period must be even. Axes whose cells are already larger than the others' wait for these.
  [[nodiscard]] static std::optional<CartesianGrid<D>> coarser(const CartesianGrid<D>& fine);

  Coarsening(const CartesianGrid<D>& fine, const CartesianGrid<D>& coarse);

  /// Adds to the coarse value of each node its children's, weighted.
  template <int V>
  void restrict_to(std::span<double> coarse, std::span<const double> fine) const noexcept;
  /// Adds to each fine value that `mask` is not zero at the interpolated coarse one.
  template <int V>
  void interpolate(std::span<double> fine, std::span<const double> mask,
                   std::span<const double> coarse) const noexcept;
  /// Sums of the cells that make up each coarse one.
  void sum_cells(std::span<double> coarse, std::span<const double> fine) const noexcept;
  /// The fine node that a coarse one stands at, or the last one before it.
  [[nodiscard]] Index heir(Index coarse_node) const noexcept;

 private:
  /// What one place along an axis is made from on the other grid: places times strides, and weights. The
  /// first is its own.
  struct Kin {
    std::array<Index, 3> place{};
    std::array<double, 3> weight{};
  };
  using Table = std::array<std::vector<Kin>, static_cast<std::size_t>(D)>;

  template <class Body>
  static void for_each_kin(const Table& table, Body&& body) noexcept;

  Table children_;  // fine nodes of each coarse one
  Table parents_;   // coarse nodes of each fine one
  Table cells_;     // fine cells of each coarse one
  Lattice<D> coarse_nodes_;
};

}  // namespace scree::rheology::detail
