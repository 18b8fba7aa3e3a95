#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/// The exact solution of segregation_column: any number of sizes s_k, from a mixture, under a constant driver
/// W.
///
/// A mixture has invariants sigma_j between s_j and s_j+1, the roots of sum_k Phi_k/(s_k - sigma) = 0. With
/// them s_h = prod s_k/prod sigma_j, and the mean size is sum s_k - sum sigma_j. (The characteristic speeds
/// of Eq. (G10) are W (1 - s_h/sigma_j).) A front changes one sigma_j; the fluxes on its two sides balance at
/// the speed W (1 - s_h below it/sigma_j above it). Fronts of different j pass through each other and keep
/// theirs.
namespace demo {

struct Front {
  std::size_t j;     ///< of the invariant that it changes
  double z;          ///< height [m]
  double below;      ///< sigma_j below it [m]
  double above;      ///< sigma_j above it [m]
  double speed = 0;  ///< upwards [m/s]
};

struct ExactColumn {
  double smallest;            ///< s_1 [m]: the finest grains are alone at the base
  double driver;              ///< W [m/s]
  std::vector<Front> fronts;  ///< from the base upwards
};

/// A mixture in a column of some height [m], with its fronts where they start.
/// @param sizes s_k [m], increasing  @param invariants sigma_j of the mixture [m], one less
[[nodiscard]] inline ExactColumn exact_column(const std::vector<double>& sizes,
                                              const std::vector<double>& invariants, double height,
                                              double driver) {
  ExactColumn column{sizes.front(), driver, {}};
  for (std::size_t j = 0; j < invariants.size(); ++j) {
    column.fronts.push_back({j, 0, sizes[j + 1], invariants[j]});  // from the finest grains to the mixture
  }
  for (std::size_t j = 0; j < invariants.size(); ++j) {
    column.fronts.push_back({j, height, invariants[j], sizes[j]});  // from the mixture to the coarsest
  }
  return column;
}

/// Moves the fronts by a duration [s], through all their meetings.
inline void advance(ExactColumn& column, double duration) {
  auto& fronts = column.fronts;
  double s_h = column.smallest;
  for (Front& front : fronts) {
    front.speed = column.driver * (1 - s_h / front.above);
    s_h *= front.below / front.above;
  }
  double wait = duration;
  auto lower = fronts.end();  // of the two that meet first
  for (auto front = fronts.begin(); front + 1 < fronts.end(); ++front) {
    const double closing = front[0].speed - front[1].speed;
    const double gap = std::max(0.0, front[1].z - front[0].z);
    if (closing < 1e-12 * column.driver || gap >= wait * closing)
      continue;  // parting, to round-off, or later
    wait = gap / closing;
    lower = front;
  }
  for (Front& front : fronts) front.z += front.speed * wait;
  if (lower == fronts.end()) return;
  if (lower[0].j == lower[1].j) {  // they merge
    lower[1].below = lower[0].below;
    fronts.erase(lower);
  } else {
    std::swap(lower[0], lower[1]);
  }
  advance(column, duration - wait);
}

/// The integral of the mean size from the base to z [m^2]: every front adds its jump.
[[nodiscard]] inline double integral_of_mean_size(const ExactColumn& column, double z) {
  double sum = column.smallest * z;
  for (const Front& front : column.fronts) sum += (front.below - front.above) * std::max(0.0, z - front.z);
  return sum;
}

}  // namespace demo
