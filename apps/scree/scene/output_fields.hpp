#pragma once

#include <scree/rheology/laws.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scree::app {

inline constexpr std::array<std::string_view, 6> fields_of_points{"id",      "mass",     "velocity",
                                                                  "density", "pressure", "shear_rate"};
inline constexpr std::array<std::string_view, 2> fields_of_grains{"grain_size", "fraction"};
inline constexpr std::string_view stability_field = "stability_number";

/// What a frame can hold besides positions, what the law reads and keeps among it; a field that is not asked
/// for is neither computed nor written.
[[nodiscard]] inline std::vector<std::string_view> known_fields(bool has_grains,
                                                                const rheology::AnyLaw& any_law) {
  std::vector<std::string_view> fields{fields_of_points.begin(), fields_of_points.end()};
  if (has_grains) fields.insert(fields.end(), fields_of_grains.begin(), fields_of_grains.end());
  const auto add = [&](std::string_view field) {
    if (std::ranges::find(fields, field) == fields.end()) fields.push_back(field);
  };
  std::visit(
      [&]<class Law>(const Law& /*law*/) {
        if (rheology::HasStabilityNumber<Law>) add(stability_field);
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
