#pragma once

#include <limits>
#include <string_view>

namespace scree {

/// Which numbers a quantity can be: those between two ends. Infinity and NaN are never among them.
struct Interval {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  bool is_open = true;  ///< whether the ends themselves are left out

  [[nodiscard]] constexpr bool contains(double value) const noexcept {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(-infinity < value && value < infinity)) return false;
    return is_open ? lower < value && value < upper : lower <= value && value <= upper;
  }
};

/// A column that a law reads.
struct InputColumn {
  std::string_view name;
  std::string_view unit;  ///< SI; "-" if it has none
  double typical;         ///< an ordinary value, for examples and tests [unit]
  Interval range{};       ///< what it can be [unit]: positive if nothing else is said
};

/// Checks a number that a law is given.
/// @param of_whom what it belongs to, for people: "material point 12 at (0.5, 1) m"; may be left out
/// @throws InputError naming law, column, value and range, unless the value is in the column's range.
void require_in_range(std::string_view law, const InputColumn& column, double value,
                      std::string_view of_whom = {});

}  // namespace scree
