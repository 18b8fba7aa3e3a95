#pragma once

#include <scree/error.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace scree::io::detail {

/// The words of a text, one after the other, and where they are.
class Words {
 public:
  Words(std::string_view text, std::string name) : rest_{text}, name_{std::move(name)} {}

  /// The next word; empty at the end.
  std::string_view next() {
    const std::string_view word = peek();
    rest_.remove_prefix(word.size());
    return word;
  }
  /// The same, without going on.
  std::string_view peek() {
    const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    const auto* const begin = std::ranges::find_if_not(rest_, is_space);
    line_ += std::count(rest_.begin(), begin, '\n');
    rest_.remove_prefix(static_cast<std::size_t>(begin - rest_.begin()));
    const auto* const end = std::ranges::find_if(rest_, is_space);
    return rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  }
  /// The next word as a number.  @throws InputError if it is none.
  double number() {
    const std::string_view word = next();
    const std::optional<double> value = to_number(word);
    if (!value) fail(word.empty() ? "ends where a number is due" : quoted(word) + " is not a number");
    return *value;
  }
  /// Throws `file:line: what`.
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError{name_ + ':' + std::to_string(line_) + ": " + what};
  }
  /// Throws `file: what`.
  [[noreturn]] void fail_whole(const std::string& what) const { throw InputError{name_ + ": " + what}; }

  [[nodiscard]] static std::string quoted(std::string_view word) {
    return std::string{"'"}.append(word).append("'");
  }
  [[nodiscard]] static std::optional<double> to_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_whole = error == std::errc{} && end == word.data() + word.size() && !word.empty();
    return is_whole ? std::optional<double>{value} : std::nullopt;
  }

 private:
  std::string_view rest_;
  std::string name_;
  std::ptrdiff_t line_ = 1;
};

}  // namespace scree::io::detail
