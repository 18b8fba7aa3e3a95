#pragma once

#include <scree/tensor.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace scree::grainsize {

/// The size classes of a granular mixture, from fine to coarse.
///
/// A class k stands for all grains with sizes between two edges by one representative diameter s_k [m]. What
/// a point or a control volume carries are the shares Phi_k of the solid volume, one per class.
class SizeClasses {
 public:
  /// Classes without extent, as in a mixture of sieved sands.
  /// @param diameters representative diameters s_k [m], positive, strictly increasing, at least one
  /// @throws InputError if they are not.
  explicit SizeClasses(std::vector<double> diameters);

  /// Classes that fill an interval of sizes.
  /// @param diameters as above
  /// @param edges [m], one more than diameters, strictly increasing, edges[k] <= s_k <= edges[k+1]
  /// @throws InputError if they are not.
  SizeClasses(std::vector<double> diameters, std::vector<double> edges);

  /// Number of classes N.
  [[nodiscard]] std::size_t size() const noexcept { return diameters_.size(); }
  /// Representative diameters s_k [m], strictly increasing.
  [[nodiscard]] std::span<const double> diameters() const noexcept { return diameters_; }
  /// Bounds of the classes [m], size() + 1 of them; empty for classes without extent.
  [[nodiscard]] std::span<const double> edges() const noexcept { return edges_; }
  /// Representative diameter of the finest class [m].
  [[nodiscard]] double smallest() const noexcept { return diameters_.front(); }
  /// Representative diameter of the coarsest class [m].
  [[nodiscard]] double largest() const noexcept { return diameters_.back(); }

  friend bool operator==(const SizeClasses&, const SizeClasses&) = default;

 private:
  std::vector<double> diameters_;
  std::vector<double> edges_;
};

}  // namespace scree::grainsize
