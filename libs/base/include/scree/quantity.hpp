#pragma once

#include <string>

namespace scree {

/// What a stored column is, for people and files.
struct Quantity {
  std::string name;    ///< the field's full term, snake_case: "velocity"
  std::string symbol;  ///< the field's symbol: "v"
  std::string unit;    ///< SI: "m/s"; "-" if it has none

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

}  // namespace scree
