#pragma once

#include <scree/tensor.hpp>

#include <array>
#include <vector>

namespace scree {

/// A surface of triangles that share their corners.
struct TriangleMesh {
  std::vector<Vector<3>> vertices{};  ///< [m]
  /// Three vertices each, counter-clockwise as seen from the side to which the normal points.
  std::vector<std::array<Index, 3>> triangles{};
};

}  // namespace scree
