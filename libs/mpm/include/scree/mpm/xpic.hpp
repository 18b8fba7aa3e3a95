#pragma once

#include <scree/mpm/transfer.hpp>

#include <memory>

namespace scree::mpm {

/// Extended particle-in-cell of order m: points keep of their velocity what m smoothings by the mesh see of
/// it, and take the nodes' increment. Order 1 is PIC; the higher, the less is lost of what the mesh resolves,
/// while what it cannot see goes in every step. For `PicFlip` with an increment share of 1.
/// @see Eqs. (M129), (M130), Hammerquist & Nairn (2017), \cite hammerquist2017
template <int D, int V>
struct Xpic {
  int order = 0;                             ///< m; 0: velocities are not filtered
  std::unique_ptr<Transfer<D, V>> smoother;  ///< takes the nodes' velocity to points
};

/// @throws InputError if the order is below 1.
template <int D, int V>
[[nodiscard]] Xpic<D, V> make_xpic(const AnyShape& shape, int order) {
  require(order >= 1, "make_xpic: the order must be at least 1");
  return {order, make_transfer<D, V>(shape, PicFlip{0})};
}

}  // namespace scree::mpm
