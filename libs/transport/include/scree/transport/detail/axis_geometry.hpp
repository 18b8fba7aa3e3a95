#pragma once

#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/row_balance.hpp>
#include <scree/transport/detail/row_kernels.hpp>

#include <cstddef>
#include <vector>

namespace scree::transport::detail {

/// What the sweep needs of one axis of a grid, one entry per coordinate. Rows along the axis take it as it
/// is, rows across it have one coordinate, and so one number of each kind.
template <bool HasEqualSpacing>
class AxisGeometry {
 public:
  /// @param cfl the CFL number that steps will keep to.  Eq. (T9)
  template <LatticeGrid Grid>
  AxisGeometry(const Grid& grid, int axis, double cfl) {
    const auto a = static_cast<std::size_t>(axis);
    const Index size = grid.count()[a];
    for (Index i = 0; i < size; ++i) {
      const double per_width = 1 / grid.width(axis, i);
      const bool is_at_wall = !grid.is_periodic()[a] && (i == 0 || i == size - 1);
      per_width_.push_back(per_width);
      of_larger_.push_back(is_at_wall ? 0 : per_width);
      of_both_.push_back(is_at_wall ? cfl * per_width : 0);
    }
    distance_below_.push_back(grid.distance_below(axis, 0));
    if constexpr (!HasEqualSpacing) {
      for (Index i = 1; i <= size; ++i) distance_below_.push_back(grid.distance_below(axis, i));
      for (std::size_t i = 0; i < per_width_.size(); ++i) {
        ratio_below_.push_back(1 / (per_width_[i] * distance_below_[i]));
        ratio_above_.push_back(1 / (per_width_[i] * distance_below_[i + 1]));
      }
    }
  }

  /// Distances between sites for faces below the sites from coordinate `from` on.
  [[nodiscard]] auto distances_along(Index from) const noexcept {
    if constexpr (HasEqualSpacing) {
      return Same{distance_below_[0]};
    } else {
      return distance_below_.data() + from;
    }
  }
  /// The same for a row of faces across the axis, below sites with one `coordinate`.
  [[nodiscard]] Same distance_across(Index coordinate) const noexcept {
    return {HasEqualSpacing ? distance_below_[0] : distance_below_[static_cast<std::size_t>(coordinate)]};
  }
  [[nodiscard]] double distance_beyond(End end) const noexcept {
    return end == End::low ? distance_below_.front() : distance_below_.back();
  }

  /// Extents of sites over the distances to their neighbours.
  [[nodiscard]] auto ratios_along(Index from) const noexcept {
    if constexpr (HasEqualSpacing) {
      return EqualCells{};
    } else {
      return UnequalCells<const double*>{ratio_below_.data() + from, ratio_above_.data() + from};
    }
  }
  [[nodiscard]] auto ratios_across(Index coordinate) const noexcept {
    if constexpr (HasEqualSpacing) {
      return EqualCells{};
    } else {
      const auto i = static_cast<std::size_t>(coordinate);
      return UnequalCells<Same>{{ratio_below_[i]}, {ratio_above_[i]}};
    }
  }

  /// Fluxes through the low and high faces of sites, with what they count for there.
  [[nodiscard]] AxisFluxes<const double*> fluxes_along(const double* low, const double* high,
                                                       Index from) const noexcept {
    return {low, high, per_width_.data() + from, of_larger_.data() + from, of_both_.data() + from};
  }
  [[nodiscard]] AxisFluxes<Same> fluxes_across(const double* low, const double* high,
                                               Index coordinate) const noexcept {
    const auto i = static_cast<std::size_t>(coordinate);
    return {low, high, {per_width_[i]}, {of_larger_[i]}, {of_both_[i]}};
  }

 private:
  std::vector<double> per_width_;  // 1/(extent of the control volume) [1/m]
  // Weights of the larger of both faces' speeds in the limit of dt, and of their sum: at a wall the whole of
  // the site's value stands behind one face [1/m].  Eq. (T9)
  std::vector<double> of_larger_;
  std::vector<double> of_both_;
  std::vector<double> distance_below_;  // to the site below, in the end above the last; one if all are equal
  std::vector<double> ratio_below_;     // extent over distance to the site below; none if all are equal
  std::vector<double> ratio_above_;
};

}  // namespace scree::transport::detail
