#pragma once

#include <scree/tensor.hpp>

namespace scree::transport::detail {

/// A number that is the same at every site or face of a row. Where it differs a `const double*` stands in
/// its place: both are read by an index and cut by adding one.
struct Same {
  double value;
  [[nodiscard]] double operator[](Index /*entry*/) const noexcept { return value; }
  [[nodiscard]] friend Same operator+(Same row, Index /*begin*/) noexcept { return row; }
};

}  // namespace scree::transport::detail
