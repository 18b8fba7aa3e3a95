#include <scree/mpm/terrain/height_field.hpp>

#include <algorithm>
#include <limits>

namespace scree::mpm {

template <int N>
MapField<N>::MapField(const Lattice<N>& sites, std::vector<double> values)
    : sites_{sites}, values_{std::move(values)} {
  for (int axis = 0; axis < N; ++axis) {
    require(sites.count[static_cast<std::size_t>(axis)] >= 2,
            "MapField: needs at least two sites along each axis");
    require(sites.spacing[axis] > 0 && std::isfinite(sites.spacing[axis]),
            "MapField: the spacing must be positive and finite");
  }
  require(sites.first.allFinite(), "MapField: the first site must be finite");
  require(static_cast<Index>(values_.size()) == sites.num_sites(),
          "MapField: has " + std::to_string(values_.size()) + " values for " +
              std::to_string(sites.num_sites()) + " sites");
}

template <int N>
typename MapField<N>::Value MapField<N>::operator()(const Vector<N>& x) const noexcept {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Indices<N> base{};
  Vector<N> xi;
  for (int axis = 0; axis < N; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double place = (x[axis] - sites_.first[axis]) / sites_.spacing[axis];
    const auto last = static_cast<double>(sites_.count[a] - 1);
    if (!(-0.5 <= place && place <= last + 0.5)) return {nan, Vector<N>::Constant(nan)};
    const double cell = std::clamp(std::floor(place), 0.0, last - 1);
    base[a] = static_cast<Index>(cell);
    xi[axis] = place - cell;
  }
  Value result{0, Vector<N>::Zero()};
  for (std::size_t corner = 0; corner < std::size_t{1} << N; ++corner) {
    Indices<N> site = base;
    double weight = 1;
    Vector<N> slope = Vector<N>::Ones();
    for (std::size_t axis = 0; axis < N; ++axis) {
      const int a = static_cast<int>(axis);
      const bool is_high = ((corner >> axis) & 1) != 0;
      site[axis] += is_high ? 1 : 0;
      const double along = is_high ? xi[a] : 1 - xi[a];
      weight *= along;
      for (int d = 0; d < N; ++d) slope[d] *= d == a ? (is_high ? 1 : -1) / sites_.spacing[a] : along;
    }
    const double value = values_[static_cast<std::size_t>(sites_.index(site))];
    result.value += weight * value;
    result.gradient += value * slope;
  }
  return result;
}

MapField<2> map_field(const Raster& raster) {
  return MapField<2>{{.count = {raster.num_columns, raster.num_rows},
                      .spacing = Vector<2>::Constant(raster.cell_size),
                      .first = raster.first},
                     raster.values};
}

template class MapField<1>;
template class MapField<2>;

}  // namespace scree::mpm
