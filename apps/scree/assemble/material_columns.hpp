#pragma once

#include "scree/scene/scene.hpp"

#include <scree/mpm/boundaries/carried_input.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

/// A column of one number that material points carry.
struct MaterialColumn {
  std::string_view name;
  std::string_view unit;
};

/// The columns of a scene's material that a wall may read: what follows from the fractions of each point, as
/// far as the law asks for it, and the friction at which its mix yields.
/// @param scene of which the law and the grains have been read
[[nodiscard]] std::vector<MaterialColumn> material_columns(const Scene& scene);

/// Whether any wall, ground or body of a scene reads this column of the material.
[[nodiscard]] bool is_read_by_walls(const Scene& scene, std::string_view column);

/// The place, among the means of a node, of a column of the material that the law of a wall reads as `input`.
using PlaceOfMean =
    std::function<std::size_t(std::string_view column, const InputColumn& input, std::string_view law)>;

/// Which inputs of the law of a wall are columns of the material.
/// @param of_material the name of one for each input; empty: it is the wall's own
template <class Law>
[[nodiscard]] mpm::CarriedInput<Law> carried_input(const std::vector<std::string>& of_material,
                                                   const PlaceOfMean& place_of) {
  mpm::CarriedInput<Law> carried;
  for (std::size_t i = 0; i < Law::inputs.size() && i < of_material.size(); ++i) {
    if (!of_material[i].empty()) carried.read(i, place_of(of_material[i], Law::inputs[i], Law::name));
  }
  return carried;
}

}  // namespace scree::app
