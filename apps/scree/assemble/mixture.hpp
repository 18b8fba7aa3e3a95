#pragma once

#include "scree/scene/scene.hpp"

#include <scree/grainsize/maximum_packing.hpp>
#include <scree/mpm/particles.hpp>

#include <variant>
#include <vector>

namespace scree::app {

/// What follows from the fractions of a point, a column each: its mean size, Eq. (G1), and, if the law of the
/// scene reads them, its share of coarse grains, Eq. (G23), and its largest packing, Eqs. (G30) to (G32); if
/// a wall reads it, the friction at which the law yields there, Eq. (R164).
class Mixture {
 public:
  /// @param scene with grains
  explicit Mixture(const Scene& scene);

  /// Gives every point the fractions of the scene, or others, and the columns that follow from them.
  /// @param fractions one per class [-]; none: those of the scene
  template <int D, int V>
  void add_to(mpm::Particles<D, V>& particles, const std::vector<double>& fractions = {});

  /// Lets these columns follow the fractions of every point.
  template <int D, int V>
  void update(mpm::Particles<D, V>& particles);

 private:
  using Weights = std::vector<double>;  // one per class: the column is their sum, by fractions
  using Rule = std::variant<Weights, grainsize::CompressiblePacking, rheology::AnyLaw>;
  struct Follower {
    Quantity quantity;
    Rule rule;
  };
  void follow(const Weights& weights, const mpm::Column& fractions, mpm::Column& column);
  void follow(const grainsize::CompressiblePacking& packing, const mpm::Column& fractions,
              mpm::Column& column);
  template <int D, int V>
  static void follow(const rheology::AnyLaw& law, const mpm::Particles<D, V>& particles, mpm::Column& column);

  std::vector<double> initial_;
  std::vector<Follower> followers_;
  std::vector<double> of_point_;  // fractions, one per class
};

}  // namespace scree::app
