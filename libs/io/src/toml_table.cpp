#include "concat.hpp"
#include "nearest_name.hpp"
#include "toml_state.hpp"

#include <scree/io/toml_reader.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace scree::io {

using detail::concat;
using detail::KeySpec;
using detail::TomlNode;
using detail::TomlState;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::string to_toml(double value) {
  return to_text(value);
}
std::string to_toml(std::int64_t value) {
  return std::to_string(value);
}
std::string to_toml(bool value) {
  return value ? "true" : "false";
}
std::string to_toml(const std::string& value) {
  return concat({"\"", value, "\""});
}

/// One key of one table, and what it should be.
struct Question {
  TomlState& state;
  const TomlNode& node;
  KeySpec spec;
  std::size_t element = 0;  ///< of an array, counted from 1; 0: the whole

  void remember(std::string fallback) const { detail::remember(state, node, spec, std::move(fallback)); }
  [[nodiscard]] const toml::node* find() const { return detail::find(node, spec.key); }
  void add_missing() const { detail::add_missing(state, node, spec); }
  void add_fault(std::string_view message) const {
    const std::string place = element == 0 ? "" : concat({"element ", std::to_string(element), ": "});
    detail::add_fault(state, node, spec.key, concat({place, message}));
  }
  void add_wrong_type(const toml::node& found) const {
    add_fault(concat({"expected ", spec.type, " (", spec.meaning, "), got ", detail::type_name(found)}));
  }
};

/// Reads one key: what `convert(value)` makes of it, which reports its faults itself and then makes nothing.
/// @param on_fault the result then, unless there is a fallback
template <class T, class Convert>
T read(const Question& question, const std::optional<T>& fallback, T on_fault, const Convert& convert) {
  question.remember(fallback ? to_toml(*fallback) : "");
  const toml::node* const found = question.find();
  if (found == nullptr && !fallback) question.add_missing();
  std::optional<T> value;
  if (found != nullptr) value = convert(*found);
  return value ? *std::move(value) : fallback.value_or(std::move(on_fault));
}

/// A number within bounds, of type T or an integer; reports what is not.
template <class T>
std::optional<T> to_number(const Question& question, const Bounds& bounds, const toml::node& found) {
  std::optional<T> value = found.value_exact<T>();
  if (const auto integer = found.value_exact<std::int64_t>()) value = static_cast<T>(*integer);
  if (!value) {
    question.add_wrong_type(found);
    return {};
  }
  const auto number = static_cast<double>(*value);
  if (std::isfinite(number) && bounds.contain(number)) return value;
  const std::string message = std::isfinite(number) ? question.spec.rule : "must be finite";
  question.add_fault(concat({message, " (", question.spec.meaning, ")"}));
  return {};
}

template <class T>
T read_number(const Question& question, const Bounds& bounds, const std::optional<T>& fallback, T on_fault) {
  return read<T>(question, fallback, on_fault,
                 [&](const toml::node& found) { return to_number<T>(question, bounds, found); });
}

/// A boolean or a string.
template <class T>
T read_plain(const Question& question, const std::optional<T>& fallback) {
  return read<T>(question, fallback, T{}, [&](const toml::node& found) {
    std::optional<T> value = found.value_exact<T>();
    if (!value) question.add_wrong_type(found);
    return value;
  });
}

std::string one_of(std::span<const std::string_view> allowed) {
  return concat({"one of ", detail::joined(allowed, ", ")});
}

std::string read_choice(const Question& question, std::span<const std::string_view> allowed,
                        const std::optional<std::string>& fallback) {
  const auto convert = [&](const toml::node& found) -> std::optional<std::string> {
    std::optional<std::string> value = found.value_exact<std::string>();
    if (!value) {
      question.add_wrong_type(found);
      return {};
    }
    if (std::ranges::find(allowed, *value) != allowed.end()) return value;
    std::string message = concat({"expected ", question.spec.rule, " (", question.spec.meaning, ")"});
    const std::string_view nearest = detail::nearest_name(*value, allowed);
    if (!nearest.empty()) message += concat({", did you mean '", nearest, "'?"});
    question.add_fault(message);
    return {};
  };
  return read<std::string>(question, fallback, std::string{allowed.front()}, convert);
}

