#pragma once

#include <scree/error.hpp>

#include <cmath>
#include <cstddef>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

namespace scree::grainsize::detail {

/// The parts of a message one after the other, numbers in six digits.
template <class... Parts>
[[nodiscard]] std::string message(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// @throws InputError unless `lengths` [m] are positive, finite and strictly increasing; `what` names one.
inline void require_increasing(std::span<const double> lengths, std::string_view what) {
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    if (!(lengths[k] > 0 && std::isfinite(lengths[k]))) {
      throw InputError{message(what, " ", k + 1, " is ", lengths[k], " m, but must be positive and finite")};
    }
    if (k > 0 && !(lengths[k] > lengths[k - 1])) {
      throw InputError{message(what, " ", k + 1, " is ", lengths[k], " m, but must exceed the one before, ",
                               lengths[k - 1], " m")};
    }
  }
}

}  // namespace scree::grainsize::detail
