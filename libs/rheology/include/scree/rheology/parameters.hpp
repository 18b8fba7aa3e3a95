#pragma once

#include <scree/error.hpp>

#include <limits>
#include <string>
#include <string_view>

namespace scree::rheology {

/// Whether the value at which those of a parameter begin (0, if no other is said) is among them. Infinity and
/// NaN never are.
enum class Bound { non_negative, positive };

/// One parameter of a law, described for people, readers of scenes and tests.
template <class Law>
struct LawParameter {
  std::string_view name;     ///< of the member, which is also its key in a scene
  std::string_view unit;     ///< SI; "-" if it has none
  std::string_view meaning;  ///< in a few words
  double Law::*member;       ///< where its value is
  Bound bound;
  double typical;  ///< an ordinary value, for examples and tests [unit]
  double upper = std::numeric_limits<double>::infinity();  ///< the value lies below this one [unit]
  double Law::*exceeds = nullptr;                          ///< another parameter that is smaller, if any
  double lower = 0;                                        ///< where its values begin [unit]
  bool may_equal = false;                                  ///< whether the one of `exceeds` may be as large
};

namespace detail {
/// Between which values one parameter lies.
struct Range {
  Bound bound;
  double lower;
  double upper;
};
/// @throws InputError naming law, parameter, value and range, unless `value` is finite and within the range.
void require_within(std::string_view law, std::string_view parameter, std::string_view unit,
                    const Range& range, double value);
/// @throws InputError naming law, parameter, value and `broken`, unless that is empty.
void require_relation(std::string_view law, std::string_view parameter, std::string_view unit, double value,
                      const std::string& broken);
/// "must exceed mu_s = 0.38"; "must be at least mu_s = 0.38" if it may equal it
[[nodiscard]] std::string must_exceed(std::string_view parameter, double value, bool may_equal);
}  // namespace detail

/// Name of the parameter that a member holds.
template <class Law>
[[nodiscard]] constexpr std::string_view name_of(double Law::*member) noexcept {
  for (const LawParameter<Law>& parameter : Law::parameters) {
    if (parameter.member == member) return parameter.name;
  }
  return {};
}

/// What `parameter` must do beside lying within its bound: "must exceed mu_s = 0.38"; empty if it does.
template <class Law>
[[nodiscard]] std::string broken_relation(const Law& law, const LawParameter<Law>& parameter) {
  if (parameter.exceeds == nullptr) return {};
  const double value = law.*parameter.member;
  const double other = law.*parameter.exceeds;
  if (value > other || (parameter.may_equal && value == other)) return {};
  return detail::must_exceed(name_of(parameter.exceeds), other, parameter.may_equal);
}

/// Checks every parameter of a law.
/// @throws InputError for the first that is out of its bound or breaks a relation: law, parameter, value and
/// what was expected.
template <class Law>
void validate(const Law& law) {
  for (const LawParameter<Law>& parameter : Law::parameters) {
    detail::require_within(Law::name, parameter.name, parameter.unit,
                           {parameter.bound, parameter.lower, parameter.upper}, law.*parameter.member);
  }
  for (const LawParameter<Law>& parameter : Law::parameters) {
    detail::require_relation(Law::name, parameter.name, parameter.unit, law.*parameter.member,
                             broken_relation(law, parameter));
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
