#pragma once

#include <scree/io/faults.hpp>
#include <scree/io/toml_reader.hpp>

#include <toml++/toml.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace scree::io::detail {

/// A change of the command line: as it was given, and its value as TOML.
struct Override {
  std::string assignment;
  std::string value;
};

/// Where a TomlTable stands.
struct TomlNode {
  const toml::table* table;  ///< null: left out by the file
  std::string label;         ///< with its place in arrays, counted from 1: "walls 2"
  std::string schema;        ///< without: "walls"
  int line = 0;              ///< of its header; 0: none
  bool is_silent = false;    ///< its absence is a fault already
};

/// One key as its reader described it.
struct KeySpec {
  std::string_view key;
  std::string_view meaning;
  std::string_view type;  ///< "an integer"
  std::string rule;       ///< "must exceed 0"; may be empty
};

/// All that a TomlFile and its tables share.
struct TomlState {
  std::string name;
  std::string text;
  toml::table root;
  std::map<std::string, Override> overrides;  ///< by path
  Faults faults;
  std::set<std::string> faulty_paths;
  std::map<std::string, std::vector<std::string>> asked;  ///< keys by the label of their table
  std::vector<KnownKey> known_keys;
};

/// "mesh.cells"; the key alone at the top of the file.
[[nodiscard]] std::string path_of(const TomlNode& node, std::string_view key);

/// The part of the file's text that made a value: "0.30".
[[nodiscard]] std::string_view source_text(const TomlState& state, const toml::node& value);

/// Notes a key that its reader asked for.
void remember(TomlState& state, const TomlNode& node, const KeySpec& spec, std::string fallback);

/// The value of a key, or null.
[[nodiscard]] const toml::node* find(const TomlNode& node, std::string_view key);

/// A fault at a key, at most one for each: "scene.toml:14: [rheology] mu_2 = 0.30: " and the message.
void add_fault(TomlState& state, const TomlNode& node, std::string_view key, std::string_view message);

/// The fault of a required key: "missing, expected an integer (number of cells)".
void add_missing(TomlState& state, const TomlNode& node, const KeySpec& spec);

/// A fault for every key of the tables read that no reader asked for.
void add_unknown_keys(TomlState& state);

/// "an integer", "a string", ...
[[nodiscard]] std::string_view type_name(const toml::node& value);

}  // namespace scree::io::detail
