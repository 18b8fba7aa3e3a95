#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace scree::io::detail {

/// The parts, one after the other.
[[nodiscard]] inline std::string concat(std::initializer_list<std::string_view> parts) {
  std::string result;
  for (const std::string_view part : parts) result += part;
  return result;
}

/// The names in a row: "cells, cell_size". @param names a range of strings or string views
template <class Names>
[[nodiscard]] std::string joined(const Names& names, std::string_view separator) {
  std::string result;
  for (const std::string_view name : names) {
    if (!result.empty()) result += separator;
    result += name;
  }
  return result;
}

}  // namespace scree::io::detail
