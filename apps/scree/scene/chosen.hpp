#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace scree::app {

/// The names of a list's entries, in its order.
template <class List>
[[nodiscard]] constexpr auto names_of() noexcept {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<std::string_view, sizeof...(I)>{std::variant_alternative_t<I, List>::name...};
  }
  (std::make_index_sequence<std::variant_size_v<List>>{});
}

/// Calls visit(std::type_identity<Entry>{}) for every entry of a list, in its order.
template <class List, class Visit>
constexpr void for_each_entry(Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit(std::type_identity<std::variant_alternative_t<I, List>>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<List>>{});
}

}  // namespace scree::app
