#pragma once

#include "scree/scene/scene.hpp"

#include <string>
#include <vector>

namespace scree::app {

/// Something of a scene without which the numbers of a checkpoint mean nothing: a key and what it is set to.
struct Trait {
  std::string key;                    ///< "[mesh] cells"
  std::string value;                  ///< "12"
  std::string if_absent = "not set";  ///< what a checkpoint without the key was run with
};

/// What the columns of points depend on: dimensions, symmetry, law, classes of grains.
[[nodiscard]] std::vector<Trait> traits_of_points(const Scene& scene);
/// The same and what blocks of points, rates and sums depend on: mesh, scheme, streams.
[[nodiscard]] std::vector<Trait> traits_of_run(const Scene& scene);

/// What the boxes of points of uniform GIMP depend on: shape and mesh.
[[nodiscard]] std::vector<Trait> traits_of_boxes(const Scene& scene);

/// "key = value", one on a line.
[[nodiscard]] std::string traits_text(const std::vector<Trait>& traits);

/// Which of the traits are not the same in a text of traits_text(), which may hold more.
/// @returns "[mesh] cells is 12 there and 24 in the scene; ..", empty if all are the same
[[nodiscard]] std::string difference(const std::string& text, const std::vector<Trait>& traits);

}  // namespace scree::app
