#pragma once

#include "scree/scene/scene.hpp"

#include <scree/grid.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>

#include <functional>
#include <vector>

namespace scree::app {

/// Where the material of a scene is at the start.
template <int D>
class Filling {
 public:
  /// @param ground of the scene; none: there is none
  Filling(const Scene& scene, const CartesianGrid<D>& grid, mpm::AnySurface<D> ground);

  [[nodiscard]] bool contains(const Vector<D>& x) const;
  /// Height of the surface of the material straight above a place in it [m].
  [[nodiscard]] double top_above(const Vector<D>& x) const;

  /// Points in it, with the density of the law without pressure.
  /// @throws InputError if there are none, or if some lie below the ground.
  template <int V>
  [[nodiscard]] mpm::Particles<D, V> points() const;

 private:
  using Region = std::function<bool(const Vector<D>&)>;

  const MaterialScene& material_;
  double density_;  // [kg/m^3]
  CartesianGrid<D> grid_;
  mpm::AnySurface<D> ground_;
  std::vector<Region> regions_;
};

}  // namespace scree::app
