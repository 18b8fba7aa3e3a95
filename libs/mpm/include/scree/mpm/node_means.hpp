#pragma once

#include <scree/input_column.hpp>
#include <scree/instruction_set.hpp>
#include <scree/mpm/nodes.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/read_nodes.hpp>
#include <scree/mpm/shapes.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scree::mpm {

/// Between what the values of a column lie.
struct Extremes {
  double lowest;
  double highest;
};

/// Means at the nodes of what points carry, weighted by their mass: of columns that laws of walls read where
/// they hold material, such as the mean size of its grains.  @see Eqs. (M170), (M171)
template <int D, int V>
class NodeMeans {
 public:
  /// @param shape of momentum, whose weights nodes have
  /// @param set what its loops are compiled for: one of instruction_sets()
  explicit NodeMeans(const AnyShape& shape, InstructionSet set = widest_instruction_set());

  /// Asks for the means of a column, one component wide.
  /// @param input what the law `law` reads it as: its unit and range
  /// @returns its place among the means of a node: the same if it was asked for before.
  /// @throws InputError naming law and column if there is none of that name, it has more components or
  /// another unit, or is out of range at a point.
  std::size_t add(const Particles<D, V>& particles, std::string_view column, const InputColumn& input,
                  std::string_view law);

  /// How many columns were asked for.
  [[nodiscard]] Index size() const noexcept { return static_cast<Index>(columns_.size()); }

  /// Checks all that laws read of each point that has mass; for when it has changed.
  /// @throws InputError as require_in_range() does.
  void require_inputs(const Particles<D, V>& particles) const;

  /// Brings the means to the nodes that are read; zero where there is no mass. What others have is of no use.
  /// @param blocks of the points, none of which has left its block's reach  @param read found for these
  /// blocks
  /// @param nodes that carry size() means
  /// @param extremes working memory: more is taken only when there are more blocks
  void bring(const Particles<D, V>& particles, const ParticleBlocks<D>& blocks, const ReadNodes<D>& read,
             Nodes<D>& nodes, std::vector<Extremes>& extremes, Threads threads) const;

 private:
  struct Reader {
    std::size_t column;
    InputColumn input;
    std::string law;
  };
  void add_block(const Particles<D, V>& particles, const ParticleBlock<D>& block,
                 Nodes<D>& nodes) const noexcept;

  AnyShape shape_;
  InstructionSet set_;
  std::vector<std::size_t> columns_;
  std::vector<Reader> readers_;
};

}  // namespace scree::mpm
