#pragma once

#include "scree/scene/chosen.hpp"

#include <scree/constitutive_law.hpp>
#include <scree/error.hpp>
#include <scree/io/toml_reader.hpp>
#include <scree/parameter.hpp>
#include <scree/rheology/concepts.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace scree::app {

/// Laws of materials and of walls alike.
template <class Law>
concept IsLaw = rheology::DescribedLaw<Law> || rheology::DescribedWall<Law>;

/// What a key may be that gives a law what it reads.
[[nodiscard]] inline io::Bounds bounds_of(const Interval& range) noexcept {
  return {range.lower, range.upper, range.is_open, range.is_open && std::isfinite(range.upper)};
}

/// A number of a law's memory at the start, where a person may tell it; else that of undeformed material.
/// @param table may have a key of its name
[[nodiscard]] inline double read_initial(const io::TomlTable& table, const StateColumn& state) {
  if (!state.start || !table.has(state.name)) return state.initial;
  return table.number(state.name, fmt::format("at the start [{}]", state.unit), bounds_of(*state.start));
}

/// A law from its parameters, each a key of the table.
template <IsLaw Law>
void read_model(const io::TomlTable& table, auto& chosen) {
  Law law{};
  for (const auto& parameter : Law::parameters) {
    const bool has_upper = std::isfinite(parameter.upper);
    const io::Bounds bounds{parameter.lower, parameter.upper, parameter.bound == rheology::Bound::positive,
                            has_upper};
    law.*parameter.member =
        table.number(parameter.name, fmt::format("{} [{}]", parameter.meaning, parameter.unit), bounds);
  }
  for (const auto& parameter : Law::parameters) {
    const std::string broken = rheology::broken_relation(law, parameter);
    if (broken.empty()) continue;
    table.check(false, {parameter.name, rheology::name_of(parameter.exceeds)}, broken);
  }
  chosen = law;
}

/// Any other model, from the parameters of its constructor; what that objects to is put down to the table.
template <class Model>
void read_model(const io::TomlTable& table, auto& chosen) {
  constexpr auto parameters = parameters_of<Model>();
  std::array<double, parameters.size()> values{};
  bool is_sound = true;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    const std::string meaning = fmt::format("{} [{}]", parameter.meaning, parameter.unit);
    values[i] = std::isnan(parameter.fallback) ? table.number(parameter.name, meaning)
                                               : table.number_or(parameter.fallback, parameter.name, meaning);
    is_sound = is_sound && table.is_sound(parameter.name);
  }
  if (!is_sound) return;
  try {
    chosen = make_model<Model>(values);
  } catch (const InputError& error) {
    if constexpr (parameters.size() > 0) table.add_fault(parameters[0].name, error.what());
  }
}

/// The entry of a list that `name` names, made from the parameters in the table.
template <class List>
void read_named(const io::TomlTable& table, std::string_view name, List& chosen) {
  for_each_entry<List>([&](auto entry) {
    using Model = typename decltype(entry)::type;
    if (Model::name == name) read_model<Model>(table, chosen);
  });
}

/// The entry of a list that `key` names; the first one if the key is absent and there is a fallback.
template <class List>
void read_chosen(const io::TomlTable& table, std::string_view key, std::string_view meaning, List& chosen,
                 std::string_view fallback = {}) {
  constexpr auto names = names_of<List>();
  read_named(
      table,
      fallback.empty() ? table.choice(key, meaning, names) : table.choice_or(fallback, key, meaning, names),
      chosen);
}

}  // namespace scree::app
