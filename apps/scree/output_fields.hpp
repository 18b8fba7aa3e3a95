#pragma once

#include <scree/rheology/laws.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scree::app {

/// What a frame can hold besides positions, what the law reads and keeps among it; a field that is not asked
/// for is neither computed nor written.
[[nodiscard]] inline std::vector<std::string_view> known_fields(bool has_grains,
                                                                const rheology::AnyLaw& any_law) {
  std::vector<std::string_view> fields{"id", "mass", "velocity", "density", "pressure", "shear_rate"};
  if (has_grains) fields.insert(fields.end(), {"grain_size", "fraction"});
  const auto add = [&](std::string_view field) {
    if (std::ranges::find(fields, field) == fields.end()) fields.push_back(field);
  };
  std::visit(
      [&]<class Law>(const Law& /*law*/) {
        if (rheology::HasStabilityNumber<Law>) add("stability_number");
        if (has_grains) {
          for (const InputColumn& input : Law::inputs) add(input.name);
        }
        for (const StateColumn& state : Law::states) add(state.name);
      },
      any_law);
  return fields;
}

/// What it holds unless the scene says otherwise.
[[nodiscard]] inline std::vector<std::string> default_fields(bool has_grains) {
  std::vector<std::string> fields{"id", "mass", "velocity", "pressure"};
  if (has_grains) fields.insert(fields.end(), {"grain_size", "fraction"});
  return fields;
}

}  // namespace scree::app
