#pragma once

#include <array>
#include <cstddef>

namespace scree::mpm {

/// Weight one in the cell that holds the point: the mesh cells as control volumes of carried fields.
/// @see Eq. (M6)
struct TopHat {
  static constexpr std::size_t support = 1;
  static constexpr double shift = 0;
  template <class Real>
  [[nodiscard]] static constexpr std::array<Real, 1> weights(Real /*xi*/) noexcept {
    return {Real(1)};
  }
};

}  // namespace scree::mpm
