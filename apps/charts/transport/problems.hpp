#pragma once

#include "../cpu_time.hpp"
#include "record.hpp"

#include <algorithm>
#include <vector>

namespace scree::charts {

/// How much of a problem is run.
struct Extent {
  bool is_quick = false;  ///< the two coarsest grids only
  Effort effort;
};

/// sin x over one period, periodic; L1 on [0, 2 pi].
[[nodiscard]] std::vector<Record> advection(const Extent& extent);
/// Burgers' equation from 0.5 + sin x at T = 0.5, half-way to the shock; L1 on [0, 2 pi].
[[nodiscard]] std::vector<Record> burgers_smooth(const Extent& extent);
/// The same at T = 2, with a shock; mean over four places of the shock in its cell.
[[nodiscard]] std::vector<Record> burgers_shock(const Extent& extent);
/// Sod's shock tube at T = 0.2; L1 of the density on [-0.5, 0.5].
[[nodiscard]] std::vector<Record> sod(const Extent& extent);
/// Shu and Osher's shock that runs into waves of density, T = 1.8, against our own run with 12 800 cells; L1
/// of the density on [-5, 5].
[[nodiscard]] std::vector<Record> shu_osher(const Extent& extent);
/// Zalesak's slotted disk, one turn in the unit square; L1 over the area of the disk.
[[nodiscard]] std::vector<Record> slotted_disk(const Extent& extent);
/// Two sizes of ratio 2, fines on top, W t/H = 1: a fan between two shocks; L1 of all fractions.
[[nodiscard]] std::vector<Record> segregation_two_sizes(const Extent& extent);
/// Five sizes from a mixture, W t/H = 1.3: ten shocks; L1 of all fractions.
[[nodiscard]] std::vector<Record> segregation_five_sizes(const Extent& extent);

/// The numbers of cells: each twice the one before.
[[nodiscard]] inline std::vector<Index> doublings(Index coarsest, int count, const Extent& extent) {
  std::vector<Index> cells;
  for (int level = 0; level < (extent.is_quick ? std::min(2, count) : count); ++level) {
    cells.push_back(coarsest << level);
  }
  return cells;
}

}  // namespace scree::charts
