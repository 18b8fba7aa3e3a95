#include "implicit_viscosity_checks.hpp"

#include <scree/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace scree::rheology::detail {

namespace {

template <class... Part>
[[noreturn]] void refuse(const Part&... part) {
  std::ostringstream text;
  text << "ImplicitViscosity: ";
  (text << ... << part);
  throw InputError{text.str()};
}

void require_length(const char* name, std::size_t length, std::size_t expected) {
  if (length != expected) refuse(length, " values of ", name, ": must be ", expected);
}

void require_each(const char* name, const char* unit, const char* place, std::span<const double> values,
                  double upper) {
  const auto wrong =
      std::ranges::find_if(values, [=](double value) { return !(0 <= value && value <= upper); });
  if (wrong == values.end()) return;
  std::ostringstream expected;
  expected << (std::isfinite(upper) && upper == 1 ? "must lie in [0, 1]"
                                                  : "must be zero or positive, and finite");
  refuse(name, " of ", place, ' ', wrong - values.begin(), " is ", *wrong, unit, ": ", expected.str());
}

constexpr double largest_finite = std::numeric_limits<double>::max();

}  // namespace

void require_valid(const ImplicitViscosityOptions& options) {
  if (!(options.tolerance > 0 && options.tolerance < 1)) {
    refuse("tolerance = ", options.tolerance, ": must lie in (0, 1)");
  }
  if (options.largest_newton < 1) {
    refuse("largest_newton = ", options.largest_newton, ": must be 1 or more");
  }
  if (options.largest_linear < 1) {
    refuse("largest_linear = ", options.largest_linear, ": must be 1 or more");
  }
}

void require_valid(const StepInput& input) {
  const std::size_t num_nodes = input.velocity.size() / input.num_components;
  require_length("mass", input.body.mass.size(), num_nodes);
  if (!input.body.is_held.empty())
    require_length("is_held", input.body.is_held.size(), input.velocity.size());
  if (!input.body.filled.empty()) require_length("filled", input.body.filled.size(), input.num_cells);
  if (!(input.dt >= 0 && std::isfinite(input.dt))) {
    refuse("the step is ", input.dt, " s: must be zero or positive, and finite");
  }
  require_each("the mass", " kg", "node", input.body.mass, largest_finite);
  require_each("the filled share", "", "cell", input.body.filled, 1);
  const auto wrong = std::ranges::find_if(input.velocity, [](double value) { return !std::isfinite(value); });
  if (wrong == input.velocity.end()) return;
  const auto place = static_cast<std::size_t>(wrong - input.velocity.begin());
  refuse("component ", place % input.num_components, " of the velocity of node ",
         place / input.num_components, " is ", *wrong, " m/s: must be finite");
}

void require_valid_viscosity(std::span<const double> viscosity, std::size_t num_cells) {
  require_length("viscosity", viscosity.size(), num_cells);
  require_each("the viscosity", " Pa s", "cell", viscosity, largest_finite);
}

}  // namespace scree::rheology::detail
