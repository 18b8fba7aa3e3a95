#include "scree/assemble/ground.hpp"

#include "scree/assemble/with_contact.hpp"
#include "scree/scene/axes.hpp"

#include <scree/mpm/boundaries/bed.hpp>
#include <scree/mpm/terrain/height_field.hpp>
#include <scree/mpm/terrain/triangle_surface.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace scree::app {

namespace {

template <int D>
[[nodiscard]] mpm::AnySurface<D> made(const PlaneScene& plane, const MeshScene& /*mesh*/) {
  return mpm::PlaneSurface<D>{Eigen::Map<const Vector<D>>{plane.point.data()},
                              Eigen::Map<const Vector<D>>{plane.normal.data()}};
}

/// A height over the mesh, that goes on level beyond it: at open ends nodes outside lie on ground too.
template <int D, class Field>
[[nodiscard]] mpm::AnySurface<D> within(Field field, const Vector<D>& low, const Vector<D>& high) {
  return [field = std::move(field), low, high](const Vector<D>& x) {
    Vector<D> inside = x.cwiseMax(low).cwiseMin(high);
    inside[D - 1] = x[D - 1];
    return field(inside);
  };
}

template <int D>
[[nodiscard]] mpm::AnySurface<D> made(const ProfileScene& profile, const MeshScene& mesh) {
  if constexpr (D != 2) {
    throw InputError{"[terrain] surface: a profile is for meshes of 2 dimensions"};
  } else {
    const auto count = static_cast<Index>(profile.heights.size());
    const Lattice<1> sites{.count = {count},
                           .spacing = Vector<1>::Constant(mesh.size[0] / static_cast<double>(count - 1)),
                           .first = Vector<1>::Zero()};
    return within<2>(mpm::HeightField<2>{mpm::MapField<1>{sites, profile.heights}}, Vector<2>::Zero(),
                     Vector<2>{mesh.size[0], 0});
  }
}

/// A surface of a map, whose height is its third coordinate, seen in a mesh, where it is the second.
[[nodiscard]] mpm::AnySurface<3> in_mesh(mpm::AnySurface<3> on_map, const MapPlace& place) {
  return [on_map = std::move(on_map), place](const Vector<3>& x) {
    mpm::FromSurface<3> seen =
        on_map(Vector<3>{place.origin[0] + x[0], place.origin[1] + x[2], place.datum + x[1]});
    std::swap(seen.normal[1], seen.normal[2]);
    return seen;
  };
}

template <int D>
[[nodiscard]] mpm::AnySurface<D> made(const RasterScene& map, const MeshScene& mesh) {
  if constexpr (D != 3) {
    throw InputError{"[terrain] surface: a raster is for meshes of 3 dimensions"};
  } else {
    constexpr double slack = 1e-9;  // [-], of a cell of the map: its very rim may be lost to round-off
    const Raster& raster = map.heights;
    const double half = (0.5 - slack) * raster.cell_size;
    const Vector<2> steps{static_cast<double>(raster.num_columns - 1),
                          static_cast<double>(raster.num_rows - 1)};
    const Vector<2> last = raster.first + raster.cell_size * steps;
    const auto bound = [&](int d, double side) {
      const auto axis = static_cast<std::size_t>(d);
      const double end = map.place.origin[axis] + (side > 0 ? mesh.size[d == 0 ? 0 : 2] : 0);
      return std::clamp(end, raster.first[d] - half, last[d] + half);
    };
    return in_mesh(
        within<3>(mpm::HeightField<3>{mpm::map_field(raster)}, Vector<3>{bound(0, -1), bound(1, -1), 0},
                  Vector<3>{bound(0, 1), bound(1, 1), 0}),
        map.place);
  }
}

template <int D>
[[nodiscard]] mpm::AnySurface<D> made(const TrianglesScene& surface, const MeshScene& /*mesh*/) {
  if constexpr (D != 3) {
    throw InputError{"[terrain] surface: triangles are for meshes of 3 dimensions"};
  } else {
    return in_mesh(mpm::TriangleSurface{surface.triangles}, surface.place);
  }
}

/// Friction of the ground at each place [-]; NaN where no map tells it.
template <int D>
[[nodiscard]] std::function<double(const Vector<D>&)> friction_of(const TerrainScene& terrain) {
  if constexpr (D == 3) {
    if (terrain.friction) {
      const mpm::MapField<2> map = mpm::map_field(terrain.friction->heights);
      return [map, origin = terrain.friction->place.origin](const Vector<3>& x) {
        return map(Vector<2>{origin[0] + x[0], origin[1] + x[2]}).value;
      };
    }
  }
  return [](const Vector<D>&) { return std::numeric_limits<double>::quiet_NaN(); };
}

/// Material that leaves through one end of a periodic axis comes back through the other, on the same ground.
template <int D>
void require_periodic(const mpm::AnySurface<D>& surface, const CartesianGrid<D>& grid) {
  constexpr double slack = 1e-6;  // [-], of a cell
  for (int axis = 0; axis < D; ++axis) {
    if (!grid.is_periodic()[static_cast<std::size_t>(axis)]) continue;
    Lattice<D> end = grid.nodes();
    end.count[static_cast<std::size_t>(axis)] = 1;
    const Vector<D> period = grid.length(axis) * Vector<D>::Unit(axis);
    for (Index i = 0; i < end.num_sites(); ++i) {
      const Vector<D> x = end.position(end.site(i));
      const double step = std::abs(surface(x).distance - surface(x + period).distance);
      const std::string_view name = axis_names(D)[static_cast<std::size_t>(axis)];
      require(step <= slack * grid.spacing()[axis],
              fmt::format(
                  "[terrain] and [boundaries] {0} = \"periodic\": the ground must be the same at both ends "
                  "of {0}, and differs by {1:.3g} m",
                  name, step));
    }
  }
}

}  // namespace

template <int D>
mpm::AnySurface<D> surface_of(const TerrainScene& terrain, const MeshScene& mesh) {
  return std::visit([&](const auto& surface) { return made<D>(surface, mesh); }, terrain.surface);
}

template <int D>
std::unique_ptr<mpm::Boundary<D>> make_terrain(const TerrainScene& terrain, const mpm::AnySurface<D>& surface,
                                               const CartesianGrid<D>& grid, Symmetry symmetry,
                                               const PlaceOfMean& place_of) {
  require_periodic(surface, grid);
  return with_contact(terrain.contact, [&]<class Law>(const mpm::Contact<Law>& contact,
                                                      const typename Law::template Input<double>& /*input*/) {
    const auto friction_at = friction_of<D>(terrain);
    return mpm::make_bed<D, Law>(
        contact, [&](const Vector<D>& x) { return input_of<Law>(terrain.contact.inputs, friction_at(x)); },
        grid, surface, symmetry, carried_input<Law>(terrain.contact.of_material, place_of));
  });
}

template mpm::AnySurface<2> surface_of(const TerrainScene&, const MeshScene&);
template std::unique_ptr<mpm::Boundary<2>> make_terrain(const TerrainScene&, const mpm::AnySurface<2>&,
                                                        const CartesianGrid<2>&, Symmetry,
                                                        const PlaceOfMean&);
template mpm::AnySurface<3> surface_of(const TerrainScene&, const MeshScene&);
template std::unique_ptr<mpm::Boundary<3>> make_terrain(const TerrainScene&, const mpm::AnySurface<3>&,
                                                        const CartesianGrid<3>&, Symmetry,
                                                        const PlaceOfMean&);

}  // namespace scree::app
