#pragma once

#include <scree/io/bounds.hpp>
#include <scree/io/faults.hpp>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

namespace detail {
struct TomlNode;
struct TomlState;
}  // namespace detail

/// What a reader asked for once: enough to document the key.
struct KnownKey {
  std::string table;        ///< "rheology"; empty for the top of the file
  std::string key;          ///< "viscosity"
  std::string meaning;      ///< with its unit: "dynamic viscosity [Pa s]"
  std::string expectation;  ///< "a number, must exceed 0"
  std::string fallback;     ///< the default as TOML; empty if the key is required
};

/// One table of a TOML file, read key by key. Refers to its TomlFile, which must outlive it.
///
/// Nothing throws: each fault goes to the file's list, with its place. A key that is faulty or missing reads
/// as the fallback, or NaN, 0, false, "", the first choice or nothing, so that reading goes on to the next
/// fault; finish() of the file then throws. Every key asked for is known; any other is a fault.
/// `meaning` is what the value is, with its unit, as a person reads it: "dynamic viscosity [Pa s]".
class TomlTable {
 public:
  /// Whether the key is there. It counts as known.
  [[nodiscard]] bool has(std::string_view key) const;
  /// Whether the key is there and holds a table, for keys that may be either a value or a table. It counts as
  /// known.
  [[nodiscard]] bool is_table(std::string_view key) const;
  /// Whether the key is there and holds a string, for keys that may be a name or a number. It counts as
  /// known.
  [[nodiscard]] bool is_string(std::string_view key) const;

  /// A finite number; an integer will do.
  double number(std::string_view key, std::string_view meaning, const Bounds& bounds = any_value()) const;
  double number_or(double fallback, std::string_view key, std::string_view meaning,
                   const Bounds& bounds = any_value()) const;
  std::int64_t integer(std::string_view key, std::string_view meaning,
                       const Bounds& bounds = any_value()) const;
  std::int64_t integer_or(std::int64_t fallback, std::string_view key, std::string_view meaning,
                          const Bounds& bounds = any_value()) const;
  bool boolean(std::string_view key, std::string_view meaning) const;
  bool boolean_or(bool fallback, std::string_view key, std::string_view meaning) const;
  std::string string(std::string_view key, std::string_view meaning) const;
  std::string string_or(std::string_view fallback, std::string_view key, std::string_view meaning) const;
  /// One of the names allowed, of which there is at least one.
  std::string choice(std::string_view key, std::string_view meaning,
                     std::span<const std::string_view> allowed) const;
  std::string choice_or(std::string_view fallback, std::string_view key, std::string_view meaning,
                        std::span<const std::string_view> allowed) const;
  /// An array of finite numbers, each within the bounds. @param count how many, if it matters.
  std::vector<double> numbers(std::string_view key, std::string_view meaning,
                              const Bounds& bounds = any_value(),
                              std::optional<std::size_t> count = {}) const;
  /// An array of strings.
  std::vector<std::string> strings(std::string_view key, std::string_view meaning) const;

  /// A table that must be there.
  TomlTable table(std::string_view key) const;
  /// A table that may be left out: it then reads as an empty one.
  TomlTable table_or_empty(std::string_view key) const;
  /// An array of tables, [[key]]; none if the key is absent.
  std::vector<TomlTable> tables(std::string_view key) const;

  /// Reports at a key what only the caller can see: "must be a multiple of 3". Say nothing of a key with a
  /// fault already.
  void add_fault(std::string_view key, std::string_view message) const;
  /// True if no fault was found at the key: only then is its value the user's own.
  [[nodiscard]] bool is_sound(std::string_view key) const;
  /// add_fault(keys[0], message) unless the condition holds or one of the keys is not sound.
  void check(bool condition, std::initializer_list<std::string_view> keys, std::string_view message) const;

 private:
  friend class TomlFile;
  TomlTable(detail::TomlState& state, const detail::TomlNode& node);

  detail::TomlState* state_;
  std::shared_ptr<const detail::TomlNode> node_;
};

/// A TOML file that a person wrote, with the changes of a command line on top.
class TomlFile {
 public:
  /// @throws InputError naming the file and the system's reason, or `file:line:column: ` and the error.
  [[nodiscard]] static TomlFile read(const std::filesystem::path& path);
  /// The same of a text; `name` stands for the file in messages.
  [[nodiscard]] static TomlFile parse(std::string_view text, std::string name);

  TomlFile(TomlFile&&) noexcept;
  TomlFile& operator=(TomlFile&&) noexcept;
  TomlFile(const TomlFile&) = delete;
  TomlFile& operator=(const TomlFile&) = delete;
  ~TomlFile();

  /// Sets or adds one key: "mesh.cells=102". The value is TOML; what is not, such as a bare word, is a
  /// string. Faults of the key are then placed at `--set mesh.cells=102`.
  /// @throws InputError if the assignment has no key or value, or leads through something not a table.
  void set(std::string_view assignment);

  [[nodiscard]] TomlTable root();

  /// Ends the reading.
  /// @throws InputError with all faults, and every key that was never asked for with the nearest one that
  /// was.
  void finish();

  /// Every key that was asked for, in that order, each once.
  [[nodiscard]] std::span<const KnownKey> known_keys() const noexcept;

  /// The whole as TOML: the file's own text, or, after set(), its keys in their order and as they are
  /// written, without the comments.
  [[nodiscard]] std::string to_text() const;

 private:
  explicit TomlFile(std::unique_ptr<detail::TomlState> state);

  std::unique_ptr<detail::TomlState> state_;
};

}  // namespace scree::io
