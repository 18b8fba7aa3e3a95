#include <scree/error.hpp>
#include <scree/rheology/batch.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace scree::rheology::detail {

void require_length(std::string_view law, std::string_view column, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  std::ostringstream message;
  message << "the law '" << law << "' is given " << length << " numbers as " << column << ": must be "
          << expected << ", as many as of density";
  throw InputError{message.str()};
}

void require_step(std::string_view law, double dt) {
  if (dt > 0 && std::isfinite(dt)) return;
  std::ostringstream message;
  message << "the law '" << law << "' is given a step of " << dt << " s: must be finite and above 0";
  throw InputError{message.str()};
}

void require_values(std::string_view law, const InputColumn& column, std::span<const double> values) {
  const auto is_wrong = [&](double value) { return !column.range.contains(value); };
  const auto wrong = std::ranges::find_if(values, is_wrong);
  if (wrong == values.end()) return;
  require_in_range(law, column, *wrong, "point " + std::to_string(wrong - values.begin()));
}

}  // namespace scree::rheology::detail
