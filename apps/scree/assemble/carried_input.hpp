#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/mpm/boundaries/carried_input.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

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
