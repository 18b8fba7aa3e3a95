#pragma once

#include <scree/rheology/laws.hpp>

#include <algorithm>
#include <string_view>
#include <variant>

namespace scree::app {

/// Whether a law reads the column of this name.
[[nodiscard]] inline bool reads(const rheology::AnyLaw& any_law, std::string_view column) {
  return std::visit(
      [&](const auto& law) {
        return std::ranges::any_of(law.inputs, [&](const InputColumn& one) { return one.name == column; });
      },
      any_law);
}

/// Whether a law keeps it.
[[nodiscard]] inline bool keeps(const rheology::AnyLaw& any_law, std::string_view column) {
  return std::visit(
      [&](const auto& law) {
        return std::ranges::any_of(law.states, [&](const StateColumn& one) { return one.name == column; });
      },
      any_law);
}

}  // namespace scree::app
