#pragma once

#include <scree/mpm/concepts.hpp>

namespace scree::mpm {

/// Hat functions over two nodes. Their gradient jumps from cell to cell: a point that crosses a node kicks
/// its neighbours, by a force that does not vanish as the mesh is refined.
/// @see Eq. (M4)
struct Linear {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view summary =
      "hat functions, 2 nodes per axis; for points that stay in their cells";
  static constexpr std::size_t support = 2;
  static constexpr double shift = 0;

  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 2> weights(Real xi) noexcept {
    return {1 - xi, xi};
  }
  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 2> gradients(Real /*xi*/) noexcept {
    return {Real(-1), Real(1)};
  }
  /// The gradients themselves: N_i (i - xi) = xi (1 - xi) dN_i/dxi.
  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 2> affine(Real xi) noexcept {
    return gradients(xi);
  }
  template <class Real>
  [[nodiscard]] static constexpr Real second_moment(Real xi) noexcept {
    return xi * (1 - xi);
  }
};
static_assert(Shape<Linear>);

}  // namespace scree::mpm
