#pragma once

#include <scree/grainsize/size_classes.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace scree::grainsize {

/// The largest share of space that a mixture of sizes fills, by the compressible packing model: coarser
/// grains take room of their own volume from finer ones and spoil some beside their walls; finer ones fit
/// into the pores of coarser ones, or force them open. How near all classes come to their densest arrangement
/// is one index.
/// @see Eqs. (G30) to (G32), from de Larrard (1999), \cite delarrard1999
class CompressiblePacking {
 public:
  /// @param packing_of_one_size solid fraction at which grains of one size are packed [-]: spheres 0.64 at
  /// random, 0.585 where they still flow
  /// @param compaction index K [-]: 4.1 for grains that are poured, 9 for vibrated ones
  /// @throws InputError unless the packing lies between 0 and 1, and K is finite and above packing/(1 -
  /// packing), where the densest arrangement would fill all space.
  CompressiblePacking(const SizeClasses& classes, double packing_of_one_size, double compaction);

  /// Solid fraction at which a mixture is packed [-].
  /// @param fractions Phi_k [-], one per class, their sum 1
  [[nodiscard]] double maximum_fraction(std::span<const double> fractions) const noexcept;

  /// Number of classes N.
  [[nodiscard]] std::size_t num_classes() const noexcept { return num_classes_; }

 private:
  [[nodiscard]] double least_volume(std::size_t i, std::span<const double> fractions) const noexcept;

  std::size_t num_classes_;
  double densest_;  // beta, the densest packing of one size
  double compaction_;
  std::vector<double> spared_;  // num_classes x num_classes: share of j's volume that i does without
};

}  // namespace scree::grainsize
