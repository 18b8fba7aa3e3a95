#pragma once

#include <scree/mpm/particles.hpp>

#include <cstdio>
#include <string>

namespace scree::mpm {

/// "material point 12 at (0.5, 1) m", for people: its identity and where it is.
template <int D, int V>
[[nodiscard]] std::string point_text(const Particles<D, V>& particles, Index p) {
  char text[64];
  std::snprintf(text, sizeof text, "material point %.0f at (", particles.id.component(0)[p]);
  std::string result = text;
  for (int axis = 0; axis < D; ++axis) {
    std::snprintf(text, sizeof text, "%s%.6g", axis ? ", " : "", particles.position.component(axis)[p]);
    result += text;
  }
  return result + ") m";
}

}  // namespace scree::mpm
