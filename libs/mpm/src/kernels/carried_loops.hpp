#pragma once

#include "carried_kernels.hpp"
#include "tile_part.hpp"
#include "transpose.hpp"

#include <scree/mpm/shapes/top_hat.hpp>

#include <algorithm>

/// Carried fields to sites and back, a pack of points at a time. Lanes are points, but four fields of a site
/// on the way there. Sorted points mostly share their stencil with their neighbours: what they share is read
/// and written once for all.
namespace scree::mpm::SCREE_INSTRUCTION_SET {

/// The shape itself; mesh cells have the only one of theirs.
template <class ShapeType>
[[nodiscard]] inline ShapeType the(const AnyShape& shape) noexcept {
  if constexpr (std::is_same_v<ShapeType, TopHat>) {
    return {};
  } else {
    return *std::get_if<ShapeType>(&shape);
  }
}

/// The sites of one point's stencil in its block's tile, first axis fastest.
template <int D, std::size_t S>
struct SiteStencil {
  static constexpr Index edge = SiteTile<D, S>::edge;
  static constexpr std::size_t num_sites = D == 1 ? S : D == 2 ? S * S : S * S * S;

  /// Of site (i, j, k), from the first.
  [[nodiscard]] static constexpr Index offset(std::size_t i, std::size_t j, std::size_t k) noexcept {
    return (static_cast<Index>(k) * edge + static_cast<Index>(j)) * edge + static_cast<Index>(i);
  }

