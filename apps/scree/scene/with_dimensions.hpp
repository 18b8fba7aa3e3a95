#pragma once

#include "scree/scene/scene.hpp"

#include <type_traits>

namespace scree::app {

/// visit(D, V) with the dimensions of a scene as compile-time constants. read_scene() admits no others.
template <class Visit>
auto with_dimensions(const Scene& scene, Visit&& visit) {
  constexpr std::integral_constant<int, 1> one;
  constexpr std::integral_constant<int, 2> two;
  constexpr std::integral_constant<int, 3> three;
  const int components = scene.mesh.velocity_components;
  if (scene.mesh.dimensions == 3) return visit(three, three);
  if (scene.mesh.dimensions == 2) return components == 2 ? visit(two, two) : visit(two, three);
  if (components == 1) return visit(one, one);
  return components == 2 ? visit(one, two) : visit(one, three);
}

}  // namespace scree::app
