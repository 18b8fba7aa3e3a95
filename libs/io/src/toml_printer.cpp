#include "toml_printer.hpp"

#include "concat.hpp"

#include <algorithm>
#include <sstream>
#include <tuple>
#include <vector>

namespace scree::io::detail {
namespace {

struct Entry {
  const toml::key* key;
  const toml::node* value;
};

/// The entries of a table in the order of the file, those of the command line last.
std::vector<Entry> in_order(const toml::table& table) {
  std::vector<Entry> entries;
  for (const auto& [key, value] : table) entries.push_back({&key, &value});
  std::ranges::stable_sort(entries, {}, [](const Entry& entry) {
    const toml::source_position& place = entry.key->source().begin;
    return std::tuple{place.line == 0, place.line, place.column};
  });
  return entries;
}

bool is_table_like(const toml::node& value) {
  return value.is_table() || value.is_array_of_tables();
}

std::string print_key(std::string_view key) {
  if (is_bare_key(key)) return std::string{key};
  std::ostringstream stream;
  stream << toml::value<std::string>{key};
  return stream.str();
}

std::string below(std::string_view path, std::string_view key) {
  return path.empty() ? std::string{key} : concat({path, ".", key});
}

void print_values(const TomlState& state, const toml::table& table, const std::string& path,
                  std::string& out) {
  for (const Entry& entry : in_order(table)) {
    if (is_table_like(*entry.value)) continue;
    const std::string key = print_key(entry.key->str());
    const auto change = state.overrides.find(below(path, key));
    out += key + " = ";
    out += change != state.overrides.end() ? change->second.value : source_text(state, *entry.value);
    out += '\n';
  }
}

void print_tables(const TomlState& state, const toml::table& table, const std::string& path,
                  std::string& out);

void print_table(const TomlState& state, const toml::table& table, const std::string& path,
                 const std::string& header, std::string& out) {
  out += (out.empty() ? "" : "\n") + header + "\n";
  print_values(state, table, path, out);
  print_tables(state, table, path, out);
}

void print_tables(const TomlState& state, const toml::table& table, const std::string& path,
                  std::string& out) {
  for (const Entry& entry : in_order(table)) {
    const std::string key = print_key(entry.key->str());
    const std::string inner = below(path, key);
    if (const toml::table* const only = entry.value->as_table()) {
      print_table(state, *only, inner, concat({"[", inner, "]"}), out);
    } else if (entry.value->is_array_of_tables()) {
      for (const toml::node& element : *entry.value->as_array()) {
        print_table(state, *element.as_table(), inner, concat({"[[", inner, "]]"}), out);
      }
    }
  }
}

}  // namespace

bool is_bare_key(std::string_view key) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  return !key.empty() && key.find_first_not_of(letters) == std::string_view::npos;
}

std::string print(const TomlState& state) {
  std::string out;
  print_values(state, state.root, "", out);
  print_tables(state, state.root, "", out);
  return out;
}

}  // namespace scree::io::detail
