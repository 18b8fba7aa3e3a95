#pragma once

#include <scree/rheology/laws.hpp>

#include <algorithm>
#include <limits>
#include <optional>
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

/// What a law that crushes grains keeps of it.
inline constexpr std::string_view breakage_column = "breakage";

/// Whether a law crushes grains.
[[nodiscard]] inline bool crushes(const rheology::AnyLaw& law) {
  return keeps(law, breakage_column);
}

/// The friction at which a law yields, if it is the same everywhere [-].
[[nodiscard]] inline std::optional<double> yield_friction(const rheology::AnyLaw& any_law) {
  return std::visit(
      []<class Law>(const Law& law) -> std::optional<double> {
        if constexpr (rheology::HasYieldFriction<Law>) return law.yield_friction();
        return std::nullopt;
      },
      any_law);
}

/// Whether a law yields at a friction that is by place, of the grains there.
[[nodiscard]] inline bool has_local_friction(const rheology::AnyLaw& any_law) {
  return std::visit([]<class Law>(const Law& /*law*/) { return rheology::HasLocalYieldFriction<Law>; },
                    any_law);
}

/// Its bulk modulus; infinite if it has no key for one [Pa].
[[nodiscard]] inline double bulk_modulus_of(const rheology::AnyLaw& any_law) {
  return std::visit(
      [](const auto& law) {
        if constexpr (requires { law.bulk_modulus; }) {
          return static_cast<double>(law.bulk_modulus);
        } else {
          return std::numeric_limits<double>::infinity();
        }
      },
      any_law);
}

}  // namespace scree::app
