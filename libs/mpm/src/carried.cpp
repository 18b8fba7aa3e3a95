#include "carried_blocks.hpp"
#include "instances.hpp"
#include "kernel_choice.hpp"

#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/exchange_map.hpp>

#include <algorithm>
#include <cmath>

namespace scree::mpm {

namespace {

/// Number of a site along an axis; that of the site whose image it is in the first layer past an end; -1 if
/// it is further out.
template <int D>
[[nodiscard]] Index site_along(const Lattice<D>& lattice, Index site, std::size_t axis) noexcept {
  const Index n = lattice.count[axis];
  if (lattice.is_periodic[axis]) return (site % n + n) % n;
  if (site < -1 || site > n) return -1;
  const Index image_of_first = lattice.sites == Sites::cells ? -1 : 0;  // they share the wall, or sit on it
  if (site < 0) return std::min(image_of_first - site, n - 1);
  if (site >= n) return std::max(2 * (n - 1) - image_of_first - site, Index{0});
  return site;
}

/// Calls body(begin, end) for batches of sites.
template <class Body>
void for_each_batch(std::size_t num_sites, Threads threads, Body&& body) {
  constexpr std::size_t per_batch = 4096;
  for_each_block(static_cast<Index>((num_sites + per_batch - 1) / per_batch), threads, [&](Index batch) {
    const std::size_t begin = static_cast<std::size_t>(batch) * per_batch;
    body(begin, std::min(begin + per_batch, num_sites));
  });
}

/// The sums that up to four columns of mass and fields add to, from `first` on: mass is column 0.
[[nodiscard]] FourSums four_sums_of(std::span<const CarriedField> fields, std::size_t first,
                                    std::span<double> masses, std::span<double> means) noexcept {
  FourSums sums;
  const std::size_t count = std::min<std::size_t>(fields.size() + 1 - first, 4);
  sums.count = static_cast<int>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t column = first + i;
    const bool is_mass = column == 0;
    sums.field[i] = is_mass ? nullptr : fields[column - 1].column->component(fields[column - 1].component);
    sums.sum[i] = is_mass ? masses.data() : means.data() + (column - 1);
    sums.step[i] = is_mass ? 1 : static_cast<Index>(fields.size());
  }
  return sums;
}

/// Those of as many columns as a kernel takes at once.
[[nodiscard]] SiteSums sums_of(std::span<const CarriedField> fields, std::size_t first,
                               std::span<double> masses, std::span<double> means) noexcept {
  SiteSums sums;
  for (; sums.num_fours < SiteSums::most && first <= fields.size(); first += 4) {
    sums.fours[sums.num_fours++] = four_sums_of(fields, first, masses, means);
  }
  return sums;
}

/// What a site tells its points.  @param loss,gain of each class
void change_of_site(std::span<const double> before, std::span<const double> after, CarriedMap map,
                    std::span<double> loss, std::span<double> gain) noexcept {
  if (map == CarriedMap::exchange) return exchange_at_site(before, after, loss, gain);
  for (std::size_t k = 0; k < gain.size(); ++k) {
    loss[k] = 0;
    gain[k] = after[k] - before[k];
  }
}

/// Whether all points of a block are where its tile reaches.
template <int D>
[[maybe_unused]] bool is_in_reach(const CarriedBlock<D>& block, double shift, Index reach) noexcept {
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double* position = block.position + static_cast<Index>(axis) * block.stride;
    for (Index p = block.begin; p < block.end; ++p) {
      const double base =
          std::floor((position[p] - block.origin[axis]) * block.inverse_spacing[axis] - shift) -
          block.first[axis];
      if (!(0 <= base && base < static_cast<double>(reach))) return false;
    }
  }
  return true;
}

/// Whether the fractions of each point sum to one.
[[maybe_unused]] bool sum_to_one(const Column& fractions) noexcept {
  const double operations = 16.0 * fractions.num_components();  // on each of the fractions
  for (Index p = 0; p < fractions.size(); ++p) {
    double sum = 0;
    for (int k = 0; k < fractions.num_components(); ++k) sum += fractions.component(k)[p];
    if (!(std::abs(sum - 1) <= operations * round_off)) return false;
  }
  return true;
}

}  // namespace

