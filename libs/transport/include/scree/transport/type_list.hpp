#pragma once

#include <variant>

namespace scree::transport {

/// A list of types, for what is built over every entry: typed tests, the program's list of names.
template <class... Entries>
struct TypeList {};

namespace detail {
template <class List>
struct VariantOf;
template <class... Entries>
struct VariantOf<TypeList<Entries...>> {
  using type = std::variant<Entries...>;
};
}  // namespace detail

/// A value that is one of the entries of a list: a choice made at run time, visited once around a loop.
template <class List>
using AnyOf = typename detail::VariantOf<List>::type;

/// Calls `visit.template operator()<Entry>()` for each entry of a list, in order.
template <class Visitor, class... Entries>
constexpr void for_each_entry(TypeList<Entries...> /*list*/, Visitor&& visit) {
  (visit.template operator()<Entries>(), ...);
}

}  // namespace scree::transport
