#pragma once

#include <scree/error.hpp>

#include <string_view>

namespace scree::rheology {

/// What values a parameter may take. Infinity and NaN are never among them.
enum class Bound { non_negative, positive };

/// One parameter of a law, described for people, readers of scenes and tests.
template <class Law>
struct LawParameter {
  std::string_view name;     ///< of the member, which is also its key in a scene
  std::string_view unit;     ///< SI
  std::string_view meaning;  ///< in a few words
  double Law::*member;       ///< where its value is
  Bound bound;
  double typical;  ///< an ordinary value, for examples and tests [unit]
};

namespace detail {
/// @throws InputError naming law, parameter, value and bound, unless `value` is within the bound.
void require_within(std::string_view law, std::string_view parameter, std::string_view unit, Bound bound,
                    double value);
}  // namespace detail

/// Checks every parameter of a law.
/// @throws InputError for the first that is out of its bound: law, parameter, value and what was expected.
template <class Law>
void validate(const Law& law) {
  for (const LawParameter<Law>& parameter : Law::parameters) {
    detail::require_within(Law::name, parameter.name, parameter.unit, parameter.bound, law.*parameter.member);
  }
}

/// The law with the typical value of each parameter.
template <class Law>
[[nodiscard]] constexpr Law typical() noexcept {
  Law law{};
  for (const LawParameter<Law>& parameter : Law::parameters) law.*parameter.member = parameter.typical;
  return law;
}

}  // namespace scree::rheology
