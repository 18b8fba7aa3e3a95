#pragma once

#include <scree/grainsize/distribution.hpp>
#include <scree/mpm/particles.hpp>

#include <vector>

namespace scree::app {

/// Where a law's breakage and the size classes meet: as the breakage of a point grows, the volume of its
/// grains moves to finer classes, on the point itself.  Eqs. (G20), (G21)
///
/// What the fractions have followed of the breakage is a column of its own, so that a restarted run goes on.
template <int D, int V>
class Crushing {
 public:
  /// @param particles with the column `breakage` of the law
  /// @param fractal_dimension of the ultimate one, by number [-]
  /// @throws InputError if the distribution has no ultimate one that it may be crushed to.
  Crushing(mpm::Particles<D, V>& particles, const grainsize::Distribution& grains, double fractal_dimension);

  /// Lets the fractions of every point follow its breakage.
  /// @returns whether any became finer
  bool advance(mpm::Particles<D, V>& particles) const;

 private:
  std::vector<double> ultimate_;  // one per class
};

}  // namespace scree::app
