#include "instances.hpp"
#include "stencil.hpp"

#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/exchange_map.hpp>
#include <scree/mpm/shapes/top_hat.hpp>

#include <algorithm>
#include <variant>

namespace scree::mpm {

namespace {

using detail::place_of;
using detail::stencil_nodes;

/// Number of a site along an axis. Past an end stand the images of the sites inside.
template <int D>
[[nodiscard]] Index site_along(const Lattice<D>& lattice, Index site, std::size_t axis) noexcept {
  const Index n = lattice.count[axis];
  if (lattice.is_periodic[axis]) return (site % n + n) % n;
  const Index image_of_first =
      lattice.sites == Sites::cells ? -1 : 0;  // in the low wall: they share it, or sit on it
  if (site < 0) return std::min(image_of_first - site, n - 1);
  if (site >= n) return std::max(2 * (n - 1) - image_of_first - site, Index{0});
  return site;
}

/// The sites that a point touches, with their weights.
template <int D, class ShapeType>
struct Touched {
  static constexpr auto table = stencil_nodes<D, ShapeType::support>();
  std::array<Index, table.size()> site;
  std::array<double, table.size()> weight;

  Touched(const CartesianGrid<D>& grid, const Lattice<D>& lattice, const Column& position, Index p) noexcept {
    std::array<std::array<double, ShapeType::support>, D> weights;
    std::array<std::array<Index, ShapeType::support>, D> sites;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const int a = static_cast<int>(axis);
      const auto place =
          place_of(position.component(a)[p], grid.origin()[a], 1 / grid.spacing()[a], ShapeType::shift);
      weights[axis] = ShapeType::weights(place.xi);
      for (std::size_t i = 0; i < ShapeType::support; ++i) {
        sites[axis][i] = site_along(lattice, place.base + static_cast<Index>(i), axis) * lattice.stride(a);
      }
    }
    for (std::size_t n = 0; n < table.size(); ++n) {
      site[n] = 0;
      weight[n] = 1;
      for (std::size_t axis = 0; axis < D; ++axis) {
        site[n] += sites[axis][table[n][axis]];
        weight[n] *= weights[axis][table[n][axis]];
      }
    }
  }
};

/// Calls body(shape) with the weights that belong to a kind of site.
template <class Body>
void visit_weights(Sites sites, const AnyShape& shape, Body&& body) {
  if (sites == Sites::cells) {
    body(TopHat{});
  } else {
    std::visit(body, shape);
  }
}

}  // namespace

template <int D, int V>
CarriedCells<D, V>::CarriedCells(const CartesianGrid<D>& grid, Sites sites, const AnyShape& shape)
    : grid_{grid}, lattice_{sites == Sites::cells ? grid.cells() : grid.nodes()}, shape_{shape} {}

template <int D, int V>
void CarriedCells<D, V>::to_sites(const Particles<D, V>& particles, const ParticleBlocks<D>& blocks,
                                  std::span<const CarriedField> fields, std::span<double> masses,
                                  std::span<double> means, Threads threads) const {
  const std::size_t num_fields = fields.size();
  SCREE_ASSERT(static_cast<Index>(masses.size()) == lattice_.num_sites());
  SCREE_ASSERT(means.size() == masses.size() * num_fields);
  std::fill(masses.begin(), masses.end(), 0.0);
  std::fill(means.begin(), means.end(), 0.0);
  visit_weights(lattice_.sites, shape_, [&](auto shape) {
    blocks.for_each_coloured(threads, [&](Index b) {
      const ParticleBlock<D>& block = blocks.blocks[static_cast<std::size_t>(b)];
      for (Index p = block.begin; p < block.end; ++p) {
        const double mass = particles.mass.component(0)[p];
        const Touched<D, decltype(shape)> touched{grid_, lattice_, particles.position, p};
        for (std::size_t n = 0; n < touched.site.size(); ++n) {
          const auto site = static_cast<std::size_t>(touched.site[n]);
          const double share = touched.weight[n] * mass;
          masses[site] += share;
          for (std::size_t f = 0; f < num_fields; ++f) {
            means[site * num_fields + f] += share * fields[f].column->component(fields[f].component)[p];
          }
        }
      }
    });
  });
  for (std::size_t site = 0; site < masses.size(); ++site) {
    if (!(masses[site] > 0)) continue;
    for (std::size_t f = 0; f < num_fields; ++f) means[site * num_fields + f] /= masses[site];
  }
}

