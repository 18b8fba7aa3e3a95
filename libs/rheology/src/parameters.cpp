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

void require_within(std::string_view law, std::string_view parameter, std::string_view unit, Bound bound,
                    double upper, double value) {
  const bool is_within = (bound == Bound::positive ? value > 0 : value >= 0) && value < upper;
  if (is_within && std::isfinite(value)) return;
  std::ostringstream expected;
  expected << "must be finite and " << (bound == Bound::positive ? "above 0" : "at least 0");
  if (std::isfinite(upper)) expected << " and below " << upper;
  refuse(law, parameter, unit, value, expected.str());
}

void require_relation(std::string_view law, std::string_view parameter, std::string_view unit, double value,
                      const std::string& broken) {
  if (!broken.empty()) refuse(law, parameter, unit, value, broken);
}

std::string must_exceed(std::string_view parameter, double value) {
  std::ostringstream text;
  text << "must exceed " << parameter << " = " << value;
  return text.str();
}

}  // namespace scree::rheology::detail
