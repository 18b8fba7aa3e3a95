#include "scree/assemble/stored_points.hpp"

#include "scree/assemble/crushing.hpp"
#include "scree/assemble/mixture.hpp"
#include "scree/assemble/node_viscosity.hpp"
#include "scree/scene/axes.hpp"
#include "scree/scene/checkpoint_points.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/law_columns.hpp"
#include "scree/scene/material_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace scree::app {

namespace {

/// Points of a periodic axis may lie past its ends by as much as their run lets them before it sorts.
template <int D, int V>
void require_inside(const mpm::Particles<D, V>& particles, const CartesianGrid<D>& grid,
                    const StoredScene& stored) {
  for (Index p = 0; p < particles.size(); ++p) {
    for (int d = 0; d < D; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      const double slack = grid.is_periodic()[axis] ? stored.spacing.at(axis) : 0;
      const double x = particles.position.component(d)[p];
      if (-slack <= x && x <= grid.length(d) + slack) continue;
      std::vector<double> place;
      place.reserve(D);
      for (int i = 0; i < D; ++i) place.push_back(particles.position.component(i)[p]);
      throw InputError{fmt::format(
          "[material] checkpoint: {}: its point {:.0f} at ({:.6g}) m lies outside the mesh, which is {:g} m "
          "long along {}: make the mesh larger ([mesh] size)",
          stored.path.string(), particles.id.component(0)[p], fmt::join(place, ", "), grid.length(d),
          axis_names(D)[axis])};
    }
  }
}

/// What implicit viscosity keeps of a step is found anew in the next, and what walls read as the walls are.
[[nodiscard]] bool is_kept(const std::string& column) {
  return column != viscosity_column && column != friction_column;
}

}  // namespace

template <int D, int V>
mpm::Particles<D, V> stored_points(const StoredScene& stored, const CartesianGrid<D>& grid) {
  const io::Checkpoint checkpoint = open_checkpoint(stored.path);
  const auto points = heavy_points(checkpoint);
  mpm::Particles<D, V> particles;
  particles.resize(static_cast<Index>(points.size()));
  particles.for_each_column([&](mpm::Column& column) {
    std::ranges::copy(values_of(checkpoint, column.quantity().name, column.num_components(), points),
                      column.values().begin());
  });
  require_inside(particles, grid, stored);
  return particles;
}

template <int D, int V>
void take_stored(const Scene& scene, mpm::Particles<D, V>& particles) {
  const StoredScene& stored = *scene.material.stored;
  if (scene.grains && crushes(scene.law)) {
    const Crushing<D, V> adds_its_column{particles, *scene.grains, scene.mixture.ultimate_fractal_dimension};
  }
  const io::Checkpoint checkpoint = open_checkpoint(stored.path);
  const auto points = heavy_points(checkpoint);
  std::vector<std::string> here;
  particles.for_each_column([&](mpm::Column& column) {
    const std::string& name = here.emplace_back(column.quantity().name);
    if (name == friction_column) return;
    require(std::ranges::count(stored.columns, name) == 1, "[material] checkpoint: " + stored.path.string() +
                                                               ": its points have no column '" + name +
                                                               "', which those of the scene have");
    std::ranges::copy(values_of(checkpoint, name, column.num_components(), points), column.values().begin());
  });
  for (const std::string& name : stored.columns) {
    require(!is_kept(name) || std::ranges::count(here, name) == 1,
            "[material] checkpoint: " + stored.path.string() + ": its points have a column '" + name +
                "', which those of the scene lack");
  }
  if (scene.grains) Mixture{scene}.update(particles);
}

#define SCREE_INSTANCE(D, V)                                                                      \
  template mpm::Particles<D, V> stored_points<D, V>(const StoredScene&, const CartesianGrid<D>&); \
  template void take_stored(const Scene&, mpm::Particles<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