/// The elements of an array, each through `convert(its question, element)`; nothing if one is at fault.
/// @param element_type "a number"
template <class T, class Convert>
std::vector<T> read_array(const Question& question, std::string_view element_type,
                          std::optional<std::size_t> count, const Convert& convert) {
  question.remember("");
  const toml::node* const found = question.find();
  if (found == nullptr) {
    question.add_missing();
    return {};
  }
  const toml::array* const array = found->as_array();
  if (array == nullptr) {
    question.add_wrong_type(*found);
    return {};
  }
  if (count && array->size() != *count) {
    question.add_fault(concat({"expected ", std::to_string(*count), " values (", question.spec.meaning,
                               "), got ", std::to_string(array->size())}));
    return {};
  }
  std::vector<T> values;
  Question of_element = question;
  of_element.spec.type = element_type;
  for (const toml::node& element : *array) {
    ++of_element.element;
    std::optional<T> value = convert(of_element, element);
    if (!value) return {};
    values.push_back(*std::move(value));
  }
  return values;
}

}  // namespace

TomlTable::TomlTable(TomlState& state, const TomlNode& node)
    : state_{&state}, node_{std::make_shared<const TomlNode>(node)} {
  state.asked[node.label];
}

bool TomlTable::has(std::string_view key) const {
  auto& asked = state_->asked[node_->label];
  if (std::ranges::find(asked, key) == asked.end()) asked.emplace_back(key);
  return detail::find(*node_, key) != nullptr;
}

bool TomlTable::is_table(std::string_view key) const {
  return has(key) && detail::find(*node_, key)->is_table();
}

bool TomlTable::is_string(std::string_view key) const {
  return has(key) && detail::find(*node_, key)->is_string();
}

double TomlTable::number(std::string_view key, std::string_view meaning, const Bounds& bounds) const {
  const Question question{*state_, *node_, {key, meaning, "a number", bounds.to_text()}};
  return read_number<double>(question, bounds, {}, no_number);
}

double TomlTable::number_or(double fallback, std::string_view key, std::string_view meaning,
                            const Bounds& bounds) const {
  const Question question{*state_, *node_, {key, meaning, "a number", bounds.to_text()}};
  return read_number<double>(question, bounds, fallback, no_number);
}

std::int64_t TomlTable::integer(std::string_view key, std::string_view meaning, const Bounds& bounds) const {
  const Question question{*state_, *node_, {key, meaning, "an integer", bounds.to_text()}};
  return read_number<std::int64_t>(question, bounds, {}, 0);
}

std::int64_t TomlTable::integer_or(std::int64_t fallback, std::string_view key, std::string_view meaning,
                                   const Bounds& bounds) const {
  const Question question{*state_, *node_, {key, meaning, "an integer", bounds.to_text()}};
  return read_number<std::int64_t>(question, bounds, fallback, 0);
}

bool TomlTable::boolean(std::string_view key, std::string_view meaning) const {
  return read_plain<bool>({*state_, *node_, {key, meaning, "a boolean", ""}}, {});
}

bool TomlTable::boolean_or(bool fallback, std::string_view key, std::string_view meaning) const {
  return read_plain<bool>({*state_, *node_, {key, meaning, "a boolean", ""}}, fallback);
}

std::string TomlTable::string(std::string_view key, std::string_view meaning) const {
  return read_plain<std::string>({*state_, *node_, {key, meaning, "a string", ""}}, {});
}

std::string TomlTable::string_or(std::string_view fallback, std::string_view key,
                                 std::string_view meaning) const {
  return read_plain<std::string>({*state_, *node_, {key, meaning, "a string", ""}}, std::string{fallback});
}

