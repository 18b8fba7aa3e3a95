#include <scree/rheology/parameters.hpp>

#include <cmath>
#include <sstream>

namespace scree::rheology::detail {

namespace {

[[noreturn]] void refuse(std::string_view law, std::string_view parameter, std::string_view unit,
                         double value, const std::string& expected) {
  std::ostringstream message;
  message << law << ": " << parameter << " = " << value;
  if (unit != "-") message << ' ' << unit;
  message << ": " << expected;
  throw InputError{message.str()};
}

}  // namespace

void require_within(std::string_view law, std::string_view parameter, std::string_view unit,
                    const Range& range, double value) {
  const bool is_open = range.bound == Bound::positive;
  const bool is_within = (is_open ? value > range.lower : value >= range.lower) && value < range.upper;
  if (is_within && std::isfinite(value)) return;
  std::ostringstream expected;
  expected << "must be finite and " << (is_open ? "above " : "at least ") << range.lower;
  if (std::isfinite(range.upper)) expected << " and below " << range.upper;
  refuse(law, parameter, unit, value, expected.str());
}

void require_relation(std::string_view law, std::string_view parameter, std::string_view unit, double value,
                      const std::string& broken) {
  if (!broken.empty()) refuse(law, parameter, unit, value, broken);
}

std::string must_exceed(std::string_view parameter, double value, bool may_equal) {
  std::ostringstream text;
  text << (may_equal ? "must be at least " : "must exceed ") << parameter << " = " << value;
  return text.str();
}

}  // namespace scree::rheology::detail
