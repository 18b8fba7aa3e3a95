#include "scree/assemble/filling.hpp"

#include "scree/scene/axes.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/vector_of.hpp"

#include <scree/mpm/seed.hpp>
#include <scree/mpm/seed_region.hpp>
#include <scree/mpm/terrain/above_bed.hpp>
#include <scree/mpm/terrain/height_field.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace scree::app {

namespace {

template <int D>
using Region = std::function<bool(const Vector<D>&)>;

template <int D>
[[nodiscard]] Region<D> made(const BoxRegion& box, const mpm::AnySurface<D>& /*ground*/) {
  return [low = vector_of<D>(box.low), high = vector_of<D>(box.high)](const Vector<D>& x) {
    return (low.array() <= x.array()).all() && (x.array() <= high.array()).all();
  };
}

template <int D>
[[nodiscard]] Region<D> made(const PolygonRegion& polygon, const mpm::AnySurface<D>& /*ground*/) {
  if constexpr (D == 1) {
    throw InputError{"[[material.regions]] shape: a polygon is for meshes of 2 or 3 dimensions"};
  } else {
    std::vector<Vector<2>> corners;
    for (std::size_t i = 0; i < polygon.x.size(); ++i) corners.emplace_back(polygon.x[i], polygon.y[i]);
    return [corners = std::move(corners), across = polygon.across](const Vector<D>& x) {
      if (D == 3 && !(across[0] <= x[D - 1] && x[D - 1] <= across[1])) return false;
      return mpm::is_in_polygon(corners, x.template head<2>());
    };
  }
}

template <int D>
[[nodiscard]] Region<D> made(const LayerRegion& layer, const mpm::AnySurface<D>& ground) {
  return [layer, ground](const Vector<D>& x) {
    const double height = x[normal_component(D)];
    return layer.bottom <= height && height <= layer.top && (!ground || ground(x).distance > 0);
  };
}

/// A place lies in it if the ground is below it, and no further below than the release is deep.
template <int D>
[[nodiscard]] Region<D> made(const ReleaseRegion& release, const mpm::AnySurface<D>& ground) {
  if constexpr (D != 3) {
    throw InputError{"[[material.regions]] shape: a release is for meshes of 3 dimensions"};
  } else {
    const mpm::MapField<2> depths = mpm::map_field(release.depths);
    return [depths, ground, origin = release.place.origin](const Vector<3>& x) {
      const double depth = depths(Vector<2>{origin[0] + x[0], origin[1] + x[2]}).value;
      if (!(depth > 0) || !(ground(x).distance > 0)) return false;
      return !(ground(Vector<3>{x - depth * Vector<3>::Unit(1)}).distance > 0);
    };
  }
}

}  // namespace

template <int D>
Filling<D>::Filling(const Scene& scene, const CartesianGrid<D>& grid, mpm::AnySurface<D> ground)
    : material_{scene.material},
      density_{std::visit([](const auto& law) { return law.density; }, scene.law)},
      grid_{grid},
      ground_{std::move(ground)} {
  for (const RegionScene& region : material_.regions) {
    regions_.push_back(std::visit([&](const auto& one) { return made<D>(one, ground_); }, region));
  }
  if (regions_.empty()) regions_.push_back(made<D>(BoxRegion{material_.low, material_.high}, ground_));
}

template <int D>
bool Filling<D>::contains(const Vector<D>& x) const {
  return std::ranges::any_of(regions_, [&](const Region& region) { return region(x); });
}

template <int D>
double Filling<D>::top_above(const Vector<D>& x) const {
  const int normal = normal_component(D);
  if (material_.regions.empty()) return material_.high[static_cast<std::size_t>(normal)];
  const double share = grid_.spacing()[normal] / static_cast<double>(material_.points_per_cell);
  Vector<D> in = x;
  Vector<D> out = x + share * Vector<D>::Unit(normal);
  while (contains(out)) {
    in = out;
    out[normal] += share;
  }
  constexpr int num_halvings = 20;  // to 1e-6 of a share, as much as is left of pressure by it
  for (int i = 0; i < num_halvings; ++i) {
    const Vector<D> middle = (in + out) / 2;
    (contains(middle) ? in : out) = middle;
  }
  return in[normal];
}

template <int D>
template <int V>
mpm::Particles<D, V> Filling<D>::points() const {
  Indices<D> per_cell{};
  per_cell.fill(material_.points_per_cell);
  const auto density_at = [&](const Vector<D>& x) { return contains(x) ? density_ : 0.0; };
  const bool is_plain = material_.regions.empty() && !material_.random_seed;
  auto particles = is_plain ? mpm::seed_box<D, V>(grid_, vector_of<D>(material_.low),
                                                  vector_of<D>(material_.high), per_cell, density_)
                            : mpm::seed_region<D, V>(grid_, {.per_cell = per_cell}, density_at);
  if (ground_) mpm::require_above(particles, ground_);
  if (!material_.random_seed) return particles;
  particles =
      mpm::seed_region<D, V>(grid_, {.per_cell = per_cell, .random_seed = material_.random_seed}, density_at);
  if (ground_) mpm::keep_above(particles, ground_);  // a share on the ground reaches into it
  return particles;
}

template class Filling<1>;
template class Filling<2>;
template class Filling<3>;
#define SCREE_INSTANCE(D, V) template mpm::Particles<D, V> Filling<D>::points<V>() const;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