template <int D, int V>
CarriedCells<D, V>::CarriedCells(const CartesianGrid<D>& grid, Sites sites, const AnyShape& shape,
                                 InstructionSet set)
    : grid_{grid}, lattice_{sites == Sites::cells ? grid.cells() : grid.nodes()}, shape_{shape}, set_{set} {
  detail::require_kernels(set, "CarriedCells");
}

template <int D, int V>
CarriedBlock<D> CarriedCells<D, V>::opened(const Particles<D, V>& particles,
                                           const ParticleBlock<D>& block) const noexcept {
  const auto part_of = [&](Index place, std::size_t axis) {
    const Index site = site_along(lattice_, place, axis);
    return site < 0 ? Index{-1} : site * lattice_.stride(static_cast<int>(axis));
  };
  const CarriedBlock<D> open = detail::opened(grid_, particles, block, part_of);
  [[maybe_unused]] const bool is_cells = lattice_.sites == Sites::cells;
  [[maybe_unused]] const double shift =
      is_cells ? 0 : std::visit([](const auto& shape) { return shape.shift; }, shape_);
  SCREE_ASSERT(is_in_reach(open, shift, block_edge<D> + 2 * block_skin<D> + (is_cells ? 1 : 0)));
  return open;
}

template <int D, int V>
void CarriedCells<D, V>::to_sites(const Particles<D, V>& particles, const ParticleBlocks<D>& blocks,
                                  std::span<const CarriedField> fields, std::span<double> masses,
                                  std::span<double> means, Threads threads) const {
  const std::size_t num_fields = fields.size();
  SCREE_ASSERT(static_cast<Index>(masses.size()) == lattice_.num_sites());
  SCREE_ASSERT(means.size() == masses.size() * num_fields);
  const auto kernels = detail::kernels_for<D>(set_, lattice_.sites, shape_.index());
  for_each_batch(masses.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::ranges::fill(masses.subspan(begin, end - begin), 0.0);
    std::ranges::fill(means.subspan(begin * num_fields, (end - begin) * num_fields), 0.0);
  });
  blocks.for_each_coloured(threads, [&](Index b) {
    const CarriedBlock<D> block = opened(particles, blocks.blocks[static_cast<std::size_t>(b)]);
    for (std::size_t first = 0; first <= num_fields; first += 4 * SiteSums::most) {
      kernels.to_sites(shape_, block, sums_of(fields, first, masses, means));
    }
  });
  for_each_batch(masses.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t site = begin; site < end; ++site) {
      if (!(masses[site] > 0)) continue;
      for (std::size_t f = 0; f < num_fields; ++f) means[site * num_fields + f] /= masses[site];
    }
  });
}

template <int D, int V>
void CarriedCells<D, V>::to_points(const ParticleBlocks<D>& blocks, const Particles<D, V>& particles,
                                   Column& fractions, std::span<const double> old_means,
                                   std::span<const double> new_means, CarriedMap map, Threads threads) {
  const auto num_classes = static_cast<std::size_t>(fractions.num_components());
  const auto num_sites = static_cast<std::size_t>(lattice_.num_sites());
  SCREE_ASSERT(old_means.size() == num_sites * num_classes);
  SCREE_ASSERT(map == CarriedMap::increments || sum_to_one(fractions));
  records_.resize(num_sites * 2 * num_classes);
  for_each_batch(num_sites, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin * num_classes; at < end * num_classes; at += num_classes) {
      const std::span<double> record = std::span{records_}.subspan(2 * at, 2 * num_classes);
      change_of_site(old_means.subspan(at, num_classes), new_means.subspan(at, num_classes), map,
                     record.first(num_classes), record.last(num_classes));
    }
  });
  const PointChange change{.records = records_.data(),
                           .fractions = fractions.component(0),
                           .stride = fractions.size(),
                           .num_classes = fractions.num_components(),
                           .is_exchange = map == CarriedMap::exchange};
  const auto kernels = detail::kernels_for<D>(set_, lattice_.sites, shape_.index());
  blocks.for_each(threads, [&](Index b) {
    kernels.to_points(shape_, opened(particles, blocks.blocks[static_cast<std::size_t>(b)]), change);
  });
}

#define SCREE_INSTANCE(D, V) template class CarriedCells<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
