#include "checks.hpp"

#include <scree/grainsize/maximum_packing.hpp>

#include <algorithm>
#include <cmath>

namespace scree::grainsize {

namespace {

/// How much finer grains loosen coarser ones: 0 if they fit into the pores, 1 if they are as large.  Eq.
/// (G32)
/// @param ratio of the finer size to the coarser [-]
[[nodiscard]] double loosening(double ratio) {
  return std::sqrt(1 - std::pow(1 - ratio, 1.02));
}

/// How little the walls of coarser grains spoil the packing of finer ones: 0 for a plane wall, 1 for grains
/// that are as large.  Eq. (G32)
[[nodiscard]] double wall(double ratio) {
  return 1 - std::pow(1 - ratio, 1.5);
}

void require_packing(double packing, double compaction) {
  if (!(0 < packing && packing < 1)) {
    throw InputError{detail::message("CompressiblePacking: the packing of one size is ", packing,
                                     ", but must lie between 0 and 1")};
  }
  const double least = packing / (1 - packing);
  if (!(compaction > least && std::isfinite(compaction))) {
    throw InputError{detail::message("CompressiblePacking: the compaction is ", compaction,
                                     ", but must be finite and exceed ", least,
                                     ", where one size would fill all space")};
  }
}

}  // namespace

CompressiblePacking::CompressiblePacking(const SizeClasses& classes, double packing_of_one_size,
                                         double compaction)
    : num_classes_{classes.size()},
      densest_{packing_of_one_size * (1 + 1 / compaction)},
      compaction_{compaction},
      spared_(num_classes_ * num_classes_) {
  require_packing(packing_of_one_size, compaction);
  const std::span<const double> sizes = classes.diameters();
  for (std::size_t i = 0; i < num_classes_; ++i) {
    for (std::size_t j = 0; j < num_classes_; ++j) {
      double& spared = spared_[i * num_classes_ + j];
      if (j < i) spared = 1 - loosening(sizes[j] / sizes[i]);
      if (j > i) spared = (1 - densest_) * (1 - wall(sizes[i] / sizes[j]));
    }
  }
}

/// 1/gamma_i [-]: space per solid where class i is packed as densely as can be.  Eq. (G30)
double CompressiblePacking::least_volume(std::size_t i, std::span<const double> fractions) const noexcept {
  double spared = 0;
  for (std::size_t j = 0; j < num_classes_; ++j) spared += spared_[i * num_classes_ + j] * fractions[j];
  return (1 - spared) / densest_;
}

/// Newton's method for the space per solid u. The sum of Eq. (G31) is convex and falls in u, so that u grows
/// up to the root from a start where one class alone would have all of K, and ends where it no longer does.
double CompressiblePacking::maximum_fraction(std::span<const double> fractions) const noexcept {
  SCREE_ASSERT(fractions.size() == num_classes_);
  double u = 0;
  for (std::size_t i = 0; i < num_classes_; ++i) {
    if (fractions[i] <= 0) continue;
    u = std::max(u, least_volume(i, fractions) + fractions[i] / (densest_ * compaction_));
  }
  for (double before = 0; before < u;) {
    before = u;
    double sum = 0;
    double slope = 0;
    for (std::size_t i = 0; i < num_classes_; ++i) {
      if (fractions[i] <= 0) continue;
      const double room = u - least_volume(i, fractions);
      const double term = fractions[i] / (densest_ * room);
      sum += term;
      slope += term / room;
    }
    u += (sum - compaction_) / slope;
  }
  return 1 / u;
}

}  // namespace scree::grainsize
