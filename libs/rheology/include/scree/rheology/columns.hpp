#pragma once

#include <scree/constitutive_law.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace scree::rheology {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-braces"  // a member may be an aggregate itself
/// An aggregate of numbers (a law's Input or State), each made from the column that describes it.
/// @param columns the law's `inputs` or `states`  @param number_of from a column to its value, in its unit
template <class Aggregate, class Columns, class NumberOf>
[[nodiscard]] constexpr Aggregate made_of(const Columns& columns, const NumberOf& number_of) {
  if constexpr (std::is_empty_v<Aggregate>) {
    return Aggregate{};
  } else {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return Aggregate{number_of(columns[I])...};
    }
    (std::make_index_sequence<std::tuple_size_v<Columns>>{});
  }
}
#pragma GCC diagnostic pop

/// What a law remembers after the columns of a tensor.
template <std::size_t Size, std::same_as<StateColumn>... More>
[[nodiscard]] constexpr auto followed_by(const std::array<StateColumn, Size>& first, const More&... more) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{first[I]..., more...};
  }
  (std::make_index_sequence<Size>{});
}

/// A law's memory of material that has not been deformed yet.
template <class Law, class Real = double>
[[nodiscard]] constexpr typename Law::template State<Real> initial_state() {
  return made_of<typename Law::template State<Real>>(
      Law::states, [](const StateColumn& column) { return Real(column.initial); });
}

/// What a law reads, each number ordinary: for examples and tests.
template <class Law, class Real = double>
[[nodiscard]] constexpr typename Law::template Input<Real> typical_input() {
  return made_of<typename Law::template Input<Real>>(
      Law::inputs, [](const InputColumn& column) { return Real(column.typical); });
}

/// Checks every number that a law reads.
/// @throws InputError for the first that is out of its range: law, column, value and range.
template <class Law>
void validate_input(const typename Law::template Input<double>& input) {
  if constexpr (std::tuple_size_v < decltype(Law::inputs) >> 0) {
    const auto numbers = std::bit_cast<std::array<double, Law::inputs.size()>>(input);
    for (std::size_t i = 0; i < numbers.size(); ++i) require_in_range(Law::name, Law::inputs[i], numbers[i]);
  }
}

}  // namespace scree::rheology