template <int D, int V>
void CarriedCells<D, V>::to_points(const ParticleBlocks<D>& blocks, const Particles<D, V>& particles,
                                   Column& fractions, std::span<const double> old_means,
                                   std::span<const double> new_means, CarriedMap map, Threads threads) {
  const auto num_classes = static_cast<std::size_t>(fractions.num_components());
  SCREE_ASSERT(old_means.size() == static_cast<std::size_t>(lattice_.num_sites()) * num_classes);
  loss_ratio_.assign(old_means.size(), 0.0);
  gain_share_.assign(old_means.size(), 0.0);
  for (std::size_t at = 0; at < old_means.size(); at += num_classes) {
    if (map == CarriedMap::increments) {
      for (std::size_t k = 0; k < num_classes; ++k)
        gain_share_[at + k] = new_means[at + k] - old_means[at + k];
    } else {
      exchange_at_site(old_means.subspan(at, num_classes), new_means.subspan(at, num_classes),
                       std::span{loss_ratio_}.subspan(at, num_classes),
                       std::span{gain_share_}.subspan(at, num_classes));
    }
  }
  visit_weights(lattice_.sites, shape_, [&](auto shape) {
    blocks.for_each(threads, [&](Index b) {
      const ParticleBlock<D>& block = blocks.blocks[static_cast<std::size_t>(b)];
      for (Index p = block.begin; p < block.end; ++p) {
        const Touched<D, decltype(shape)> touched{grid_, lattice_, particles.position, p};
        exchange_at_point(touched.site, touched.weight, fractions, p, map);
      }
    });
  });
}

template <int D, int V>
template <std::size_t N>
void CarriedCells<D, V>::exchange_at_point(const std::array<Index, N>& sites,
                                           const std::array<double, N>& weights, Column& fractions, Index p,
                                           CarriedMap map) const noexcept {
  const auto num_classes = static_cast<std::size_t>(fractions.num_components());
  const Index size = fractions.size();
  double* phi = fractions.component(0) + p;  // class k at phi[k * size]
  const auto fraction = [&](std::size_t k) -> double& { return phi[static_cast<Index>(k) * size]; };
  std::array<double, N> given;  // what the point gives up round each site
  for (std::size_t n = 0; n < N; ++n) {
    const double* ratio = loss_ratio_.data() + static_cast<std::size_t>(sites[n]) * num_classes;
    given[n] = map == CarriedMap::increments ? 1 : 0;
    for (std::size_t k = 0; k < num_classes; ++k) given[n] += fraction(k) * ratio[k];
  }
  for (std::size_t k = 0; k < num_classes; ++k) {
    double lost = 0;
    double taken = 0;
    for (std::size_t n = 0; n < N; ++n) {
      const std::size_t at = static_cast<std::size_t>(sites[n]) * num_classes + k;
      lost += weights[n] * loss_ratio_[at];
      taken += weights[n] * gain_share_[at] * given[n];
    }
    fraction(k) += taken - fraction(k) * lost;
  }
  if (map == CarriedMap::exchange) close_sum(fractions, p);
}

/// What rounding took from the sum of a point's fractions goes to the largest of them, so that the sum does
/// not wander off over many steps. It is a few round-offs, of either sign: class masses do not drift by it.
template <int D, int V>
void CarriedCells<D, V>::close_sum(Column& fractions, Index p) noexcept {
  int largest = 0;
  double sum = 0;
  for (int k = 0; k < fractions.num_components(); ++k) {
    sum += fractions.component(k)[p];
    if (fractions.component(k)[p] > fractions.component(largest)[p]) largest = k;
  }
  [[maybe_unused]] const double operations = 16.0 * fractions.num_components();  // on each of the fractions
  SCREE_ASSERT(std::abs(sum - 1) <= operations * round_off);
  fractions.component(largest)[p] += 1 - sum;
}

#define SCREE_INSTANCE(D, V) template class CarriedCells<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
