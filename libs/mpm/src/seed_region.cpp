#include "instances.hpp"

#include <scree/error.hpp>
#include <scree/mpm/seed_region.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace scree::mpm {

namespace {

/// A number in [0, 1) by 53 bits of a generator that the standard fixes, unlike its distributions.
[[nodiscard]] double draw(std::mt19937_64& random) {
  constexpr double bits_53 = 9007199254740992;  // 2^53
  return static_cast<double>(random() >> 11) / bits_53;
}

template <int D>
[[nodiscard]] Lattice<D> shares_of(const CartesianGrid<D>& grid, const Indices<D>& per_cell) {
  Lattice<D> shares = grid.cells();
  for (std::size_t axis = 0; axis < D; ++axis) {
    const int a = static_cast<int>(axis);
    require(per_cell[axis] >= 1, "seed_region: each cell must get at least one point along each axis");
    shares.count[axis] *= per_cell[axis];
    shares.spacing[a] /= static_cast<double>(per_cell[axis]);
    shares.first[a] = grid.origin()[a] + shares.spacing[a] / 2;
  }
  return shares;
}

}  // namespace

template <int D, int V>
Particles<D, V> seed_region(const CartesianGrid<D>& grid, const PointLayout<D>& layout,
                            const std::function<double(const Vector<D>&)>& density_at) {
  const Lattice<D> shares = shares_of(grid, layout.per_cell);
  std::mt19937_64 random{layout.random_seed.value_or(0)};
  std::vector<Vector<D>> places;
  std::vector<double> densities;
  for (Index share = 0; share < shares.num_sites(); ++share) {
    Vector<D> x = shares.position(shares.site(share));
    const double density = density_at(x);
    if (!(density > 0)) continue;
    require(std::isfinite(density), "seed_region: the density must be finite");
    if (layout.random_seed) {
      for (int axis = 0; axis < D; ++axis) x[axis] += (draw(random) - 0.5) * shares.spacing[axis];
    }
    places.push_back(x);
    densities.push_back(density);
  }
  require(!places.empty(), "seed_region: no place of the mesh lies in the region");
  Particles<D, V> particles;
  particles.resize(static_cast<Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto p = static_cast<Index>(i);
    for (int axis = 0; axis < D; ++axis) particles.position.component(axis)[p] = places[i][axis];
    particles.density.component(0)[p] = densities[i];
    particles.mass.component(0)[p] = densities[i] * shares.spacing.prod();
    particles.id.component(0)[p] = static_cast<double>(i);
  }
  return particles;
}

bool is_in_polygon(std::span<const Vector<2>> corners, const Vector<2>& x) noexcept {
  bool is_inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<2>& a = corners[i];
    const Vector<2>& b = corners[(i + 1) % corners.size()];
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    if (x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) is_inside = !is_inside;
  }
  return is_inside;
}

template <int D, int V>
CellFilling cell_filling(const Particles<D, V>& particles, const CartesianGrid<D>& grid, Index wanted) {
  const Lattice<D> cells = grid.cells();
  std::vector<Index> counts(static_cast<std::size_t>(cells.num_sites()), 0);
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    Indices<D> cell{};
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double place =
          (particles.position.component(axis)[p] - grid.origin()[axis]) / grid.spacing()[axis];
      cell[a] = std::clamp(static_cast<Index>(std::floor(place)), Index{0}, cells.count[a] - 1);
    }
    ++counts[static_cast<std::size_t>(cells.index(cell))];
  }
  CellFilling filling{.num_filled = 0, .num_too_few = 0, .fewest = std::numeric_limits<Index>::max()};
  for (const Index count : counts) {
    if (count == 0) continue;
    ++filling.num_filled;
    filling.num_too_few += count < wanted ? 1 : 0;
    filling.fewest = std::min(filling.fewest, count);
  }
  if (filling.num_filled == 0) filling.fewest = 0;
  return filling;
}

#define SCREE_INSTANCE(D, V)                                                            \
  template Particles<D, V> seed_region(const CartesianGrid<D>&, const PointLayout<D>&,  \
                                       const std::function<double(const Vector<D>&)>&); \
  template CellFilling cell_filling(const Particles<D, V>&, const CartesianGrid<D>&, Index);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
