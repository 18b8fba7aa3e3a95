#include "scree/assemble/make_stages.hpp"

#include "scree/assemble/ground.hpp"
#include "scree/assemble/overlaps.hpp"
#include "scree/assemble/streams.hpp"
#include "scree/assemble/walls.hpp"
#include "scree/scene/axes.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/mpm/axisymmetric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::app {

namespace {

/// Gravity by velocity component [m/s^2]: down the slope along the flow, into the base along its normal.
template <int V>
[[nodiscard]] std::array<double, V> gravity_of(const GravityScene& gravity, int dimensions) {
  const double slope = gravity.slope_degrees * std::numbers::pi / 180;
  std::array<double, V> result{};
  result[static_cast<std::size_t>(normal_component(dimensions))] = -gravity.magnitude * std::cos(slope);
  const int along = flow_component(dimensions, V);
  if (along >= 0) result[static_cast<std::size_t>(along)] = gravity.magnitude * std::sin(slope);
  return result;
}

}  // namespace

template <int D>
CartesianGrid<D> make_grid(const Scene& scene) {
  const MeshScene& mesh = scene.mesh;
  const double edge =
      mesh.size[static_cast<std::size_t>(normal_component(D))] / static_cast<double>(mesh.cells);
  Vector<D> spacing;
  Indices<D> cells{};
  std::array<bool, D> is_periodic{};
  for (std::size_t d = 0; d < D; ++d) {
    cells[d] = std::lround(mesh.size[d] / edge);
    spacing[static_cast<int>(d)] = mesh.size[d] / static_cast<double>(cells[d]);
    is_periodic[d] = scene.axes[d].is_periodic;
  }
  return {Vector<D>::Zero(), spacing, cells, is_periodic};
}

template <int D>
mpm::AnySurface<D> ground_of(const Scene& scene) {
  if constexpr (D > 1) {
    if (scene.terrain) return surface_of<D>(*scene.terrain, scene.mesh);
  }
  return {};
}

template <int D, int V>
std::vector<std::unique_ptr<mpm::Boundary<D>>> make_boundaries(const Scene& scene,
                                                               const CartesianGrid<D>& grid,
                                                               const mpm::AnySurface<D>& ground, double reach,
                                                               const PlaceOfMean& place_of) {
  const Symmetry symmetry = symmetry_of(scene);
  std::vector<std::unique_ptr<mpm::Boundary<D>>> boundaries;
  if constexpr (D > 1) {
    if (ground) boundaries.push_back(make_terrain<D>(*scene.terrain, ground, grid, symmetry, place_of));
    require_apart(scene, grid, ground);
    for (const BodyScene& body : scene.bodies) boundaries.push_back(make_body<D>(body, symmetry, place_of));
  }
  for (int axis = 0; axis < D; ++axis) {
    const AxisScene& ends = scene.axes[static_cast<std::size_t>(axis)];
    if (ends.is_periodic) continue;
    boundaries.push_back(make_boundary<D>(ends.low, axis, mpm::Side::low, symmetry, place_of));
    boundaries.push_back(make_boundary<D>(ends.high, axis, mpm::Side::high, symmetry, place_of));
  }
  for (const InflowScene& inflow : scene.inflows) {
    boundaries.push_back(mpm::make_inflow_hold(stream_of<D, V>(scene, inflow), grid, reach));
  }
  std::erase(boundaries, nullptr);
  return boundaries;
}

template <int D, int V>
mpm::Stages<D, V> make_stages(const Scene& scene, const CartesianGrid<D>& grid,
                              mpm::Particles<D, V>& particles) {
  mpm::Stages<D, V> stages;
  if constexpr (D == 2 && V == 2) {  // first: the law reads what this adds
    if (scene.mesh.is_axisymmetric) stages.point_term = mpm::make_axisymmetric(particles, grid, scene.shape);
  }
  stages.stress = std::visit(
      [&](const auto& law) -> std::unique_ptr<mpm::StressUpdate<D, V>> {
        using By = mpm::StressUpdateBy<D, V, std::decay_t<decltype(law)>>;
        // Every law of the list has a kernel for each set.
        return std::make_unique<By>(law, particles, block_kernel(law, widest_instruction_set()));
      },
      scene.law);
  for (const InitialScene& initial : scene.initial) {
    const std::size_t column = particles.find_column(initial.column, "the scene");
    std::ranges::fill(particles.column(column).values(), initial.value);
  }
  stages.transfer = mpm::make_transfer<D, V>(scene.shape, scene.transfer);
  stages.order = scene.order;
  stages.averaging = scene.averaging;
  if (scene.xpic_order > 0) stages.xpic = mpm::make_xpic<D, V>(scene.shape, scene.xpic_order);
  stages.mass_floor = scene.mass_floor;
  stages.leaving = scene.leaving;
  stages.balanced = particles.column_named(fraction_column);
  stages.gravity = gravity_of<V>(scene.gravity, D);
  return stages;
}

template CartesianGrid<1> make_grid<1>(const Scene& scene);
template CartesianGrid<2> make_grid<2>(const Scene& scene);
template CartesianGrid<3> make_grid<3>(const Scene& scene);
template mpm::AnySurface<1> ground_of<1>(const Scene& scene);
template mpm::AnySurface<2> ground_of<2>(const Scene& scene);
template mpm::AnySurface<3> ground_of<3>(const Scene& scene);

// NOLINTBEGIN(bugprone-macro-parentheses): D and V are template arguments
#define SCREE_INSTANCE(D, V)                                                                            \
  template mpm::Stages<D, V> make_stages(const Scene&, const CartesianGrid<D>&, mpm::Particles<D, V>&); \
  template std::vector<std::unique_ptr<mpm::Boundary<D>>> make_boundaries<D, V>(                        \
      const Scene&, const CartesianGrid<D>&, const mpm::AnySurface<D>&, double, const PlaceOfMean&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace scree::app
