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

void require_trace_zero(std::string_view law, std::span<const StateColumn, 6> columns,
                        std::span<const std::span<double>, 6> values) {
  // Ten million steps that each round 240 times the same way leave less, and so do numbers that were stored
  // in single precision.
  constexpr double tolerance = 1e-6;  // [-]
  double largest = 0;
  for (const auto column : values) {
    for (const double value : column) largest = std::max(largest, std::abs(value));
  }
  for (std::size_t p = 0; p < values[0].size(); ++p) {
    const double trace = values[0][p] + values[1][p] + values[2][p];
    if (std::abs(trace) <= tolerance * largest) continue;
    std::ostringstream sum;
    sum << columns[0].name << " + " << columns[1].name << " + " << columns[2].name;
    require_in_range(law, {sum.str(), columns[0].unit, 0, Interval{0, 0, false}}, trace,
                     "point " + std::to_string(p));
  }
}

}  // namespace scree::rheology::detail
