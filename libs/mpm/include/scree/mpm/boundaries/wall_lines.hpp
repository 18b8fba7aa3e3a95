#pragma once

#include <scree/mpm/nodes.hpp>

namespace scree::mpm {

/// Calls body(image, wall, inside, index of the image) for the three outermost nodes of every line of nodes
/// in use that runs into an end of an axis.
template <int D, class Body>
void for_each_wall_line(Nodes<D>& nodes, std::size_t axis, Side side, Body&& body) noexcept {
  const Index inward = side == Side::low ? nodes.stride(axis) : -nodes.stride(axis);
  for (const Index image : nodes.images(axis, side)) {
    body(nodes[image], nodes[image + inward], nodes[image + 2 * inward], image);
  }
}

}  // namespace scree::mpm
