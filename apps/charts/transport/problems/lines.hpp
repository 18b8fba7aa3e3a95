#pragma once

#include <scree/lattice.hpp>

#include <vector>

namespace scree::charts {

/// n cells between two ends.
[[nodiscard]] inline Lattice<1> line(Index n, double low, double high, bool is_periodic) {
  const double dx = (high - low) / static_cast<double>(n);
  return {
      .count = {n}, .spacing = Vector<1>{dx}, .first = Vector<1>{low + dx / 2}, .is_periodic = {is_periodic}};
}

/// Cell averages of a function: the differences of its antiderivative.
template <class Antiderivative>
[[nodiscard]] std::vector<double> averages(const Lattice<1>& cells, Antiderivative&& integral) {
  std::vector<double> result;
  for (Index i = 0; i < cells.count[0]; ++i) {
    const double low = cells.first[0] + (static_cast<double>(i) - 0.5) * cells.spacing[0];
    result.push_back((integral(low + cells.spacing[0]) - integral(low)) / cells.spacing[0]);
  }
  return result;
}

}  // namespace scree::charts
