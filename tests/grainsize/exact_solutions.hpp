#pragma once

#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace scree::test {

/// Two sizes in a closed column of height 1 under a constant driver W = 1, time T = W t: fines settle from a
/// mixture with phi_0 of them. Two shocks, from the base and from the top.
struct HomogeneousColumn {
  double size_ratio;
  double phi_0;
  double time;

  [[nodiscard]] double base_front() const { return shock_speed() * phi_0 * time; }
  [[nodiscard]] double top_front() const { return 1 - shock_speed() * (1 - phi_0) * time; }

  /// Fines at height z [-].
  [[nodiscard]] double fraction(double z) const {
    if (z < base_front()) return 1;
    return z < top_front() ? phi_0 : 0;
  }
  /// Volume of fines below height z.
  [[nodiscard]] double below(double z) const {
    const double pure = std::min(z, base_front());
    return pure + phi_0 * std::max(0.0, std::min(z, top_front()) - base_front());
  }

 private:
  [[nodiscard]] double shock_speed() const { return (size_ratio - 1) / (1 + (size_ratio - 1) * phi_0); }
};

/// The same from an inverted start, the fines in the uppermost `share` of the column: a fan of rarefaction
/// between a shock that rises from the base once the first fines arrive, and one from the top.
struct InvertedColumn {
  double size_ratio;
  double share;
  double time;

  [[nodiscard]] double base_front() const {
    const double x = (1 + std::sqrt(q() * interface() / time)) / std::sqrt(size_ratio);
    return q() * time < interface() ? 0 : interface() + time * (1 - x * x);
  }
  [[nodiscard]] double top_front() const {
    const double x = std::sqrt(size_ratio) - std::sqrt(q() * share / time);
    return q() * time < size_ratio * share ? 1 : interface() + time * (1 - x * x);
  }
  [[nodiscard]] double fraction(double z) const {
    if (z < base_front()) return 1;
    if (z > top_front()) return 0;
    const double characteristic = std::clamp(speed(z), -q(), q() / size_ratio);
    return (std::sqrt(size_ratio / (1 - characteristic)) - 1) / q();
  }
  [[nodiscard]] double below(double z) const {
    if (z < base_front()) return z;
    if (z > top_front()) return share;
    if (speed(z) < -q()) return 0;
    const double pure = std::max(0.0, z - interface() - time * q() / size_ratio);
    const double x = std::sqrt(1 - std::min(speed(z), q() / size_ratio)) - std::sqrt(size_ratio);
    return time * x * x / q() + pure;
  }

 private:
  [[nodiscard]] double q() const { return size_ratio - 1; }
  [[nodiscard]] double interface() const { return 1 - share; }
  [[nodiscard]] double speed(double z) const { return (z - interface()) / time; }
};

/// Several sizes from a homogeneous start: constant states between fronts.
struct FrontColumn {
  std::vector<double> fronts;               ///< upper ends of the states but the last, increasing
  std::vector<std::vector<double>> states;  ///< num_fronts + 1 of num_classes fractions

  /// Volume of class k below height z.
  [[nodiscard]] double below(double z, std::size_t k) const {
    double volume = 0;
    double bottom = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const double top = i < fronts.size() ? fronts[i] : 1;
      volume += states[i][k] * std::max(0.0, std::min(z, top) - bottom);
      bottom = top;
    }
    return volume;
  }
};

/// The tabulated solution `name` at the time written as `time` in the tables.
/// @throws InputError if the tables do not have it whole.
[[nodiscard]] inline FrontColumn read_front_column(const std::string& name, const std::string& time) {
  FrontColumn column;
  for (const auto& row : read_table("segregation/polydisperse_fronts_exact.csv")) {
    if (row[0] == name && row[1] == time) column.fronts.push_back(std::stod(row[3]));
  }
  column.states.resize(column.fronts.size() + 1);
  for (const auto& row : read_table("segregation/polydisperse_profiles_exact.csv")) {
    if (row[0] != name || row[1] != time) continue;
    const auto above = std::upper_bound(column.fronts.begin(), column.fronts.end(), std::stod(row[2]));
    auto& state = column.states[static_cast<std::size_t>(above - column.fronts.begin())];
    state.clear();
    for (std::size_t k = 5; k < row.size(); ++k) state.push_back(std::abs(std::stod(row[k])));
  }
  for (const auto& state : column.states) {
    if (state.empty()) throw InputError{"the table of " + name + " has a gap at " + time};
  }
  return column;
}

}  // namespace scree::test
