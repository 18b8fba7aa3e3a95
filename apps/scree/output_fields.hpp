#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

/// What a frame can hold besides positions; a field that is not asked for is neither computed nor written.
[[nodiscard]] inline std::vector<std::string_view> known_fields(bool has_grains, bool tells_stability) {
  std::vector<std::string_view> fields{"id", "mass", "velocity", "density", "pressure", "shear_rate"};
  if (has_grains) fields.insert(fields.end(), {"grain_size", "fraction"});
  if (tells_stability) fields.emplace_back("stability_number");
  return fields;
}

/// What it holds unless the scene says otherwise.
[[nodiscard]] inline std::vector<std::string> default_fields(bool has_grains) {
  std::vector<std::string> fields{"id", "mass", "velocity", "pressure"};
  if (has_grains) fields.insert(fields.end(), {"grain_size", "fraction"});
  return fields;
}

}  // namespace scree::app
