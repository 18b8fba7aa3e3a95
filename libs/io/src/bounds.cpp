#include <scree/io/bounds.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace scree::io {

std::string to_text(double value) {
  std::array<char, 32> digits{};  // the longest double takes 24
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string Bounds::to_text() const {
  const bool has_lower = std::isfinite(lower);
  const bool has_upper = std::isfinite(upper);
  if (has_lower && has_upper) {
    return std::string{"must lie in "} + (is_lower_open ? "(" : "[") + io::to_text(lower) + ", " +
           io::to_text(upper) + (is_upper_open ? ")" : "]");
  }
  if (has_lower) return (is_lower_open ? "must exceed " : "must be at least ") + io::to_text(lower);
  if (has_upper) return (is_upper_open ? "must be below " : "must be at most ") + io::to_text(upper);
  return "";
}

}  // namespace scree::io
