#include <scree/error.hpp>
#include <scree/input_column.hpp>

#include <cmath>
#include <sstream>

namespace scree {

void require_in_range(std::string_view law, const InputColumn& column, double value,
                      std::string_view of_whom) {
  const Interval& range = column.range;
  if (range.contains(value)) return;
  std::ostringstream message;
  message << "the law '" << law << "' reads " << column.name << " = " << value;
  if (column.unit != "-") message << ' ' << column.unit;
  if (!of_whom.empty()) message << " of " << of_whom;
  if (range.lower == range.upper) {
    message << ": must be " << range.lower;
  } else if (std::isfinite(range.upper)) {
    message << ": must lie in " << (range.is_open ? '(' : '[') << range.lower << ", " << range.upper
            << (range.is_open ? ')' : ']');
  } else if (!std::isfinite(range.lower)) {
    message << ": must be finite";
  } else {
    message << ": must be finite and " << (range.is_open ? "above " : "at least ") << range.lower;
  }
  throw InputError{message.str()};
}

}  // namespace scree
