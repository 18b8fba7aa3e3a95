#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/fields.hpp>

namespace scree::transport::detail {

/// The lattice that is half a spacing off along every axis: from cells to their corners.
///
/// A periodic axis has as many corners as cells; another one more, the outer two with volumes cut in half.
template <int D>
[[nodiscard]] Lattice<D> corners_of(const Lattice<D>& cells);

/// What each site of one lattice gives to those of the lattice half a spacing off: site t of the target takes
/// from entries t and t + 1 along each axis. Cells are stored from entry 1 on, corners from entry 0 on; the
/// entries round them are for what comes across a periodic axis, or from a wall.  Eq. (T43)
template <int D, int N>
class Pieces {
 public:
  static constexpr int num_rows = (D + 1) * N;

  explicit Pieces(const Lattice<D>& cells) : extent_{entries_of(cells)}, values_{extent_.num_sites()} {}

  [[nodiscard]] Index entry(const Indices<D>& at) const noexcept { return extent_.index(at); }
  [[nodiscard]] Index stride(int axis) const noexcept { return extent_.stride(axis); }
  [[nodiscard]] const Lattice<D>& extent() const noexcept { return extent_; }

  /// The state of a component.
  [[nodiscard]] double* state(int k) noexcept { return values_.data() + k * values_.stride(); }
  [[nodiscard]] const double* state(int k) const noexcept { return values_.data() + k * values_.stride(); }
  /// What a component passes on along an axis.
  [[nodiscard]] double* passed(int axis, int k) noexcept { return state((axis + 1) * N + k); }
  [[nodiscard]] const double* passed(int axis, int k) const noexcept { return state((axis + 1) * N + k); }
  /// Distance between components.
  [[nodiscard]] Index component_stride() const noexcept { return values_.stride(); }

 private:
  [[nodiscard]] static Lattice<D> entries_of(const Lattice<D>& cells) noexcept {
    Lattice<D> entries = cells;
    for (Index& n : entries.count) n += 2;
    return entries;
  }

  Lattice<D> extent_;  // of the entries; only its numbering is used
  Fields<num_rows> values_;
};

extern template Lattice<1> corners_of<1>(const Lattice<1>&);
extern template Lattice<2> corners_of<2>(const Lattice<2>&);
extern template Lattice<3> corners_of<3>(const Lattice<3>&);

}  // namespace scree::transport::detail
