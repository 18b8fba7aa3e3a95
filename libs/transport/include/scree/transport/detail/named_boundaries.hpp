#pragma once

#include <scree/error.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace scree::transport::detail {

/// The conditions of a grid's boundaries in the grid's order.
/// @throws InputError naming a boundary without a condition, or a condition without a boundary.
template <class Boundary>
[[nodiscard]] std::vector<Boundary> in_order(const std::map<std::string, Boundary, std::less<>>& conditions,
                                             const std::vector<std::string>& names) {
  std::vector<Boundary> result;
  for (const std::string& name : names) {
    const auto found = conditions.find(name);
    if (found == conditions.end()) {
      throw InputError{"transport: the boundary \"" + name + "\" of the grid has no condition"};
    }
    result.push_back(found->second);
  }
  for (const auto& condition : conditions) {
    if (std::find(names.begin(), names.end(), condition.first) != names.end()) continue;
    throw InputError{"transport: there is a condition for a boundary \"" + condition.first +
                     "\", which the grid does not have"};
  }
  return result;
}

}  // namespace scree::transport::detail