  /// Calls body(number of a site, its place from the first) for all.
  template <class Body>
  static void for_each_site(Body&& body) noexcept {
    std::size_t n = 0;
    for (std::size_t k = 0; k < (D > 2 ? S : 1); ++k) {
      for (std::size_t j = 0; j < (D > 1 ? S : 1); ++j) {
        for (std::size_t i = 0; i < S; ++i) body(n++, offset(i, j, k));
      }
    }
  }
};

/// The stencils of a pack of points in memory.
template <int D, std::size_t S>
struct PackSites {
  using Stencil = SiteStencil<D, S>;
  alignas(64) double weight[Stencil::num_sites][Pack::size];
  Pack first;  ///< place in the tile
};

template <int D, class ShapeType>
inline void keep(const ShapeType& shape, const CarriedBlock<D>& block, Index p,
                 PackSites<D, ShapeType::support>& kept, PartOfPacks<D, ShapeType::support>& part) noexcept {
  constexpr std::size_t S = ShapeType::support;
  Pack{1}.store(kept.weight[0]);
  Pack first{0};
  std::size_t count = 1;
  for (std::size_t axis = D; axis-- > 0;) {
    const Pack x = Pack::load(block.position + static_cast<Index>(axis) * block.stride + p);
    const Pack along = coordinate(x, block.origin[axis], block.inverse_spacing[axis], ShapeType::shift);
    const Pack base = floor(along);
    const auto weight = shape.weights(along - base + ShapeType::shift);
    for (std::size_t n = count; n-- > 0;) {
      const Pack product = Pack::load(kept.weight[n]);
      for (std::size_t i = S; i-- > 0;) (product * weight[i]).store(kept.weight[n * S + i]);
    }
    count *= S;
    const Pack place = base - block.first[axis];
    part.widen(axis, place);
    first = first * static_cast<double>(SiteStencil<D, S>::edge) + place;
  }
  kept.first = first;
}

/// Lanes of a pack that follow each other and whose stencils begin at one place of the tile.
struct AlikeLanes {
  int begin;
  int end;
  Index place;
};

/// Calls body(alike) for all lanes.  @tparam joins else each by itself: of one site there is little to share
template <bool joins, class Body>
inline void for_each_alike(const Pack& first, Body&& body) noexcept {
  double places[Pack::size];
  first.store(places);
  for (int begin = 0; begin < Pack::size;) {
    int end = begin + 1;
    while (joins && end < Pack::size && places[end] == places[begin]) ++end;
    body(AlikeLanes{begin, end, static_cast<Index>(places[begin])});
    begin = end;
  }
}

/// Calls body(place in the tile, number of the site) for the sites of a part of the tile that are there.
template <int D, std::size_t S, class Body>
inline void for_each_site(const CarriedBlock<D>& block, const TilePart<D>& part, Body&& body) noexcept {
  Strides<D> stride{{1}};
  for (int axis = 1; axis < D; ++axis) stride.axis[axis] = stride.axis[axis - 1] * SiteTile<D, S>::edge;
  for_each_row<D - 1, D>(block.site, stride, part, 0, 0, [&](Index start, Index row) {
    for (Index i = part.begin[0]; i < part.end[0]; ++i) {
      const Index along = block.site[0][static_cast<std::size_t>(i)];
      if (along >= 0) body(row + i, start + along);
    }
  });
}

/// Where the tile of a four begins in those of all, one after the other.
template <int D, std::size_t S>
[[nodiscard]] constexpr Index tile_start(Index four) noexcept {
  return four * (4 * SiteTile<D, S>::num_sites);
}

/// Adds a four of a site in its tile to the sums, but nothing where no point is: there may be a site of
/// another block.
inline void add_to_sums(const double* from, const FourSums& sums, Index site) noexcept {
  if (from[0] == 0 && from[1] == 0 && from[2] == 0 && from[3] == 0) return;
  for (std::size_t f = 0; f < static_cast<std::size_t>(sums.count); ++f) {
    sums.sum[f][site * sums.step[f]] += from[f];
  }
}

/// Adds what points with one stencil give, a plane of its sites at a time: those stay in registers.
template <int D, std::size_t S>
inline void add_alike(const PackSites<D, S>& sites, const double (&given)[Pack::size][4],
                      const AlikeLanes& alike, double* tile) noexcept {
  using Stencil = SiteStencil<D, S>;
  constexpr std::size_t in_plane = D == 1 ? S : S * S;
  double* first = tile + 4 * alike.place;
  for (std::size_t plane = 0; plane < Stencil::num_sites / in_plane; ++plane) {
    const double(*weight)[Pack::size] = sites.weight + plane * in_plane;
    double* at = first + 4 * Stencil::offset(0, 0, plane);
    Four sums[in_plane];
#pragma GCC unroll 16
    for (std::size_t n = 0; n < in_plane; ++n)
      sums[n] = Four::load(at + 4 * Stencil::offset(n % S, n / S, 0));
    for (int lane = alike.begin; lane < alike.end; ++lane) {
      const Four values = Four::load(given[lane]);
#pragma GCC unroll 16
      for (std::size_t n = 0; n < in_plane; ++n) sums[n] += weight[n][lane] * values;
    }
#pragma GCC unroll 16
    for (std::size_t n = 0; n < in_plane; ++n) sums[n].store(at + 4 * Stencil::offset(n % S, n / S, 0));
  }
}

/// What the points of a pack give to the sums, in fours, point by point.
inline void keep_given(const FourSums& sums, const Pack& mass, Index p,
                       double (&given)[Pack::size][4]) noexcept {
  Pack fields[4];
  for (std::size_t f = 0; f < 4; ++f) {
    fields[f] = f < static_cast<std::size_t>(sums.count) ? mass : Pack{0};
    if (sums.field[f] != nullptr) fields[f] = mass * Pack::load(sums.field[f] + p);
  }
  to_fours(fields, given[0], 4);
}

/// Weights are taken, and sites looked up, once for all fours.
template <int D, class ShapeType>
SCREE_KERNEL void to_sites(const AnyShape& any_shape, const CarriedBlock<D>& block,
                           const SiteSums& sums) noexcept {
  constexpr std::size_t S = ShapeType::support;
  const auto shape = the<ShapeType>(any_shape);
  alignas(64) double tiles[static_cast<std::size_t>(tile_start<D, S>(SiteSums::most))];
  std::fill_n(tiles, tile_start<D, S>(sums.num_fours), 0.0);
  PackSites<D, S> sites;
  PartOfPacks<D, S> part;
  alignas(64) double given[SiteSums::most][Pack::size][4];
  for (Index p = block.begin; p < block.end; p += Pack::size) {
    keep(shape, block, p, sites, part);
    const Pack mass = Pack::load(block.mass + p);
    for (Index f = 0; f < sums.num_fours; ++f) keep_given(sums.fours[f], mass, p, given[f]);
    for_each_alike<(S > 1)>(sites.first, [&](const AlikeLanes& alike) {
      for (Index f = 0; f < sums.num_fours; ++f) {
        add_alike<D, S>(sites, given[f], alike, tiles + tile_start<D, S>(f));
      }
    });
  }
  for_each_site<D, S>(block, part.of_block(), [&](Index place, Index site) {
    for (Index f = 0; f < sums.num_fours; ++f) {
      add_to_sums(tiles + tile_start<D, S>(f) + 4 * place, sums.fours[f], site);
    }
  });
}

/// Points of a pack that have one stencil, on their way.
template <int D, std::size_t S>
struct AlikePoints {
  using Stencil = SiteStencil<D, S>;
  PackSites<D, S> sites;
  const Index* record;  ///< of the first site of the stencil
  Pack::Mask which;
  Index p;                         ///< the first point of the pack
  Pack given[Stencil::num_sites];  ///< what each gives up round each site, then times the weight
};

/// Adds what points give up of `count` classes from `first` on.
template <int count, int D, std::size_t S>
inline void add_given(const PointChange& change, int first, AlikePoints<D, S>& points) noexcept {
  Pack phi[count];
  for (int k = 0; k < count; ++k)
    phi[k] = Pack::load(change.fractions + (first + k) * change.stride + points.p);
  SiteStencil<D, S>::for_each_site([&](std::size_t n, Index place) {
    const double* loss = change.records + points.record[place] + first;
    for (int k = 0; k < count; ++k) points.given[n] = points.given[n] + phi[k] * loss[k];
  });
}

/// Changes `count` classes of the points from `first` on.
template <int count, int D, std::size_t S>
inline void exchange(const PointChange& change, int first, const AlikePoints<D, S>& points) noexcept {
  Pack taken[count];
  Pack lost[count];
  for (int k = 0; k < count; ++k) taken[k] = lost[k] = Pack{0};
  SiteStencil<D, S>::for_each_site([&](std::size_t n, Index place) {
    const double* loss = change.records + points.record[place] + first;
    const double* gain = loss + change.num_classes;
    const Pack weight = Pack::load(points.sites.weight[n]);
    for (int k = 0; k < count; ++k) {
      taken[k] = taken[k] + points.given[n] * gain[k];
      lost[k] = lost[k] + weight * loss[k];
    }
  });
  for (int k = 0; k < count; ++k) {
    double* column = change.fractions + (first + k) * change.stride + points.p;
    const Pack phi = Pack::load(column);
    select(points.which, phi + (taken[k] - phi * lost[k]), phi).store(column);
  }
}

/// Calls body(how many, first class) for all classes: as many at a time as `most`, then half as many, ..
template <int most, class Body>
inline void for_classes(int first, int end, Body&& body) noexcept {
  for (; first + most <= end; first += most) body(std::integral_constant<int, most>{}, first);
  if constexpr (most > 1) for_classes<most / 2>(first, end, body);
}

template <int D, std::size_t S>
inline void change_alike(const PointChange& change, AlikePoints<D, S>& points) noexcept {
  for (Pack& given : points.given) given = Pack{change.is_exchange ? 0.0 : 1.0};
  if (change.is_exchange) {
    for_classes<4>(0, change.num_classes,
                   [&](auto count, int first) { add_given<decltype(count)::value>(change, first, points); });
  }
  for (std::size_t n = 0; n < SiteStencil<D, S>::num_sites; ++n) {
    points.given[n] = points.given[n] * Pack::load(points.sites.weight[n]);
  }
  for_classes<4>(0, change.num_classes,
                 [&](auto count, int first) { exchange<decltype(count)::value>(change, first, points); });
}

/// What rounding took from the sum of a point's fractions goes to the largest of them, so that the sum does
/// not wander off over many steps. It is a few round-offs, of either sign: class masses do not drift by it.
inline void close_sums(const PointChange& change, Index p) noexcept {
  Pack sum{0};
  Pack largest = Pack::load(change.fractions + p);
  Pack place{0};
  for (int k = 0; k < change.num_classes; ++k) {
    const Pack phi = Pack::load(change.fractions + k * change.stride + p);
    place = select(largest < phi, Pack{static_cast<double>(k)}, place);
    largest = max(largest, phi);
    sum = sum + phi;
  }
  const Pack rest = 1.0 - sum;
  for (int k = 0; k < change.num_classes; ++k) {
    double* column = change.fractions + k * change.stride + p;
    const Pack phi = Pack::load(column);
    select(place == static_cast<double>(k), phi + rest, phi).store(column);
  }
}

/// A pack of points, those with one stencil at a time.
template <int D, std::size_t S>
inline void change_pack(const PointChange& change, const Index* record_of,
                        AlikePoints<D, S>& points) noexcept {
  double numbers[Pack::size];
  for (int lane = 0; lane < Pack::size; ++lane) numbers[lane] = lane;
  const Pack lanes = Pack::load(numbers);
  for_each_alike<true>(points.sites.first, [&](const AlikeLanes& alike) {
    points.which =
        (Pack{static_cast<double>(alike.begin)} <= lanes) & (lanes < Pack{static_cast<double>(alike.end)});
    points.record = record_of + alike.place;
    change_alike(change, points);
  });
}

/// A pack of points with one site each.
template <int D>
inline void change_pack(const PointChange& change, const Index* record_of,
                        AlikePoints<D, 1>& points) noexcept {
  const auto column = [&](int k) { return change.fractions + k * change.stride + points.p; };
  double places[Pack::size];
  points.sites.first.store(places);
  const auto of_sites = [&](const double* values) {
    double lanes[Pack::size];
    for (int lane = 0; lane < Pack::size; ++lane) {
      lanes[lane] = values[record_of[static_cast<Index>(places[lane])]];
    }
    return Pack::load(lanes);
  };
  Pack given{change.is_exchange ? 0.0 : 1.0};
  for (int k = 0; change.is_exchange && k < change.num_classes; ++k) {
    given = given + Pack::load(column(k)) * of_sites(change.records + k);
  }
  for (int k = 0; k < change.num_classes; ++k) {
    const Pack phi = Pack::load(column(k));
    const Pack loss = of_sites(change.records + k);
    const Pack gain = of_sites(change.records + change.num_classes + k);
    (phi + (given * gain - phi * loss)).store(column(k));
  }
}

/// Lanes are points throughout: a site's numbers are read once for neighbours that share it.
template <int D, class ShapeType>
SCREE_KERNEL void to_points(const AnyShape& any_shape, const CarriedBlock<D>& block,
                            const PointChange& change) noexcept {
  constexpr std::size_t S = ShapeType::support;
  const auto shape = the<ShapeType>(any_shape);
  Index record_of[static_cast<std::size_t>(SiteTile<D, S>::num_sites)];
  std::fill_n(record_of, SiteTile<D, S>::num_sites, Index{0});  // where there is no site no weight is
  const Index record_size = Index{2} * change.num_classes;
  for_each_site<D, S>(block, TilePart<D>::whole(SiteTile<D, S>::edge),
                      [&](Index place, Index site) { record_of[place] = site * record_size; });
  AlikePoints<D, S> points;
  PartOfPacks<D, S> part;  // not asked for
  for (points.p = block.begin; points.p < block.end; points.p += Pack::size) {
    keep(shape, block, points.p, points.sites, part);
    change_pack(change, record_of, points);
    if (change.is_exchange) close_sums(change, points.p);
  }
}

/// The kernels of every shape.
template <int D, class Shapes>
struct CarriedTable;
template <int D, class... S>
struct CarriedTable<D, std::variant<S...>> {
  static constexpr CarriedKernels<D> of_cells{to_sites<D, TopHat>, to_points<D, TopHat>};
  static constexpr CarriedKernels<D> of_nodes[] = {{to_sites<D, S>, to_points<D, S>}...};
};

template <int D>
CarriedKernels<D> carried_kernels(Sites sites, std::size_t shape) noexcept {
  using Table = CarriedTable<D, AnyShape>;
  return sites == Sites::cells ? Table::of_cells : Table::of_nodes[shape];
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
