#pragma once

#include <scree/lattice.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>
#include <scree/raster.hpp>

#include <vector>

namespace scree::mpm {

/// A number at each place of a map, linear along each axis between the sites where it is known, and on by
/// half a spacing beyond the outermost: what a raster says of the cells around its centres.
/// @see Eq. (M64)
template <int N>
class MapField {
 public:
  struct Value {
    double value;        ///< NaN where one of the sites around is NaN, or beyond the map
    Vector<N> gradient;  ///< [1/m of the value's unit]
  };

  /// @param sites at least two along each axis
  /// @param values one for each site, the first axis fastest; NaN where nothing is known
  /// @throws InputError if there are fewer, their number differs, or a spacing is not positive.
  MapField(const Lattice<N>& sites, std::vector<double> values);

  [[nodiscard]] Value operator()(const Vector<N>& x) const noexcept;

 private:
  Lattice<N> sites_;
  std::vector<double> values_;
};

/// A raster as a field.  @throws InputError if it has fewer than two rows or columns, or values are missing.
[[nodiscard]] MapField<2> map_field(const Raster& raster);

/// Ground of a given height [m] over each place of a map; height is along the last axis of the mesh.
/// Distances are (z - b)/sqrt(1 + |grad b|^2).  @see Eqs. (M60), (M64)
template <int D>
class HeightField {
 public:
  explicit HeightField(MapField<D - 1> height) : height_{std::move(height)} {}

  [[nodiscard]] FromSurface<D> operator()(const Vector<D>& x) const noexcept {
    const auto [height, slope] = height_(x.template head<D - 1>());
    const double stretch = std::sqrt(1 + slope.squaredNorm());
    FromSurface<D> seen{(x[D - 1] - height) / stretch, Vector<D>::Unit(D - 1)};
    if (std::isfinite(stretch)) {
      seen.normal.template head<D - 1>() = -slope / stretch;
      seen.normal[D - 1] = 1 / stretch;
    }
    return seen;
  }

 private:
  MapField<D - 1> height_;
};

static_assert(SignedDistance<HeightField<2>, 2> && SignedDistance<HeightField<3>, 3>);

}  // namespace scree::mpm
