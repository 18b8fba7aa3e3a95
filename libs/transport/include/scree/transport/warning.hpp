#pragma once

#include <concepts>
#include <string_view>

namespace scree::transport {

/// A part of a scheme that has no proof, and says so: what a program that uses it should show to people.
template <class T>
concept HasWarning = requires {
  { T::warning } -> std::convertible_to<std::string_view>;
};

/// Passes on the warning of a part to a whole that derives from this; nothing if there is none.
template <class T>
struct WarningOf {};
template <HasWarning T>
struct WarningOf<T> {
  static constexpr std::string_view warning = T::warning;
};

}  // namespace scree::transport
