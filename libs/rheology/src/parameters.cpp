#include <scree/rheology/parameters.hpp>

#include <cmath>
#include <sstream>

namespace scree::rheology::detail {

void require_within(std::string_view law, std::string_view parameter, std::string_view unit, Bound bound,
                    double value) {
  const bool is_within = bound == Bound::positive ? value > 0 : value >= 0;
  if (is_within && std::isfinite(value)) return;
  std::ostringstream message;
  message << law << ": " << parameter << " = " << value << ' ' << unit << ": must be finite and "
          << (bound == Bound::positive ? "above 0" : "at least 0");
  throw InputError{message.str()};
}

}  // namespace scree::rheology::detail
