#pragma once

#include <scree/tensor.hpp>

#include <ostream>

namespace scree::transport::detail {

/// Writes a position for people: "(0.5, 1)".
template <int D>
void write_position(std::ostream& out, const Vector<D>& position) {
  out << '(';
  for (int axis = 0; axis < D; ++axis) out << (axis == 0 ? "" : ", ") << position[axis];
  out << ')';
}

}  // namespace scree::transport::detail
