#include "toml_state.hpp"

#include "concat.hpp"
#include "nearest_name.hpp"

#include <algorithm>
#include <utility>

namespace scree::io::detail {
namespace {

/// Where the character at a line and column lies; both count from 1, columns in UTF-8 characters.
std::size_t offset_of(std::string_view text, toml::source_position position) {
  std::size_t offset = 0;
  for (toml::source_index line = 1; line < position.line; ++line) offset = text.find('\n', offset) + 1;
  const auto is_inside_character = [&](std::size_t i) {
    constexpr unsigned char mask = 0xC0;          // the two bits that tell
    constexpr unsigned char continuation = 0x80;  // the bytes of a character after its first
    return i < text.size() && (static_cast<unsigned char>(text[i]) & mask) == continuation;
  };
  for (toml::source_index column = 1; column < position.column; ++column) {
    do ++offset;
    while (is_inside_character(offset));
  }
  return std::min(offset, text.size());
}

int line_of(const TomlNode& node, std::string_view key) {
  if (node.table == nullptr) return node.line;
  const auto entry = node.table->find(key);
  return entry == node.table->end() ? node.line : static_cast<int>(entry->first.source().begin.line);
}

/// Whether a message may repeat the value as it is written.
bool is_short(const toml::node& value) {
  const toml::source_region& region = value.source();
  constexpr toml::source_index widest = 40;  // characters of a line that also has a place and a reason
  return !value.is_table() && region.begin.line == region.end.line &&
         region.end.column - region.begin.column <= widest;
}

/// "scene.toml:14: [rheology] mu_2"
std::string place_in_file(const TomlState& state, const TomlNode& node, std::string_view key, int line) {
  std::string result = state.name;
  if (line > 0) result += concat({":", std::to_string(line)});
  result += ": ";
  if (!node.label.empty()) result += concat({"[", node.label, "] "});
  result += key;
  return result;
}

/// "scene.toml:14: [rheology] mu_2 = 0.30: " or "--set rheology.mu_2=0.3: ".
std::string place(const TomlState& state, const TomlNode& node, std::string_view key) {
  const auto change = state.overrides.find(path_of(node, key));
  if (change != state.overrides.end()) return concat({"--set ", change->second.assignment, ": "});
  std::string result = place_in_file(state, node, key, line_of(node, key));
  const toml::node* const value = find(node, key);
  if (value != nullptr && is_short(*value)) result += concat({" = ", source_text(state, *value)});
  result += ": ";
  return result;
}

/// The change of the command line that made a key, or a table for a key in it; null: it is the file's.
const Override* maker_of(const TomlState& state, const std::string& path, bool is_in_file) {
  const auto change = state.overrides.find(path);
  if (change != state.overrides.end()) return &change->second;
  const std::string prefix = concat({path, "."});
  const auto below = state.overrides.lower_bound(prefix);
  const bool is_made = !is_in_file && below != state.overrides.end() && below->first.starts_with(prefix);
  return is_made ? &below->second : nullptr;
}

/// @param known the keys that were asked for in the table
void add_unknown_key(TomlState& state, const TomlNode& node, const toml::key& key, const toml::node& value,
                     const std::vector<std::string>& known) {
  const auto line_in_file = static_cast<int>(key.source().begin.line);
  const Override* const change = maker_of(state, path_of(node, key.str()), line_in_file > 0);
  const int line = change == nullptr ? line_in_file : 0;
  std::string message = change == nullptr ? place_in_file(state, node, key.str(), line)
                                          : concat({"--set ", change->assignment});
  message += value.is_table() || value.is_array_of_tables() ? ": unknown table" : ": unknown key";
  const std::vector<std::string_view> candidates{known.begin(), known.end()};
  const std::string_view nearest = nearest_name(key.str(), candidates);
  if (!nearest.empty()) {
    message += concat({", did you mean '", nearest, "'?"});
  } else if (!known.empty()) {
    message += concat({", known here: ", joined(known, ", ")});
  }
  state.faults.add(line, std::move(message));
}

void add_unknown_keys_in(TomlState& state, const TomlNode& node) {
  const auto asked = state.asked.find(node.label);
  if (asked == state.asked.end()) return;
  for (const auto& [key, value] : *node.table) {
    if (std::ranges::find(asked->second, key.str()) == asked->second.end()) {
      add_unknown_key(state, node, key, value, asked->second);
      continue;
    }
    const std::string path = path_of(node, key.str());
    if (const toml::table* const table = value.as_table()) {
      add_unknown_keys_in(state, {.table = table, .label = path, .schema = {}});
    }
    const toml::array* const array = value.as_array();
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
      const toml::table* const table = (*array)[i].as_table();
      if (table == nullptr) continue;
      add_unknown_keys_in(
          state, {.table = table, .label = concat({path, " ", std::to_string(i + 1)}), .schema = {}});
    }
  }
}

}  // namespace

std::string path_of(const TomlNode& node, std::string_view key) {
  return node.label.empty() ? std::string{key} : concat({node.label, ".", key});
}

std::string_view source_text(const TomlState& state, const toml::node& value) {
  const std::string_view text = state.text;
  const std::size_t begin = offset_of(text, value.source().begin);
  return text.substr(begin, offset_of(text, value.source().end) - begin);
}

void remember(TomlState& state, const TomlNode& node, const KeySpec& spec, std::string fallback) {
  auto& asked = state.asked[node.label];
  if (std::ranges::find(asked, spec.key) == asked.end()) asked.emplace_back(spec.key);
  const auto is_it = [&](const KnownKey& known) {
    return known.table == node.schema && known.key == spec.key;
  };
  if (std::ranges::any_of(state.known_keys, is_it)) return;
  state.known_keys.push_back({.table = node.schema,
                              .key = std::string{spec.key},
                              .meaning = std::string{spec.meaning},
                              .expectation = concat({spec.type, spec.rule.empty() ? "" : ", ", spec.rule}),
                              .fallback = std::move(fallback)});
}

const toml::node* find(const TomlNode& node, std::string_view key) {
  return node.table == nullptr ? nullptr : node.table->get(key);
}

void add_fault(TomlState& state, const TomlNode& node, std::string_view key, std::string_view message) {
  if (node.is_silent || !state.faulty_paths.insert(path_of(node, key)).second) return;
  const bool is_changed = state.overrides.contains(path_of(node, key));
  state.faults.add(is_changed ? 0 : line_of(node, key), concat({place(state, node, key), message}));
}

void add_missing(TomlState& state, const TomlNode& node, const KeySpec& spec) {
  add_fault(state, node, spec.key, concat({"missing, expected ", spec.type, " (", spec.meaning, ")"}));
}

void add_unknown_keys(TomlState& state) {
  add_unknown_keys_in(state, {.table = &state.root, .label = {}, .schema = {}});
}

std::string_view type_name(const toml::node& value) {
  switch (value.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return value.is_array_of_tables() ? "an array of tables" : "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    case toml::node_type::date:
      return "a date";
    case toml::node_type::time:
      return "a time";
    case toml::node_type::date_time:
      return "a date and time";
    case toml::node_type::none:
      break;
  }
  return "nothing";
}

}  // namespace scree::io::detail
