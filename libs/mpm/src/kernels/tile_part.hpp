#pragma once

#include "pack.hpp"
#include "stencil_loops.hpp"
#include "transfer_kernels.hpp"

#include <array>
#include <limits>

/// The part of a block's tile that its points reach: what lies beyond need not be given to the mesh.
namespace scree::mpm::SCREE_INSTRUCTION_SET {

/// From `begin` up to but not `end` along each axis.
template <int D>
struct TilePart {
  Components<Index, D> begin{};
  Components<Index, D> end{};

  [[nodiscard]] static TilePart whole(Index edge) noexcept {
    TilePart all;
    for (Index& end : all.end) end = edge;
    return all;
  }
};

/// The part that stencils of S have been in, lane by lane.
template <int D, std::size_t S>
class PartOfPacks {
 public:
  PartOfPacks() noexcept {
    for (Pack& before : before_) before = Pack{-std::numeric_limits<double>::max()};
    last_ = before_;
  }
  /// @param place in the tile where each stencil begins along the axis
  void widen(std::size_t axis, const Pack& place) noexcept {
    before_[axis] = max(before_[axis], -place);
    last_[axis] = max(last_[axis], place);
  }
  [[nodiscard]] TilePart<D> of_block() const noexcept {
    TilePart<D> part;
    for (std::size_t axis = 0; axis < D; ++axis) {
      part.begin[axis] = -static_cast<Index>(largest_lane(before_[axis])[0]);
      part.end[axis] = static_cast<Index>(largest_lane(last_[axis])[0]) + static_cast<Index>(S);
    }
    return part;
  }

 private:
  Components<Pack, D> before_;  ///< the first place, negative
  Components<Pack, D> last_;
};

/// Calls body(place in the mesh, place in the tile) for the rows along axis 0 of a part of a tile.
/// @param offset of each place along each axis, in the mesh; negative where there is none
template <int axis, int D, std::size_t N, class Body>
inline void for_each_row(const Components<std::array<Index, N>, D>& offset, const Strides<D>& stride,
                         const TilePart<D>& part, Index place, Index in_tile, Body&& body) noexcept {
  if constexpr (axis == 0) {
    body(place, in_tile);
  } else {
    for (Index i = part.begin[axis]; i < part.end[axis]; ++i) {
      const Index along = offset[axis][static_cast<std::size_t>(i)];
      if (along < 0) continue;
      for_each_row<axis - 1>(offset, stride, part, place + along, in_tile + i * stride.axis[axis], body);
    }
  }
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
