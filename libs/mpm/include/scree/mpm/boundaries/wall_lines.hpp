#pragma once

#include <scree/mpm/nodes.hpp>

namespace scree::mpm {

/// Which end of an axis.
enum class Side { low, high };

/// Calls body(image, wall, inside, index of the image) for the three outermost nodes of every line of nodes
/// that runs into an end of an axis.
template <int D, class Body>
void for_each_wall_line(Nodes<D>& nodes, std::size_t axis, Side side, Body&& body) noexcept {
  const Index last = nodes.count(axis) - 1;
  const Index outermost = side == Side::low ? 0 : last;
  const Index stride = nodes.stride(axis);
  const Index inward = side == Side::low ? stride : -stride;
  const Index num_lines = nodes.num_nodes() / nodes.count(axis);
  for (Index line = 0; line < num_lines; ++line) {
    const Index below = line % stride;
    const Index above = line / stride;
    const Index image = below + above * stride * nodes.count(axis) + outermost * stride;
    body(nodes[image], nodes[image + inward], nodes[image + 2 * inward], image);
  }
}

}  // namespace scree::mpm
