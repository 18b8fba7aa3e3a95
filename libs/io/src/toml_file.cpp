#include "concat.hpp"
#include "toml_printer.hpp"
#include "toml_state.hpp"

#include <scree/error.hpp>
#include <scree/io/toml_reader.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace scree::io {
namespace {

struct Assignment {
  std::vector<std::string> path;
  std::string value;  ///< as TOML
};

bool holds_table(const toml::node& node) {
  if (node.is_table()) return true;
  const toml::array* const array = node.as_array();
  return array != nullptr && std::ranges::any_of(*array, holds_table);
}

/// The value as TOML: itself, or in quotes if it is none and has no mark that says it was meant to be.
/// @throws InputError
std::string to_toml(const std::string& value, const std::string& place) {
  if (value.find('\n') == std::string::npos) {
    try {
      const toml::table parsed = toml::parse(detail::concat({"value = ", value}));
      require(!holds_table(*parsed.get("value")), place + "a table is set key by key");
      return value;
    } catch (const toml::parse_error&) {
      if (value.find_first_of("\"'[]{}=#") == std::string::npos) return detail::concat({"'", value, "'"});
    }
  }
  throw InputError{place + "the value is not TOML"};
}

/// @throws InputError
Assignment parse_assignment(std::string_view text, const std::string& place) {
  const std::size_t equals = text.find('=');
  const bool is_assignment = equals != std::string_view::npos && equals > 0 && equals + 1 < text.size();
  require(is_assignment, place + "expected table.key=value");
  Assignment assignment;
  std::string_view rest = text.substr(0, equals);
  for (bool is_last = false; !is_last;) {
    const std::size_t dot = rest.find('.');
    is_last = dot == std::string_view::npos;
    assignment.path.emplace_back(rest.substr(0, dot));
    require(detail::is_bare_key(assignment.path.back()), place + "expected table.key=value");
    if (!is_last) rest.remove_prefix(dot + 1);
  }
  assignment.value = to_toml(std::string{text.substr(equals + 1)}, place);
  return assignment;
}

/// The table that holds the last name of the path, made if it is not there.  @throws InputError
toml::table& holder(toml::table& root, const std::vector<std::string>& path, const std::string& place) {
  toml::table* table = &root;
  for (std::size_t depth = 0; depth + 1 < path.size(); ++depth) {
    toml::node& next = table->insert(path[depth], toml::table{}).first->second;
    const std::string so_far = detail::joined(std::span{path}.first(depth + 1), ".");
    require(next.is_table(), detail::concat({place, "'", so_far, "' is not a table"}));
    table = next.as_table();
  }
  return *table;
}

std::unique_ptr<detail::TomlState> parse_state(std::string_view text, std::string name) {
  auto state = std::make_unique<detail::TomlState>();
  state->name = std::move(name);
  state->text = text;
  try {
    state->root = toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position& where = error.source().begin;
    throw InputError{detail::concat({state->name, ":", std::to_string(where.line), ":",
                                     std::to_string(where.column), ": ", error.description()})};
  }
  return state;
}

}  // namespace

TomlFile::TomlFile(std::unique_ptr<detail::TomlState> state) : state_{std::move(state)} {}
TomlFile::TomlFile(TomlFile&&) noexcept = default;
TomlFile& TomlFile::operator=(TomlFile&&) noexcept = default;
TomlFile::~TomlFile() = default;

TomlFile TomlFile::read(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream stream{path, std::ios::binary};
  stream.peek();
  if (!stream && errno != 0) throw InputError{path.string() + ": cannot be read: " + std::strerror(errno)};
  const std::string text{std::istreambuf_iterator<char>{stream}, {}};
  return parse(text, path.string());
}

TomlFile TomlFile::parse(std::string_view text, std::string name) {
  return TomlFile{parse_state(text, std::move(name))};
}

void TomlFile::set(std::string_view text) {
  const std::string place = detail::concat({"--set ", text, ": "});
  const Assignment assignment = parse_assignment(text, place);
  const std::string path = detail::joined(assignment.path, ".");
  toml::table value = toml::parse(detail::concat({"value = ", assignment.value}));
  holder(state_->root, assignment.path, place)
      .insert_or_assign(assignment.path.back(), std::move(*value.get("value")));
  const std::string prefix = path + ".";
  std::erase_if(state_->overrides, [&](const auto& change) { return change.first.starts_with(prefix); });
  state_->overrides[path] = {.assignment = std::string{text}, .value = assignment.value};
}

TomlTable TomlFile::root() {
  return {*state_, {.table = &state_->root, .label = {}, .schema = {}}};
}

void TomlFile::finish() {
  detail::add_unknown_keys(*state_);
  state_->faults.throw_if_any();
}

std::span<const KnownKey> TomlFile::known_keys() const noexcept {
  return state_->known_keys;
}

std::string TomlFile::to_text() const {
  return state_->overrides.empty() ? state_->text : detail::print(*state_);
}

}  // namespace scree::io
