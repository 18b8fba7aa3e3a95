#include "carried_blocks.hpp"
#include "instances.hpp"
#include "kernel_choice.hpp"

#include <scree/mpm/law_inputs.hpp>
#include <scree/mpm/node_means.hpp>
#include <scree/pack_size.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace scree::mpm {

namespace {

constexpr Extremes no_value{std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};

[[nodiscard]] Extremes wider(const Extremes& a, const Extremes& b) noexcept {
  return {std::min(a.lowest, b.lowest), std::max(a.highest, b.highest)};
}

/// Of the points of a block that have mass: by lanes, as blocks are whole packs, so that it costs a reading.
[[nodiscard]] Extremes extremes_of(const double* values, const double* mass, Index begin,
                                   Index end) noexcept {
  constexpr auto lanes = static_cast<std::size_t>(pack_size);
  std::array<double, lanes> lowest;
  std::array<double, lanes> highest;
  lowest.fill(no_value.lowest);
  highest.fill(no_value.highest);
  for (Index p = begin; p < end; p += pack_size) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double m = mass[p + static_cast<Index>(lane)];
      const double value = values[p + static_cast<Index>(lane)];
      lowest[lane] = std::min(lowest[lane], m > 0 ? value : no_value.lowest);
      highest[lane] = std::max(highest[lane], m > 0 ? value : no_value.highest);
    }
  }
  return {*std::ranges::min_element(lowest), *std::ranges::max_element(highest)};
}

/// Makes means of the sums of a node. No mean lies beyond the values that it is made of, as it might by
/// rounding: so it is in the range of the law that reads it, and of equal values it is that value to the bit.
void divide(double* record, std::span<const Extremes> of_columns) noexcept {
  if (!(record[0] > 0)) return;
  for (std::size_t k = 0; k < of_columns.size(); ++k) {
    double& mean = record[k + 1];
    mean = std::clamp(mean / record[0], of_columns[k].lowest, of_columns[k].highest);
  }
}

/// The sums that a pass of the kernel adds to, of mass (number 0) and of mass times each field.
/// @param first number of the sum that this pass begins with  @param fields of all columns
/// @param sums of node 0, `size` for each node
[[nodiscard]] SiteSums sums_from(Index first, Index size, double* sums, const auto& field_of) noexcept {
  SiteSums pass;
  for (; pass.num_fours < SiteSums::most && first < size; first += 4) {
    FourSums& four = pass.fours[pass.num_fours++];
    four.count = static_cast<int>(std::min<Index>(size - first, 4));
    for (Index i = 0; i < four.count; ++i) {
      const auto n = static_cast<std::size_t>(i);
      four.field[n] = first + i == 0 ? nullptr : field_of(first + i - 1);
      four.sum[n] = sums + first + i;
      four.step[n] = size;
    }
  }
  return pass;
}

/// Calls body(first node, one past the last) for the nodes in use.
template <int D, class Body>
void for_each_run_in_use(const Nodes<D>& nodes, Threads threads, Body&& body) {
  for_each_block(nodes.num_batches(), threads, [&](Index batch) {
    for (const NodeRun& run : nodes.batch(batch)) body(run.begin, run.end);
  });
}

}  // namespace

template <int D, int V>
NodeMeans<D, V>::NodeMeans(const AnyShape& shape, InstructionSet set) : shape_{shape}, set_{set} {
  detail::require_kernels(set, "NodeMeans");
}

template <int D, int V>
std::size_t NodeMeans<D, V>::add(const Particles<D, V>& particles, std::string_view column,
                                 const InputColumn& input, std::string_view law) {
  const std::string reader = "the law '" + std::string{law} + "' of a wall";
  const std::size_t index = particles.find_column(column, reader);
  const Column& found = particles.column(index);
  const std::string& unit = found.quantity().unit;
  require(found.num_components() == 1, reader + " reads the column '" + std::string{column} +
                                           "' as one number, but it has " +
                                           std::to_string(found.num_components()));
  require(unit == input.unit, reader + " reads the column '" + std::string{column} + "' in " +
                                  std::string{input.unit} + ", but it is in " + unit);
  readers_.push_back({index, input, std::string{law}});
  require_in_range(particles, index, input, law);
  const auto known = std::ranges::find(columns_, index);
  const std::size_t place = static_cast<std::size_t>(known - columns_.begin());
  if (known == columns_.end()) columns_.push_back(index);
  return place;
}

template <int D, int V>
void NodeMeans<D, V>::require_inputs(const Particles<D, V>& particles) const {
  for (const Reader& reader : readers_) {
    require_in_range(particles, reader.column, reader.input, reader.law);
  }
}

template <int D, int V>
void NodeMeans<D, V>::add_block(const Particles<D, V>& particles, const ParticleBlock<D>& block,
                                Nodes<D>& nodes) const noexcept {
  const auto part_of = [&](Index node, std::size_t axis) {
    const Index place = nodes.place(node, axis);
    return place < 0 ? Index{-1} : place * nodes.stride(axis);
  };
  const auto field_of = [&](Index k) {
    return particles.column(columns_[static_cast<std::size_t>(k)]).component(0);
  };
  const CarriedBlock<D> open = detail::opened(nodes.grid(), particles, block, part_of);
  const auto kernels = detail::kernels_for<D>(set_, Sites::nodes, shape_.index());
  for (Index first = 0; first <= size(); first += 4 * SiteSums::most) {
    kernels.to_sites(shape_, open, sums_from(first, size() + 1, nodes.carried(0), field_of));
  }
}

template <int D, int V>
void NodeMeans<D, V>::bring(const Particles<D, V>& particles, const ParticleBlocks<D>& blocks,
                            const ReadNodes<D>& read, Nodes<D>& nodes, std::vector<Extremes>& extremes,
                            Threads threads) const {
  const std::size_t num_columns = columns_.size();
  extremes.resize((blocks.blocks.size() + 1) * num_columns);
  for_each_run_in_use(nodes, threads, [&](Index begin, Index end) {
    std::fill(nodes.carried(begin), nodes.carried(end), 0.0);
  });
  for_each_coloured(read.colours(), threads, [&](Index b) {
    add_block(particles, blocks.blocks[static_cast<std::size_t>(b)], nodes);
  });
  blocks.for_each(threads, [&](Index b) {
    const ParticleBlock<D>& block = blocks.blocks[static_cast<std::size_t>(b)];
    for (std::size_t k = 0; k < num_columns; ++k) {
      extremes[static_cast<std::size_t>(b) * num_columns + k] = extremes_of(
          particles.column(columns_[k]).component(0), particles.mass.component(0), block.begin, block.end);
    }
  });
  const auto of_all = std::span{extremes}.last(num_columns);
  std::ranges::fill(of_all, no_value);
  for (std::size_t i = 0; i < blocks.blocks.size() * num_columns; ++i) {
    of_all[i % num_columns] = wider(of_all[i % num_columns], extremes[i]);
  }
  for (const Index node : read.nodes()) divide(nodes.carried(node), of_all);
}

#define SCREE_INSTANCE(D, V) template class NodeMeans<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