std::string TomlTable::choice(std::string_view key, std::string_view meaning,
                              std::span<const std::string_view> allowed) const {
  return read_choice({*state_, *node_, {key, meaning, "a string", one_of(allowed)}}, allowed, {});
}

std::string TomlTable::choice_or(std::string_view fallback, std::string_view key, std::string_view meaning,
                                 std::span<const std::string_view> allowed) const {
  return read_choice({*state_, *node_, {key, meaning, "a string", one_of(allowed)}}, allowed,
                     std::string{fallback});
}

std::vector<double> TomlTable::numbers(std::string_view key, std::string_view meaning, const Bounds& bounds,
                                       std::optional<std::size_t> count) const {
  const Question question{*state_, *node_, {key, meaning, "an array of numbers", bounds.to_text()}};
  return read_array<double>(question, "a number", count, [&](const Question& one, const toml::node& element) {
    return to_number<double>(one, bounds, element);
  });
}

std::vector<std::string> TomlTable::strings(std::string_view key, std::string_view meaning) const {
  const Question question{*state_, *node_, {key, meaning, "an array of strings", ""}};
  return read_array<std::string>(question, "a string", {},
                                 [](const Question& one, const toml::node& element) {
                                   std::optional<std::string> value = element.value_exact<std::string>();
                                   if (!value) one.add_wrong_type(element);
                                   return value;
                                 });
}

TomlTable TomlTable::table(std::string_view key) const {
  const bool is_absent = !has(key);
  if (is_absent) detail::add_fault(*state_, *node_, key, "missing table");
  TomlTable result = table_or_empty(key);
  if (!is_absent) return result;
  TomlNode silent = *result.node_;
  silent.is_silent = true;
  return {*state_, silent};
}

TomlTable TomlTable::table_or_empty(std::string_view key) const {
  const bool is_absent = !has(key);
  const toml::node* const found = detail::find(*node_, key);
  const toml::table* const table = is_absent ? nullptr : found->as_table();
  const bool is_wrong = !is_absent && table == nullptr;
  if (is_wrong) {
    detail::add_fault(*state_, *node_, key, concat({"expected a table, got ", detail::type_name(*found)}));
  }
  return {*state_,
          {.table = table,
           .label = detail::path_of(*node_, key),
           .schema = detail::path_of({.table = nullptr, .label = node_->schema, .schema = {}}, key),
           .line = table == nullptr ? 0 : static_cast<int>(table->source().begin.line),
           .is_silent = is_wrong || node_->is_silent}};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  if (!has(key)) return {};
  const toml::node* const found = detail::find(*node_, key);
  const toml::array* const array = found->as_array();
  const bool is_right = array != nullptr && (array->empty() || found->is_array_of_tables());
  if (!is_right) {
    detail::add_fault(*state_, *node_, key,
                      concat({"expected an array of tables, [[", detail::path_of(*node_, key), "]], got ",
                              detail::type_name(*found)}));
    return {};
  }
  std::vector<TomlTable> result;
  for (const toml::node& element : *array) {
    const std::string place = std::to_string(result.size() + 1);
    result.push_back(
        {*state_,
         {.table = element.as_table(),
          .label = concat({detail::path_of(*node_, key), " ", place}),
          .schema = detail::path_of({.table = nullptr, .label = node_->schema, .schema = {}}, key),
          .line = static_cast<int>(element.source().begin.line)}});
  }
  return result;
}

void TomlTable::add_fault(std::string_view key, std::string_view message) const {
  detail::add_fault(*state_, *node_, key, message);
}

bool TomlTable::is_sound(std::string_view key) const {
  return !node_->is_silent && !state_->faulty_paths.contains(detail::path_of(*node_, key));
}

void TomlTable::check(bool condition, std::initializer_list<std::string_view> keys,
                      std::string_view message) const {
  const bool are_sound = std::ranges::all_of(keys, [this](std::string_view key) { return is_sound(key); });
  if (!condition && are_sound) add_fault(*keys.begin(), message);
}

}  // namespace scree::io
