#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/concepts.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace scree::transport {

/// A box cut by planes across its axes at any distances: cells of unequal extents, fine where it matters.
///
/// Second order where the extents change smoothly and where they do not. The smallest cell sets the step.
/// @see Eqs. (T60) to (T62)
template <int D>
class Rectilinear {
 public:
  static constexpr int dimension = D;
  static constexpr bool is_full = true;  ///< density 1 everywhere, known when compiled
  static constexpr bool has_equal_spacing = false;

  /// @param edges of the cells along each axis, from the low end to the high one [m]: one more than cells
  /// @param is_periodic axes whose two ends are one
  /// @throws InputError naming axis and edge if an axis has less than two, or they are not finite and
  ///   increasing.
  explicit Rectilinear(std::array<std::vector<double>, static_cast<std::size_t>(D)> edges,
                       const std::array<bool, D>& is_periodic = {});

  [[nodiscard]] std::span<const double> edges(int axis) const noexcept {
    return edges_[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] const Indices<D>& count() const noexcept { return count_; }
  [[nodiscard]] const std::array<bool, D>& is_periodic() const noexcept { return is_periodic_; }

  /// Extent of the cells with this coordinate [m].
  [[nodiscard]] double width(int axis, Index coordinate) const noexcept {
    return edge(axis, coordinate + 1) - edge(axis, coordinate);
  }
  /// Distance between the centres of a cell and of the one below it, round the end of a periodic axis; to
  /// the mirror image at a boundary [m].
  [[nodiscard]] double distance_below(int axis, Index coordinate) const noexcept {
    const Index size = count_[static_cast<std::size_t>(axis)];
    const bool is_at_low_end = coordinate == 0;
    const bool is_at_high_end = coordinate == size;
    if (!is_at_low_end && !is_at_high_end) {
      return 0.5 * (width(axis, coordinate - 1) + width(axis, coordinate));
    }
    if (is_periodic_[static_cast<std::size_t>(axis)]) return 0.5 * (width(axis, size - 1) + width(axis, 0));
    return width(axis, is_at_low_end ? 0 : size - 1);
  }
  /// Where the boundary lies at an end of an axis [m].
  [[nodiscard]] double end(int axis, End end) const noexcept {
    return end == End::low ? edges(axis).front() : edges(axis).back();
  }

  /// Centre of a cell [m].
  [[nodiscard]] Vector<D> position(const Indices<D>& site) const noexcept {
    Vector<D> x;
    for (int axis = 0; axis < D; ++axis) {
      const Index coordinate = site[static_cast<std::size_t>(axis)];
      x[axis] = 0.5 * (edge(axis, coordinate) + edge(axis, coordinate + 1));
    }
    return x;
  }
  /// Size of a cell [m^D].
  [[nodiscard]] double volume(const Indices<D>& site) const noexcept {
    double product = 1;
    for (int axis = 0; axis < D; ++axis) product *= width(axis, site[static_cast<std::size_t>(axis)]);
    return product;
  }
  /// Known when compiled, so that whatever asks for it costs nothing.
  [[nodiscard]] static constexpr double density(Index /*site*/) noexcept { return 1; }

 private:
  [[nodiscard]] double edge(int axis, Index i) const noexcept {
    return edges_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
  }

  std::array<std::vector<double>, static_cast<std::size_t>(D)> edges_;
  std::array<bool, D> is_periodic_;
  Indices<D> count_{};
};

extern template class Rectilinear<1>;
extern template class Rectilinear<2>;
extern template class Rectilinear<3>;
static_assert(LatticeGrid<Rectilinear<2>>);

}  // namespace scree::transport
